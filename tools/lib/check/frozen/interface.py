"""The table of the interface, conformance/expected/interface.csv: names, parameters, defaults, nodes and bounds, which
stay from 1.0 on. They are read from the texts that have them. docs/reference/frozen.md describes the promise."""

from __future__ import annotations

import ast
import csv
import importlib
import io
import json
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from base.pieces import PIECES, is_deleted
from base.tree import BOUNDS, GLSL, ROOT, TOOLS, glsl_files
from catalog import javascript as of_javascript
from catalog import model
from catalog.tables.functions import read_functions
from catalog.tables.glsl import declarations
from ship import hlsl_nodes
from translate.parsing.syntax import Parameter
from translate.pick.command import Choice, read_library

COLUMNS = ("kind", "name", "what")
BOUND, RANGE = "bound", "range"
# Rows of what was deleted do not count. These kinds, and one name, are not called as the piece is.
OF_PIECES = {"javascript": "npm", "arithmetic of tools/bake": "baker"}
DELETED = {name for name in PIECES if is_deleted(name)}
OF_VALUES = BOUND, RANGE  # kinds of rows that experimental functions have not
MEMBERS = {"hn_place": ("cell",), "hn_octaves": ("place", "seed"), "hn_slopes": (), "hn_shifts": (), "hn_flows": ()}  # else all
CONSTANT = re.compile(r"^ *#define (HN_(?:METRIC|DISTRIBUTION|HASH|GRADIENT|ARITHMETIC|FAST|PRECISE|FIXED)\w*) +(\w+)",
                      re.M)
STRUCT_OF_CPP = re.compile(r"^struct (Settings|(?:Cell)?(?:Grid|Points)|Range) \{\n(.*?)^\};", re.M | re.S)
MEMBER_OF_CPP = re.compile(r"^  ([^\n()]+?) (\w+)(\{\}| = [^;]+)?;", re.M)
ENUM_OF_CPP = re.compile(r"^enum class (\w+) \{ (.*) \};", re.M)
OF_JAVASCRIPT = re.compile(r"^export (?:interface|declare class) (\w+) \{(.*?)^\}", re.M | re.S)
OPTIONAL = re.compile(r"(?:; |(?<=[({]))(\w+\?: [^;,(){}]+)(?=[;)}])")  # a member, or the last parameter
BOUNDS_OF = re.compile(r'^(\w+)_BOUNDS\((?:"(\w+)", (\d, \w+), )?(.+)\)$', re.M)
TABLES_OF_BOUNDS = re.compile(r"<!-- tools/make bounds: (?:sums|Jacobians) -->(?:\n[^\n]*){2}\n(.*?)<!-- end -->", re.S)
PACKAGE = ("packages", "python", "hashnoise")
# In the row of hn_uniform, the numbers that belong to hn_distribution_fbm.
OF_DISTRIBUTIONS = (2, 3, 6, 7)

Key = tuple[str, str]  # a kind and a name
Row = tuple[str, str, str]
Rows = dict[Key, str]


def text_at(*path: str) -> str:
    return ROOT.joinpath(*path).read_text(encoding="utf-8")


def of_parameter(one: Parameter) -> str:
    return ("out " if one.is_set else "") + one.type.removeprefix("hn_")


def shaders() -> Iterator[Row]:
    """Functions, and those that languages without overloads have, by the names there."""
    library = read_library(GLSL, Choice("glsl", "fixed"))
    yield from (("function", str(function), "") for function in declarations())
    for form, of in library.forms.items():
        yield "form", form, f"{of.type.removeprefix('hn_')} {of.name}({', '.join(map(of_parameter, of.parameters))})"
    for name, struct in library.structs.items():
        if not name.startswith("hn_i_"):
            fields = MEMBERS.get(name.rstrip("1234"), [field for field, _, _ in struct.fields])
            yield "struct", name, ""
            yield from (("struct", f"{name}.{field}", type_) for field, type_, _ in struct.fields if field in fields)
    yield from (("file", path.name, "") for path in GLSL.iterdir() if path.is_file())
    for path in glsl_files().values():
        yield from (("constant", *found) for found in CONSTANT.findall(path.read_text(encoding="utf-8")))


