"""The drawings of the page of the paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np


def _saved(figure, path: Path) -> None:
    from matplotlib.backends.backend_svg import FigureCanvasSVG

    FigureCanvasSVG(figure).print_svg(path)


def histograms(path: Path, samples: Sequence, counts: Mapping[tuple[str, ...], np.ndarray], low: float,
               high: float) -> None:
    """The density of each sample, and a normal distribution of the same mean and variance."""
    from matplotlib.figure import Figure

    columns = 3
    rows = -(-len(samples) // columns)
    figure = Figure((15, 3 * rows), layout="constrained")
    edges = np.linspace(low, high, len(next(iter(counts.values()), [0])) + 1)
    at = np.linspace(low, high, 300)
    for number, sample in enumerate(samples, 1):
        axes = figure.add_subplot(rows, columns, number, title=sample.title(), xlabel="value", ylabel="density")
        found = counts[sample[:3]]
        axes.stairs(found / found.sum() / (edges[1] - edges[0]), edges, fill=True, alpha=0.7)
        deviation = sample.variance ** 0.5
        axes.plot(at, np.exp(-0.5 * ((at - sample.mean) / deviation) ** 2) / (deviation * np.sqrt(2 * np.pi)))
    _saved(figure, path)


def sweep(path: Path, curves: Mapping[str, tuple[Sequence[int], Sequence[float]]], dimensions: str, texture: str) -> None:
    from matplotlib.figure import Figure

    figure = Figure((8, 5), layout="constrained")
    axes = figure.add_subplot(title=f"{dimensions}D noise with further fetches", xlabel=f"fetches per pixel from {texture}",
                              ylabel="time, as a multiple of Perlin/Float without them")
    unit = curves["Perlin/Float"][1][0]
    for name, (fetches, times) in curves.items():
        axes.plot(fetches, np.array(times) / unit, marker="o", label=name)
    axes.set_ylim(bottom=0)
    axes.legend()
    _saved(figure, path)
