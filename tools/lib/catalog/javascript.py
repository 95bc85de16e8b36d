"""The JavaScript parts: the twin in the npm package, its types and its module in WebAssembly, and the playground."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from base.pieces import is_deleted
from base.tree import ROOT
from catalog.grid import in_camel_case
from catalog.model import Catalog, Function, Noise, Sum, read
from catalog.tables.functions import STRENGTHS
from catalog.tables.markdown import table
from catalog.tables.markdown import with_section as with_table

PAGE = "docs/guide/javascript.md"
PLAYGROUND = ROOT / "playground" / "catalog.js"
MOST_DIMENSIONS = 3  # of the twin
MOST_BYTES = 52_000  # of its module
PARTS = ("jitter", "metric")  # the options of a noise of the twin beside a seed and a period; it has no phases
NUMBERS = ("seed", "period", "jitter", "octaves", "lacunarity", "gain")


def literal(value: Any) -> str:
    if isinstance(value, Mapping):
        return f"{{ {', '.join(f'{key}: {literal(one)}' for key, one in value.items())} }}"
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(literal, value))}]"
    return json.dumps(value)


def rows(values: Mapping[str, Any], indent: str = "  ") -> str:
    return "".join(f"{indent}{name}: {literal(value)},\n" for name, value in values.items())


def listed(names: Sequence[object]) -> str:
    """a, b and c"""
    *others, last = map(str, names)
    return f"{', '.join(others)} and {last}" if others else last


def code(names: Sequence[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


def in_quotes(names: Sequence[str]) -> str:
    return ", ".join(f'"{name}"' for name in names)


def dimensions_of(function: Function, most: int) -> list[int]:
    return [number for number in range(1, most + 1) if function.is_in(number)]


# ---------------------------------------------------------------------------------------------------------------------
# The npm package.


class Twin:
    """The twin's tables."""

    def __init__(self, catalog: Catalog) -> None:
        self.noises = [noise for noise in catalog.noises if noise.small and noise.first <= MOST_DIMENSIONS]
        # There would be kernels for its own noises.
        self.sums = [sum_ for sum_ in catalog.sums if sum_.first <= MOST_DIMENSIONS and sum_.takes_noise]
        self.absent = [function for function in (*catalog.noises, *catalog.sums)
                       if function not in (*self.noises, *self.sums)]
        self.metrics = catalog.metrics
        self.settings = catalog.settings

    def owners(self, option: str) -> list[str]:
        """The noises that have a jitter or a metric, and the sums that have a strength or an amplitude."""
        if option in STRENGTHS:
            return [sum_.name for sum_ in self.sums if sum_.strength and sum_.strength.name == option]
        return [noise.name for noise in self.noises if option in noise.options]

    def default(self, setting: str) -> str:
        return literal(self.settings[setting].default)


def parts_of(noise: Noise) -> list[str]:
    return [part for part in PARTS if part in noise.options]


def constants(twin: Twin) -> str:
    """The constants of index.js."""
    def of_noise(noise: Noise) -> dict[str, Any]:
        return {"dimensions": dimensions_of(noise, MOST_DIMENSIONS), "shape": noise.shape, "takes": parts_of(noise)}

    def of_sum(sum_: Sum) -> dict[str, Any]:
        strength = sum_.strength
        return {"dimensions": dimensions_of(sum_, MOST_DIMENSIONS), "shape": sum_.shape, "noise": sum_.noise,
                **({"strength": strength.name, "usual": strength.default, "most": strength.most} if strength else {})}

    def of_number(name: str) -> dict[str, Any]:
        setting = twin.settings[name]
        ends = {"least": setting.least, "most": setting.most}
        return {"usual": setting.default, **{end: value for end, value in ends.items() if value is not None}}

    def have(option: str) -> str:
        owners = twin.owners(option)
        return f"{listed(owners)} {'have' if len(owners) > 1 else 'has'} one"

    return "".join([
        "const NOISES = {\n", rows({noise.name: of_noise(noise) for noise in twin.noises}), "};\n",
        "const FRACTALS = {\n", rows({sum_.name: of_sum(sum_) for sum_ in twin.sums}), "};\n",
        f"const METRICS = {literal(twin.metrics)};\n",
        "const NUMBERS = {\n", rows({name: of_number(name) for name in NUMBERS}), "};\n",
        "const OWNERS = {\n", rows({name: have(name) for name in (*STRENGTHS, *PARTS)}), "};\n"])


