"""Programs of Debian's unstable suite, each with the C library and all else that it wants, unpacked into a folder
beside each other. Nothing is installed.

A chroot would need root and a gigabyte. A program is started by the folder's own dynamic linker instead, which takes
libraries of the folder first, and those of the system for what the folder lacks.

    python3 -B -m base.debian PROGRAM    one of those of PROGRAMS: prints the path of a script that starts it

Exit status: 0 done, 77 it cannot be had here.
"""

from __future__ import annotations

import argparse
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from base.tree import ROOT

MIRROR = "http://deb.debian.org/debian"
SUITE = "sid"
KEYS = Path("/usr/share/keyrings/debian-archive-keyring.gpg")
VERSIONS = "packages.txt"  # which packages a folder has
SKIPPED = 77
APT = """Dir "{0}/";
Dir::State "state";
Dir::State::status "{0}/status";
Dir::Cache "cache";
Dir::Etc "etc";
APT::Sandbox::User "";
APT::Install-Recommends "false";
APT::Status-Fd "1";
Acquire::Languages "none";
// Mirrors lag behind; what they serve is signed all the same.
Acquire::Check-Valid-Until "false";
"""


class Missing(Exception):
    """Why something cannot be had here."""


class Program(NamedTuple):
    packages: Sequence[str]
    # Variables of its environment: {folder} has the packages and {libraries} their libraries.
    variables: Mapping[str, str] = {}


PROGRAMS = {
    # Debian 12 has 1.2, which compiles no HLSL.
    "vkd3d-compiler": Program(["vkd3d-compiler"]),
    # The newest of what goes between compilers.
    "glslangValidator": Program(["glslang-tools"]), "spirv-cross": Program(["spirv-cross"]),
    "spirv-opt": Program(["spirv-tools"]),
    # It loads what it shows windows with, and draws by Mesa's drivers for processors.
    "godot": Program(
        ["godot", "mesa-vulkan-drivers", "libgl1-mesa-dri", "libgl1", "libegl1", "libgles2", "libvulkan1",
         "libglx-mesa0", "libx11-6", "libxcursor1", "libxinerama1", "libxrandr2", "libxi6", "libxext6"],
        {"LIBGL_DRIVERS_PATH": "{libraries}/dri", "VK_DRIVER_FILES": "{folder}/usr/share/vulkan/icd.d/lvp_icd.json",
         "__EGL_VENDOR_LIBRARY_DIRS": "{folder}/usr/share/glvnd/egl_vendor.d"}),
}


class Root(NamedTuple):
    """A folder of packages, and what starts its programs."""
    folder: Path
    libraries: Path
    linker: Path

    def command(self, program: Sequence[str], *options: str) -> list[str]:
        # Some libraries find what only they use by the path of a folder of the system.
        own = sorted({path.parent for path in self.libraries.glob("*/lib*.so*")})
        return [str(self.linker), "--library-path", ":".join(map(str, (self.libraries, *own))), *options, *program]

    def starter(self, program: str, variables: Mapping[str, str]) -> Path:
        """A script that starts a program of the folder."""
        path = self.folder / program
        values = {name: value.format(folder=self.folder, libraries=self.libraries) for name, value in variables.items()}
        command = shlex.join(self.command([str(self.folder / "usr/bin" / program)]))
        exports = "".join(f"export {name}={shlex.quote(value)}\n" for name, value in values.items())
        path.write_text(f'#!/bin/sh\n{exports}exec {command} "$@"\n', encoding="utf-8")
        path.chmod(0o755)
        return path


def find(folder: Path, library: str) -> Root | None:
    """The folder, if the library is there."""
    folder = folder.absolute()
    if set(str(folder)) & set(" :;"):
        raise Missing(f"the dynamic linker cannot read the name of {folder}: use one without blanks, colons and "
                      "semicolons")
    for path in sorted(folder.glob(f"usr/lib/*/{library}")):
        for linker in sorted(path.parent.glob("ld-linux*.so.*")):
            return Root(folder, path.parent, linker)
    return None


