"""Finds the scale and the factor with which a call of ours looks like one of theirs."""

from __future__ import annotations

import functools
import hashlib
import re
import subprocess
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from base.renderer import Renderer
from base.tree import ROOT
from catalog.tables.glsl import files_of
from catalog.tables.markdown import table
from measure import record as records
from measure.likeness.measure import Look, look
from measure.likeness.table import BILLOW, ROWS, UNKNOWN, Row
from translate.single_file.files import text

RECORD = ROOT / "docs" / "measured" / "results" / "llvmpipe" / "likeness.csv"
# Pages show these, so there is no copy of a library to name.
PORTS = dict.fromkeys(("unity", "quilez"), Path(__file__).with_name("ports.glsl"))
# A scale or a factor so near to 1 is left out: nobody sees it.
NEAR = 0.05
# So far may the deviation and the size of a port be from theirs: what was left out, and 1% for the places that are
# tried.
LIMIT = 0.06
# So far may the mean be, in deviations of theirs: a nearest distance is 0 here and there, and an offset would end that.
MEAN_LIMIT = 0.3
INCLUDE = re.compile(r'^\s*#include "(.*)"')
ON_THE_PAGE = {"seed": "seed", "sum": "octaves, lacunarity, gain", "amplitude": "amplitude"}


class Port(NamedTuple):
    """A row of the record."""
    id: str
    version: str  # of theirs
    theirs: Look
    ours: Look
    scale: float
    factor: float
    offset: float
    ported: Look  # ours with the page's settings


class Missing(LookupError):
    pass


# --- Their source -----------------------------------------------------------------------------------------------------


