#!/usr/bin/env bash
# lint.sh: checks without a build: layout (clang-format), includes between packages and file lengths (check_layers), words
# (check_prose), packages (catkin_lint). tidy.py checks built sources.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mapfile -t sources < <(git ls-files 'src/*.cpp' 'src/*.hpp' 'examples/*.cpp' 'examples/*.hpp')
echo "== clang-format: ${#sources[@]} files" >&2
clang-format --dry-run --Werror "${sources[@]}"
echo "== layers and lengths" >&2
python3 scripts/check_layers.py
echo "== prose" >&2
python3 scripts/check_prose.py
echo "== catkin_lint" >&2
# all ignored checks concern liburdfdom-dev and TBB, which have no rosdep names here
ROS_DISTRO=noetic catkin_lint -W1 --strict --offline --ignore unknown_depend --ignore uninstalled_target \
  --ignore missing_depend --ignore missing_cmake_modules --ignore uninstalled_script --ignore order_violation src
