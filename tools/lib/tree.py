"""Where things are. A file that moves is named anew here."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOOLS = ROOT / "tools"
GLSL = ROOT / "glsl"
FUNCTIONS = ROOT / "conformance" / "library" / "functions.inc"
CONFIGURATIONS = ROOT / "conformance" / "library" / "configurations.inc"
BOUNDS = ROOT / "conformance" / "expected" / "bounds.inc"
GOLDEN = ROOT / "conformance" / "expected" / "golden"
