"""Holds the binary interface of hashnoise::grid, as a shared library, to the promise of this major version.

    tools/test abi --check     builds the library, and prints the differences from src/grid/tests/grid.abi
    tools/test abi --write     writes that file anew. Refused if something in it has changed or is gone, and in a patch
                               also if something is new

A program that was compiled with 1.2.0 runs with the library of 1.2.3 and of 1.3.0, and not with that of 2.0.0: its
SONAME differs, and so does the namespace of its functions. The file has a line for each fact that a program relies
on: a symbol, a size, the place of a member. abidw of Debian's abigail-tools finds them. They are those of x86-64, and
elsewhere the command is skipped.

Before a release, new functions may change again: begin with the file of the last release, `git checkout TAG
src/grid/tests/grid.abi`.

The library is compiled anew, which takes minutes; FOLDER (build/abi) keeps it.

Exit status: 0 the interface is as it was, or is written; 1 it is not as it was, or must stay; 2 bad usage; 4 the
library cannot be built or described; 77 the machine is no x86-64, or there is no abigail-tools.
"""

from base import needs

needs.python("test", "abi")

import os  # noqa: E402
import platform  # noqa: E402
import re  # noqa: E402
import shutil  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
from collections.abc import Sequence  # noqa: E402
from pathlib import Path  # noqa: E402
from xml.etree import ElementTree  # noqa: E402

from base.tree import ROOT, version  # noqa: E402
from base.usage import Parser  # noqa: E402

INTERFACE = ROOT / "src" / "grid" / "tests" / "grid.abi"
FOLDER = ROOT / "build" / "abi"
NEEDED = ("abidw", "c++filt")
# The rest does not matter to a program of another patch.
OPTIONS = ("--no-corpus-path", "--no-comp-dir-path", "--no-elf-needed", "--no-show-locs", "--no-parameter-names",
           "--exported-interfaces-only", "--drop-undefined-syms", "--drop-private-types", "--headers-dir",
           str(ROOT / "include" / "hashnoise"))
SIGNS = {"pointer-type-def": "*", "reference-type-def": "&", "qualified-type-def": " const"}  # of types made of others


class Failed(Exception):
    """The library is not there, or a program does not do its work."""


def skipped() -> str:
    """Why there is nothing to compare with; empty if there is."""
    missing = [program for program in NEEDED if shutil.which(program) is None]
    if missing:
        return f"skipped: there is no {' and no '.join(missing)}"
    return "" if platform.machine() == "x86_64" else "skipped: this machine is no x86-64"


def output_of(*command: str | Path) -> str:
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failed(f"{command[0]} ended with status {done.returncode}: {(done.stdout + done.stderr)[-2000:].strip()}")
    return done.stdout


def build(folder: Path) -> Path:
    """The shared library, with what abidw needs to know of its types. One instruction set stands for all: they have the
    same interface."""
    output_of("cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DBUILD_SHARED_LIBS=ON", "-DHASHNOISE_CONFORMANCE=OFF",
              "-DHASHNOISE_TESTS=OFF", "-DHASHNOISE_INSTRUCTION_SETS=sse4.1", "-DCMAKE_BUILD_TYPE=Release",
              "-DCMAKE_CXX_FLAGS=-g")
    command = ["cmake", "--build", folder, "--target", "hashnoise-grid", "--parallel", str(os.cpu_count() or 1)]
    if subprocess.run(command, stdout=2, check=False).returncode != 0:  # ninja prints how far it is
        raise Failed("the library could not be built")
    return folder / "src" / "grid" / "libhashnoise-grid.so"


def described(library: Path) -> str:
    return "".join(f"{fact}\n" for fact in facts(ElementTree.fromstring(output_of("abidw", *OPTIONS, library))))


