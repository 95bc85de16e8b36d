"""The shaders whose compilation is timed: a noise with the whole library before it, with the file of it, or as
tools/pick prints it, in two arithmetics; and other libraries' noise."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from measure.gpu.pages import LETTERS
from measure.peers import CALLS, PEERS
from translate.pick.command import Choice, picked
from translate.whole import library


class Subject(NamedTuple):
    noise: str  # as the peers' calls have it
    form: str  # for tools/pick
    file: str
    call: str  # of a position p; the first word is the name in languages that have overloads
    axes: int


SUBJECTS = (Subject("Perlin 2D", "hn_perlin2", "perlin2d.glsl", "hn_perlin(p, 7u)", 2),
            Subject("cellular 3D", "hn_cellular3", "cellular3d.glsl", "length(hn_cellular(p, 7u))", 3),
            Subject("turning simplex 3D with derivatives", "hn_simplex_d3_phase", "simplex_phase3d.glsl",
                    "length(hn_simplex_d(p, p.x, 7u))", 3),
            Subject("fBm 2D, 6 octaves", "hn_fbm2", "fbm2d.glsl", "hn_fbm(p, 6, 2.0, 0.5, 7u)", 2),
            Subject("fBm 3D, 6 octaves", "hn_fbm3", "fbm3d.glsl", "hn_fbm(p, 6, 2.0, 0.5, 7u)", 3),
            Subject("gullies 2D, 5 octaves", "hn_gullies2", "gullies2d.glsl",
                    "length(hn_gullies(p, p, 5, 2.0, 0.5, 0.1, 7u))", 2))
WAYS = ("whole", "file", "pick")
FIXED = "+fixed"
OTHERS = tuple(peer for peer in PEERS if peer.option in ("fastnoiselite", "wombat", "psrdnoise"))
EMPTY = "empty"
FRAMES = {
    "glsl": "{version}{library}\nin vec{axes} p;\nout vec4 color;\nvec4 hn_bench_set;\n"
            "void main() {{ color = vec4({call}); }}\n",
    "hlsl": "{library}\nfloat4 main(float{axes} p : TEXCOORD0) : SV_Target {{ return ({call}).xxxx; }}\n",
    "wgsl": "{library}\n@fragment fn main(@location(0) p: vec{axes}f) -> @location(0) vec4f {{ return vec4f({call}); }}\n"}
# FastNoiseLite as its users call it: the kind of noise and of fractal, in GLSL and in HLSL.
STATES = {"Perlin 2D": ("PERLIN", "NONE"), "cellular 3D": ("CELLULAR", "NONE"), "fBm 2D, 6 octaves": ("PERLIN", "FBM"),
          "fBm 3D, 6 octaves": ("PERLIN", "FBM")}
STATE = """
fnl_state made_state() {{
  fnl_state state = fnlCreateState(7);
  state.frequency = 1.0;
  state.noise_type = FNL_NOISE_{};
  state.fractal_type = FNL_FRACTAL_{};
  state.octaves = 6;
  return state;
}}
"""


class Job(NamedTuple):
    noise: str
    way: str  # one of WAYS, with FIXED or not; the letter of a peer; or EMPTY
    library: str
    call: str
    axes: int

    @property
    def is_foreign(self) -> bool:
        return len(self.way) == 1

    def shader(self, language: str, version: str) -> str:
        return FRAMES[language].format(version=version, library=self.library, call=self.call, axes=self.axes)


def ours(language: str) -> Iterator[Job]:
    for subject in SUBJECTS:
        name = subject.form.partition("2")[0].partition("3")[0]
        call = subject.call.replace(name, subject.form) if language == "wgsl" else subject.call
        for arithmetic, suffix in (("fast", ""), ("fixed", FIXED)):
            pick = picked([subject.form], Choice(language=language, arithmetic=arithmetic))
            texts = (library(language, arithmetic), library(language, arithmetic, subject.file), pick)
            for way, found in zip(WAYS, texts):
                yield Job(subject.noise, way + suffix, found, call, subject.axes)


def theirs(language: str, peers: Mapping[str, Path]) -> Iterator[Job]:
    axes = {subject.noise: subject.axes for subject in SUBJECTS}
    if file := peers.get("fastnoiselite"):
        if language == "hlsl":
            file = file.parents[1] / "HLSL" / "FastNoiseLite.hlsl"
        for noise in filter(axes.get, STATES) if language != "wgsl" and file.exists() else ():
            call = f"fnlGetNoise{axes[noise]}D(made_state(), {', '.join(('p.x', 'p.y', 'p.z')[:axes[noise]])})"
            yield Job(noise, "F", file.read_text("utf-8") + STATE.format(*STATES[noise]), call, axes[noise])
    for call in CALLS if language == "glsl" else ():
        if call.noise in axes and call.peer in peers and call.peer != "fastnoiselite":
            yield Job(call.noise, LETTERS[call.peer], (peers[call.peer] / call.file).read_text("utf-8"), call.expression,
                      axes[call.noise])


def jobs(language: str, peers: Mapping[str, Path]) -> list[Job]:
    """All of them, the empty shader first."""
    return [Job("", EMPTY, "", "p.x", 2), *ours(language), *theirs(language, peers)]
