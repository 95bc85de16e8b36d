"""Formats the sources: C++ and GLSL by clang-format, and Python by ruff.

    tools/make format [--check] [FILE...]    all files, or these; with --check it changes none, and prints what it would

.clang-format and ruff.toml have the rules. PyPI's packages of the versions that
requirements.txt names are installed into build/format-environment at first, so each machine formats alike. For Python
ruff mends imports, blanks and empty lines, and finds mistakes. It does not break lines anew: as `ruff format` lays them
out, the tree has 14,000 lines more.

Exit status: 0 done, or (--check) nothing to do; 1 (--check) a file is not formatted, or ruff found a fault that it
cannot mend, or the formatters cannot be installed; 2 bad usage, 4 PyPI cannot be reached.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from base.pypi import SKIPPED, environment
from base.tree import ROOT, files
from base.usage import Parser

ENVIRONMENT = ROOT / "build" / "format-environment"
BY_CLANG_FORMAT = {".comp", ".cpp", ".frag", ".glsl", ".h", ".hlsl", ".hpp", ".metal", ".vert"}
PYTHON = {".py", ".pyi"}


def unformatted(sources: Sequence[Path], check: bool, bin: Path) -> list[str]:
    """The changes that the formatters would make, in words, and the faults that they could not mend."""
    found = []
    if others := [file for file in sources if file.suffix in BY_CLANG_FORMAT]:
        options = ["--dry-run", "-Werror"] if check else ["-i"]
        done = subprocess.run([bin / "clang-format", *options, *others], capture_output=True, text=True, check=False)
        lines = dict(line.split(": error:")[0].rsplit(":", 2)[:2] for line in reversed(done.stderr.splitlines())
                     if ": error:" in line)
        found = [f"{file}:{line}: clang-format changes it" for file, line in lines.items()]
        if done.returncode and not found:
            raise RuntimeError(f"clang-format ended with status {done.returncode}: {done.stderr}")
    if python := [file for file in sources if file.suffix in PYTHON]:
        done = subprocess.run([bin / "ruff", "check", "--quiet", "--no-cache", "--output-format=concise",
                               f"--config={ROOT / 'ruff.toml'}", *(() if check else ("--fix",)), *map(Path.resolve, python)],
                              cwd=ROOT, capture_output=True, text=True, check=False)
        found += (done.stdout + done.stderr).splitlines() if done.returncode else []
    return found


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/make format", __doc__)
    parser.add_argument("--check", action="store_true", help="only print what it would change")
    parser.add_argument("files", metavar="FILE", type=Path, nargs="*", help="these files alone")
    options = parser.parse_args(arguments)
    for file in options.files:
        if not file.is_file() or file.suffix not in BY_CLANG_FORMAT | PYTHON:
            parser.error(f"{file} is no file of C++, GLSL, HLSL, Metal or Python")
    if status := environment(ENVIRONMENT, Path(__file__).with_name("requirements.txt")):
        return 4 if status == SKIPPED else 1
    found = unformatted(options.files or [ROOT / name for name in files()], options.check, ENVIRONMENT / "bin")
    print(*(line.replace(f"{ROOT}/", "") for line in found), sep="\n", end="\n" if found else "")
    if found and options.check:
        print("tools/make format formats them.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