def source(path: Path) -> str:
    """GLSL without #version lines, and with the files that it includes."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        included = INCLUDE.match(line)
        if included:
            lines.append(source(path.parent / included[1]))
        elif not line.lstrip().startswith("#version"):
            lines.append(line)
    return "\n".join(lines)


def version(path: Path) -> str:
    """The commit of a file in a repository of git, or the name that git would give to its content."""
    if path not in PORTS.values():
        printed = subprocess.run(["git", "-C", path.parent, "log", "-1", "--format=%h of %cs", "HEAD"],
                                 capture_output=True, text=True, check=False)
        if printed.returncode == 0:
            return printed.stdout.strip()
    content = path.read_bytes()
    return f"blob {hashlib.sha1(b'blob %d%c' % (len(content), 0) + content).hexdigest()[:10]}"


# --- Calls ------------------------------------------------------------------------------------------------------------


def number(value: float) -> str:
    """As it is written on the page: with two digits behind the point, or nothing if it is near 1."""
    return "" if abs(round(value, 2) - 1.0) <= NEAR + 1e-9 else f"{value:.2f}"


def written(value: float) -> float:
    return float(number(value) or 1.0)


def filled(text_of_row: str, values: Mapping[str, str]) -> str:
    return re.sub(r"\{(\w+)\}", lambda name: values[name[1]], text_of_row)


def call(row: Row, scale: float = 1.0, factor: float = 1.0, offset: float = 0.0, **values: str) -> str:
    """Ours, with what differs from 1."""
    times, by = number(factor), number(scale)
    return filled(row.ours, {"p": f"{by} * p" if by else "p", "factor": f"{times} * " if times else "",
                             "offset": f"{offset:.2f} + " if abs(offset) >= 0.01 else "", **values})


def measured_call(row: Row, *numbers: float) -> str:
    expression = call(row, *numbers, seed="7u", sum=row.sum, amplitude=row.amplitude)
    expression = f"({expression}){row.part}" if row.part else expression
    return f"{row.statement}return {expression};" if row.statement else expression


def our_library(calls: str, axes: int) -> str:
    """The files of what is called, as all files take a second to compile."""
    names = re.findall(r"\bhn_\w+", calls)
    files = [file for name in names for file in files_of(name) if file.endswith(f"{axes}d.glsl")]
    return text(list(dict.fromkeys(files)), strip=True)


def our_source(row: Row, factors: Mapping[str, float]) -> str:
    """Of the library, and what stands before the call; factors: of the rows before, by id."""
    inner = f"{written(factors[row.inner])}" if row.inner else ""
    library = our_library(f"{row.statement} {row.ours} {row.before}", row.axes)
    return f"{library}\n{filled(row.before, {'inner': inner})}\n"


# --- The measurement --------------------------------------------------------------------------------------------------


Looker = Callable[[str, str, int], Look]  # of a source, an expression and a number of axes


def port(looker: Looker, row: Row, path: Path, factors: Mapping[str, float]) -> Port:
    def of_ours(*numbers: float) -> Look:
        return looker(our_source(row, factors), measured_call(row, *numbers), row.axes)

    file = path / row.file if row.file else path
    theirs, ours = looker(source(file), row.expression, row.axes), of_ours()
    scale = ours.size / theirs.size if "{p}" in row.ours else 1.0
    factor = theirs.deviation / ours.deviation if "{factor}" in row.ours else 1.0
    offset = theirs.mean - written(factor) * ours.mean if "{offset}" in row.ours else 0.0
    return Port(row.id, version(file), theirs, ours, scale, factor, offset, of_ours(scale, factor, offset))


def ports(paths: Mapping[str, Path], rows: Iterable[Row] = ROWS, tell: Callable[[Port], None] = lambda _: None,
          renderer: Renderer | None = None) -> list[Port]:
    """Of the peers at these paths."""
    looker = functools.cache(functools.partial(look, renderer or Renderer()))
    found: list[Port] = []
    for row in rows:
        if row.peer in paths:
            found.append(port(looker, row, paths[row.peer], {port.id: port.factor for port in found}))
            tell(found[-1])
    return found


def problems(found: Iterable[Port], limit: float = LIMIT) -> list[str]:
    """Of ports that do not look alike."""
    printed = []
    for each in found:
        for name, theirs, ours in (("deviation", each.theirs.deviation, each.ported.deviation),
                                   ("size", each.theirs.size, each.ported.size)):
            if not abs(ours / theirs - 1.0) <= limit:
                printed.append(f"{each.id}: the {name} of theirs is {theirs:.3f}, and of ours as ported {ours:.3f}")
        if not abs(each.ported.mean - each.theirs.mean) <= MEAN_LIMIT * each.theirs.deviation:
            printed.append(f"{each.id}: the mean of theirs is {each.theirs.mean:.3f}, and of ours as ported "
                        f"{each.ported.mean:.3f}")
    return printed


# --- The record -------------------------------------------------------------------------------------------------------

LOOKS = ("theirs", "ours", "ported")
COLUMNS = ("id", "version", "scale", "factor", "offset", *(f"{part} {name}" for part in LOOKS for name in Look._fields))


def write(found: Iterable[Port], path: Path) -> None:
    rows = []
    for each in found:
        numbers = (each.scale, each.factor, each.offset, *each.theirs, *each.ours, *each.ported)
        rows.append(dict(zip(COLUMNS, (each.id, each.version, *(f"{number + 0.0:.4f}" for number in numbers)))))
    records.write(path, rows, COLUMNS)


def read(path: Path = RECORD) -> dict[str, Port]:
    """By id."""
    def look_of(row: Mapping[str, str], part: str) -> Look:
        return Look(*(float(row[f"{part} {name}"]) for name in Look._fields))

    return {row["id"]: Port(row["id"], row["version"], *(look_of(row, part) for part in LOOKS[:2]),
                            *(float(row[name]) for name in ("scale", "factor", "offset")), look_of(row, LOOKS[2]))
            for row in records.read(path).rows}


# --- The page ---------------------------------------------------------------------------------------------------------


def moving_table(name: str, record: Mapping[str, Port], rows: Sequence[Row] = ROWS) -> str:
    """Their calls, and ours with the scale and the factor, where they are not near 1."""
    lines: dict[tuple[str, str, str], list[str]] = {}
    for row in rows:
        if row.table == name:
            if row.id not in record:
                raise Missing(f"likeness.csv has no row {row.id!r}: run tools/measure likeness")
            ours = call(row, record[row.id].scale, record[row.id].factor, record[row.id].offset, **ON_THE_PAGE)
            lines.setdefault((row.theirs, ours, _range(row, record)), []).append(f"{row.axes}D")
    # A column that would show nothing is left out.
    columns = [("theirs", [key[0] for key in lines]), ("", [", ".join(axes) for axes in lines.values()]),
               ("hashnoise", [f"`{key[1]}`" for key in lines]), ("range", [key[2] for key in lines])]
    columns = [(head, cells) for head, cells in columns
               if any(cells) and not (head == "" and all("vec" in key[0] for key in lines))]
    return table([head for head, _ in columns], list(zip(*(cells for _, cells in columns))))


def blender_table(record: Mapping[str, Port]) -> str:
    """OSL and Blender have the Perlin noise of MaterialX."""
    plane, space = (record[f"MaterialX: mx_perlin_noise_float(vec{axes} p) {axes}D"].factor for axes in (2, 3))
    return table(("OSL or Blender", "hashnoise"), [
        ['OSL\'s `noise(p)`, `noise("uperlin", p)`', f"`0.5 + {space / 2:.2f} * hn_perlin(p, seed)`"],
        ["Noise Texture, fBM, normalized", f"`0.5 + {space / 2:.2f} * hn_fbm(p, detail + 1.0, lacunarity, roughness, seed)`; "
                                           f"in 2D {plane / 2:.2f}"],
        ["the same, not normalized", f"`{space:.2f} * hn_fbm(...)` times the sum of `roughness^i`; in 2D {plane:.2f}"],
        ["its Distortion", f"`p += distortion * {space:.2f} * hn_perlin_vector(p, seed)` before the call"]])


def ends(row: Row, record: Mapping[str, Port]) -> tuple[float, float]:
    """The range of ours with its factor."""
    found, (low, high) = record[row.id], row.range
    if row.range == BILLOW:
        low = 1.0 - 2.0 * written(record[row.inner].factor)
    offset = round(found.offset, 2) if "{offset}" in row.ours else 0.0
    return written(found.factor) * low + offset, written(found.factor) * high + offset


def _range(row: Row, record: Mapping[str, Port]) -> str:
    return "" if row.range == UNKNOWN else "[{:.3g}, {:.3g}]".format(*ends(row, record))


def page_tables(record: Mapping[str, Port]) -> list[tuple[str, str]]:
    """The tables of docs/guide/moving.md, by the names of their marks."""
    names = dict.fromkeys(row.table for row in ROWS)
    return [*((f"tools/make readme: {name}", moving_table(name, record)) for name in names),
            ("tools/make readme: OSL and Blender", blender_table(record))]
