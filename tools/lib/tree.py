"""Where things are. A file that moves is named anew here."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOOLS = ROOT / "tools"
GLSL = ROOT / "glsl"
FUNCTIONS = ROOT / "conformance" / "library" / "functions.inc"
CONFIGURATIONS = ROOT / "conformance" / "library" / "configurations.inc"
BOUNDS = ROOT / "conformance" / "expected" / "bounds.inc"
GOLDEN = ROOT / "conformance" / "expected" / "golden"


def version() -> str:
    """Of the library. It stands once, in the file that every shader includes."""
    text = (GLSL / "config.glsl").read_text(encoding="ascii")
    return ".".join(re.findall(r"^#define HN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", text, re.MULTILINE))
