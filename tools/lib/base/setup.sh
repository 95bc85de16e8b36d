# To be sourced: brings a Debian machine to where the project builds.
#
#   setup conform   what hn-conform needs, built into build/
#   setup drivers   the same, with every driver that a machine without a GPU and a display can have
#   setup clock     as conform, with the Vulkan driver that counts AMD's instructions, and what makes the page
#   setup paper     the same, with what draws
#   setup bake      what hn-bake needs, without the suite unless build/ has it already
#   setup test      all of it, with the tests and what they need
#
# It installs the packages that are missing; where it cannot, it stops with status 4. On another system it names what is
# needed and tries to build. It prints first what it will do and an estimate of the time, and tools/lib/base/progress.sh
# reports what is going on. --help is answered before any of that:
#
#   help_if_asked PROGRAM [ARGUMENT...] -- "$@"     the program has the options of the command
#
# and so is an option that there is not:
#
#   refuse_unknown_options COMMAND TEXT... -- "$@"  the texts name the options of the command

readonly root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
readonly build=$root/build
readonly log=$build/setup.log
source "$root/tools/lib/base/progress.sh"

readonly conform_packages=(
  cmake g++ ninja-build
  glslang-dev glslang-tools spirv-tools
  python3-glad libboost-dev libcli11-dev libcpp-httplib-dev libexpected-dev libfccp-dev libfmt-dev
  libkainjow-mustache-dev libpng-dev libpugixml-dev libvulkan-dev nlohmann-json3-dev pkg-config zlib1g-dev
  libegl-dev libglfw3-dev libjemalloc-dev libosmesa6 libegl1 libegl-mesa0 libgl1-mesa-dri
)
readonly paper_packages=(libvulkan1 mesa-vulkan-drivers)
# Of the page of the paper; costs need the first.
readonly page_packages=(python3-jinja2 python3-matplotlib python3-numpy python3-scipy)
# GLFW loads the libraries of OpenGL by their names.
readonly driver_packages=("${paper_packages[@]}" chromium-headless-shell clang libgl1 libgles2 libglfw3 libglx-mesa0 xvfb)
# Of the programs of src/, which have no need of drivers.
readonly program_packages=(cmake g++ ninja-build
  libcli11-dev libexpected-dev libfmt-dev libkainjow-mustache-dev libpng-dev nlohmann-json3-dev pkg-config zlib1g-dev)
readonly bake_packages=("${program_packages[@]}" libopenexr-dev)
# Of tools/pack npm, which compiles to WebAssembly, and the bounds of vectors.
readonly npm_packages=(clang g++ libc++-dev-wasm32 libfmt-dev lld python3 wasi-libc)
# Of the tests of examples/, which build raylib.
readonly example_packages=(git libxcursor-dev libxi-dev libxinerama-dev libxrandr-dev vulkan-validationlayers x11-utils)
# The packages behind python3-venv compile for ARM, and run the results; abigail-tools compare binary interfaces; Clang
# compiles hashnoise::grid with libc++, too. The last are compilers of the languages that tools/pick writes. Node.js is
# not among them: tools/lib/base/node gets one that is new enough.
readonly test_packages=("${driver_packages[@]}" "${npm_packages[@]}" "${example_packages[@]}" ccache libopenexr-dev
  libbenchmark-dev libc++-dev libclang-rt-dev libgtest-dev python3 python3-dev python3-jinja2 python3-numpy python3-pip python3-scipy
  python3-venv g++-aarch64-linux-gnu qemu-user abigail-tools dieharder spirv-cross
  cargo default-jdk-headless golang-go iverilog mono-mcs mono-runtime rust-clippy rustc rustfmt)
# Of thorough tests: Microsoft's FXC, a program for Windows, and the compiler of what starts it; the compilers for
# RISC-V and WebAssembly, and what libc++ links; a Debian that has nothing; what sees connections; what simulates
# circuits and synthesises them.
readonly thorough_packages=(debootstrap emscripten g++-mingw-w64-x86-64 g++-riscv64-linux-gnu libc++abi-dev
  python3-matplotlib strace verilator wine wine64 yosys)

# If the arguments behind -- have --help, prints the comment at the top of the command, and the program's list of its
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

