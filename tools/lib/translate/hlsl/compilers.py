"""Microsoft's compilers of HLSL on Linux, for tests: DXC, of PyPI's compushady, and FXC, of PyPI's PyQt5-Qt5 under
wine. Nothing of them is installed: they are unpacked into build/hlsl/.

    python3 -m translate.hlsl.compilers -x hlsl -b dxbc-tpf -p PROFILE -e ENTRY -o OUTPUT INPUT

is FXC with the options of vkd3d-compiler, for the suite. HN_VKD3D_REAL names a real one, which gets all other options.
"""

from __future__ import annotations

import functools
import itertools
import os
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from base.debian import Missing
from base.pypi import downloaded
from base.tree import ROOT

HERE = Path(__file__).resolve().parent
FOLDER = ROOT / "build" / "hlsl"
# The folders of the archives' names are their own.
DXC = "compushady==0.17.5"
DXC_LIBRARY = "libdxcompiler_x86_64.so.3.7"
FXC = "PyQt5-Qt5==5.15.2"
FXC_LIBRARY = "d3dcompiler_47.dll"
# Debian's packages that FXC needs, by their programs.
NEEDED = {"wine": "wine wine64", "x86_64-w64-mingw32-g++": "g++-mingw-w64-x86-64"}


class Compiled(NamedTuple):
    """A compiler's result."""
    code: bytes  # nothing if it does not compile
    messages: str


def refusal(made: Compiled) -> str:
    """Why it does not compile, or not in silence; nothing if it does."""
    messages = re.sub(r"warning: DXIL\.dll not found\..*", "", made.messages).strip()  # which signs
    return messages or ("" if made.code else "no code")


def _for_this_machine() -> None:
    if platform.system() != "Linux" or platform.machine() != "x86_64":
        raise Missing(f"the compilers are for Linux on x86-64, not for {platform.system()} on {platform.machine()}")


def _kept(whole: Path, folder: Path) -> None:
    try:
        whole.rename(folder)
    except OSError:
        if not folder.exists():  # another test was faster
            raise


def _built(program: Path, source: Path, *command: str | Path) -> None:
    """By the command and -o PROGRAM."""
    if not program.exists() or program.stat().st_mtime < source.stat().st_mtime:
        made = program.with_suffix(f".{os.getpid()}")
        _run(*command, source, "-o", made)
        made.rename(program)


def _run(*words: str | Path) -> None:
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, words))}:\n{done.stdout}{done.stderr}")


@functools.cache
def dxc() -> Path:
    """A program that takes the options of DXC's."""
    _for_this_machine()
    folder = FOLDER / DXC.replace("==", "-")
    if not folder.exists():
        FOLDER.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=FOLDER) as place:
            whole = Path(place) / "whole"
            whole.mkdir()
            with tarfile.open(downloaded(DXC, Path(place), "--no-binary", ":all:")) as archive:
                for member in archive:
                    if Path(member.name).name in (DXC_LIBRARY, "dxcapi.h", "WinAdapter.h"):
                        member.name = Path(member.name).name
                        archive.extract(member, whole)
            _kept(whole, folder)
    program = folder / "dxc"
    _built(program, HERE / "dxc.cpp", "g++", "-std=c++17", "-fms-extensions", "-isystem", folder,
           f'-DHN_LIBRARY="{folder / DXC_LIBRARY}"', f'-DHN_PACKAGE="{DXC}"')
    return program


def dxc_of_windows(folder: Path) -> Path:
    """A program for Windows over the dxcompiler.dll of this folder."""
    program = folder / "dxc.exe"
    _built(program, HERE / "dxc.cpp", "x86_64-w64-mingw32-g++", "-std=c++17", "-O1", "-static", "-isystem",
           dxc().parent, '-DHN_LIBRARY="dxcompiler.dll"', '-DHN_PACKAGE="webgpu"')
    return program


# Profiles by the stages of glslang, for DXC and FXC.
STAGES = {"vert": ("vs_6_0", "vs_5_0"), "frag": ("ps_6_0", "ps_5_0")}


@functools.cache
def missing() -> str:
    """Why DXC or FXC is not here; nothing if both are."""
    try:
        dxc()
        fxc()
    except Missing as why:
        return str(why)
    return ""


