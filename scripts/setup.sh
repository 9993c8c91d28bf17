# Shared by ./run and ./test: installs packages and builds. Sourced with $root set to the repository.

say() { printf '== %s\n' "$*" >&2; }

# install_packages GROUP...: installs the packages of these groups of packages.txt that are missing.
install_packages() {
  local wanted=() missing=() package
  for group in "$@"; do
    mapfile -t -O "${#wanted[@]}" wanted < <(awk -v group="$group" '$1 == group { print $2 }' "$root/packages.txt")
  done
  for package in "${wanted[@]}"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ "${#missing[@]}" -eq 0 ] && return
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  say "installing ${#missing[@]} packages: ${missing[*]}"
  "${as_root[@]}" apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# build FOLDER CMAKE_OPTION...: configures with the options and builds.
build() {
  local folder=$1
  shift
  local launcher=()
  command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  say "building in $folder"
  mkdir -p "$folder"
  if ! cmake -S "$root" -B "$folder" -G Ninja "${launcher[@]}" "$@" >"$folder/configure.log" 2>&1; then
    cat "$folder/configure.log" >&2
    return 1
  fi
  cmake --build "$folder" -j "$(nproc)" >&2
}

# use_workspace FOLDER: sources a devel space. By default nodes communicate on this machine only.
use_workspace() {
  export ROS_HOSTNAME=${ROS_HOSTNAME:-localhost}
  set +u
  # shellcheck disable=SC1091
  source "$1/devel/setup.bash"
  set -u
}
