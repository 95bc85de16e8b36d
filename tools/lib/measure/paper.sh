# shellcheck shell=bash
# Reproduces what the paper shows: installs what is missing, builds, measures, and makes a page with pictures and data.
#
#   tools/measure paper [options of hn-conform paper]     into out/ on the driver osmesa, or --out and --driver
#
# With --dump the values that are drawn and tested are kept, as little-endian floats in values/.
#
# Exit status: 0 done, 1 something could not be measured, 2 bad usage, 3 no usable driver, 4 it could not be built.
help_if_asked "$build/conformance/hn-conform" paper -- "$@"
refuse_unknown_options "$called" "$root/conformance/cli/options.cpp" -- "$@"
setup conform vulkan
exec "$root/tools/lib/base/scientific-python" --with jinja2,numpy,scipy -m measure.paper.reproduction "$@"
