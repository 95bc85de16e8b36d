"""The GPUs that can be measured without one: which driver of Vulkan compiles for each, what stands in for its kernel,
and what the compiler says of a shader."""

from __future__ import annotations

from typing import NamedTuple


class Vendor(NamedTuple):
    """A driver, and the names of its statistics (VK_KHR_pipeline_executable_properties)."""
    title: str
    driver: str  # Mesa's name: of DRIVER_icd.json
    shim: str  # of libSHIM_noop_drm_shim.so
    cost: str  # what a shader takes, as the compiler estimates it
    unit: str  # of that, for tables
    instructions: str
    kinds: tuple[str, ...]  # what else is counted
    registers: str
    spills: tuple[str, ...]


class Chip(NamedTuple):
    name: str
    title: str
    vendor: Vendor
    variable: str  # NAME=VALUE by which the shim is told which GPU to be, or empty


NVIDIA = Vendor("NVIDIA", "nouveau", "nouveau", "Static cycle count", "cycles", "Instruction count", (),
                "Number of GPRs", ("Spills to memory", "Spills to reg"))
AMD = Vendor("AMD", "radeon", "amdgpu", "Inverse Throughput", "cycles of a SIMD", "Instructions",
             ("Latency", "VALU", "SALU", "VOPD", "VMEM", "SMEM", "Branches"), "VGPRs",
             ("Spilled VGPRs", "Spilled SGPRs"))
ADRENO = Vendor("Adreno", "freedreno", "freedreno", "Instruction Count", "instructions", "Instruction Count",
                ("NOPs Count", *(f"cat{number} instructions" for number in range(8)),
                 "Estimated cycles stalled on SS", "Estimated cycles stalled on SY", "Loops"), "Registers used",
                ("STP Count", "LDP Count"))
APPLE = Vendor("Apple", "asahi", "asahi", "ALU", "cycles", "Instructions", ("FSCIB", "IC", "Loops"), "GPRs",
               ("Spills", "Fills"))

CHIPS = (
    Chip("turing", "NVIDIA TU104, Turing", NVIDIA, "NOUVEAU_CHIPSET=0x164"),
    Chip("ampere", "NVIDIA GA104, Ampere", NVIDIA, "NOUVEAU_CHIPSET=0x174"),
    Chip("ada", "NVIDIA AD104, Ada", NVIDIA, "NOUVEAU_CHIPSET=0x194"),
    Chip("blackwell", "NVIDIA GB202, Blackwell", NVIDIA, "NOUVEAU_CHIPSET=0x1b2"),
    Chip("polaris10", "AMD Polaris 10, GCN 4", AMD, "AMDGPU_GPU_ID=polaris10"),
    Chip("vega10", "AMD Vega 10, GCN 5", AMD, "AMDGPU_GPU_ID=vega10"),
    Chip("navi10", "AMD Navi 10, RDNA", AMD, "AMDGPU_GPU_ID=navi10"),
    Chip("navi21", "AMD Navi 21, RDNA 2", AMD, "AMDGPU_GPU_ID=navi21"),
    Chip("navi31", "AMD Navi 31, RDNA 3", AMD, "AMDGPU_GPU_ID=navi31"),
    Chip("strix1", "AMD Strix Point, RDNA 3.5", AMD, "AMDGPU_GPU_ID=strix1"),
    Chip("gfx1201", "AMD Navi 48, RDNA 4", AMD, "AMDGPU_GPU_ID=gfx1201"),
    Chip("adreno630", "Adreno 630", ADRENO, "FD_GPU_ID=630"),
    Chip("adreno660", "Adreno 660", ADRENO, "FD_GPU_ID=660"),
    Chip("adreno730", "Adreno 730", ADRENO, "FD_GPU_ID=730"),
    Chip("adreno740", "Adreno 740", ADRENO, "FD_GPU_ID=740"),
    Chip("adreno750", "Adreno 750", ADRENO, "FD_GPU_ID=750"),
    # Its shim has no other.
    Chip("m1", "Apple M1", APPLE, ""),
)
# One of each vendor, for tables.
SHOWN = ("ampere", "navi31", "adreno740", "m1")
# In the package, and of no use here: its GPUs are older than Vulkan.
UNUSED_SHIMS = frozenset({"radeon"})


def chip_named(name: str) -> Chip:
    return next(chip for chip in CHIPS if chip.name == name)
