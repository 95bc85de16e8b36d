"""The shaders of the node groups, in Open Shading Language, and what each has of its parameters."""

import re
from pathlib import Path

FOLDER = Path(__file__).parent / "shaders"
METADATA = re.compile(r'(\w+) = \S+\s+\[\[ string help = "([^"]*)"(.*?)\]\]', re.S)
END = re.compile(r"(float|int) (min|max) = ([-\d.]+)")


def names():
    return sorted(path.stem for path in FOLDER.glob("*.osl"))


def text(name):
    return (FOLDER / f"{name}.osl").read_text(encoding="utf-8")


def code(of):
    """A text without comments, in which the version is, and without metadata: it alone makes values."""
    return re.sub(r"(?m)^ *//.*\n|(?s:\s+\[\[.*?\]\])", "", of)


def described(of):
    """A text's parameters by name: the properties that Blender calls description, min and max."""
    return {name: {"description": what[0].upper() + what[1:],
                   **{end: {"float": float, "int": int}[kind](number) for kind, end, number in END.findall(ends)}}
            for name, what, ends in METADATA.findall(of)}
