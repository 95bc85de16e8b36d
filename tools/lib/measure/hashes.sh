# shellcheck shell=bash
# Starts hashes/command.py. Pictures need matplotlib, which is large, so it is installed only where some are drawn.
plots=,matplotlib
for argument in "$@"; do
  case $argument in
    --check | --hash* | --words* | --least | --dimensions* | --seeds* | --steps* | --help | -h) # they draw nothing
      plots=
      break
      ;;
    --quick) plots= ;;
    --out | --out=*) plots=,matplotlib && break ;; # what draws with --quick as well
  esac
done
exec "$root/tools/lib/base/scientific-python" --with "numpy,scipy$plots" -m measure.hashes.command "$@"