def catalog() -> Iterator[Row]:
    of = model.read()
    for function in (*of.noises, *of.sums):
        kind = "fractal" if isinstance(function, model.Sum) else "noise"
        yield from ((kind, f"{function.name} {n}D", function.shape) for n in range(function.first, function.last + 1))
    for noise in of.noises:
        yield from ((RANGE, f"{noise.name} {n}D, {component}", f"{pair[0]} {pair[1]}")
                    for component, pairs in noise.all_ranges.items()
                    for n, pair in enumerate(pairs, noise.first) if pair)
    for sum_ in of.sums:
        yield RANGE, sum_.name, sum_.range if isinstance(sum_.range, str) else f"{sum_.range[0]} {sum_.range[1]}"
        if sum_.noise:
            yield "default", f"noise of {sum_.name}", sum_.noise
        if sum_.strength:
            yield "default", f"{sum_.strength.name} of {sum_.name}", str(sum_.strength.default)
    yield from (("default", one.name, str(one.default)) for one in of.settings.values() if one.default is not None)
    yield from (("metric", name, str(number)) for number, name in enumerate(of.metrics, 1))
    yield "default", "metric", of.metrics[0]
    # The catalog does not have these two.
    yield from (("default", "wave", f"{found} along x")
                for found in re.findall(r"\boptions\.wave\[0\] = ([\d.]+)f;", text_at("src", "grid", "plan.cpp")))
    if not is_deleted("baker"):
        yield from (("default", "arithmetic of tools/bake", found)
                    for found in re.findall(r'"arithmetic": "(\w+)"', text_at(*PACKAGE, "_bake.py")))


def cpp() -> Iterator[Row]:
    """Members in their order, with their defaults."""
    for file in ("points.hpp", "field.hpp", "detail/types_of_glsl.hpp"):
        text = re.sub("//.*", "", text_at("include", "hashnoise", file))
        yield from (("c++", macro, "") for macro in re.findall(r"^#define (HN_ONLY\w+)", text, re.M))
        for name, body in STRUCT_OF_CPP.findall(text):
            for number, (type_, member, usual) in enumerate(MEMBER_OF_CPP.findall(body), 1):
                yield "c++", f"{name}.{member}", f"{number}: {type_}{usual.removesuffix('{}')}"
        for name, body in ENUM_OF_CPP.findall(text):
            for number, one in enumerate(body.split(", "), 1):
                yield "c++", f"{name}.{one.split(' ')[0]}", f"{number}: {one}"


def python() -> Iterator[Row]:
    """Parameters: their place, unless they are passed by name alone, and their default, of the first overload."""
    for module in () if is_deleted("python") else ("__init__", "dask"):
        prefix = "" if module == "__init__" else f"{module}."
        for function in ast.parse(text_at(*PACKAGE, f"{module}.pyi")).body:
            if isinstance(function, ast.FunctionDef):
                of = function.args
                ordered = [*of.posonlyargs, *of.args]
                usual = [*[None] * (len(ordered) - len(of.defaults)), *of.defaults, *of.kw_defaults]
                for number, (one, value) in enumerate(zip([*ordered, *of.kwonlyargs], usual), 1):
                    place = [str(number)] if number <= len(ordered) else []
                    default = [f"default {ast.unparse(value)}"] if value else []
                    yield "python", f"{prefix}{function.name}.{one.arg}", ", ".join(place + default)


def javascript() -> Iterator[Row]:
    """The modules, and the declarations in these. The functions of WGSL and of TSL have the names of forms."""
    if is_deleted("npm"):
        return
    exports = json.loads(text_at("packages", "npm", "package.json"))["exports"]
    yield from (("javascript", f"hashnoise{path.removeprefix('.')}", "import") for path in exports)
    for path in sorted((ROOT / "packages" / "npm" / "src").rglob("*.d.ts")):
        text = re.sub(r"(?s)/\*.*?\*/|//[^\n]*", "", of_javascript.as_packed(path.read_text(encoding="utf-8")))
        yield from (("javascript", *found) for found in re.findall(r"^export declare function (\w+)(.*);$", text, re.M))
        for type_, names in re.findall(r"^export type (\w+) =([^;]+);", text, re.M):
            yield from (("javascript", f"{type_} {name}", "") for name in re.findall(r"\w+", names))
        for name, body in OF_JAVASCRIPT.findall(text):
            seen: Counter[str] = Counter()
            for line in re.sub(r"\s*\n    \s*|\n  (?=\))", " ", body).splitlines():
                if found := re.fullmatch(r"  (?:(static|readonly) )?(\w+)(.+);", line):
                    seen[found[2]] += 1
                    number = f" {seen[found[2]]}" if seen[found[2]] > 1 else ""  # of several of one name
                    yield "javascript", f"{name}.{found[2]}{number}", f"{found[1] or ''} {found[3]}".strip()


