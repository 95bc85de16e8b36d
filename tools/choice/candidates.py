"""The candidates: the library with some of its functions replaced, so that nothing else differs."""

from __future__ import annotations

import re
import shutil
from dataclasses import dataclass
from pathlib import Path

FUNCTION = r"HN_FN [^;{{}}]*\b{name}\([^{{}}]*\) \{{"  # of a definition, up to its brace


@dataclass(frozen=True)
class Candidate:
    name: str
    what: str                       # how it joins and mixes, or what it makes of the bits
    functions: dict[str, str]       # by name, what stands for all definitions of it, in the place of the first
    macros: tuple[str, ...] = ()    # of a hash that the library has already
    scales: tuple[str, str] = ("1913", "1819")  # of noise in 2D and 3D, in 1024ths: what makes the largest value 1


# --- Hashes: from the spread coordinates of a point and the mixed seed to its word ------------------------------

PLAIN = """
HN_FN hn_uint hn_i_fold(hn_uint x) { return x; }
HN_FN hn_uvec2 hn_i_fold(hn_uvec2 v) { return v; }
HN_FN hn_uvec3 hn_i_fold(hn_uvec3 v) { return v; }
HN_FN hn_uvec4 hn_i_fold(hn_uvec4 v) { return v; }
"""
TURNED = """
HN_FN hn_uint hn_i_turned(hn_uint x, hn_int by) { return (x << by) | (x >> (32 - by)); }
HN_FN hn_uint hn_i_fold(hn_uint x) { return x; }
HN_FN hn_uvec2 hn_i_fold(hn_uvec2 v) { return uvec2(hn_i_turned(v.x, 13), v.y); }
HN_FN hn_uvec3 hn_i_fold(hn_uvec3 v) {
  return uvec3(hn_i_turned(v.x, 26), hn_i_turned(v.y, 13), v.z);
}
HN_FN hn_uvec4 hn_i_fold(hn_uvec4 v) {
  return uvec4(hn_i_turned(v.x, 7), hn_i_turned(v.y, 26), hn_i_turned(v.z, 13), v.w);
}
"""


def word(body: str) -> str:
    return f"""
HN_FN hn_uint hn_i_word(hn_uint k, HN_I_UNUSED hn_uint odd) {{ {body} }}
"""


ONE_ROUND = "k ^= k >> 15; k *= 0x2C1B3C6Du;"
TWO_ROUNDS = f"{ONE_ROUND} k ^= k >> 12; k *= 0x297A2D39u;"

HASHES = [
    Candidate("product", "product of the exclusive or of folded coordinates and of their sum", {}),
    Candidate("two_rounds", "exclusive or of turned coordinates; two rounds of shift and multiplication, a last shift: "
              "the default of 0.1", {"hn_i_fold": TURNED, "hn_i_word": word(f"{TWO_ROUNDS} return k ^ (k >> 15);")}),
    Candidate("two_rounds_high", "the same without the last shift, which the high bits do not need",
              {"hn_i_fold": TURNED, "hn_i_word": word(f"{TWO_ROUNDS} return k;")}),
    Candidate("one_round", "exclusive or of turned coordinates; one round",
              {"hn_i_fold": TURNED, "hn_i_word": word(f"{ONE_ROUND} return k;")}),
    Candidate("one_round_24", "exclusive or of turned coordinates; a round of 24 bits, then a multiplication",
              {"hn_i_fold": TURNED, "hn_i_word": word("k ^= (k >> 8) * 0x9A2D39u; return k * 0x2C1B3C6Du;")}),
    Candidate("two_rounds_24", "exclusive or of turned coordinates; two rounds of 24 bits, which AMD multiplies at full "
              "rate", {"hn_i_fold": TURNED,
                       "hn_i_word": word("k ^= (k >> 8) * 0x9A2D39u; return k ^ ((k >> 8) * 0x1B3C6Du);")}),
    Candidate("square", "exclusive or of the coordinates; one round; the square and its high half",
              {"hn_i_fold": PLAIN, "hn_i_word": word(f"{ONE_ROUND} k *= k; return k ^ (k >> 16);")}),
    Candidate("bare_square", "exclusive or of the coordinates; the square and its high half",
              {"hn_i_fold": PLAIN, "hn_i_word": word("k *= k; return k ^ (k >> 16);")}),
    Candidate("half_turn", "exclusive or of turned coordinates, times itself turned by 16 bits",
              {"hn_i_fold": TURNED, "hn_i_word": word("return k * ((k << 16) | (k >> 16));")}),
    Candidate("unfolded_product", "as product, of coordinates that are not folded",
              {"hn_i_fold": PLAIN, "hn_i_word": word("return k * odd;")}),
    *(Candidate(name, f"product, the exclusive or hashed by HN_HASH_{name.upper()}", {},
                (f"HN_HASH=HN_HASH_{name.upper()}",))
      for name in ("partial_fnv1", "murmur", "pcg", "partial_jenkins", "fnv1", "xxhash32", "jenkins")),
]

