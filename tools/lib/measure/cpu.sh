# shellcheck shell=bash
# Measures what hashnoise::grid costs on this processor, by each of its instruction sets: installs what is missing,
# builds the library with each compiler, measures. Nothing else should run meanwhile. The pages are gcc.md and clang.md,
# of the records gcc.csv and clang.csv.
#
#   tools/measure cpu [options of hn-bench-cpu] [--compiler PROGRAM]...     g++ unless --compiler names another
#
#   tools/measure cpu --compiler g++ --compiler clang++ --against fastnoise2=libFastNoise.so --python venv/bin/python
#
# Exit status: 0 done, even if an aim is missed, 1 a measurement failed, 2 bad usage, 4 it could not be built.
program_by() { echo "$build/bench-cpu-$1/src/bench_cpu/hn-bench-cpu"; }
help_if_asked "$(program_by g++)" -- "$@"

compilers=()
options=()
while (($#)); do
  case $1 in
    --compiler=*) compilers+=("${1#--compiler=}") ;;
    --compiler)
      (($# > 1)) || { echo "tools/$called: --compiler wants a program, such as clang++" >&2; exit 2; }
      compilers+=("$2")
      shift
      ;;
    *) options+=("$1") ;;
  esac
  shift
done
((${#compilers[@]})) || compilers=(g++)
refuse_unknown_options "$called" "${BASH_SOURCE[0]}" "$root/src/bench_cpu/options.cpp" -- "${options[@]}"

setup_bench_cpu "${compilers[@]}"
for compiler in "${compilers[@]}"; do
  in_group python3 "$root/tools/lib/measure/command.py" cpu "$(program_by "$(basename "$compiler")")" "${options[@]}"
done