def refusals(file: Path, stage: str, entry: str) -> dict[str, str]:
    """By which compilers a shader is refused, and why: by glslang, and by DXC and FXC where they are here. Includes
    begin at its folder."""
    found = {}
    done = subprocess.run(["glslangValidator", "-D", "-V", f"-I{file.parent}", "-S", stage, "-e", entry, "-o",
                           "/dev/null", file], cwd=file.parent, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        found["glslang"] = done.stdout
    if missing():
        return found
    made = {"DXC": compile_by_dxc([file], STAGES[stage][0], entry, "-I", str(file.parent)),
            "FXC": fxc().compile([file], STAGES[stage][1], entry)}
    return found | {name: one.messages for name, (one,) in made.items() if not one.code}


def compiled(files: Sequence[Path], *command: str | Path, environment: Mapping[str, str] = os.environ) -> list[Compiled]:
    """Results of files, which are in one folder, by a command that writes FILE.code and FILE.messages."""
    written = [(Path(f"{file}.code"), Path(f"{file}.messages")) for file in files]
    for path in itertools.chain(*written):  # of an earlier text
        path.unlink(missing_ok=True)
    done = subprocess.run([*command, *(file.name for file in files)], cwd=files[0].parent, env=environment,
                          capture_output=True, text=True, errors="replace", check=False)
    # Wine may end with 1, too.
    if done.returncode not in (0, 1) or not written[-1][1].exists():
        raise RuntimeError(f"{command} ended with {done.returncode}: {done.stdout}{done.stderr}")
    return [Compiled(code.read_bytes() if code.exists() else b"",
                     messages.read_bytes().decode(errors="replace").rstrip("\0"))
            for code, messages in written]


@functools.cache
def fxc() -> Fxc:
    return Fxc()


class Fxc:
    """A folder with its files."""

    def __init__(self) -> None:
        _for_this_machine()
        if missing := [package for program, package in NEEDED.items() if not shutil.which(program)]:
            raise Missing(f"FXC is a program for Windows: apt-get install {' '.join(missing)}")
        self.folder = FOLDER / FXC.replace("==", "-")
        if not self.folder.exists():
            FOLDER.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryDirectory(dir=FOLDER) as place:
                whole = Path(place) / "whole"
                whole.mkdir()
                wheel = downloaded(FXC, Path(place), "--only-binary", ":all:", "--platform", "win_amd64")
                with zipfile.ZipFile(wheel) as archive:
                    name, = (name for name in archive.namelist() if name.endswith(f"/{FXC_LIBRARY}"))
                    (whole / FXC_LIBRARY).write_bytes(archive.read(name))
                _kept(whole, self.folder)
        _built(self.folder / "fxc.exe", HERE / "fxc.cpp", "x86_64-w64-mingw32-g++", "-O1", "-static")
        self.environment = {**os.environ, "WINEPREFIX": str(self.folder / "wine"), "WINEDEBUG": "-all",
                            # Wine has a compiler of its own by that name; the others would ask for downloads.
                            "WINEDLLOVERRIDES": f"{Path(FXC_LIBRARY).stem}=n;mscoree=;mshtml="}

    def compile(self, files: Sequence[Path], profile: str, entry: str = "main") -> list[Compiled]:
        """An include is looked for from the files' folder on."""
        return compiled(files, "wine", self.folder / "fxc.exe", profile, entry, environment=self.environment)


def compile_by_dxc(files: Sequence[Path], profile: str, entry: str = "main", *options: str) -> list[Compiled]:
    """To what Direct3D takes, or by -spirv to SPIR-V."""
    return compiled(files, dxc(), *options, "-T", profile, "-E", entry, "-each")


def main(arguments: Sequence[str]) -> int:
    if list(arguments[:4]) != ["-x", "hlsl", "-b", "dxbc-tpf"]:
        os.execvp(os.environ["HN_VKD3D_REAL"], [os.environ["HN_VKD3D_REAL"], *arguments])
    _, profile, _, entry, _, output, file = arguments[4:]
    made, = Fxc().compile([Path(file)], profile, entry)
    Path(output).write_bytes(made.code)
    print(made.messages, file=sys.stderr)
    return not made.code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
