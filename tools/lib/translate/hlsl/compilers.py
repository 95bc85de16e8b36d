"""Microsoft's compilers of HLSL on Linux, for tests: DXC, and FXC under wine."""

from __future__ import annotations

import functools
import itertools
import re
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from base.debian import Missing
from translate.tools import DXC, FXC, Tool


class Compiled(NamedTuple):
    """A compiler's result."""
    code: bytes  # nothing if it does not compile
    messages: str


def refusal(made: Compiled) -> str:
    """Why it does not compile, or not in silence; nothing if it does."""
    messages = re.sub(r"warning: DXIL\.dll not found\..*", "", made.messages).strip()  # which signs
    return messages or ("" if made.code else "no code")


# Profiles by the stages of glslang, for DXC and FXC.
STAGES = {"vert": ("vs_6_0", "vs_5_0"), "frag": ("ps_6_0", "ps_5_0")}


@functools.cache
def missing() -> str:
    """Why DXC or FXC is not here; nothing if both are."""
    try:
        DXC.path()
        FXC.path()
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
    made = {"DXC": compiled(DXC, [file], STAGES[stage][0], entry, "-I", str(file.parent)),
            "FXC": compiled(FXC, [file], STAGES[stage][1], entry)}
    return found | {name: one.messages for name, (one,) in made.items() if not one.code}


def compiled(tool: Tool, files: Sequence[Path], profile: str, entry: str = "main", *options: str) -> list[Compiled]:
    """Results of files, which are in one folder, to what Direct3D takes, or by -spirv to SPIR-V. FXC looks for includes
    from that folder on."""
    written = [(Path(f"{file}.code"), Path(f"{file}.messages")) for file in files]
    for path in itertools.chain(*written):  # of an earlier text
        path.unlink(missing_ok=True)
    command = [tool.path(), *options, "-T", profile, "-E", entry, "-each", *(file.name for file in files)]
    done = subprocess.run(command, cwd=files[0].parent, capture_output=True, text=True, errors="replace", check=False)
    # Wine may end with 1, too.
    if done.returncode not in (0, 1) or not written[-1][1].exists():
        raise RuntimeError(f"{command} ended with {done.returncode}: {done.stdout}{done.stderr}")
    return [Compiled(code.read_bytes() if code.exists() else b"",
                     messages.read_bytes().decode(errors="replace").rstrip("\0"))
            for code, messages in written]
