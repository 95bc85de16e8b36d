# shellcheck shell=bash
# Measures what noise costs: installs what is missing, builds, measures, and makes a page.
#
#   tools/measure clock [options of hn-conform bench] [--baseline FILE]     into out/ on the driver osmesa, or --out and --driver
#
# --baseline compares with an earlier bench.csv: status 1 if something became slower.
#
# Exit status: 0 done, 1 something became slower or could not be measured, 2 bad usage, 3 no usable driver,
# 4 it could not be built.
help_if_asked "$build/conformance/hn-conform" bench -- "$@"
refuse_unknown_options "$called" "$root/conformance/cli/options.cpp" "$root/tools/lib/measure/clock.sh" -- "$@"
setup conform vulkan
exec "$root/tools/lib/base/scientific-python" --with jinja2 -m measure.clock "$@"
