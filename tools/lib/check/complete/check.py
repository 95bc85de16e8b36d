"""Whether every function, noise, hash and setting has all of its entries. A missing one is reported with its place."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterator
from pathlib import Path

import catalog.model
from base.golden_values import head_of
from base.tree import BOUNDS, GLSL, GOLDEN, ROOT, glsl_files
from catalog.popular import snippets
from catalog.tables import glsl
from catalog.tables.configurations import Configuration, read_configurations
from catalog.tables.functions import NOISES, Function, read_functions
from proof.bounds import table
from proof.golden.files import golden_files
from proof.oracle import hashes
from proof.oracle import noises as oracle

ROWS, SETTINGS = "catalog/functions.toml", "catalog/configurations.toml"
KNOBS = "docs/reference/knobs.md"
SNIPPETS = "docs/reference/snippets"
SAME_BITS = "docs/guide/same-bits.md"
OTHERS = ("docs/guide/uniform.md", "docs/guide/random.md")  # have tables of functions, and so has a section of the page of noises
OF_NOISES, OTHER_FUNCTIONS = "docs/reference/noises.md", "\n## Other functions\n"
OF_DERIVATIVES = "docs/reference/noises.md"  # whose table has what returns the derivatives of vectors
ORACLE = "tools/lib/proof/oracle/noises"
OF_A_NOISE = {"error", "cost"}  # in each comment; and in one of its comments
OF_A_NOISE_ONCE = OF_A_NOISE | {"returns", "period", "source"}


class Tree:
    """The repository, or a copy of it."""

    def __init__(self, root: Path = ROOT) -> None:
        self.root = root
        self.functions = read_functions(root / "catalog")
        self.configurations = read_configurations(root / "catalog")
        self.config = self.text("glsl/hashnoise/config.glsl")
        self.declarations = glsl.declarations(self.at(GLSL))

    def at(self, path: Path) -> Path:
        return self.root / path.relative_to(ROOT)

    def text(self, path: str) -> str:
        return (self.root / path).read_text(encoding="utf-8")

    @property
    def noises(self) -> list[Function]:
        return [function for function in self.functions if function.family in NOISES]


def lacks(function: Function, what: str) -> str:
    return str(function.error(what))


# Functions that make places, their positions, and octaves. They have no values of their own: the rows of noises and
# sums prove them.
STEPS = re.compile(r"hn_(place|tile|position|octaves|next|add|add_\w+|mean|density|slopes|shifts|flows)")


# --- Functions --------------------------------------------------------------------------------------------------


def functions_without_a_row(tree: Tree) -> Iterator[str]:
    rows = {(function.calls, types) for function in tree.functions for types in function.overloads}
    known = {configuration.hash for configuration in tree.configurations}
    # On the line and in 4D a sum is made of the text on the plane, and every form of it has a row. So there it is
    # enough that one form has a row.
    sums = {(declared.path, declared.name) for declared in tree.declarations
            if (declared.name, declared.types) in rows and declared.dimensions_of_sums in (1, 4)}
    for declared in tree.declarations:
        if (declared.path, declared.name) in sums or STEPS.fullmatch(declared.name):
            continue
        if (declared.name, declared.types) in rows:
            continue
        if declared.name.startswith("hn_hash_") and declared.types == ("uint",):
            name = declared.name.removeprefix("hn_hash_")
            if name not in known:
                yield (f"{declared.place}: {declared} is the hash of no configuration: add {name} to the hashes of "
                       f"{SETTINGS}, or a row that calls it to {ROWS}")
        else:
            yield (f"{declared.place}: {declared} has no row: give it an entry in catalog/noises.toml or sums.toml, or add a "
                   f"row that calls it to {ROWS}")


def functions_in_another_form(tree: Tree) -> Iterator[str]:
    for function in glsl.overlooked(tree.at(GLSL)):
        yield (f"{function} is not written as the tools read public functions: begin its first line with HN_FN, then "
               "its type, one word, and its name")


def rows_without_a_function(tree: Tree) -> Iterator[str]:
    declared = {(declaration.name, declaration.types) for declaration in tree.declarations}
    for function in tree.functions:
        for types in function.overloads:
            if (function.calls, types) not in declared:
                yield lacks(function, f"declare {function.calls}({', '.join(types)}) in {GLSL.name}/, unless "
                            "tools/make catalog and tools/make dimensions write it")


def functions_without_words(tree: Tree) -> Iterator[str]:
    """In the comments of the library, in the README or a page that its table leaves them to, and in the contract."""
    functions = tree.text("README.md").partition("\n## Functions\n")[2].partition("\n- ")[0]
    others = tree.text(OF_NOISES).partition(OTHER_FUNCTIONS)[2].partition("\n## ")[0]
    tables = "\n".join([functions, others, *map(tree.text, OTHERS)])
    first_cells = [line.split(" | ")[0] for line in tables.split("\n") if line.startswith("|")]
    first_cells += [line.split(" | ")[0] for line in tree.text(OF_DERIVATIVES).split("\n") if "`hn_derivatives" in line]
    contract = tree.text("docs/reference/contract.md")
    for declared in tree.declarations:
        if not declared.comment or "returns" not in declared.comment.headings:
            yield f"{declared.place}: {declared} has no comment on what it returns: write one over it"
        elif "example" not in declared.comment.headings:
            yield f"{declared.place}: the comment over {declared} has no line `example`: add a call, before what it returns"
    for name in sorted({function.calls for function in tree.functions}):
        if not any(is_named(name, cell) for cell in first_cells):
            yield f"README.md: no line for {name}: add one to the table of functions, or to that of {' or '.join((OF_NOISES, *OTHERS))}"
        if not re.search(rf"`{name}\b", contract):
            yield f"docs/reference/contract.md: no word of {name}(...): state what its value is"


def arguments_without_words(tree: Tree) -> Iterator[str]:
    """docs/guide/same-bits.md lists the floats that are the same everywhere. It treats positions and fractions before."""
    said = tree.text(SAME_BITS).partition("\n## The other arguments\n")[2].partition("\n## ")[0].lower()
    told = set()
    for declared in tree.declarations:
        for type_, name in zip(declared.types, declared.arguments, strict=True):
            is_float = re.fullmatch("float|vec[234]", type_) and name not in ("p", "f")
            if is_float and name not in told and not re.search(rf"\b{name}\b", said):
                told.add(name)
                yield f"{declared.place}: {declared} takes {name}, which {SAME_BITS} does not name: name it there"


def is_named(name: str, cell: str) -> bool:
    """Whether a cell of a table has it, alone or in a series: `hn_gradient1(h)` to `hn_gradient4(h)`."""
    series = re.search(r"`(\w+?)(\d)\(.*` to `\1(\d)\(", cell)
    return f"`{name}(" in cell or f"`{name}`" in cell or (series is not None and
                                   name in {f"{series[1]}{i}" for i in range(int(series[2]), int(series[3]) + 1)})


# --- Noises -----------------------------------------------------------------------------------------------------


def noises_without_entries(tree: Tree) -> Iterator[str]:
    bounds = {(row.noise, row.dimensions) for row in table.read(tree.at(BOUNDS))}
    contract = tree.text("docs/reference/contract.md")
    for function in tree.noises:
        noise = function.bound
        if noise not in oracle.names():
            yield lacks(function, f"write in {ORACLE} its exact and its fixed value, from docs/reference/contract.md")
        if (noise, function.axes) not in bounds:
            yield lacks(function, f"{BOUNDS.relative_to(ROOT)} has no {noise} in {function.axes}D: "
                        "run tools/make bounds, which has its range proven in tools/lib/proof/bounds/noises")
        if not re.search(rf"`{function.calls}`[^.]* (?:takes positions of|have the forms of)", contract):
            yield lacks(function, f"state in docs/reference/contract.md that `{function.calls}` takes positions of "
                        f"{function.axes} dimensions, and what its value is")


def of_sum(sum_: catalog.model.Sum) -> Iterator[tuple[str, str, str]]:
    """The parts of the oracle: the file, a mark in it, and the content."""
    module = "sums" if sum_.is_of_values else "jacobians"  # with slopes, or of vectors
    yield (f"tools/lib/proof/oracle/{module}.py", f'"{sum_.name}": ',
           "its exact and its fixed value, from docs/reference/contract.md")


def sums_without_entries(tree: Tree) -> Iterator[str]:
    for sum_ in catalog.model.read(tree.root / "catalog").sums:
        for file, mark, what in of_sum(sum_) if sum_.takes_noise else ():
            if mark not in tree.text(file):
                yield f"catalog/sums.toml: {sum_.name}: write in {file} {what}"


def noises_without_comments(tree: Tree) -> Iterator[str]:
    noises = {function.calls: function.bound for function in tree.noises}
    headings: dict[Path, set[str]] = {}
    for declared in tree.declarations:
        if declared.name in noises and declared.comment:
            headings.setdefault(declared.path, set()).update(declared.comment.headings)
            for heading in sorted(OF_A_NOISE - declared.comment.headings):
                yield f"{declared.path}:{declared.comment.line}: the comment over {declared} has no line `{heading}`"
    for path, found in headings.items():
        for heading in sorted(OF_A_NOISE_ONCE - found):
            yield f"{path}: no comment over its functions has a line `{heading}`"


def files_without_a_text_to_read(tree: Tree) -> Iterator[str]:
    """The header of a file names the picked text of one of its functions, if docs/reference/snippets has any."""
    wanted: dict[Path, set[str]] = {}
    for declared in tree.declarations:
        if "phase" not in declared.arguments and (snippet := f"{declared.name}{declared.path.stem[-2]}") in snippets():
            wanted.setdefault(declared.path, set()).add(snippet)
    for path, names in wanted.items():
        lines = {f"// To read it in one piece: {SNIPPETS}/{name}.md" for name in sorted(names)}
        if not lines & {*tree.text(str(path)).partition("\n\n")[0].splitlines()}:
            yield f"{path}: its header has no line `{min(lines)}`: write it above the license"


def entries_without_a_noise(tree: Tree) -> Iterator[str]:
    noises = {function.bound for function in tree.noises}
    # Functions built on noise are not of a family of noises: hn_curl is not. Vectors with derivatives have bounds of
    # their components, under their name.
    known = noises | {function.bound for function in tree.functions} | {
        function.calls.removeprefix("hn_") for function in tree.functions if function.component is not None}
    for place, names in ((ORACLE, oracle.names()), (
            BOUNDS.relative_to(ROOT), {row.noise: None for row in table.read(tree.at(BOUNDS))})):
        for name in names:
            if name not in known:
                yield f"{place}: no function is the noise {name}: give it an entry in catalog/, or delete its own"


# --- Settings ---------------------------------------------------------------------------------------------------


def further_values_of_nothing(tree: Tree) -> Iterator[str]:
    """A function that has values with a setting besides is there, and not of one of its families."""
    functions = {function.id: function for function in tree.functions}
    for configuration in tree.configurations:
        for id_ in configuration.further:
            if id_ not in functions:
                yield f"{SETTINGS}: there is no function {id_}: name another, or take it away"
            elif functions[id_].family in configuration.families:
                yield (f"{SETTINGS}: {id_} has values with {configuration.name} as all of {functions[id_].family} have: "
                       "take it away")


def knobs_without_entries(tree: Tree) -> Iterator[str]:
    """A knob is a macro of config.glsl with a default."""
    header = tree.text("include/hashnoise/hashnoise.hpp")
    table_of_knobs = tree.text(KNOBS).partition("| knob |")[2].partition("\n\n")[0]
    fields = {field.name for field in dataclasses.fields(Configuration)}
    for knob in knobs_of(tree.config):
        field = knob.removeprefix("HN_").lower()
        if not re.search(rf"inline namespace HN_I_PASTE\(\w+, {knob}\)", header):
            yield (f"include/hashnoise/hashnoise.hpp: {knob} names no inline namespace: add inline namespace "
                   f"HN_I_PASTE({field}_, {knob}), so that settings can be linked together")
        if f"| `{knob}` |" not in table_of_knobs:
            yield f"{KNOBS}: no line for {knob}: add one to the table of knobs"
        if field not in fields:
            yield f"tools/lib/catalog/tables/configurations.py: {knob} is not in Configuration: add {field}"


def knobs_of(config: str) -> list[str]:
    defaults = set(re.findall(r"^#define (HN_(?!I_)\w+) +[^\s/]", config, re.MULTILINE))
    return [name for name in re.findall(r"^#ifndef (\w+)", config, re.MULTILINE) if name in defaults]


def values_without_settings(tree: Tree) -> Iterator[str]:
    """A value of a knob has its name in front, as HN_GRADIENT_SINE, or is an arithmetic. Hashes have more entries."""
    knobs = knobs_of(tree.config)
    numbers = re.findall(r"^#define (HN_(?!I_|HASH_|VERSION_)\w+) \d+\b", tree.config, re.MULTILINE)
    for name in (name for name in numbers if name not in knobs):
        knob = next((knob for knob in knobs if name.startswith(f"{knob}_")), None)
        field = (knob or "HN_ARITHMETIC").removeprefix("HN_").lower()
        word = name.removeprefix(f"{knob}_" if knob else "HN_")
        if not any(getattr(configuration, field, None) == word.lower() for configuration in tree.configurations):
            yield f"{SETTINGS}: {name} is under test nowhere: add a group with {word.lower()} as its {field}"


def hashes_without_entries(tree: Tree) -> Iterator[str]:
    contract, page = tree.text("docs/reference/contract.md"), tree.text(KNOBS)
    for name in re.findall(r"^#define HN_HASH_(\w+) \d+\b", tree.config, re.MULTILINE):
        macro, word = f"HN_HASH_{name}", name.lower()
        if not any(_is_plain(configuration, word) for configuration in tree.configurations):
            yield f"{SETTINGS}: {macro} is under test with no default gradient: add {word} to the hashes of fast"
        if word not in hashes.HASHES:
            yield f"tools/lib/proof/oracle/hashes.py: {macro} is not among the hashes: add it from docs/reference/contract.md"
        if f"| `{name}`" not in contract:
            yield f"docs/reference/contract.md: no line for {macro}: add one to its table of hashes"
        if f"`{macro}`" not in page:
            yield f"{KNOBS}: the knob HN_HASH does not offer {macro}: add it to its line"


def _is_plain(configuration: Configuration, hash: str) -> bool:
    return configuration.name == hash and "hash" in configuration.families


def missing_golden_values(tree: Tree) -> Iterator[str]:
    for file in golden_files(tree.functions, tree.configurations):
        path = tree.at(GOLDEN) / file.name
        there = head_of(path).settings if path.is_file() else []
        if missing := [values.name for values in file.values if values.name not in there]:
            yield f"{path}: {file.function.id} has no golden values with {', '.join(missing)}: run tools/make golden"


def names_of_two_kinds(tree: Tree) -> Iterator[str]:
    """Whoever includes the file with the macro first would read another text in that with the function."""
    macros: dict[str, str] = {}
    functions: set[str] = set()
    for path in glsl_files(tree.at(GLSL)).values():
        text = path.read_text()
        for match in re.finditer(r"^[ \t]*#[ \t]*define (hn_\w+)", text, re.MULTILINE):
            macros[match[1]] = f"{path}:{text.count(chr(10), 0, match.start()) + 1}"
        functions |= set(re.findall(r"^HN_FN \w+ (hn_\w+)\(", text, re.MULTILINE))
    for name in sorted(functions & macros.keys()):
        yield f"{macros[name]}: {name} is also a function: give the macro another name"


PAGES = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "llms.txt", "docs/*/*.md", "docs/guide/gallery/*.md", "examples/**/*.md",
         "packages/*/README.md")
OF_THE_INSIDE = {"adding", "frozen", "glossary", "internals", "one-noise", "release"}  # pages for who changes the library


def internal_names_in_pages(tree: Tree) -> Iterator[str]:
    """Pages and messages name no function that may be renamed tomorrow."""
    for path in (path for pages in PAGES for path in sorted(tree.root.glob(pages))):
        if path.stem in OF_THE_INSIDE:
            continue
        # But for the example of a proof, which quotes the lines that round.
        page = re.sub(r"(?s)(?<=<!-- tools/make bounds: example -->).*?(?=<!-- end -->)", lambda made: "\n" * made[0].count("\n"),
                      path.read_text(encoding="utf-8"))
        for match in re.finditer(r"\bhn_i_\w*|\bHN_I_\w*", page):
            yield (f"{path}:{page.count(chr(10), 0, match.start()) + 1}: {match[0]} is internal: recommend a public "
                   "function, or publish one")


CHECKS = (functions_without_a_row, functions_in_another_form, rows_without_a_function, functions_without_words,
          arguments_without_words, noises_without_entries, sums_without_entries, noises_without_comments,
          files_without_a_text_to_read, entries_without_a_noise,
          further_values_of_nothing, knobs_without_entries, values_without_settings, hashes_without_entries,
          missing_golden_values, names_of_two_kinds, internal_names_in_pages)


def problems(root: Path = ROOT) -> list[str]:
    tree = Tree(root)
    return [message.replace(f"{root}/", "") for check in CHECKS for message in check(tree)]