def types_of_settings(twin: Twin) -> str:
    """Members of Settings, with defaults and owners in their comments."""
    def member(name: str, type_: str, comment: str) -> str:
        return f"  /** {comment} */\n  {name}?: {type_};\n"

    def strength(name: str, unit: str = "") -> str:
        owners = {sum_.name: sum_.strength for sum_ in twin.sums if sum_.strength and sum_.strength.name == name}

        def each(values: Sequence[float]) -> str:
            return str(values[0]) if len(set(values)) == 1 else listed(values)

        return (f"For {listed(list(owners))}{unit}: from 0 to {each([one.most for one in owners.values()])}; "
                f"{each([one.default for one in owners.values()])} if it is left out.")

    jitter, octaves = twin.settings["jitter"], twin.settings["octaves"]
    usual = list(dict.fromkeys(sum_.noise for sum_ in twin.sums))
    return "".join([
        member("noise", "NoiseName", f'"perlin" if it is left out, and of fractals what the shader\'s take: '
                                     f'{in_quotes(usual[:-1])} or "{usual[-1]}".'),
        member("octaves", "number", f"For fractals: from {octaves.least} to {octaves.most}; {twin.default('octaves')} if "
                                    "they are left out."),
        *(member(name, "number", f"For fractals: from 0 to {most}; {twin.default(name)} if it is left out.")
          for name, most in (("lacunarity", "255, and a whole number from 1 with a period"), ("gain", "1"))),
        member("strength", "number", strength("strength")),
        member("amplitude", "number", strength("amplitude", ", in cells")),
        member("jitter", "number", f"For {listed(twin.owners('jitter'))}: from {jitter.least} to {jitter.most}; "
                                   f"{twin.default('jitter')} if it is left out."),
        member("metric", "MetricName", f'For {listed(twin.owners("metric"))}; "{twin.metrics[0]}" if it is left out.')])


def types_of_names(twin: Twin) -> str:
    names = {"NoiseName": [noise.name for noise in twin.noises], "FractalName": [sum_.name for sum_ in twin.sums],
             "MetricName": twin.metrics}
    return "\n".join(f"export type {type_} =\n" + "\n".join(f'  | "{name}"' for name in of_type) + ";\n"
                     for type_, of_type in names.items())


def tables_of_module(twin: Twin) -> str:
    """The file that twin.cpp includes: the kernels of the noises, and the numbers of the sums."""
    calls = (", ".join([noise.name, *(f"settings.{part}" for part in parts_of(noise)), "seed"]) for noise in twin.noises)
    kernels = "".join(f"TWIN_NOISE({call}),\n" for call in calls)
    names = ", ".join(f"k{in_camel_case(sum_.name)}" for sum_ in twin.sums)
    return f"template <int D>\nconst Kernel<D> kNoises[] = {{\n{kernels}}};\nenum Sum {{ {names} }};\n"


def settings_of_page(twin: Twin) -> str:
    """The table in docs/guide/javascript.md, and the noises that the twin lacks."""
    def by_dimensions(functions: Sequence[Function]) -> str:
        line = code([function.name for function in functions if function.is_in(1)])
        return f"{line}; in 2D and 3D {code([function.name for function in functions if not function.is_in(1)])}"

    def strengths(name: str) -> str:
        values = [sum_.strength.default for sum_ in twin.sums if sum_.strength and sum_.strength.name == name]
        return ", ".join(map(literal, values if len(set(values)) > 1 else values[:1]))

    jitter, octaves = twin.settings["jitter"], twin.settings["octaves"]
    return table(("setting", "of", "if it is left out"), [
        ("`noise`", by_dimensions(twin.noises), '`"perlin"`; of fractals as in the shader'),
        ("`fractal`", by_dimensions(twin.sums), "none"),
        ("`seed`", f"all; 0 to 2^{int(twin.settings['seed'].most).bit_length()} - 1", twin.default("seed")),
        ("`period`", "all; cells, a number or one for each axis; 0 for none", "none"),
        ("`octaves`, `lacunarity`, `gain`", f"fractals; octaves from {octaves.least} to {octaves.most}, lacunarity to 255 (whole with a "
         "period), gain to 1", ", ".join(map(twin.default, ("octaves", "lacunarity", "gain")))),
        ("`strength`; `amplitude`", "; ".join(code(twin.owners(name)) for name in STRENGTHS),
         "; ".join(map(strengths, STRENGTHS))),
        ("`jitter`", f"{code(twin.owners('jitter'))}; {jitter.least} to {jitter.most}", twin.default("jitter")),
        ("`metric`", f"{code(twin.owners('metric'))}; " + ", ".join(f'`"{name}"`' for name in twin.metrics),
         f'`"{twin.metrics[0]}"`')])


