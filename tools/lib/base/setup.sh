# To be sourced: brings a Debian machine to where the project builds.
#
#   setup conform [PURPOSE...]     what hn-conform needs, built into build/; with the packages of more purposes. vkd3d
#                                  is the compiler of HLSL that find_vkd3d gets
#   setup test                     all of it, with the tests and what they need
#
# packages.txt lists Debian's packages by purpose. Packages that are missing are installed; where that fails, the
# command stops with status 4. On another system it names what is needed and tries to build. While a step runs, a line
# every ten seconds shows how far it is. --help is answered before any of that, and so is an option that there is not:
#
#   help_if_asked PROGRAM [ARGUMENT...] -- "$@"     the program has the options of the command
#   refuse_unknown_options COMMAND TEXT... -- "$@"  the texts name the options of the command
set -o pipefail

readonly root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
readonly build=$root/build
readonly log=$build/setup.log
readonly tick=${HN_PROGRESS_SECONDS:-10}  # tests have no time for ten

# The packages of these purposes.
packages() {
  local purpose
  for purpose in "$@"; do sed -n "s/^$purpose://p" "$root/tools/lib/base/packages.txt"; done | xargs -n 1 | sort -u
}

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
  echo
  "${program[@]}" --help 2>/dev/null ||
    echo "${program[0]} is not built yet. When it is, its options are listed here. docs/guide/ has them, too."
  exit 0
}

# " (did you mean --out?)", or nothing; also where there is no Python yet.
#   suggestion WORD NAME...
suggestion() {
  PYTHONPATH=$root/tools/lib python3 -B -c 'import sys
from base.usage import near
print(near(sys.argv[1], sys.argv[2:]), end="")' "$@" 2>/dev/null || true
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
  mapfile -t known < <(grep -oE -e '--[a-z][a-z0-9.-]*[a-z0-9]' <<<"$texts" | sort -u)
  known+=(--help --version)
  for argument in "$@"; do
    [[ $argument != -- ]] || break  # no option stands behind it
    word=${argument%%=*}
    [[ $word =~ ^--[a-zA-Z0-9][a-zA-Z0-9._-]*$ && " ${known[*]} " != *" $word "* ]] || continue
    [[ -z ${abbreviated-} || " ${known[*]} " != *" $word"* ]] || continue
    echo "tools/$command: there is no option $word$(suggestion "$word" "${known[@]}"); see tools/$command --help" >&2
    exit 2
  done
}

# --- Steps ------------------------------------------------------------------------------------------------------------

# Prints how far a step is that has run for so many seconds, by its output: [12/140] of ninja, or what apt-get writes
# with APT::Status-Fd.
#   progress TITLE SECONDS
progress() {
  awk -v title="$1" -v gone="$2" '
    match($0, /^\[[0-9]+\/[0-9]+\]/) { at = substr($0, 1, RLENGTH) }
    /^dlstatus:/ { split($0, n, ":"); at = int(n[3]) " % downloaded" }
    /^pmstatus:/ { split($0, n, ":"); at = int(n[3]) " % installed" }
    END { printf "%s%s, %d:%02d\n", title, at ? " " at : "", gone / 60, gone % 60 }'
}

# A line every ten seconds, from what the log has behind so many bytes.
#   show_progress TITLE BYTES
show_progress() {
  local idle started=$SECONDS
  exec {idle}<> <(:)
  while ! read -rt "$tick" -u "$idle"; do  # a sleep that is no process, which would go on
    tail -c "+$(($2 + 1))" "$log" | progress "$1" $((SECONDS - started)) >&2
  done
}

with_progress() {
  local status=0 shown from
  from=$(wc -c <"$log")  # not in the background, where the command could have written already
  show_progress "$1" "$from" &
  shown=$!
  "${@:2}" >>"$log" 2>&1 || status=$?
  kill "$shown"
  return "$status"
}

# Runs a command or a function in a process group that a signal to this shell ends, too: else it would run on. It cannot
# read from a terminal. Where `to_its_end` is set, as for packages that would be left in pieces, the signal waits.
in_group() {
  local signal status=0
  for signal in HUP INT TERM; do trap "end_group $signal" "$signal"; done
  set -m
  "$@" </dev/null &
  set +m
  wait "$!" || status=$?
  trap - HUP INT TERM
  return "$status"
}

end_group() {
  trap - HUP INT TERM
  if [[ -n ${!-} ]]; then
    [[ -n ${to_its_end-} ]] || kill -"$1" -- "-$!" 2>/dev/null || true
    wait "$!" 2>/dev/null || true
  fi
  kill -"$1" "$BASHPID"
}

