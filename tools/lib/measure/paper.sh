#!/usr/bin/env bash
# Reproduces what the paper shows: installs what is missing, builds, measures, and writes a page with pictures and data.
#
#   tools/paper [options of hn-conform paper]     into out/ on the driver osmesa unless --out and --driver say otherwise
#
# Exit status: 0 done, 1 something could not be measured, 2 bad usage, 3 no usable driver, 4 it could not be built.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
help_if_asked "$build/conformance/hn-conform" paper -- "$@"
refuse_unknown_options paper "$root/conformance/cli/options.cpp" -- "$@"
runs=$(cost run paper)
(($# == 0)) || [[ $# == 2 && $1 == --out ]] || runs=
setup paper "$runs"
exec "$build/conformance/hn-conform" paper "$@"
