"""The GPUs that can be measured without one: what compiles for each, and the compiler's report on a shader: a
driver of Vulkan with what stands in for its kernel, or a compiler that needs neither."""

from __future__ import annotations

from typing import NamedTuple


class Vendor(NamedTuple):
    """A compiler, and the names of its statistics: a driver's own (VK_KHR_pipeline_executable_properties), or those of
    kernels.py."""
    title: str
    driver: str  # Mesa's name: of DRIVER_icd.json; or one of kernels.COMPILERS
    shim: str  # of libSHIM_noop_drm_shim.so
    cost: str  # what a shader takes, as the compiler estimates it
    unit: str  # of that, for tables
    instructions: str
    kinds: tuple[str, ...]  # what else is counted
    registers: str
    spills: tuple[str, ...]
    is_driver: bool = True  # which takes SPIR-V, by hn-conform


class Chip(NamedTuple):
    name: str
    title: str
    vendor: Vendor
    variable: str  # NAME=VALUE that sets the shim's GPU, or empty; or the compiler's name of the GPU
    lanes: int = 0  # in a pass, where passes are counted


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
# The kinds are the units that run instructions. From Ampere to Hopper a multiprocessor has 128 lanes for FP, 64 for the
# ALU (integers, comparisons, minima) and for IMAD, and fewer for XU (roots, powers, floors, conversions).
NVCC = Vendor("NVIDIA", "nvcc", "", "Issue slots", "issue slots", "Issue slots",
              ("FP", "ALU", "IMAD", "XU", "moves", "uniform", "memory", "branches", "Loops"), "Registers",
              ("Spilled bytes",), is_driver=False)
IGC = Vendor("Intel", "ocloc", "", "Passes", "passes for 16 lanes", "Instructions",
             ("floats", "integers", "products", "math", "moves", "memory", "branches", "Loops"), "Registers",
             ("Spilled bytes",), is_driver=False)

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
    # For sm_89 (Ada) it makes the same counts.
    Chip("sm86", "NVIDIA sm_86, Ampere and Ada, by nvcc", NVCC, "sm_86"),
    Chip("sm90", "NVIDIA sm_90, Hopper, by nvcc", NVCC, "sm_90"),
    Chip("sm100", "NVIDIA sm_100, Blackwell for data centres, by nvcc", NVCC, "sm_100"),
    Chip("sm120", "NVIDIA sm_120, Blackwell, by nvcc", NVCC, "sm_120"),
    Chip("tgllp", "Intel Tiger Lake, Xe", IGC, "tgllp", 8),
    Chip("acm", "Intel Arc A770, Xe-HPG", IGC, "acm-g10", 8),
    Chip("bmg", "Intel Arc B580, Xe2", IGC, "bmg", 16),
)
# One of each compiler, for tables.
SHOWN = ("ampere", "sm90", "navi31", "adreno740", "m1", "acm")


def chip_named(name: str) -> Chip:
    return next(chip for chip in CHIPS if chip.name == name)