def page(twin: Twin) -> str:
    text = (ROOT / PAGE).read_text(encoding="utf-8")
    text = with_table(PAGE, text, "tools/make catalog: settings", settings_of_page(twin))
    absent = code([function.name for function in twin.absent])
    return with_table(PAGE, text, "tools/make catalog: noises that are not there",
                      f"Noises that did not fit into {MOST_BYTES // 1000} kB: {absent}.\n")


def as_packed(text: str) -> str:
    """A file of packages/npm/src as the package has it: with what stands behind lines such as `// tools/pack npm: names`."""
    twin = Twin(read())
    parts = {"constants": constants, "settings": types_of_settings, "names": types_of_names}
    return re.sub(r"^ *// tools/pack npm: (\w+)\n", lambda line: line[0] + parts[line[1]](twin), text, flags=re.MULTILINE)


# ---------------------------------------------------------------------------------------------------------------------
# The playground. The page has to stay small, so false and missing options are left out.


def drawn(catalog: Catalog) -> tuple[list[Noise], list[Sum]]:
    """A function with slopes, or with a noise along each axis, is a form of the one without, and no picture of its own.
    For a wave there is no control, and of noises that nobody chooses there is no formula to show."""
    forms = [noise for noise in catalog.noises
             if "slopes" in noise.shape or noise.name.endswith("_vector") or "wave" in noise.options]
    return ([noise for noise in catalog.noises if noise not in forms],
            [sum_ for sum_ in catalog.sums if sum_.shape == "value" and sum_.takes_noise])


def shown(function: Function) -> str:
    """Its sentence, for a page that shows its dimensions elsewhere."""
    return function.about.replace(", {dimensions}", "").replace("`", "")


def may_draw(noise: Noise, option: str) -> bool:
    """Noise with points that go round is left out: at a phase of 0 it is not the noise without one. So are
    vectors: the page draws a component without a phase."""
    return option != "phase" or ("jitter" not in noise.options and noise.shape != "vector")


def playground(catalog: Catalog) -> str:
    steep = {noise.plain for noise in catalog.noises if noise.shape == "slopes"}

    def of_noise(noise: Noise) -> dict[str, Any]:
        return {"dimensions": dimensions_of(noise, 4), **{option: True for option in noise.options if may_draw(noise, option)},
                **({"steep": True} if noise.name in steep else {}),
                **({"range": noise.ranges["value"][0]} if "value" in noise.ranges else {}), "about": shown(noise)}

    def of_sum(sum_: Sum) -> dict[str, Any]:
        strength = {"strength": {"usual": sum_.strength.default, "most": sum_.strength.most}} if sum_.strength else {}
        return {"dimensions": dimensions_of(sum_, 4), **strength, **({"steep": True} if sum_.of == "slopes" else {}),
                **({"step": step} if (step := sum_.step_of_loops.removeprefix("hn_add").removeprefix("_")) else {}),
                **({"mean": sum_.mean} if sum_.mean else {}),
                **({"range": sum_.range} if sum_.range == (0, 1) else {}), "about": shown(sum_)}

    noises, sums = drawn(catalog)
    return "".join([
        "// Made by tools/make catalog. A steep noise has slopes, and a steep sum needs them.\n",
        "export const kCatalog = {\n", "  noises: {\n",
        rows({noise.name: of_noise(noise) for noise in noises}, "    "), "  },\n", "  sums: {\n",
        rows({sum_.name: of_sum(sum_) for sum_ in sums}, "    "), "  },\n", f"  metrics: {literal(catalog.metrics)},\n", "  settings: {\n",
        rows({name: f"{catalog.settings[name].about.capitalize()}." for name in (*NUMBERS, "phase")}, "    "), "  },\n", "};\n"])


def files(catalog: Catalog) -> dict[Path, str]:
    of_package = {} if is_deleted("npm") else {ROOT / PAGE: page(Twin(catalog))}
    return of_package if is_deleted("playground") else {**of_package, PLAYGROUND: playground(catalog)}
