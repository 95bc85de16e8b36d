# To be sourced: brings a Debian machine to where the project builds.
#
#   setup conform   what hn-conform needs, built into build/
#   setup test      the same, with the tests and what they need
#
# It names the packages that are missing and installs them. Where it cannot, it stops with status 4.

readonly root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly build=$root/build

readonly conform_packages=(
  cmake g++ ninja-build
  glslang-dev glslang-tools spirv-tools python3-glad libcli11-dev libexpected-dev libfmt-dev nlohmann-json3-dev libegl-dev
  libosmesa6 libegl1 libegl-mesa0 libgl1-mesa-dri
)
readonly test_packages=(clang libgtest-dev libpng-dev python3)

install_missing() {
  local missing=() package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == *' installed' ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  echo "Missing Debian packages: ${missing[*]}" >&2
  local sudo=()
  if ((EUID != 0)); then sudo=(sudo -n); fi
  if ! command -v apt-get >/dev/null || ! "${sudo[@]}" true 2>/dev/null; then
    echo "They cannot be installed from here. Install them (or what they are called on this system), then run this again." >&2
    exit 4
  fi
  echo "Installing them." >&2
  if ! { "${sudo[@]}" apt-get update -qq &&
         "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"; } >&2; then
    echo "apt-get could not install: ${missing[*]}" >&2
    exit 4
  fi
}

setup() {
  local -a packages=("${conform_packages[@]}") configuration=() target=(--target hn-conform)
  if [[ $1 == test ]]; then
    packages+=("${test_packages[@]}")
    configuration=(-DHASHNOISE_TESTS=ON)
    target=()
  elif [[ ! -e $build/CMakeCache.txt ]]; then
    configuration=(-DHASHNOISE_TESTS=OFF)  # their packages may be missing; a build that has tests keeps them
  fi
  install_missing "${packages[@]}"
  mkdir -p "$build"
  local log=$build/setup.log
  if ! { cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${configuration[@]}" &&
         cmake --build "$build" "${target[@]}"; } >"$log" 2>&1; then
    tail -n 40 "$log" >&2
    echo "The build failed; all of its output is in $log." >&2
    exit 4
  fi
}
