"""The pictures of docs/measured/quality.md."""

from __future__ import annotations

from pathlib import Path

import matplotlib
import numpy as np
from PIL import Image  # which matplotlib needs as well

matplotlib.use("Agg")

import matplotlib.pyplot as plt

from measure.hashes import controls, fields, fourier, isotropy
from measure.hashes.lattice import of_words, sample
from measure.hashes.library import Twin

SIDE = 64    # cells: small enough to see single lags
PATCH = 24   # cells of noise in a picture
PER_CELL = 10  # samples of it
SECTORS = 36  # of 5 degrees
SHOWN = 8.0  # standard deviations, and spectral ordinates, at which the scales end: what the gate calls a failure


def lattices(path: Path, default: Twin) -> None:
    """Autocorrelation and periodogram of the x component: of the default hash, and of two that fail."""
    shape = (SIDE, SIDE)
    shown = [(f"hashnoise, {default.name}", sample(default, shape, (0, 0), 0)),
             ("partial FNV1, as published", of_words(controls.partial_fnv1(shape), default)),
             ("a sum of multiples", of_words(controls.linear_sum(shape), default))]
    figure, axes = plt.subplots(2, 3, figsize=(8, 5.6), layout="constrained")
    for column, (name, window) in zip(axes.T, shown):
        power = fourier.power(fourier.component(window, 0))
        lags = np.fft.fftshift(fourier.lag_scores(fourier.correlation(power)))
        column[0].imshow(lags.T, cmap="RdBu", vmin=-SHOWN, vmax=SHOWN, extent=[-SIDE / 2, SIDE / 2] * 2, origin="lower",
                         interpolation="nearest")
        column[0].set_title(name, fontsize=10)
        below = column[1].imshow(np.fft.fftshift(power).T, cmap="magma", vmin=0, vmax=SHOWN, extent=[-0.5, 0.5] * 2,
                                 origin="lower", interpolation="nearest")
        column[1].set_xlabel("cycles per cell, x")
        column[0].set_xlabel("lag, x")
    axes[0][0].set_ylabel("lag, y")
    axes[1][0].set_ylabel("cycles per cell, y")
    figure.colorbar(axes[0][2].images[0], ax=axes[0], label="standard deviations", shrink=0.8)
    figure.colorbar(below, ax=axes[1], label="power / mean", shrink=0.8)
    save(figure, path)


def isotropy_of_shapes(path: Path, default: Twin) -> None:
    """The same words as gradients of three sets: the noise, and how often its structures have which direction."""
    window = sample(default, (2 * isotropy.SIDES[2],) * 2, (0, 0), 0)
    angle = window.words * (2 * np.pi / 2 ** 32)
    signs = np.stack([fourier.signs(window.words, 31), fourier.signs(window.words, 22)], axis=-1)
    shown = [("four diagonals", signs, "--"), ("hashnoise", window.gradients, "-"),
             ("on the circle", np.stack([np.cos(angle), np.sin(angle)], axis=-1), ":")]
    figure, axes = plt.subplots(1, 4, figsize=(10.4, 2.7), layout="constrained")
    for axis, (name, gradients, line) in zip(axes, shown):
        field = isotropy.noise(gradients[:PATCH, :PATCH], PER_CELL)
        axis.imshow(field.T, cmap="gray", vmin=-2.5 * field.std(), vmax=2.5 * field.std(), origin="lower")
        axis.set(xticks=[], yticks=[])
        found = [isotropy.across(isotropy.structure(isotropy.noise(block))) for block in isotropy.blocks(gradients)]
        axis.set_title(f"{name}: {np.mean([isotropy.mean_preference(*f) for f in found]):+.2f}", fontsize=10)
        vectors, weights = map(np.concatenate, zip(*found))
        degrees = np.degrees(np.arctan2(vectors[:, 1], vectors[:, 0])) % 180
        density, edges = np.histogram(degrees, SECTORS, (0, 180), weights=weights)
        axes[3].plot((edges[1:] + edges[:-1]) / 2, density / density.mean(), line, label=name)
    axes[3].set(xlabel="direction across structures, degrees", ylabel="weight / mean", xticks=range(0, 181, 45),
                ylim=(0, 3))
    axes[3].grid(alpha=0.3)
    axes[3].legend(frameon=False, fontsize=8)
    save(figure, path)


def looks(path: Path, default: Twin) -> None:
    """Noises on the plane, with as many steps of their lattices, and how often their structures have which direction."""
    figure, axes = plt.subplots(1, 4, figsize=(10.4, 2.7), layout="constrained")
    for axis, noise_, line in zip(axes, fields.NOISES, ("--", "-", ":")):
        blocks = [fields.block(default, noise_, seed) for seed in fields.SEEDS]
        side = PATCH * isotropy.PER_CELL
        field = blocks[0][:side, :side]
        axis.imshow(field.T, cmap="gray", vmin=-2.5 * field.std(), vmax=2.5 * field.std(), origin="lower")
        axis.set(xticks=[], yticks=[])
        axis.set_title(f"hn_{noise_.name}", fontsize=10)
        vectors, weights = map(np.concatenate, zip(*[isotropy.across(isotropy.structure(b)) for b in blocks]))
        degrees = np.degrees(np.arctan2(vectors[:, 1], vectors[:, 0])) % 180
        density, edges = np.histogram(degrees, SECTORS, (0, 180), weights=weights)
        axes[3].plot((edges[1:] + edges[:-1]) / 2, density / density.mean(), line, label=f"hn_{noise_.name}")
    axes[3].set(xlabel="direction across structures, degrees", ylabel="weight / mean", xticks=range(0, 181, 45),
                ylim=(0, 2))
    axes[3].grid(alpha=0.3)
    axes[3].legend(frameon=False, fontsize=8)
    save(figure, path)


def noise(path: Path, results: list) -> None:
    """The plot of the default hash: power by frequency, and by direction."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    for result in results:
        measured = result.noise
        left.semilogy(measured.radius, measured.radial / measured.radial.max(), label=f"{result.dimensions}D")
        degrees = (np.arange(len(measured.angular)) + 0.5) * 180 / len(measured.angular)
        right.plot(degrees, measured.angular, "o-", markersize=3, label=f"{result.dimensions}D")
    left.set(xlabel="cycles per cell", ylabel="power density / highest", xlim=(0, 4), ylim=(1e-9, 2))
    right.set(xlabel="direction, degrees", ylabel="power / mean, 0.3 to 1.2 cycles per cell", ylim=(0.5, 1.5))
    right.set_xticks(range(0, 181, 45))
    for axis in (left, right):
        axis.grid(alpha=0.3)
        axis.legend(frameon=False)
    save(figure, path)


def save(figure, path: Path) -> None:
    figure.canvas.draw()
    picture = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3])
    # 64 colours, without dithering: a quarter of the size, and the same to the eye.
    picture.quantize(64, dither=Image.Dither.NONE).save(path, optimize=True)
    plt.close(figure)
