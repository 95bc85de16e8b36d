# To be sourced: brings a Debian machine to where the project builds.
#
#   setup conform   what hn-conform needs, built into build/
#   setup drivers   the same, with every driver that a machine without a GPU and a display can have
#   setup paper     as conform, with the Vulkan driver that counts AMD's instructions
#   setup bake      what hn-bake needs, without the suite unless build/ has it already
#   setup test      all of it, with the tests and what they need
#
# It names the packages that are missing and installs them; where it cannot, it stops with status 4. On another system
# it names what is needed and tries to build. Who asks for help is shown it before any of that:
#
#   help_if_asked PROGRAM [ARGUMENT...] -- "$@"     the program has the options of the command
#
#   setup_bench_cpu COMPILER...                     hn-bench-cpu by each, in a folder of its own

readonly root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly build=$root/build
readonly log=$build/setup.log

readonly conform_packages=(
  cmake g++ ninja-build
  glslang-dev glslang-tools spirv-tools
  python3-glad libboost-math-dev libcli11-dev libcpp-httplib-dev libexpected-dev libfccp-dev libfmt-dev
  libkainjow-mustache-dev libpng-dev libpugixml-dev libvulkan-dev nlohmann-json3-dev pkg-config zlib1g-dev
  libegl-dev libglfw3-dev libosmesa6 libegl1 libegl-mesa0 libgl1-mesa-dri
)
readonly paper_packages=(libvulkan1 mesa-vulkan-drivers)
# GLFW loads the libraries of OpenGL by their names.
readonly driver_packages=("${paper_packages[@]}" chromium clang libgl1 libgles2 libglfw3 libglx-mesa0 xvfb)
# Of the programs of src/, which have no need of drivers.
readonly program_packages=(cmake g++ ninja-build
  libcli11-dev libexpected-dev libfmt-dev libkainjow-mustache-dev libpng-dev nlohmann-json3-dev pkg-config zlib1g-dev)
readonly bake_packages=("${program_packages[@]}" libopenexr-dev)
# Of tools/npm, which compiles to WebAssembly.
readonly npm_packages=(clang libc++-dev-wasm32 lld python3 wasi-libc)
# Of the tests of examples/, which build raylib.
readonly example_packages=(git libxcursor-dev libxi-dev libxinerama-dev libxrandr-dev vulkan-validationlayers x11-utils)
# The last two compile for ARM, and run what they compile.
readonly test_packages=("${driver_packages[@]}" "${npm_packages[@]}" "${example_packages[@]}" ccache libopenexr-dev
  libclang-rt-dev libgtest-dev python3 python3-dev python3-numpy python3-scipy python3-venv g++-aarch64-linux-gnu
  qemu-user)
# Of tools/quality, which has no need of hn-conform.
readonly quality_packages=(g++ python3 python3-numpy python3-scipy)
readonly plot_packages=(python3-matplotlib)

# If the arguments behind -- ask for help, prints the comment at the top of the command, and what the program says of its
# options, and stops.
help_if_asked() {
  local -a program=()
  while [[ $1 != -- ]]; do
    program+=("$1")
    shift
  done
  shift
  [[ ${1-} == help || " $* " == *' --help '* || " $* " == *' -h '* ]] || return 0
  sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[1]}"
  if ! command -v "${program[0]}" >/dev/null; then
    printf '\n%s\n' "${program[0]} does not exist yet. When it does, its options are listed here. docs/ has them, too."
    exit 0
  fi
  echo
  exec "${program[@]}" --help
}

install_missing() {
  if ! command -v dpkg-query >/dev/null; then
    echo "This system is not Debian. The build needs what these Debian packages provide: $*" >&2
    return 0
  fi
  local missing=() package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) == *' installed' ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  echo "Missing Debian packages: ${missing[*]}" >&2
  local sudo=()
  if ((EUID != 0)); then sudo=(sudo -n); fi
  if ! command -v apt-get >/dev/null || ! "${sudo[@]}" true 2>/dev/null; then
    echo "This command cannot install them. Install them yourself, then run it again." >&2
    exit 4
  fi
  echo "Installing them." >&2
  logged "apt-get could not install them" "${sudo[@]}" apt-get update -qq
  logged "apt-get could not install them" "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# Runs a command with its output in the log; if it fails, shows the end of the log, says what went wrong, and stops.
logged() {
  local what=$1
  shift
  "$@" >>"$log" 2>&1 && return 0
  tail -n 40 "$log" >&2
  echo "$what; all of the output is in $log." >&2
  exit 4
}

# What is built from now on, and by tests, is compiled once: the wheel has the kernels of hashnoise::grid, too. -Werror has
# no say in what a compiler makes; its name has one to ccache, and what builds the wheel would choose another.
share_objects() {
  command -v ccache >/dev/null || return 0
  export CCACHE_DIR=${CCACHE_DIR:-$build/ccache} CCACHE_NOHASHDIR=1 CCACHE_IGNOREOPTIONS=-Werror
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache} CXX=${CXX:-c++}
}

setup() {
  local -a packages=("${conform_packages[@]}") configuration=(-DHASHNOISE_CONFORMANCE=ON) target=(--target hn-conform)
  if [[ $1 == test ]]; then
    packages+=("${test_packages[@]}")
    # Warnings are errors here, where the compiler is known, and not for users, where it is not.
    configuration+=(-DHASHNOISE_TESTS=ON -DHASHNOISE_BAKE=ON -DHASHNOISE_BENCH_CPU=ON
                     -DHASHNOISE_INSTRUCTION_SETS="${HASHNOISE_INSTRUCTION_SETS:-native}" -DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
    target=()
  elif [[ $1 == bake ]]; then
    packages=("${bake_packages[@]}")
    configuration=(-DHASHNOISE_BAKE=ON)
    [[ -e $build/CMakeCache.txt ]] || configuration+=(-DHASHNOISE_CONFORMANCE=OFF)
    target=(--target hn-bake)
  elif [[ $1 == drivers ]]; then
    packages+=("${driver_packages[@]}")
  elif [[ $1 == paper ]]; then
    packages+=("${paper_packages[@]}")
  fi
  if [[ $1 != test && ! -e $build/CMakeCache.txt ]]; then
    configuration+=(-DHASHNOISE_TESTS=OFF)  # their packages may be missing; a build that has tests keeps them
  fi
  mkdir -p "$build"
  : >"$log"
  install_missing "${packages[@]}"
  [[ $1 != test ]] || share_objects
  logged "The build could not be configured" \
    cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${configuration[@]}"
  logged "The build failed" cmake --build "$build" "${target[@]}"
}

# What the compiler makes of the library is measured, so each has a build without anything else.
setup_bench_cpu() {
  local -a packages=("${program_packages[@]}")
  local compiler folder
  for compiler in "$@"; do
    [[ $compiler != clang++ ]] || packages+=(clang)
  done
  mkdir -p "$build"
  : >"$log"
  install_missing "${packages[@]}"
  for compiler in "$@"; do
    if ! command -v "$compiler" >/dev/null; then
      echo "There is no compiler $compiler; --compiler wants a program such as g++ or clang++." >&2
      exit 2
    fi
    folder=$build/bench-cpu-$(basename "$compiler")
    logged "The build by $compiler could not be configured" \
      cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
      -DHASHNOISE_CONFORMANCE=OFF -DHASHNOISE_TESTS=OFF -DHASHNOISE_BENCH_CPU=ON
    logged "The build by $compiler failed" cmake --build "$folder" --target hn-bench-cpu
  done
}
