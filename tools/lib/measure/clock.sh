# shellcheck shell=bash
# Measures what noise costs: installs what is missing, builds, measures.
#
#   tools/measure clock [options of hn-conform bench]     into out/ on the driver osmesa, or --out and --driver
#
# Exit status: 0 done, 1 something became slower or could not be measured, 2 bad usage, 3 no usable driver,
# 4 it could not be built.
help_if_asked "$build/conformance/hn-conform" bench -- "$@"
refuse_unknown_options "$called" "$root/conformance/cli/options.cpp" -- "$@"
runs=$(cost run bench)
(($# == 0)) || [[ $# == 2 && $1 == --out ]] || runs=
setup paper "$runs"
exec "$build/conformance/hn-conform" bench "$@"
