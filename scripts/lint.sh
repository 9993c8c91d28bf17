#!/usr/bin/env bash
# lint.sh BUILD_FOLDER: layout (clang-format), packages (catkin_lint), which package may include which (check_layers),
# file lengths, and mistakes (clang-tidy: what has changed since it passed; where CI is set, what commits of two days have changed).
set -euo pipefail
build=$(cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mapfile -t sources < <(git ls-files 'src/*.cpp' 'src/*.hpp' 'examples/*.cpp' 'examples/*.hpp')
echo "== clang-format: ${#sources[@]} files" >&2
clang-format --dry-run --Werror "${sources[@]}"
echo "== layers and lengths" >&2
python3 scripts/check_layers.py
echo "== catkin_lint" >&2
# liburdfdom-dev and TBB have no rosdep names here, which is all that the ignored checks are about
ROS_DISTRO=noetic catkin_lint -W1 --strict --offline --ignore unknown_depend --ignore uninstalled_target \
  --ignore missing_depend --ignore missing_cmake_modules --ignore uninstalled_script --ignore order_violation src
echo "== clang-tidy" >&2
scripts/tidy.py "$build" ${CI:+--since "2 days ago"}
