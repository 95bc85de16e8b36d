"""The shaders whose compilation is timed: a function with the whole library before it, with the files that it needs, or
as tools/pick prints it."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import NamedTuple

from translate.pick.command import Choice, picked
from translate.single_file.files import text


class Subject(NamedTuple):
    picked: str  # the name for tools/pick
    file: str
    call: str  # of a position p
    axes: int


SUBJECTS = (Subject("hn_perlin2", "perlin2d.glsl", "hn_perlin(p, 7u)", 2),
            Subject("hn_simplex3", "simplex3d.glsl", "hn_simplex(p, 7u)", 3),
            Subject("hn_cellular2", "cellular2d.glsl", "hn_cellular(p, 7u).x", 2),
            Subject("hn_fbm2", "fbm2d.glsl", "hn_fbm(p, 6, 2.0, 0.5, 7u)", 2))
WAYS = {"whole": "the whole library", "part": "the files that it needs", "pick": "tools/pick"}


@functools.cache
def whole() -> str:
    return text(["hashnoise.glsl"], strip=True)


@functools.cache
def texts(subject: Subject) -> dict[str, str]:
    """By way."""
    return {"whole": whole(), "part": text([subject.file], strip=True),
            "pick": picked([subject.picked], Choice())}


def shaders() -> Iterator[tuple[Subject, str, str]]:
    """Each subject, the way, and the library's text."""
    for subject in SUBJECTS:
        for way, library in texts(subject).items():
            yield subject, way, library


def fragment(version: str, subject: Subject, library: str) -> str:
    """A whole fragment shader. `version` has the lines before the library."""
    return (f"{version}\n{library}\nin vec{subject.axes} p;\nout vec4 color;\n"
            f"void main() {{ color = vec4({subject.call}); }}\n")