# " (did you mean --out?)", or nothing, by the rule of include/hashnoise/detail/closest.hpp.
#   suggestion WORD NAME...
suggestion() {
  printf '%s\n' "$@" | awk '
    NR == 1 { word = tolower($0); fewest = int(length(word) / 3); if (fewest < 1) fewest = 1; ++fewest; next }
    {
      for (i = 0; i <= length(word); ++i) {
        a = substr(word, i, 1)
        for (j = 0; j <= length($0); ++j) {
          b = substr($0, j, 1)
          slips = i + j
          if (i && j) {
            slips = least(at[i - 1, j] + 1, at[i, j - 1] + 1, at[i - 1, j - 1] + (a != b))
            if (i > 1 && j > 1 && a == substr($0, j - 1, 1) && substr(word, i - 1, 1) == b)
              slips = least(slips, at[i - 2, j - 2] + 1, slips)
          }
          at[i, j] = slips
        }
      }
      if (slips < fewest) { fewest = slips; best = $0 }
    }
    END { if (best) printf " (did you mean %s?)", best }
    function least(x, y, z) { if (y < x) x = y; return z < x ? z : x }'
}

# Stops with status 2 if one of the arguments behind -- is an option that no text names, before anything is installed or
# built for it. The texts are the sources of the program that has the options: they are here before the program is, and
# are never older than it. Only words such as --out are judged; the program reports wrong values, and a wrong -o.
# With abbreviated=1 before it the beginning of an option will do, as it does for Python.
refuse_unknown_options() {
  local command=$1 argument word text texts=
  local -a known
  shift
  while [[ $1 != -- ]]; do
    text=$(cat "$1" 2>/dev/null) || true
    [[ -n $text ]] || return 0  # it is not here, so nobody can know
    texts+=$text
    shift
  done
  shift
  (($#)) || return 0
  mapfile -t known < <(grep -oE -e '--[a-z][a-z0-9.-]*[a-z0-9]' <<<"$texts" | sort -u)
  known+=(--help --version)
  for argument in "$@"; do
    [[ $argument != -- ]] || break  # no option stands behind it
    word=${argument%%=*}
    [[ $word =~ ^--[a-zA-Z0-9][a-zA-Z0-9._-]*$ && " ${known[*]} " != *" $word "* ]] || continue
    [[ -z ${abbreviated-} || " ${known[*]} " != *" $word"* ]] || continue
    echo "tools/$command: there is no option $word$(suggestion "$word" "${known[@]}");" \
      "see tools/$command --help" >&2
    exit 2
  done
}

# Sets `missing` to those of the packages that are not installed.
find_missing() {
  missing=()
  command -v dpkg-query >/dev/null || return 0
  local installed package
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null) || true
  for package in "$@"; do
    [[ $'\n'$installed$'\n' == *$'\n'"$package installed"$'\n'* || " ${missing[*]-} " == *" $package "* ]] ||
      missing+=("$package")
  done
}

install_missing() {
  local -a missing
  find_missing "$@"
  if ! command -v dpkg-query >/dev/null; then
    echo "This system is not Debian. The build needs what these Debian packages provide: $*" >&2
    return 0
  fi
  ((${#missing[@]})) || return 0
  local sudo=()
  if ((EUID != 0)); then sudo=(sudo -n); fi
  if ! command -v apt-get >/dev/null || ! "${sudo[@]}" true 2>/dev/null; then
    echo "Missing Debian packages: ${missing[*]}" >&2
    echo "This command cannot install them. Install them yourself, then run it again." >&2
    exit 4
  fi
  local started
  started=$(milliseconds)
  # With the first option apt-get prints how far it is. It closes that file for dpkg and the scripts of packages: without
  # standard output ccache's fails. sudo closes what has the number 3, so the file is opened behind it. With the second
  # option apt-get needs no pseudo terminal, which a container may lack.
  local -a apt_get=(sh -c 'exec apt-get "$@" 3>&1' sh -q -o APT::Status-Fd=3 -o Dpkg::Use-Pty=0)
  logged "Asking for the newest packages" "apt-get could not read the list of packages" "${sudo[@]}" "${apt_get[@]}" update
  to_its_end=1 logged "Installing ${#missing[@]} packages and what they need" "apt-get could not install these packages: ${missing[*]}" \
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive "${apt_get[@]}" install -y --no-install-recommends "${missing[@]}"
  keep_measured packages each "$(awk -v ms=$(($(milliseconds) - started)) -v count=${#missing[@]} \
    'BEGIN { printf "%.2f", ms / 1000 / count }')"
}

# ccache compiles once what is built from now on, and by tests: the wheel has the kernels of hashnoise::grid, too.
# -Werror changes nothing in what a compiler makes. The compiler's name matters to ccache, and what builds the wheel
# would choose another.
share_objects() {
  command -v ccache >/dev/null || return 0
  export CCACHE_DIR=${CCACHE_DIR:-$build/ccache} CCACHE_NOHASHDIR=1 CCACHE_IGNOREOPTIONS=-Werror
  export CCACHE_SLOPPINESS=pch_defines,time_macros  # for headers that are compiled once
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache} CXX=${CXX:-c++}
}

# How many steps the build in this folder has yet to do for these targets; nothing if that is not known before it is
# configured. Of build.ninja itself ninja would first ask whether CMake has to run again, and in a dry run print no
# more: of a file by another name it does not ask.
steps_to_do() {
  [[ -e $1/build.ninja ]] && command -v ninja >/dev/null || return 0
  cp "$1/build.ninja" "$1/steps.ninja"
  ninja -C "$1" -f steps.ninja -n "${@:2}" 2>/dev/null | awk '
    /no work to do/ { last = 0; known = 1 }
    match($0, /^\[[0-9]+\/[0-9]+\]/) { last = substr($0, 2, RLENGTH - 2); sub(/.*\//, "", last); known = 1 }
    END { if (known) print last }'
  rm "$1/steps.ninja"
}

# How many seconds the build that the table knows by this name takes on all cores, if it has that many steps to do.
predict_build() {
  local all seconds
  all=$(cost steps "$1")
  seconds=$(cost build "$1")
  [[ -n $all && -n $seconds ]] || return 0
  seconds=$(seconds_here "$seconds" "$(nproc 2>/dev/null || echo 1)")
  echo $((seconds * ${2:-$all} / all))
}

# The first line: what is going to happen, and how long it takes about. After the build the command runs, for so many
# seconds by the table, if the second argument is a number.
#   announce NAME_OF_BUILD RUN PACKAGES_THAT_ARE_MISSING STEPS_TO_DO
announce() {
  local what='' parts='' total=0 packages='' building run=''
  if (($3)); then
    what="installs $3 Debian packages, "
    packages=$(cost packages each)
    [[ -z $packages ]] || packages=$(awk -v each="$packages" -v count="$3" 'BEGIN { printf "%.0f", each * count }')
  fi
  measure_speed
  building=$(predict_build "$1" "$4")
  if [[ -z $4 ]]; then what+=builds; elif (($4)); then what+="builds $4 steps"; else what+="has nothing to build"; fi
  [[ -z $2 ]] || run=$(seconds_here "$2" "$(nproc 2>/dev/null || echo 1)")
  local name seconds
  for name in packages build run; do
    case $name in packages) seconds=$packages ;; build) seconds=$building ;; run) seconds=$run ;; esac
    [[ -n $seconds ]] || continue
    total=$((total + seconds))
    parts+="${parts:+, }$name $(duration "$seconds")"
  done
  echo "tools/${called:-${0##*/}} $what and runs.${parts:+ The whole takes about $(duration "$total") minutes here ($parts).} \
All output of the setup is in $log." >&2
}

# Keeps what a step took, for tools/test --record: of a build from nothing, its steps and its processor time. Of what
# depends on how fast the machine is just then, that is kept with it.
#   keep_measured KIND NAME VALUE [SPEED]
keep_measured() { echo "$1,$2,$3,${4-}" >>"$build/measured.csv"; }

# setup KIND [SECONDS]: the seconds are those of the table that the command then runs, if it is known.
setup() {
  local -a packages=("${conform_packages[@]}") configuration=(-DHASHNOISE_CONFORMANCE=ON) targets=(hn-conform) missing
  local name=conform steps expected
  if [[ $1 == test ]]; then
    name=test
    packages+=("${test_packages[@]}")
    [[ -z ${HN_THOROUGH-} ]] || packages+=("${thorough_packages[@]}")
    # Warnings are errors here, where the compiler is known, and not for users, where it is not.
    configuration+=(-DHASHNOISE_TESTS=ON -DHASHNOISE_BAKE=ON
                     -DHASHNOISE_INSTRUCTION_SETS="${HASHNOISE_INSTRUCTION_SETS:-native}"
                     -DHASHNOISE_QUICK_BUILD="${HASHNOISE_QUICK_BUILD:-ON}"
                     -DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
    targets=()
  elif [[ $1 == bake ]]; then
    name=bake
    packages=("${bake_packages[@]}")
    configuration=(-DHASHNOISE_BAKE=ON)
    [[ -e $build/CMakeCache.txt ]] || configuration+=(-DHASHNOISE_CONFORMANCE=OFF)
    targets=(hn-bake)
  elif [[ $1 == drivers ]]; then
    packages+=("${driver_packages[@]}")
  elif [[ $1 == paper ]]; then
    packages+=("${paper_packages[@]}" "${page_packages[@]}")
  elif [[ $1 == clock ]]; then
    packages+=("${paper_packages[@]}" "${page_packages[0]}")
  fi
  if [[ $1 != test && ! -e $build/CMakeCache.txt ]]; then
    configuration+=(-DHASHNOISE_TESTS=OFF)  # their packages may be missing; a build that has tests keeps them
  fi
  mkdir -p "$build"
  : >"$log"
  find_missing "${packages[@]}"
  announce "$name" "${2-}" "${#missing[@]}" "$(steps_to_do "$build" "${targets[@]}")"
  install_missing "${packages[@]}"
  [[ $1 != test ]] || share_objects
  configure_and_build "$name" "$build" '' "${configuration[@]}" -- "${targets[@]}"
  if [[ $1 == drivers || ($1 == test && -n ${HN_THOROUGH-}) ]]; then find_vkd3d; fi
}

# HLSL of shader model 5 wants vkd3d-compiler 1.10. Debian 12 has 1.2, so that of Debian's unstable suite is unpacked
# into build/, 16 MB. Where it cannot be had, hn-conform calls these cases unsupported, and prints why.
find_vkd3d() {
  [[ -z ${HN_VKD3D_COMPILER-} ]] && command -v apt-get >/dev/null && command -v python3 >/dev/null || return 0
  local version program
  version=$(vkd3d-compiler --version 2>/dev/null | sed -n 's/.*version \([0-9]*\)\.\([0-9]*\).*/\1 \2/p;q') || true
  if [[ -n $version ]] && ((${version% *} * 100 + ${version#* } >= 110)); then return 0; fi
  program=$(PYTHONPATH=$root/tools/lib python3 -B -m base.debian vkd3d-compiler) || return 0
  [[ -z $program ]] || export HN_VKD3D_COMPILER=$program
}

#   configure_and_build NAME_IN_THE_TABLE FOLDER BY_WHOM OPTION... -- [TARGET...]
configure_and_build() {
  local name=$1 folder=$2 by=$3 new='' steps before speed time_of_children
  local -a options=()
  shift 3
  while [[ $1 != -- ]]; do
    options+=("$1")
    shift
  done
  shift
  [[ -e $folder/build.ninja ]] || new=1
  logged "Configuring the build$by" "The build$by could not be configured" \
    cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release "${options[@]}"
  steps=$(steps_to_do "$folder" "$@")
  [[ $steps != 0 ]] || return 0
  take_time_of_children
  before=$time_of_children
  [[ -z $new ]] || speed=$(calibration "$(nproc 2>/dev/null || echo 1)")
  expected=$(predict_build "$name" "$steps") logged "Building${steps:+ $steps steps}$by" "The build$by failed" \
    cmake --build "$folder" ${1:+--target "$@"}
  take_time_of_children
  if [[ -n $new && -n $steps ]]; then
    keep_measured build "$name" "$(awk -v a="$time_of_children" -v b="$before" 'BEGIN { printf "%.0f", a - b }')" \
      "$(calibration_since "$speed" "$(nproc 2>/dev/null || echo 1)")"
    keep_measured steps "$name" "$steps"
  fi
}