def program(name: str) -> Path:
    """The command that starts it. It is downloaded if it is not here yet."""
    folder = ROOT / "build" / "debian" / name
    wanted = PROGRAMS[name]
    if not (found := find(folder, "libc.so.6")):
        get(folder, wanted.packages, name)
        found = find(folder, "libc.so.6")
    if not found or not (folder / "usr/bin" / name).exists():
        raise Missing(f"{folder} has no program {name}: remove the folder, and try again")
    return found.starter(name, wanted.variables)


def chosen(name: str) -> str:
    """The program that HN_NAME names, the one in the PATH, or Debian's."""
    variable = f"HN_{name.upper()}"
    if found := os.environ.get(variable) or shutil.which(name):
        return found
    try:
        return str(program(name))
    except Missing as why:
        raise Missing(f"there is no {name} in the PATH, {variable} names none, and {why}") from why


def get(folder: Path, packages: Sequence[str], what: str, mirror: str = MIRROR, suite: str = SUITE) -> None:
    """Downloads and unpacks them. apt and dpkg print how far they are, so that nobody waits for a silent command.
    `what` is how messages call it."""
    for program in ("apt-get", "dpkg-deb"):
        if not shutil.which(program):
            raise Missing(f"there is no {program}, which unpacks {what}: these are Debian's packages, and on this "
                          f"{platform.system()} they cannot be had by this command")
    if not KEYS.exists():
        raise Missing(f"there is no {KEYS}, by which Debian's packages are checked: install debian-archive-keyring")
    if folder.exists() and any(folder.iterdir()):
        raise Missing(f"{folder} is not empty: remove it first, or name another")
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f"{folder.name}.") as scratch:
        apt = Path(scratch) / "apt"
        for name in ("state/lists/partial", "cache/archives/partial", "etc/apt.conf.d", "etc/preferences.d"):
            (apt / name).mkdir(parents=True)
        (apt / "status").touch()  # nothing is installed, so that all that they need is downloaded
        (apt / "apt.conf").write_text(APT.format(apt), encoding="utf-8")
        (apt / "etc/sources.list").write_text(f"deb [signed-by={KEYS}] {mirror} {suite} main\n", encoding="utf-8")
        print(f"Asking {mirror} for the packages of {suite}", file=sys.stderr, flush=True)
        _run_apt(apt, "update", failure=f"apt-get cannot read the list of {suite} at {mirror}")
        _run_apt(apt, "install", "--download-only", "-y", *packages, failure=f"apt-get cannot download {what}")
        archives = sorted((apt / "cache/archives").glob("*.deb"))
        root = Path(scratch) / "root"
        for number, package in enumerate(archives, 1):
            print(f"[{number}/{len(archives)}] unpacking {package.stem}", file=sys.stderr, flush=True)
            subprocess.run(["dpkg-deb", "-x", package, root], check=True)
        (root / VERSIONS).write_text("".join(f"{package.stem}\n" for package in archives), encoding="utf-8")
        try:
            root.rename(folder)  # it may replace an empty folder
        except OSError:
            if not (folder / VERSIONS).exists():  # another was faster
                raise


def _run_apt(apt: Path, *arguments: str, failure: str) -> None:
    """Only its progress is printed; the rest follows if it fails."""
    said, percent = [], -1
    with subprocess.Popen(["apt-get", "-q", *arguments], env={**os.environ, "APT_CONFIG": str(apt / "apt.conf")},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        for line in process.stdout:
            if not line.startswith("dlstatus:"):
                said.append(line)
                continue
            now = int(float(line.split(":")[2])) // 2 * 2
            if now != percent:
                percent = now
                print(f"downloading: {percent} %", file=sys.stderr, flush=True)
    if process.returncode:
        raise Missing(f"{failure}:\n{''.join(said[-12:])}".rstrip())


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", choices=PROGRAMS)
    try:
        print(program(parser.parse_args().program))
    except Missing as why:
        print(f"skipped: {why}", file=sys.stderr)
        return SKIPPED
    return 0


if __name__ == "__main__":
    sys.exit(main())
