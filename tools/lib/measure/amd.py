"""Instructions for AMD's GPUs, as Mesa's RADV compiles shaders for a GPU that the machine lacks."""

from __future__ import annotations

import os
from pathlib import Path

from base.debian import Missing
from base.tree import HN_CONFORM
from measure import record
from measure.gpu.compiling import compile_all

FAMILIES = ("navi21", "vega10")  # RADV's names
FOLDERS = (Path("/usr/share/vulkan/icd.d"), Path("/etc/vulkan/icd.d"))
CHANGING = ("RADV_", "ACO_", "MESA_", "VK_", "NODEVICE_SELECT")  # variables that could change the counts


def environment(family: str) -> dict[str, str]:
    drivers = ":".join(str(file) for folder in FOLDERS for file in sorted(folder.glob("radeon_icd*.json")))
    if not drivers:
        raise Missing(f"Mesa's RADV is not here: no radeon_icd*.json is in {' or '.join(map(str, FOLDERS))}")
    return {**{name: value for name, value in os.environ.items() if not name.startswith(CHANGING)},
            "RADV_FORCE_FAMILY": family, "RADV_DEBUG": "nocache", "MESA_SHADER_CACHE_DISABLE": "true",
            "VK_DRIVER_FILES": drivers, "VK_ICD_FILENAMES": drivers,  # the older name, all that Debian 12's loader knows
            "NODEVICE_SELECT": "1"}  # Mesa's layer that sorts the GPUs, and connects to a display server


def add_counts(path: Path, spirv: Path, program: str = str(HN_CONFORM)) -> bool:
    """Adds a column for each family to a record, behind that of SPIR-V, of the files that hn-conform --dump left. False
    if a shader could not be counted."""
    found = record.read(path)
    files = {row["id"]: spirv / f"{row['id']}.spv" for row in found.rows}
    files = {id: file for id, file in files.items() if file.is_file()}
    columns = list(found.rows[0])
    complete = True
    for family in reversed(FAMILIES):
        columns.insert(columns.index("spirv") + 1, family)
        counts, why = {}, ""
        try:
            if files:
                counts = dict(zip(files, compile_all([program, "shader-statistics"], environment(family),
                                                     list(files.values()))[1]))
        except Missing as error:
            why = str(error)
            found.facts[f"no counts from {family} here"] = why
        for row in found.rows:
            one = counts.get(row["id"])
            count = one.statistics.get("Instructions") if one else None
            row[family] = "not here" if why else "failed" if count is None else f"{count:g}"
            if one and count is None:
                complete = False
                row["problem"] = "\n".join(filter(None, (row["problem"], f"{family}: {one.problem or 'no count'}")))
    record.write(path, found.rows, columns, found.facts)
    return complete
