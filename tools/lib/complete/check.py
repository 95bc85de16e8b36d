"""Whether every function, noise, hash and setting has all of its entries. What is missing is said with its place."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from bounds import table
from golden.files import golden_files
from oracle import words
from tables import glsl
from tables.configurations import ARITHMETICS, Configuration, read_configurations
from tables.functions import NOISES, Function, read_functions
from tree import BOUNDS, CONFIGURATIONS, FUNCTIONS, GLSL, GOLDEN, ROOT

ENTRIES = "tools/lib/{}/noises/{}.py"
OF_A_NOISE = {"returns", "error", "cost"}  # in each comment; and in one of its comments
OF_A_NOISE_ONCE = OF_A_NOISE | {"period", "source"}


class Tree:
    """The repository, or a copy of it."""

    def __init__(self, root: Path = ROOT) -> None:
        self.root = root
        self.functions = read_functions(self.at(FUNCTIONS))
        self.configurations = read_configurations(self.at(CONFIGURATIONS))
        self.declarations = glsl.declarations(self.at(GLSL))

    def at(self, path: Path) -> Path:
        return self.root / path.relative_to(ROOT)

    def text(self, path: str) -> str:
        return (self.root / path).read_text(encoding="utf-8")

    @property
    def noises(self) -> list[Function]:
        return [function for function in self.functions if function.family in NOISES]


def lacks(function: Function, what: str) -> str:
    """A message with the place of its row."""
    return str(function.row.error(f"{function.id}: {what}"))


# --- Functions --------------------------------------------------------------------------------------------------


def functions_without_a_row(tree: Tree) -> Iterator[str]:
    rows = {(function.calls, types) for function in tree.functions for types in function.overloads}
    hashes = {configuration.hash for configuration in tree.configurations}
    for declared in tree.declarations:
        if declared.name.startswith("hn_hash_") and declared.types == ("uint",):
            name = declared.name.removeprefix("hn_hash_")
            if name not in hashes:
                yield (f"{declared.place}: {declared} is the hash of no configuration: add CONFIGURATION(\"{name}\", "
                       f"{name.upper()}, ...) to {CONFIGURATIONS.relative_to(ROOT)}")
        elif (declared.name, declared.types) not in rows:
            yield (f"{declared.place}: {declared} has no row: add a FUNCTION that calls it to "
                   f"{FUNCTIONS.relative_to(ROOT)}")


def rows_without_a_function(tree: Tree) -> Iterator[str]:
    declared = {(declaration.name, declaration.types) for declaration in tree.declarations}
    for function in tree.functions:
        for types in function.overloads:
            if (function.calls, types) not in declared:
                yield lacks(function, f"declare {function.calls}({', '.join(types)}) in {GLSL.name}/")


def functions_without_words(tree: Tree) -> Iterator[str]:
    """In the comments of the library, and in the README."""
    first_cells = [line.split(" | ")[0] for line in tree.text("README.md").split("\n") if line.startswith("|")]
    for declared in tree.declarations:
        if not declared.comment or "returns" not in declared.comment.headings:
            yield f"{declared.place}: {declared} has no comment that says what it returns: write one over it"
    for name in sorted({function.calls for function in tree.functions}):
        if not any(f"`{name}(" in cell for cell in first_cells):
            yield f"README.md: no line for {name}: add one to the table of functions"


# --- Noises -----------------------------------------------------------------------------------------------------


def noises_without_entries(tree: Tree) -> Iterator[str]:
    bounds = {(row.noise, row.dimensions) for row in table.read(tree.at(BOUNDS))}
    contract = tree.text("docs/contract.md")
    for function in tree.noises:
        noise = function.noise
        for of, what in (("oracle", "its exact and its fixed value, from docs/contract.md"),
                         ("bounds", "what is proven of it")):
            module = tree.root / ENTRIES.format(of, noise)
            if not module.is_file() and not (module.with_suffix("") / "__init__.py").is_file():
                yield lacks(function, f"write {ENTRIES.format(of, noise)}, {what}")
        if (noise, function.axes) not in bounds:
            yield lacks(function, f"{BOUNDS.relative_to(ROOT)} has no {noise} in {function.axes}D: run "
                        "tools/bounds --write")
        if not re.search(rf"^    {function.calls}\({function.types[0]}\b", contract, re.MULTILINE):
            yield lacks(function, f"define {function.calls}({', '.join(function.types)}) in docs/contract.md, in an "
                        "indented line of its own")


def noises_without_comments(tree: Tree) -> Iterator[str]:
    noises = {function.calls: function.noise for function in tree.noises}
    headings: dict[Path, set[str]] = {}
    for declared in tree.declarations:
        if declared.name in noises and declared.comment:
            headings.setdefault(declared.path, set()).update(declared.comment.headings)
            for heading in sorted(OF_A_NOISE - declared.comment.headings):
                yield f"{declared.path}:{declared.comment.line}: the comment over {declared} has no line `{heading}`"
    for path, found in headings.items():
        for heading in sorted(OF_A_NOISE_ONCE - found):
            yield f"{path}: no comment over its functions has a line `{heading}`"


def entries_without_a_noise(tree: Tree) -> Iterator[str]:
    noises = {function.noise for function in tree.noises}
    for of in ("oracle", "bounds"):
        folder = tree.root / Path(ENTRIES.format(of, "")).parent
        for path in sorted(folder.glob("[a-z]*")):
            if path.stem not in noises and not path.stem.endswith("_test"):
                yield (f"{path}: no function is the noise {path.stem}: add a row of it to "
                       f"{FUNCTIONS.relative_to(ROOT)}, or delete the file")


# --- Settings ---------------------------------------------------------------------------------------------------


def families_without_settings(tree: Tree) -> Iterator[str]:
    """Each arithmetic that concerns a family, and a period where it has one."""
    def covered(family: str, **setting: object) -> bool:
        return any(family in configuration.families
                   and all(getattr(configuration, name) == value for name, value in setting.items())
                   for configuration in tree.configurations)

    where = CONFIGURATIONS.relative_to(ROOT)
    for family in sorted({function.family for function in tree.functions}):
        exact = all(function.exact for function in tree.functions if function.family == family)
        for arithmetic in ("fast",) if exact else ARITHMETICS:
            if not covered(family, arithmetic=arithmetic):
                yield f"{where}: add {family} to the families of a configuration with {arithmetic.upper()}"
        if (family in NOISES or family.endswith("gradient")) and not any(
                configuration.period and family in configuration.families for configuration in tree.configurations):
            yield f"{where}: add {family} to the families of a configuration with a period"


def hashes_without_entries(tree: Tree) -> Iterator[str]:
    contract, readme = tree.text("docs/contract.md"), tree.text("README.md")
    names = re.findall(r"^#define HN_HASH_(\w+) \d+$", (tree.at(GLSL) / "config.glsl").read_text(), re.MULTILINE)
    for name in names:
        macro, word = f"HN_HASH_{name}", name.lower()
        if not any(_is_plain(configuration, word) for configuration in tree.configurations):
            yield (f"{CONFIGURATIONS.relative_to(ROOT)}: {macro} is under test with no default gradient and period: "
                   f"add CONFIGURATION(\"{word}\", {name}, OCTAHEDRAL, 0, FAST, ...)")
        if word not in words.HASHES:
            yield f"tools/lib/oracle/words.py: {macro} is not among the hashes: add it from docs/contract.md"
        if f"| `{name}`" not in contract:
            yield f"docs/contract.md: no line for {macro}: add one to its table of hashes"
        if f"`{macro}`" not in readme:
            yield f"README.md: the knob HN_HASH does not offer {macro}: add it to its line"


def _is_plain(configuration: Configuration, hash: str) -> bool:
    return configuration.name == hash and "hash" in configuration.families


def missing_golden_files(tree: Tree) -> Iterator[str]:
    folder = tree.at(GOLDEN)
    missing: dict[str, list[str]] = {}
    for file in golden_files(tree.functions, tree.configurations):
        if not (folder / file.name).is_file():
            missing.setdefault(file.function.id, []).append(file.configuration_name)
    for function, configurations in missing.items():
        yield f"{folder}: {function} has no golden files with {', '.join(configurations)}: run tools/golden"


CHECKS = (functions_without_a_row, rows_without_a_function, functions_without_words, noises_without_entries,
          noises_without_comments, entries_without_a_noise, families_without_settings, hashes_without_entries,
          missing_golden_files)


def problems(root: Path = ROOT) -> list[str]:
    tree = Tree(root)
    return [message.replace(f"{root}/", "") for check in CHECKS for message in check(tree)]
