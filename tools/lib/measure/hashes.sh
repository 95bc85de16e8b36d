#!/usr/bin/env bash
# Measures how random the hashes are, and what the noise is like; writes docs/quality.md and its pictures.
#
#   tools/quality [options]     installs what is missing; --help tells the options.
#   tools/quality --quick       the gate alone, with fewer and smaller windows: no page is written
#
# To judge a candidate for the default hash: a copy of glsl/ and include/ in one folder, with what is tried in its
# hash.glsl, first briefly and then as the page does:
#
#   tools/quality --include FOLDER/include --hash LATTICE --dimensions 2 --least
#   tools/quality --include FOLDER/include --hash LATTICE --dimensions 2 --seeds 5,6,7
#
# Exit status: 0 every hash passes, 1 one does not (or, with --check, the page is not up to date), 2 bad usage, 4 it
# could not be built.
set -euo pipefail
tools=$(dirname "${BASH_SOURCE[0]}")
plots=(--plots)
for argument in "$@"; do
  case $argument in
    --check | --hash* | --words* | --least | --dimensions* | --seeds* | --steps* | --help | -h) # they draw nothing
      plots=()
      break
      ;;
    --quick) plots=() ;;
    --out | --out=*) plots=(--plots) && break ;; # what draws with --quick as well
  esac
done
exec "$tools/scientific-python" "${plots[@]}" -m quality.command "$@"