def packages() -> Iterator[Row]:
    """The nodes of engines' graphs, and what packages have by interface() of their files."""
    for form in hlsl_nodes.NODES:
        ports = ", ".join(" ".join(port) for port in hlsl_nodes.ports(form))
        for suffix in hlsl_nodes.ARITHMETICS.values():
            name = f"HashNoise{suffix}{hlsl_nodes.camel(form)}"
            yield "graph", name, ports
            yield "graph", f"{name}.Out", f"output {hlsl_nodes.PORTS[hlsl_nodes.forms()[form].type]}"
    for path in sorted((TOOLS / "lib" / "ship").glob("*/files.py")):
        module = importlib.import_module(f"ship.{path.parent.name}.files")
        yield from ((path.parent.name, *row) for row in getattr(module, "interface", list)())


def bounds() -> Iterator[Row]:
    for kind, noise, of, numbers in BOUNDS_OF.findall(BOUNDS.read_text(encoding="utf-8")):
        if kind == "UNIFORM":
            split = numbers.split(", ")
            rest = [split[i] for i in OF_DISTRIBUTIONS]
            yield BOUND, "hn_distribution_fbm", " ".join(rest)
            numbers = ", ".join(one for i, one in enumerate(split) if i not in OF_DISTRIBUTIONS)
        name = f"hn_{noise or kind.lower()}" + (f" {of}" if of else "") + (", slope" if kind == "SLOPE" else "")
        yield BOUND, name, numbers.replace(",", "")
    for table in TABLES_OF_BOUNDS.findall(text_at("docs", "measured", "accuracy.md")):
        for line in table.splitlines():
            name, *cells = (cell.strip() for cell in line.strip("|").split("|"))
            yield BOUND, name.replace("`", ""), " ".join(filter(None, cells))


def library() -> Rows:
    """All rows that the library has. Values of experimental functions may change, so their bounds and ranges are left
    out."""
    experimental = {function.calls for function in read_functions() if function.experimental}
    found: Rows = {}
    for part in (shaders, catalog, cpp, python, javascript, packages, bounds):
        for kind, name, what in part():
            if kind not in OF_VALUES or f"hn_{name.removeprefix('hn_').split(' ')[0]}" not in experimental:
                found.setdefault((kind, name), what)
    return found


def read(path: Path) -> Rows:
    rows = list(csv.reader(io.StringIO(path.read_text(encoding="utf-8"))))
    if rows[:1] != [[*COLUMNS]] or any(len(row) != len(COLUMNS) for row in rows):
        raise ValueError(f"{path}: line 1 has to be {','.join(COLUMNS)}, and each other line has as many fields")
    return {(kind, name): what for kind, name, what in rows[1:]}


def text_of(rows: Rows) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([COLUMNS, *((*key, what) for key, what in sorted(rows.items()))])
    return out.getvalue()


def without_added(was: str, now: str) -> str:
    """A call of JavaScript without the options that it did not have before."""
    now, was = (re.sub(r"(?<=[({]) |[;,]? (?=[)}])", "", one) for one in (now, was))
    return OPTIONAL.sub(lambda found: found[0] if found[1] in was else "", now)


def stays(kind: str, was: str, now: str | None) -> bool:
    """Whether what there is now is what there was, or a bound that is no larger, or a call with more options. A range
    stays, too: files of 16 bits are scaled by it, so a narrower one would change each of their numbers."""
    if was == now or now is None:
        return was == now
    if kind == "javascript":
        return without_added(was, now) == without_added(was, was)
    if kind != BOUND:
        return False
    try:
        before, after = ([float.fromhex(one) if "x" in one else float(one) for one in of.split()] for of in (was, now))
    except ValueError:
        return False
    return len(before) == len(after) and all(b <= a for a, b in zip(before, after))


def changed(table: Rows, rows: Rows) -> Iterator[str]:
    for (kind, name), was in sorted(table.items()):
        if OF_PIECES.get(name, OF_PIECES.get(kind, kind)) in DELETED:
            continue
        now = rows.get((kind, name))
        if not stays(kind, was, now):
            may = " (a bound may only become smaller)" if kind == BOUND else ""
            is_now = "gone" if now is None else now
            yield (f"{kind} {name}: it was {was or 'there'}, and is {is_now}. It stays from 1.0 on{may}: "
                   "restore it, or give what is new another name")


def stale(table: Rows, rows: Rows) -> Iterator[str]:
    """Rows that tools/make freeze writes: new ones, smaller bounds, and calls with more options."""
    for (kind, name), now in sorted(rows.items()):
        was = table.get((kind, name))
        if was is None or (was != now and stays(kind, was, now)):
            yield f"{kind} {name}: {'it has no row' if was is None else 'its row is older'}. Run tools/make freeze"