def facts(corpus: ElementTree.Element) -> list[str]:
    """Of the library's own symbols and types. Types of the standard library have their names alone."""
    known: dict[str, tuple[str, ElementTree.Element]] = {}  # the scope of a type, and the type, by its number

    def visit(element: ElementTree.Element, scope: str) -> None:
        for part in element:
            if "id" in part.attrib and (part.get("is-declaration-only") != "yes" or part.get("id") not in known):
                known[part.get("id")] = scope, part
            visit(part, f"{scope}{part.get('name')}::" if part.tag in ("namespace-decl", "class-decl") else scope)

    def name(of: ElementTree.Element | None) -> str:
        scope, part = known[of.get("type-id")]
        return name(part) + SIGNS[part.tag] if part.tag in SIGNS else scope + part.get("name", "")

    visit(corpus, "")
    returned = {one.get("elf-symbol-id"): name(one.find("return")) for one in corpus.iter("function-decl")}
    found = [f"symbol {one} returns {returned.get(one, 'void')}" for one in
             (symbol.get("name") for symbol in corpus.iter("elf-symbol")) if "hashnoise" in one]
    for scope, part in known.values():
        own = scope + part.get("name", "")
        if own.startswith("hashnoise::") and part.tag in ("class-decl", "enum-decl"):
            found += [f"{own} has {part.get('size-in-bits')} bits"] if "size-in-bits" in part.attrib else []
            found += [f"{own} begins with {name(one)}" for one in part.findall("base-class")]
            found += [f"{own}::{one.get('name')} is {one.get('value')}" for one in part.findall("enumerator")]
            found += [f"{own}::{variable.get('name')} is a {name(variable)} at bit {one.get('layout-offset-in-bits')}"
                      for one in part.findall("data-member") for variable in one.findall("var-decl")]
    return [f"SONAME {corpus.get('soname')}", *sorted(found)]


def differences(before: Path, now: Path) -> tuple[list[str], list[str]]:
    """The facts that are gone, and those that are new."""
    facts_before, facts_now = ({*path.read_text(encoding="utf-8").splitlines()} for path in (before, now))
    return ([f"gone: {fact}" for fact in sorted(facts_before - facts_now)],
            [f"new: {fact}" for fact in sorted(facts_now - facts_before)])


def promised(of: str) -> str:
    """The SONAME of the library in a version."""
    return "libhashnoise-grid.so." + of.split(".")[0]


def soname(interface: str) -> str:
    found = re.search(r"(?m)^SONAME (.*)", interface)
    return found[1] if found else ""


def functions(interface: str) -> list[str]:
    """The library's symbols for a linker, by the names that C++ gives."""
    symbols = re.findall(r"(?m)^symbol (\S+)", interface)
    return sorted(output_of("c++filt", *symbols).splitlines()) if symbols else []


def problems(before: Path, now: Path, of: str) -> list[str]:
    """Differences from the description of a library."""
    text = now.read_text(encoding="utf-8")
    wrong = []
    if soname(text) != promised(of):
        wrong.append(f"the SONAME is {soname(text) or 'missing'}; of version {of} it is {promised(of)}")
    offered = functions(text)
    space = f"hashnoise::v{of.split('.')[0]}::"
    wrong += [f"{name} is not in the namespace {space[:-2]}: HN_I_LIBRARY in include/hashnoise/glsl.hpp names it"
              for name in offered if space not in name]
    wrong += [f"{name} is not for users, and is offered to them" for name in offered if "::grid::" in name]
    if not before.exists():
        return [*wrong, f"there is no {before}; tools/test abi --write makes it"]
    gone, new = differences(before, now)
    return wrong + gone + new


def broken(before: Path, now: Path, of: str) -> str:
    """A message on forbidden changes of this version's interface: a minor version adds functions, a patch none."""
    if not before.exists() or soname(before.read_text(encoding="utf-8")) != promised(of):
        return ""
    wrong, new = differences(before, now)
    rule = "no new major version: it only adds functions"
    if of.split(".")[2] != "0":
        wrong, rule = wrong + new, "a patch, which changes nothing: put the change into the next minor version"
    return "\n".join([*wrong, f"{of} is {rule}"]) if wrong else ""


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/test abi", __doc__)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--check", action="store_true", help="print what is not as it was")
    what.add_argument("--write", action="store_true", help="write the interface anew")
    parser.add_argument("folder", nargs="?", type=Path, default=FOLDER, metavar="FOLDER",
                        help="where the library is built (default: %(default)s)")
    given = parser.parse_args(arguments)
    if skipped():
        print(skipped())
        return 77
    try:
        now = given.folder / "grid.abi"
        library = build(given.folder)
        now.write_text(described(library), encoding="utf-8")
        if given.check:
            wrong = problems(INTERFACE, now, version())
        elif report := broken(INTERFACE, now, version()):
            wrong = [report]
        else:
            shutil.copyfile(now, INTERFACE)
            wrong = problems(INTERFACE, now, version())
    except (Failed, OSError) as error:
        print(f"tools/test abi: {error}", file=sys.stderr)
        return 4
    for message in wrong:
        print(message, file=sys.stderr)
    if not wrong:
        state = "as it was" if given.check else f"in {INTERFACE}"
        print(f"the binary interface of {library.resolve().name} is {state}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