# --- Gradients: from a word to what a corner adds ----------------------------------------------------------------
# The library turns the offsets in space by 45 degrees about z for its gradient; these take them as they are.

FOLDED = """
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float x, hn_float y) {
  hn_vec2 g = hn_gradient2(h);
  return g.x * x + g.y * y;
}
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float x, hn_float y, hn_float z) {
  hn_float a = hn_i_field3p(h) * 2.0f;
  hn_float b = hn_i_field3q(h) * 2.0f;
  hn_float up = 1.0f - abs(a) - abs(b);
  hn_float t = max(-up, 0.0f);
  return (a < 0.0f ? a + t : a - t) * x + (b < 0.0f ? b + t : b - t) * y + up * z;
}
"""
BOX = """
HN_FN hn_float hn_i_third(hn_uint h) {
  return uintBitsToFloat(((h << 8) & 0x007F8000u) | 0x3F800000u) - (1.5f - 1.0f / 512.0f);
}
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float x, hn_float y) {
  return hn_i_field3p(h) * x + hn_i_field3q(h) * y;
}
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float x, hn_float y, hn_float z) {
  return hn_i_field3p(h) * x + hn_i_field3q(h) * y + hn_i_third(h) * z;
}
"""
MAGNITUDE = """
HN_FN hn_float hn_i_magnitude(hn_uint h) {
  return uintBitsToFloat((h & 0x80FFFFFFu) | 0x3F000000u);
}
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float x, hn_float y) {
  return hn_i_magnitude(h) * x + hn_i_magnitude(h << 8) * y;
}
HN_FN hn_float hn_i_ramp(hn_uint h, hn_float x, hn_float y, hn_float z) {
  return hn_i_magnitude(h) * x + hn_i_magnitude(h << 8) * y + hn_i_magnitude(h << 16) * z;
}
"""
# The arguments of hn_i_ramp in space, turned and not.
OFFSETS = {"(h.x, u, v, w)": "(h.x, f.x, f.y, f.z)",
           "(h.y, u1, hn_i_minus(v, HN_I_ONE), w)": "(h.y, f.x - 1.0f, f.y, f.z)",
           "(h.z, u1, hn_i_plus(v, HN_I_ONE), w)": "(h.z, f.x, f.y - 1.0f, f.z)",
           "(h.w, hn_i_minus(u, HN_I_TWO), v, w)": "(h.w, f.x - 1.0f, f.y - 1.0f, f.z)"}

GRADIENTS = [
    Candidate("octahedral", "a point of the square or octahedron, from two fields and a sign", {}),
    Candidate("octahedral_folded", "the same in space by folding a square onto the octahedron: that of 0.1",
              {"hn_i_ramp": FOLDED}),
    Candidate("box", "a point of the square or cube: a field for each component, in (-1/2, 1/2)", {"hn_i_ramp": BOX},
              scales=("2048.0f", "2048.0f / 1.5f")),
    Candidate("magnitude", "for each component a sign and a magnitude in [1/2, 2), without a subtraction",
              {"hn_i_ramp": MAGNITUDE}, scales=("512.0f", "512.0f / 1.5f")),  # up to 2
]


def definitions(text: str, name: str) -> list[tuple[int, int]]:
    """Where each definition of a function begins and ends."""
    found = []
    for start in re.finditer(FUNCTION.format(name=name), text):
        depth, end = 1, start.end()
        while depth:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        found.append((start.start(), end))
    return found


def replaced(text: str, name: str, functions: str) -> str:
    """The text with other definitions of a function: at the place of the first, in the branch for floats."""
    places = definitions(text, name)
    if not places:
        raise ValueError(f"there is no {name} to replace")
    if name == "hn_i_ramp":
        places = places[:2]  # those of the octahedral gradient in floats come first
    for start, end in reversed(places[1:]):
        text = text[:start] + text[end:]
    start, end = places[0]
    return text[:start] + functions.strip() + text[end:]


def write(candidate: Candidate, library: Path, folder: Path) -> Path:
    """A copy of the library with the functions of a candidate; returns its include folder."""
    shutil.copytree(library / "glsl", folder / "glsl")
    shutil.copytree(library / "include", folder / "include")
    for name, functions in candidate.functions.items():
        path = folder / "glsl" / ("gradient.glsl" if name == "hn_i_ramp" else "hash.glsl")
        path.write_text(replaced(path.read_text(encoding="utf-8"), name, functions), encoding="utf-8")
    changes = {f"hn_i_scaled(n, {old})": f"n * ({new} / 1024.0f)"
               for old, new in zip(("1913", "1819"), candidate.scales)}
    if "hn_i_ramp" in candidate.functions:
        changes |= OFFSETS
    path = folder / "glsl" / "gradient.glsl"
    text = path.read_text(encoding="utf-8")
    for old, new in changes.items():
        if text.count(old) != 1:
            raise ValueError(f"there is no {old} to replace in {path.name}")
        text = text.replace(old, new)
    path.write_text(text, encoding="utf-8")
    return folder / "include"
