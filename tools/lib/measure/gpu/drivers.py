"""The folder of drivers: Mesa's and Intel's, of Debian's unstable suite (debian.py), with the LLVM that optimizes for
Intel's. NVIDIA's compiler is PyPI's (cuda.py)."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from base import cuda, debian
from base.debian import Missing
from measure.gpu.chips import Chip

LLVM = "22"  # that of today's Mesa; when Debian drops it, name the next for which there is an llvm-spirv
PACKAGES = ("mesa-vulkan-drivers", "mesa-drm-shim", "libvulkan1", "intel-ocloc", "libigc2", f"llvm-{LLVM}",
            f"llvm-spirv-{LLVM}")
SIZE = "some 410 MB of packages of Debian and PyPI that become 1.1 GB"


class Drivers(debian.Root):
    def compiler(self, chip: Chip, program: Sequence[str]) -> list[str]:
        shim = self.shim(chip.vendor.shim)
        if not shim.exists():
            raise Missing(f"{self.folder} has no {shim.name}, which stands in for {chip.vendor.title}'s kernel driver")
        return self.command(program, "--preload", str(shim))

    def environment(self, chip: Chip) -> dict[str, str]:
        """Ours, less what could change the counts."""
        ours = {name: value for name, value in os.environ.items()
                if not name.startswith(("RADV_", "ACO_", "NVK_", "NAK_", "TU_", "IR3_", "FD_", "AGX_", "HK_", "NIR_",
                                        "MESA_", "VK_", "LD_", "NOUVEAU_", "AMDGPU_", "AMD_"))}
        icd = next(iter((self.folder / "usr/share/vulkan/icd.d").glob(f"{chip.vendor.driver}_icd*.json")), None)
        if icd is None:
            raise Missing(f"{self.folder} has no {chip.vendor.driver}_icd.json, {chip.vendor.title}'s driver of Vulkan")
        chosen = dict([chip.variable.split("=")]) if chip.variable else {}
        return {**ours, **chosen, "VK_DRIVER_FILES": str(icd), "VK_LOADER_LAYERS_DISABLE": "*", "NODEVICE_SELECT": "1",
                "MESA_SHADER_CACHE_DISABLE": "true"}

    def program(self, name: str) -> list[str]:
        """The command that starts one of Debian's."""
        for path in sorted((self.folder / "usr/bin").glob(f"{name}*")):
            if path.name in (name, f"{name}-{LLVM}") or name == "ocloc":
                return self.command([str(path)])
        raise Missing(f"{self.folder} has no program {name}: remove the folder, and get the drivers again")

    def shim(self, name: str) -> Path:
        return self.libraries / f"lib{name}_noop_drm_shim.so"

    def versions(self) -> str:
        """Of what compiles."""
        return ", ".join(f"{title} {self.version(package)}" for title, package in
                         (("Mesa", PACKAGES[0]), ("IGC", "libigc"), ("LLVM", "libllvm")))

    def version(self, package: str) -> str:
        """Of the package whose name begins so."""
        packages = (self.folder / debian.VERSIONS).read_text(encoding="utf-8").split()
        found = next((one.split("_")[1] for one in packages if one.startswith(package)), "?")
        return found.rpartition("%3a")[2]


def find(folder: Path) -> Drivers:
    if found := debian.find(folder, "libvulkan.so.1"):
        return Drivers(*found)
    raise Missing(f"there are no drivers in {folder.absolute()}; tools/measure gpu --get-drivers puts them there, "
                  f"{SIZE}, without installing anything")


def get(folder: Path, mirror: str = debian.MIRROR, suite: str = debian.SUITE) -> None:
    """Downloads them all, or what an earlier call could not get."""
    if not debian.find(folder, "libvulkan.so.1"):
        debian.get(folder, PACKAGES, "the drivers", mirror, suite)
    cuda.toolkit()
