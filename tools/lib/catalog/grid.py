"""The C++ parts: the header, and in src/grid/catalog.inc the compiled library and its programs."""

from __future__ import annotations

import textwrap
from pathlib import Path

from base.tree import ROOT
from catalog.model import Catalog, Function, Noise, Setting, Sum
from catalog.sections import with_section

PATH = ROOT / "src" / "grid" / "catalog.inc"
HEADER = "include/hashnoise/detail/functions_of_glsl.h"
MACROS = {
    "HN_CATALOG_NOISE": "(Id, name, first dimension, last dimension, shape, takes): Shape::shape and Takes::takes",
    "HN_CATALOG_RANGE": "(noise, component, dimensions, least, greatest): of a component that is not in [-1, 1]",
    "HN_CATALOG_SUM": "(Id, name, first dimension, last dimension, shape, shape of its noises, its usual noise or none "
                      "if nobody chooses them, name of its strength, usual strength, most strength, Bounds::bounds of "
                      "its value, least, greatest, has a phase)",
    "HN_CATALOG_STEP": "(Id, name, the statement that adds an octave n to the octaves o, what it makes of the mean): "
                       "of a sum of values; the first may take a strength",
    "HN_CATALOG_SETTING": "(Id, name, is whole, least, most, usual)",
    "HN_CATALOG_METRIC": "(Id, name)",
}
SHAPES = {"value": "kValue", "slopes": "kWithSlopes", "two_distances": "kTwoDistances",
          "three_distances": "kThreeDistances", "distance_with_slopes": "kDistanceWithSlopes", "vector": "kVector",
          "value_and_quadrature": "kValueAndQuadrature"}


def in_camel_case(name: str) -> str:
    return "".join(part.capitalize() for part in name.split("_"))


def takes_of(noise: Noise) -> str:
    """Its arguments beside a seed and a period."""
    return "k" + ("And".join(in_camel_case(option) for option in sorted(noise.options)) or "Nothing")


def row(macro: str, *arguments: object) -> str:
    return f"{macro}({', '.join(str(argument) for argument in arguments)})\n"


def of_function(function: Function) -> tuple[object, ...]:
    return in_camel_case(function.name), function.name, function.first, function.last, SHAPES[function.shape]


def ranges(noise: Noise) -> str:
    return "".join(row("HN_CATALOG_RANGE", noise.name, component, dimensions, *pair)
                   for component, by_dimension in noise.ranges.items()
                   for dimensions, pair in enumerate(by_dimension, noise.first) if pair)


def of_sum(sum_: Sum) -> str:
    strength = (sum_.strength.name, sum_.strength.default, sum_.strength.most) if sum_.strength else ("none", 0, 0)
    if isinstance(sum_.range, tuple):
        bounds: tuple[object, ...] = ("kThese", *sum_.range)
    else:
        bounds = ("kOfTheNoise" if sum_.range == "noise" else "kOfTheStrength", 0, 0)
    summed = (SHAPES[sum_.of], sum_.noise) if sum_.takes_noise else ("kValue", "none")
    has_phase = str("phase" in sum_.options).lower()
    return row("HN_CATALOG_SUM", *of_function(sum_), *summed, *strength, *bounds, has_phase)


def steps(sum_: Sum) -> str:
    return row("HN_CATALOG_STEP", in_camel_case(sum_.name), sum_.name, sum_.adds_to("o", "n"), sum_.makes("mean"))


def of_setting(setting: Setting) -> str:
    least = "-kMostFloat" if setting.least is None else f"{setting.least}.0"
    most = "kMostFloat" if setting.most is None else f"{setting.most}.0"
    default = "kNone" if setting.default is None else setting.default
    return row("HN_CATALOG_SETTING", in_camel_case(setting.name), setting.name, str(setting.is_whole).lower(), least,
               most, default)


def needs_octahedral_gradients(function: Function) -> bool:
    return "perlin_d" in (function.name, getattr(function, "noise", ""))


def guards(catalog: Catalog) -> str:
    """The header refuses the calls that GLSL would refuse."""
    functions = (*catalog.noises, *catalog.sums)
    steps = dict.fromkeys(sum_.public_step for sum_ in catalog.sums if sum_.public_step)
    some = [function for function in functions if needs_octahedral_gradients(function)]
    names = {function.name: [f"hn_{function.name}"] for function in functions}
    for noise in catalog.noises:
        if "phase" in noise.options:
            names[noise.name] = list(dict.fromkeys([*names[noise.name], noise.called_with_phase]))
    lines = {name: "".join(f"HN_ONLY_TYPES_OF_GLSL({called})\n" for called in calls) for name, calls in names.items()}
    return "".join([*(f"HN_ONLY_TYPES_OF_GLSL({step})\n" for step in steps),
                    *(lines[function.name] for function in functions if function not in some),
                    "#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL\n",
                    *(lines[function.name] for function in some), "#endif\n"])


def files(catalog: Catalog) -> dict[Path, str]:
    head = ["// Made by tools/make catalog: noises, sums and settings. Define one of these macros, and include this "
            "file.\n"]
    head += [f"//   {line}\n" for macro, arguments in MACROS.items() for line in
             textwrap.wrap(f"{macro}{arguments}", 109, subsequent_indent="    ", break_on_hyphens=False)]
    begin = [f"#ifndef {macro}\n#define {macro}(...)\n#endif\n" for macro in MACROS]
    rows = [*(row("HN_CATALOG_NOISE", *of_function(noise), takes_of(noise)) for noise in catalog.noises),
            *(ranges(noise) for noise in catalog.noises), *map(of_sum, catalog.sums),
            *(steps(sum_) for sum_ in catalog.sums if sum_.is_of_values),
            *map(of_setting, catalog.settings.values()),
            *(row("HN_CATALOG_METRIC", in_camel_case(metric), metric) for metric in catalog.metrics)]
    end = [f"#undef {macro}\n" for macro in MACROS]
    header, text = with_section(HEADER, "noises and sums", guards(catalog))
    return {header: text, PATH: "".join([*head, "// clang-format off\n", *begin, *rows, *end, "// clang-format on\n"])}
