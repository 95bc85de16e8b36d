"""Asks Khronos' reference compiler about a shader."""

from __future__ import annotations

import subprocess


def compiled(text: str, *options: str) -> subprocess.CompletedProcess[str]:
    """Of a fragment shader. Nothing is written, unless options demand it."""
    return subprocess.run(["glslangValidator", *options, "--stdin", "-S", "frag"], input=text, capture_output=True,
                          text=True, check=False)
