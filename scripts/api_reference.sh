#!/usr/bin/env bash
# api_reference.sh [FOLDER]: generates the reference of the C++ interfaces as web pages, by default in build/api_reference. Warnings
# of Doxygen are errors.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
output=${1:-$root/build/api_reference}
mkdir -p "$output"
output=$(cd "$output" && pwd)
cd "$root"
{ cat docs/Doxyfile; printf 'OUTPUT_DIRECTORY = "%s"\n' "$output"; } | doxygen -
echo "$output/index.html"
