# Packs the npm package into a folder, and prints its path: pack.sh FOLDER, as tools/pack npm calls it.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../base/setup.sh"
folder=$1

begin_log
mapfile -t packages < <(packages npm)
install_missing "${packages[@]}" >&2

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"; rmdir "$folder" 2>/dev/null || true' EXIT  # a folder that we made stays if something is in it
mkdir "$scratch/package"
cd "$root/tools/lib"
logged "Making the files of the package" "The files of the package could not be made" \
  python3 -B -m ship.npm.files "$scratch/package"
cd "$scratch/package"
logged "Packing" "The package could not be packed" "$root/tools/lib/base/node" npm pack --silent --offline --pack-destination "$scratch"
packed=("$scratch"/*.tgz)
mv "${packed[0]}" "$folder"
echo "$folder/${packed[0]##*/}"
