"""Golden values as a picture: a fragment shader computes a row of a golden file in each pair of pixels, and this prints
what it drew wrong."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools" / "lib"))

from base.golden_values import Golden  # noqa: E402

WIDTH = 640
MARK = 0x80  # the blue of every pixel

# A condition for each row: renderers on processors would copy one large array for each pixel.
TEXT = """
{head}
uint w[{columns}];
float number(int i) {{ return uintBitsToFloat(w[i]); }}
void main() {{
  int pixel = {y} * {width} + int(gl_FragCoord.x);
  int row = min(pixel / {pixels}, {rows} - 1);
{cases}
  vec3 v = {call};
  int component = pixel / 2 % {components};
  uint word = floatBitsToUint(component == 0 ? v.x : component == 1 ? v.y : v.z);
  uint half_word = pixel % 2 == 0 ? word >> 16u : word & 65535u;
  color = vec4(vec3(half_word >> 8u, half_word & 255u, {mark}u) / 255.0, 1.0);
}}
"""


class Picture:
    """The picture of a golden file whose function is called like call, where x, seed and so on stand for the
    columns."""

    def __init__(self, name: str, call: str):
        self.golden = Golden(name)
        self.components = len(self.golden.expected[0])
        self.call = call
        self.columns = self.golden.head.columns

    def shader(self, head: str, y: str) -> str:
        """head declares color; y is the row of a pixel, from the top."""
        kinds = {"f32": "number({})", "i32": "int(w[{}])", "u32": "w[{}]"}
        values = {name: kinds[kind].format(i) for i, (name, kind) in enumerate(self.columns)}
        call = self.call.format(**values)
        cases = "\n".join(f"  if (row == {i}) w = uint[]({', '.join(f'{word}u' for word in row)});"
                          for i, row in enumerate(self.golden.inputs))
        return TEXT.format(head=head, y=y, cases=cases, width=WIDTH, mark=MARK, pixels=2 * self.components,
                           call=call if self.components == 3 else f"vec3({call}, 0.0, 0.0)",
                           rows=len(self.golden.inputs), columns=len(self.columns), components=self.components)

    @staticmethod
    def drawn(pixels: list[bytes]) -> bool:
        return all(set(row[2::3]) == {MARK} for row in pixels)

    def wrong(self, pixels: list[bytes]) -> list[str]:
        """Which rows have other bits."""
        flat = b"".join(pixels)
        halves = [flat[3 * i] << 8 | flat[3 * i + 1] for i in range(2 * self.components * len(self.golden.expected))]
        words = [high << 16 | low for high, low in zip(halves[::2], halves[1::2])]
        got = [words[i:i + self.components] for i in range(0, len(words), self.components)]
        return [f"row {row + 1}: {[f'{word:08x}' for word in one]}, not {[f'{word:08x}' for word in right]}"
                for row, (one, right) in enumerate(zip(got, self.golden.expected, strict=True)) if one != right]
