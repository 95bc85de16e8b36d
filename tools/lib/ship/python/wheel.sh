# Builds the wheel, checks it, and prints its path, or the source distribution, as tools/pack python calls it:
#
#   wheel.sh FOLDER PYTHON [LIBRARY [SDIST]]    the last two are empty, or the library, and something
#
# Exit status: as that of tools/pack python.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../base/setup.sh"
folder=$1 python=$2 library=${3-} sdist=${4-}

begin_log
packages=(cmake g++ libfmt-dev ninja-build)
# A Python of the user's own has what Debian's is without.
if ! "$python" -c 'if True:
    import ensurepip, pathlib, sysconfig, venv
    assert (pathlib.Path(sysconfig.get_path("include")) / "Python.h").exists()' 2>/dev/null; then
  packages+=(python3-dev python3-venv)
fi
install_missing "${packages[@]}" >&2

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_INPUT=1 PIP_NO_COMPILE=1  # installed packages are used once
# A virtual environment with a pip of its own needs no other: what builds the wheel is apart from it in any case.
pip=("$python" -m pip)
is_environment=1
if ! "$python" -c 'import sys; sys.exit(sys.prefix == sys.base_prefix)' || ! "${pip[@]}" --version >/dev/null 2>&1; then
  is_environment=
  pip=("$scratch/builds/bin/pip")
  logged "Making a virtual environment for the build" "There is no virtual environment for the build" \
    "$python" -m venv "$scratch/builds"
fi
logged "Making the vectors" "The vectors could not be made" "$root/tools/make" vectors
if [[ -n $sdist ]]; then
  logged "Making a virtual environment for build" "There is no virtual environment for build" \
    "$python" -m venv "$scratch/sdist"
  logged "Installing build" "build could not be installed" "$scratch/sdist/bin/pip" install build==1.6.1
  logged "Building the source distribution" "The source distribution could not be built" \
    "$scratch/sdist/bin/python" -m build --sdist --outdir "$scratch" "$root"
  archives=("$scratch"/*.tar.gz)
  mv "${archives[0]}" "$folder"
  echo "$folder/${archives[0]##*/}"
  exit
fi
settings=("--config-settings=cmake.define.HASHNOISE_INSTRUCTION_SETS=all")  # others may have any
if [[ -n $library ]]; then
  settings=("--config-settings=build-dir=$build/python/linked/{wheel_tag}"
    "--config-settings=cmake.define.HASHNOISE_LIBRARY=$(realpath "$library")"
    # The rest of the compilation is for tests, which run in less time. Most of it is reading headers.
    "--config-settings=cmake.define.CMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"
    "--config-settings=cmake.define.CMAKE_UNITY_BUILD=ON"
    "--config-settings=cmake.define.CMAKE_UNITY_BUILD_BATCH_SIZE=0")
fi
logged "Building the wheel" "The wheel could not be built" "${pip[@]}" wheel --no-deps --wheel-dir "$scratch/wheels" \
  "${settings[@]}" "$root"
wheels=("$scratch/wheels"/*.whl)

# It needs no pip of its own, which takes longer to install than the rest.
logged "Making a virtual environment for the check" "There is no virtual environment for the check" \
  "$python" -m venv --without-pip "$scratch/checks"
install_for_check() { "${pip[@]}" install --ignore-installed --prefix "$scratch/checks" "$@"; }
where_numpy_is='import numpy, pathlib; print(pathlib.Path(numpy.__file__).parents[1])'
if [[ -n $is_environment ]] && numpy=$("$python" -c "$where_numpy_is" 2>/dev/null); then
  for packages in "$scratch"/checks/lib/python*/site-packages; do echo "$numpy" >"$packages/numpy.pth"; done
else
  logged "Installing the wheel's checker" "The wheel's checker could not be installed" \
    install_for_check --requirement "$root/packages/python/tests/numpy.txt"
fi
logged "Installing the wheel" "The wheel could not be installed" install_for_check --no-deps "${wheels[0]}"
if ! "$scratch/checks/bin/python" -B -m hashnoise.check >&2; then
  echo "${wheels[0]##*/} computes wrong values, and is not kept." >&2
  exit 1
fi
mv "${wheels[0]}" "$folder"
echo "$folder/${wheels[0]##*/}"
