"""The folder of drivers: Mesa's, of Debian's unstable suite (debian.py)."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

import debian
from debian import Missing
from gpu.chips import CHIPS, UNUSED_SHIMS, Chip

PACKAGES = ("mesa-vulkan-drivers", "mesa-drm-shim", "libvulkan1")


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
        packages = (self.folder / debian.VERSIONS).read_text(encoding="utf-8").split()
        return next(package for package in packages if package.startswith(PACKAGES[0]))


def find(folder: Path) -> Drivers:
    if found := debian.find(folder, "libvulkan.so.1"):
        return Drivers(*found)
    raise Missing(f"there are no drivers in {folder.absolute()}; tools/gpu-costs --get-drivers puts them there, some 70 MB "
                  "of Debian's packages that become 350 MB, without installing anything")
