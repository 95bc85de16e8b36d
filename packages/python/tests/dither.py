"""The picture and the table of docs/guide/random.md on dithers.

    environment.py call --with bake.txt FOLDER dither      writes the picture, and prints the table
"""

from __future__ import annotations

import contextlib
import io
import sys
import tempfile
from pathlib import Path

import golden
import hashnoise
import numpy
import png
from hashnoise import _bake

PAGE = golden.ROOT / "docs" / "guide" / "random.md"
PICTURE = golden.ROOT / "docs" / "images" / "dither.png"
SIDE, GREYS, BORDER = 160, 6, 4
LOW = 0.1  # waves per pixel


def thresholds() -> dict[str, numpy.ndarray]:
    """Of the dithers of the page, by their names in its table."""
    y, x = numpy.mgrid[:SIDE, :SIDE]
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
        _bake.main(["bluenoise", "--size", str(SIDE), "--seed", "7", "-o", f"{folder}/mask.f32"])
        mask = numpy.fromfile(Path(folder) / "mask.f32", "<f4").reshape(SIDE, SIDE)
    r2 = (0x80000000 + x * 3242174889 + y * 2447445413) % 2**32 / 2**32
    return {"white noise, `hn_unorm`": hashnoise.grid("random", (SIDE, SIDE), step=1, cell=0, seed=7),
            "interleaved gradient noise": 52.9829189 * ((0.06711056 * x + 0.00583715 * y) % 1) % 1,
            "R2": abs(2 * r2 - 1), "a mask of blue noise": mask}


def spectrum(frames: numpy.ndarray) -> tuple[numpy.ndarray, numpy.ndarray]:
    """Each frequency of pictures, in waves per pixel, and its power: the mean of all pictures, which for white noise is
    1."""
    frequency = numpy.hypot(*numpy.meshgrid(*map(numpy.fft.fftfreq, frames.shape[:-3:-1])))
    power = abs(numpy.fft.fft2(frames - frames.mean()))**2 / frequency.size / frames.var()
    return frequency, power.reshape(-1, *frequency.shape).mean(0)


def mean_of(frequency: numpy.ndarray, power: numpy.ndarray, least: float, most: float) -> float:
    """The mean power of frequencies between two, without 0."""
    return power[(frequency > least) & (frequency < most)].mean()


def rows() -> list[str]:
    """Of the table: the power of low frequencies, and of the hundredth of all frequencies that are strongest."""
    found = []
    for name, threshold in thresholds().items():
        frequency, power = spectrum(threshold)
        strongest = numpy.sort(power, axis=None)[-SIDE**2 // 100:].sum() / power.sum()
        found.append(f"| {name} | {mean_of(frequency, power, 0, LOW):.2g} | {100 * strongest:.0f} % |")
    return found


def picture() -> numpy.ndarray:
    """Above, a glow in a few greys: rounded, and with each dither. Below, all greys of it, and the spectra."""
    y, x = (numpy.mgrid[:SIDE, :SIDE] + 0.5) / SIDE
    glow = 0.1 + 0.3 * (1 - y) + 0.6 * numpy.exp(-6 * ((x - 0.6)**2 + (y - 0.55)**2))
    found = thresholds().values()
    above = [numpy.floor(glow * (GREYS - 1) + threshold) / (GREYS - 1) for threshold in (0.5, *found)]
    spectra = []
    for threshold in found:
        power = numpy.fft.fftshift(spectrum(threshold)[1])
        near = sum(numpy.roll(power, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)) / 9
        spectra.append(numpy.sqrt(near / 4))
    tiles = numpy.pad([above, [glow, *spectra]], ((0, 0), (0, 0), (0, BORDER), (0, BORDER)), constant_values=1)
    sheet = tiles.transpose(0, 2, 1, 3).reshape(2 * (SIDE + BORDER), -1)[:-BORDER, :-BORDER]
    return (numpy.clip(sheet, 0, 1) * 255 + 0.5).astype(numpy.uint8)


def main() -> int:
    png.from_array(picture(), "L").save(PICTURE)
    print("\n".join(rows()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