# Runs a step. If it fails, prints the end of the log and FAILURE, and stops with status 4.
#   logged TITLE FAILURE COMMAND...
logged() {
  echo "$1" >&2
  in_group with_progress "$1" "${@:3}" && return 0
  grep -av '^..status:' "$log" | tail -n 40 >&2 || true
  echo "$2; all of the output is in $log." >&2
  exit 4
}

begin_log() {
  mkdir -p "$build"
  : >"$log"
}

# --- Packages ---------------------------------------------------------------------------------------------------------

# Prints which of the packages are not installed.
missing() {
  command -v dpkg-query >/dev/null || return 0
  comm -23 <(printf '%s\n' "$@" | sort -u) \
    <(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | sed -n 's/ installed$//p' | sort -u)
}

install_missing() {
  local -a wanted sudo=()
  if ! command -v dpkg-query >/dev/null; then
    echo "This system is not Debian. The build needs what these Debian packages provide: $*" >&2
    return 0
  fi
  mapfile -t wanted < <(missing "$@")
  ((${#wanted[@]})) || return 0
  if ((EUID != 0)); then sudo=(sudo -n); fi
  if ! command -v apt-get >/dev/null || ! "${sudo[@]}" true 2>/dev/null; then
    echo "Missing Debian packages: ${wanted[*]}" >&2
    echo "This command cannot install them. Install them yourself, then run it again." >&2
    exit 4
  fi
  # With the first option apt-get prints how far it is. It closes that file for dpkg and the scripts of packages:
  # without standard output ccache's fails. sudo closes what has the number 3, so the file is opened behind it. With the
  # second option apt-get needs no pseudo terminal, which a container may lack.
  local -a apt_get=(sh -c 'exec apt-get "$@" 3>&1' sh -q -o APT::Status-Fd=3 -o Dpkg::Use-Pty=0)
  logged "Asking for the newest packages" "apt-get could not read the list of packages" \
    "${sudo[@]}" "${apt_get[@]}" update
  to_its_end=1 logged "Installing ${#wanted[@]} packages and what they need" \
    "apt-get could not install these packages: ${wanted[*]}" \
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive "${apt_get[@]}" install -y --no-install-recommends "${wanted[@]}"
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

# --- Builds -----------------------------------------------------------------------------------------------------------

# ccache compiles once what is built from now on, and by tests: the wheel has the kernels of hashnoise::grid, too.
# -Werror changes nothing in what a compiler makes. The compiler's name matters to ccache, and what builds the wheel
# would choose another.
share_objects() {
  command -v ccache >/dev/null || return 0
  export CCACHE_DIR=${CCACHE_DIR:-$build/ccache} CCACHE_NOHASHDIR=1 CCACHE_IGNOREOPTIONS=-Werror
  export CCACHE_SLOPPINESS=pch_defines,time_macros  # for headers that are compiled once
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache} CXX=${CXX:-c++}
}

# Whether the build's compiler is Debian 12's. Then warnings are errors, for each command: tools/test takes the objects
# that tools/conform made, since their compile lines are the same. Another compiler may warn of more.
knows_compiler() {
  local compiler
  compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt" 2>/dev/null) || true
  [[ $(${compiler:-${CXX:-c++}} --version 2>/dev/null) == *"(Debian 12.2."* ]]
}

setup() {
  local -a purposes=("$@") wanted configuration=(-DHASHNOISE_CONFORMANCE=ON) targets=(hn-conform)
  local count what=
  case $1 in
    test)
      purposes=(conform vulkan drivers npm test ${HN_THOROUGH:+thorough})
      configuration+=(-DHASHNOISE_TESTS=ON
        -DHASHNOISE_INSTRUCTION_SETS="${HASHNOISE_INSTRUCTION_SETS:-native}"
        -DHASHNOISE_QUICK_BUILD="${HASHNOISE_QUICK_BUILD:-ON}")
      targets=()
      ;;
  esac
  if [[ $1 != test && ! -e $build/CMakeCache.txt ]]; then
    configuration+=(-DHASHNOISE_TESTS=OFF)  # their packages may be missing; a build that has tests keeps them
  fi
  mapfile -t wanted < <(packages "${purposes[@]}")
  begin_log
  count=$(missing "${wanted[@]}" | wc -l)
  ((!count)) || what="installs $count Debian packages, "
  echo "tools/${called:-${0##*/}} ${what}builds and runs. All output of the setup is in $log." >&2
  install_missing "${wanted[@]}"
  share_objects
  ! knows_compiler || configuration+=(-DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
  logged "Configuring the build" "The build could not be configured" \
    cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${configuration[@]}"
  logged "Building" "The build failed" cmake --build "$build" ${targets:+--target "${targets[@]}"}
  if [[ " $* " == *" vkd3d "* || ($1 == test && -n ${HN_THOROUGH-}) ]]; then find_vkd3d; fi
}
