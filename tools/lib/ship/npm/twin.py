"""The twin in WebAssembly, compiled by Clang from packages/npm/wasm/twin.cpp."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from base.tree import ROOT
from catalog.javascript import MOST_BYTES, Twin, tables_of_module
from catalog.model import read

SOURCE = ROOT / "packages" / "npm" / "wasm" / "twin.cpp"
# Bits do not depend on flags (HN_FIXED); size and speed do. With -Oz the module is a twelfth smaller and grids take up
# to twice the time; with -O2 it is twice as large. Structs are passed as their numbers (experimental-mv), and
# not in memory: a quarter of the size, and faster. Only the functions of one module know of it.
FLAGS = ("--target=wasm32-wasi", "-std=c++20", "-Os", "-flto", "-msimd128", "-mbulk-memory", "-mnontrapping-fptoint",
         "-Xclang", "-target-abi", "-Xclang", "experimental-mv", "-fno-math-errno", "-fno-exceptions", "-fno-rtti",
         "-fvisibility=hidden", "-Wall", "-Wextra", "-Wno-unused-function",
         "-Werror")
# No library is linked, so the package needs no license of one: it takes only headers of libc++, whose license
# (Apache-2.0 WITH LLVM-exception) lets compiled code go without it.
LINKED = ("--no-entry", "--gc-sections", "--strip-all", "--fatal-warnings")


class Failed(Exception):
    """Why there is no module."""


def _program(*names: str) -> str:
    """The first of these programs that there is; Debian has wasm-ld with the version in its name alone."""
    for name in names:
        if path := shutil.which(name):
            return path
    folders = sorted(Path("/usr/bin").glob(f"{names[0]}-[0-9]*"), reverse=True)
    if not folders:
        raise Failed(f"there is no program {names[0]}; Debian's packages clang and lld have what is needed")
    return str(folders[0])


def _run(*command: str) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failed(f"{' '.join(command)}\n{done.stderr}")


def compiled(source: Path = SOURCE, include: Path = ROOT / "include") -> bytes:
    clang = _program("clang++", "clang++-14")
    # The linker of the same LLVM, since it reads that compiler's output.
    major = re.search(r"version (\d+)", subprocess.run([clang, "--version"], capture_output=True, text=True,
                                                       check=True).stdout)[1]
    linker = _program(f"wasm-ld-{major}", "wasm-ld")
    with tempfile.TemporaryDirectory() as folder:
        object_, module = Path(folder) / "twin.o", Path(folder) / "twin.wasm"
        (Path(folder) / "tables.inc").write_text(tables_of_module(Twin(read())), encoding="ascii")
        _run(clang, *FLAGS, f"-I{include}", f"-I{folder}", "-c", str(source), "-o", str(object_))
        _run(linker, *LINKED, str(object_), "-o", str(module))
        found = module.read_bytes()
    if len(found) >= MOST_BYTES:
        raise Failed(f"the module has {len(found):,} bytes, and has to stay below {MOST_BYTES:,}")
    return found
