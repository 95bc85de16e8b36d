"""Masks of blue noise: the ranks of the paper, thresholds that are even, and spectra beside white noise and beside their
aim."""

from __future__ import annotations

import itertools
import math

import dither
import numpy
import png
from bake_test import Bake
from hashnoise import _bake_mask
from hashnoise._grids import grid

LEVELS = (1 / 16, 1 / 8, 1 / 4, 1 / 2, 3 / 4, 15 / 16)
WHITE = grid("random", (64, 64, 16), step=1, cell=0, seed=5, arithmetic="fixed")


def by_the_paper(words):
    """The ranks by the paper's three phases, in sums over all pairs of pixels. Frames take turns."""
    size = numpy.array(words.shape)
    place = numpy.array([*itertools.product(*map(range, words.shape))])
    apart = abs(place[:, None] - place)
    square = numpy.minimum(apart, size - apart)**2
    in_frame, in_time = square[..., 0] == 0, (square[..., 1:] == 0).all(-1)
    weight = numpy.where(in_frame | in_time, _bake_mask._WEIGHTS[square.sum(-1).clip(max=125)], 0)
    words, pixels = words.reshape(-1), size[1] * size[2]
    filled, frames = numpy.zeros(len(words), bool), [slice(f * pixels, (f + 1) * pixels) for f in range(size[0])]

    def greatest(frame, among, energy):  # the first of equal ones
        return max(numpy.flatnonzero(among[frame]) + frame.start, key=energy.__getitem__)

    def cluster(frame, among, sign=1):  # each pixel has its own weight, too, which is the same for all
        return greatest(frame, among, weight @ among + sign * words)

    def void(frame):
        return greatest(frame, ~filled, -(weight @ filled + words))

    for frame in frames:
        filled[frame.start + words[frame].argsort(kind="stable")[:max(pixels // 10, 1)]] = True
    frame = still = 0
    while still < len(frames):
        filled[crowded := cluster(frames[frame], filled)] = False
        filled[empty := void(frames[frame])] = True
        still, frame = (still + 1, (frame + 1) % len(frames)) if crowded == empty else (0, frame)
    first, ranks = filled.copy(), numpy.zeros(len(words), int)
    for rank in range(max(pixels // 10, 1) - 1, -1, -1):
        for frame in frames:
            ranks[crowded := cluster(frame, filled)] = rank
            filled[crowded] = False
    filled = first
    for rank in range(max(pixels // 10, 1), pixels):
        for frame in frames:  # from a half on the empty pixels are fewer, and the one in the tightest cluster is filled
            place = void(frame) if 2 * rank < pixels else cluster(frame, ~filled, -1)
            ranks[place], filled[place] = rank, True
    return ranks.reshape(size)


def faults(frames):
    """The faults that frames of thresholds have as blue noise."""
    found = []
    for level in LEVELS:
        aim = min(level, 1 - level)**0.5  # the principal frequency, of points that are as far apart as they can be
        spectrum = dither.spectrum(1.0 * (frames < level))
        below = dither.mean_of(*spectrum, 0, aim / 2)
        at = dither.mean_of(*spectrum, 0.9 * min(aim, 0.5), 1.3 * min(aim, 0.5))
        if below > (0.5 if level == 0.5 else 0.2) or at < 1.05:
            found.append(f"at {level:.3f} of all pixels the power is {below:.3f} below half the principal frequency, and "
                         f"{at:.2f} at it, of 1 for white noise")
    if dither.mean_of(*dither.spectrum(frames), 0, 0.2) > 0.02:
        found.append("the thresholds themselves have low frequencies")
    even = (numpy.arange(frames[0].size) + 0.5) / frames[0].size
    if any(sorted(frame) != even.astype(numpy.float32).tolist() for frame in frames.reshape(len(frames), -1).tolist()):
        found.append("some threshold is not there once in each frame")
    if len(frames) > 8:
        slow = abs(numpy.fft.fft(frames - 0.5, axis=0)[:len(frames) // 6 + 1])**2 / len(frames) * 12
        if slow.mean() > 0.2:
            found.append(f"over time the power of slow changes is {slow.mean():.2f} of that of white noise")
    return found


class Masks(Bake):
    def mask(self, line):
        self.bake(f"bluenoise {line} -o a.f32")
        return numpy.fromfile("a.f32", "<f4").reshape(-1, 64, 64)

    def test_ranks_are_those_of_the_paper(self):
        self.assertLess(max(abs(weight / 2**40 - math.exp(-square / 4.5))
                            for square, weight in enumerate(_bake_mask._WEIGHTS)), 1e-9)
        for size in ((8, 8, 1), (9, 12, 1), (6, 5, 4)):
            words = (grid("random", size, step=1, cell=0, arithmetic="fixed") * 2.0**24).astype(numpy.int64)
            self.assertEqual(_bake_mask.ranks(words).tolist(), by_the_paper(words).tolist())

    def test_masks_are_blue(self):
        for line in ("", "--seed 9 --components 3", "--frames 16"):
            with self.subTest(line):
                frames = self.mask(line)
                for component in [frames] if "frames" in line else frames[:, None]:
                    self.assertEqual(faults(component), [])
        correlation = numpy.corrcoef(self.mask("--components 4").reshape(4, -1))
        self.assertLess(abs(correlation - numpy.eye(4)).max(), 0.05)

    def test_other_masks_are_found(self):
        self.assertEqual(len(faults(WHITE)), len(LEVELS) + 3)
        blue = self.mask("--frames 16")
        sheared = numpy.stack([numpy.roll(blue[:, y], 7 * y, -1) for y in range(64)], 1)
        self.assertGreater(len(faults(sheared)), len(LEVELS) / 2)
        self.assertRegex(" ".join(faults(blue[numpy.argsort(WHITE[:, 0, 0])])), "^over time")
        blue[3, 0, 0] = blue[3, 0, 1]
        self.assertRegex(" ".join(faults(blue)), "^some threshold")

    def test_files(self):
        one = self.mask("--size 64x64 --seed 3")
        self.assertEqual(self.mask("--seed 3 --frames 1").tobytes(), one.tobytes())
        self.assertNotEqual(self.mask("--seed 4").tobytes(), one.tobytes())
        self.bake("bluenoise --components 2 --frames 4 --seed 3 -o a.png")
        self.bake("bluenoise --components 2 --frames 4 --seed 3 -o a.r16")
        pixels, record = self.read_png("a.png")
        words = self.planes("a.r16", (2, 2, 2, 64, 64), "<u2").transpose(0, 1, 3, 2, 4).reshape(2, 128, 128)
        self.assertEqual(pixels[:2].tolist(), words.tolist())
        self.assertEqual((record["size"], record["settings"]),
                         ([64, 64, 4], {"components": 2, "frames": 4, "seed": 3}))


class Page(Bake):
    def test_the_picture_and_the_table_of_the_page(self):
        _, _, rows, info = png.Reader(bytes=dither.PICTURE.read_bytes()).read()
        self.assertTrue(info["greyscale"])
        difference = abs(numpy.array([*rows], int) - dither.picture())  # a spectrum may round otherwise elsewhere
        self.assertEqual((difference[:dither.SIDE].max(), difference.max() <= 1), (0, True))
        page = dither.PAGE.read_text(encoding="utf-8")
        for row in dither.rows():
            self.assertIn(f"\n{row}\n", page)
