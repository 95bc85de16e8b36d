"""The folder of drivers: Mesa's, with the C library that they want, unpacked beside each other. Nothing is installed.

A chroot would need root and a gigabyte. Programs here are started by the folder's own dynamic linker instead, which
takes libraries of the folder first, and those of the system for what the folder lacks.
"""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from gpu.chips import CHIPS, UNUSED_SHIMS, Chip

PACKAGES = ("mesa-vulkan-drivers", "mesa-drm-shim", "libvulkan1")
KEYS = Path("/usr/share/keyrings/debian-archive-keyring.gpg")
VERSIONS = "packages.txt"  # which packages a folder has
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
    """Why something cannot be measured here, or why the drivers cannot be had."""


class Drivers(NamedTuple):
    folder: Path
    libraries: Path
    linker: Path

    def command(self, chip: Chip, program: Sequence[str]) -> list[str]:
        shim = self.shim(chip.vendor.shim)
        if not shim.exists():
            raise Missing(f"{self.folder} has no {shim.name}, which stands in for {chip.vendor.title}'s kernel driver")
        return [str(self.linker), "--library-path", str(self.libraries), "--preload", str(shim), *program]

    def environment(self, chip: Chip) -> dict[str, str]:
        """Ours, less what could change the counts."""
        ours = {name: value for name, value in os.environ.items()
                if not name.startswith(("RADV_", "ACO_", "NVK_", "NAK_", "TU_", "IR3_", "FD_", "AGX_", "HK_", "NIR_",
                                        "MESA_", "VK_", "LD_", "NOUVEAU_", "AMDGPU_", "AMD_"))}
        icd = next(iter((self.folder / "usr/share/vulkan/icd.d").glob(f"{chip.vendor.driver}_icd*.json")), None)
        if icd is None:
            raise Missing(f"{self.folder} has no {chip.vendor.driver}_icd.json, {chip.vendor.title}'s driver of Vulkan")
        told = dict([chip.variable.split("=")]) if chip.variable else {}
        return {**ours, **told, "VK_DRIVER_FILES": str(icd), "VK_LOADER_LAYERS_DISABLE": "*", "NODEVICE_SELECT": "1",
                "MESA_SHADER_CACHE_DISABLE": "true"}

    def shim(self, name: str) -> Path:
        return self.libraries / f"lib{name}_noop_drm_shim.so"

    def unused_shims(self) -> list[str]:
        """Those of GPUs that no chip of ours is of: a newer package may have them."""
        prefix, suffix = self.shim("\n").name.split("\n")
        known = UNUSED_SHIMS | {chip.vendor.shim for chip in CHIPS}
        names = (path.name for path in sorted(self.libraries.glob(f"{prefix}*{suffix}")))
        return [name for name in names if name.removeprefix(prefix).removesuffix(suffix) not in known]

    def version(self) -> str:
        """The package of the drivers, with its version."""
        packages = (self.folder / VERSIONS).read_text(encoding="utf-8").split()
        return next(package for package in packages if package.startswith(PACKAGES[0]))


def find(folder: Path) -> Drivers:
    folder = folder.absolute()
    if set(str(folder)) & set(" :;"):
        raise Missing(f"the dynamic linker cannot read the name of {folder}: use one without blanks, colons and "
                      "semicolons")
    for library in sorted(folder.glob("usr/lib/*/libvulkan.so.1")):
        for linker in sorted(library.parent.glob("ld-linux*.so.*")):
            return Drivers(folder, library.parent, linker)
    raise Missing(f"there are no drivers in {folder}; tools/gpu-costs --get-drivers puts them there, some 70 MB of "
                  "Debian's packages that become 350 MB, without installing anything")


def get(folder: Path, mirror: str, suite: str) -> None:
    """Downloads and unpacks them. apt and dpkg say what they do, so that nobody waits for a silent command."""
    for program in ("apt-get", "dpkg-deb"):
        if not shutil.which(program):
            raise Missing(f"there is no {program}: the drivers are Debian's packages, and on this {platform.system()} "
                          "they cannot be had by this command")
    if not KEYS.exists():
        raise Missing(f"there is no {KEYS}, by which Debian's packages are checked: install debian-archive-keyring")
    if folder.exists() and any(folder.iterdir()):
        raise Missing(f"{folder} is not empty: remove it first, or name another by --drivers")
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f"{folder.name}.") as scratch:
        apt = Path(scratch) / "apt"
        for name in ("state/lists/partial", "cache/archives/partial", "etc/apt.conf.d", "etc/preferences.d"):
            (apt / name).mkdir(parents=True)
        (apt / "status").touch()  # nothing is installed, so that all that the drivers need is downloaded
        (apt / "apt.conf").write_text(APT.format(apt), encoding="utf-8")
        (apt / "etc/sources.list").write_text(f"deb [signed-by={KEYS}] {mirror} {suite} main\n", encoding="utf-8")
        print(f"Asking {mirror} for the packages of {suite}", file=sys.stderr, flush=True)
        _run_apt(apt, "update", failure=f"apt-get cannot read the list of {suite} at {mirror}")
        _run_apt(apt, "install", "--download-only", "-y", *PACKAGES, failure="apt-get cannot download the drivers")
        packages = sorted((apt / "cache/archives").glob("*.deb"))
        root = Path(scratch) / "root"
        for number, package in enumerate(packages, 1):
            print(f"[{number}/{len(packages)}] unpacking {package.stem}", file=sys.stderr, flush=True)
            subprocess.run(["dpkg-deb", "-x", package, root], check=True)
        (root / VERSIONS).write_text("".join(f"{package.stem}\n" for package in packages), encoding="utf-8")
        if folder.exists():
            folder.rmdir()
        root.rename(folder)


def _run_apt(apt: Path, *arguments: str, failure: str) -> None:
    """Of what it writes, only how far it is gets through; the rest is told if it fails."""
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
