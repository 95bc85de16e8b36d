#!/usr/bin/env bash
# Measures what noise costs: installs what is missing, builds, measures.
#
#   tools/bench [options of hn-conform bench]     into out/ on the driver osmesa unless --out and --driver say otherwise
#
# Exit status: 0 done, 1 something became slower or could not be measured, 2 bad usage, 3 no usable driver,
# 4 it could not be built.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
help_if_asked "$build/conformance/hn-conform" bench -- "$@"
refuse_unknown_options bench "$root/conformance/cli/options.cpp" -- "$@"
runs=$(cost run bench)
(($# == 0)) || [[ $# == 2 && $1 == --out ]] || runs=
setup paper "$runs"
exec "$build/conformance/hn-conform" bench "$@"
