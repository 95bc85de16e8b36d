"""The types of the package. Docstrings are beside the code; that both have the same functions is tested."""

from collections.abc import Sequence
from typing import Literal, TypeAlias, overload

import numpy as np
import numpy.typing as npt

Values: TypeAlias = npt.NDArray[np.float32]
Number: TypeAlias = float | np.floating | np.integer
Cells: TypeAlias = npt.ArrayLike | Sequence[npt.ArrayLike]
Arithmetic: TypeAlias = Literal["fast", "precise", "fixed"]
Metric: TypeAlias = Literal["euclidean", "squared", "manhattan", "chebyshev", "hybrid"]

__version__: str

@overload
def value(x: Number, y: Number | None = None, z: Number | None = None, w: Number | None = None, /, *, seed: int = 0,
          period: int | Sequence[int] | None = None, cell: int | Sequence[int] | None = None,
          arithmetic: Arithmetic = "fast", out: None = None, threads: int | None = None,
          instruction_set: str | None = None) -> float: ...
@overload
def value(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
          w: npt.ArrayLike | None = None, /, *, seed: int = 0, period: int | Sequence[int] | None = None,
          cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
          threads: int | None = None, instruction_set: str | None = None) -> Values: ...
def value_d(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
            w: npt.ArrayLike | None = None, /, *, seed: int = 0, period: int | Sequence[int] | None = None,
            cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
            threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def value_cubic(x: Number, y: Number | None = None, z: Number | None = None, /, *, seed: int = 0,
                period: int | Sequence[int] | None = None, cell: int | Sequence[int] | None = None,
                arithmetic: Arithmetic = "fast", out: None = None, threads: int | None = None,
                instruction_set: str | None = None) -> float: ...
@overload
def value_cubic(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
                period: int | Sequence[int] | None = None, cell: Cells | None = None, arithmetic: Arithmetic = "fast",
                out: Values | None = None, threads: int | None = None,
                instruction_set: str | None = None) -> Values: ...
@overload
def perlin(x: Number, y: Number | None = None, z: Number | None = None, w: Number | None = None, /, *, seed: int = 0,
           period: int | Sequence[int] | None = None, phase: float | None = None,
           cell: int | Sequence[int] | None = None, arithmetic: Arithmetic = "fast", out: None = None,
           threads: int | None = None, instruction_set: str | None = None) -> float: ...
@overload
def perlin(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, seed: int = 0, period: int | Sequence[int] | None = None,
           phase: float | None = None, cell: Cells | None = None, arithmetic: Arithmetic = "fast",
           out: Values | None = None, threads: int | None = None, instruction_set: str | None = None) -> Values: ...
def perlin_d(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
             w: npt.ArrayLike | None = None, /, *, seed: int = 0, period: int | Sequence[int] | None = None,
             phase: float | None = None, cell: Cells | None = None, arithmetic: Arithmetic = "fast",
             out: Values | None = None, threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def simplex(x: Number, y: Number, z: Number | None = None, w: Number | None = None, /, *, seed: int = 0,
            period: int | Sequence[int] | None = None, phase: float | None = None,
            cell: int | Sequence[int] | None = None, arithmetic: Arithmetic = "fast", out: None = None,
            threads: int | None = None, instruction_set: str | None = None) -> float: ...
@overload
def simplex(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, w: npt.ArrayLike | None = None, /, *,
            seed: int = 0, period: int | Sequence[int] | None = None, phase: float | None = None,
            cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
            threads: int | None = None, instruction_set: str | None = None) -> Values: ...
def simplex_d(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, w: npt.ArrayLike | None = None, /,
              *, seed: int = 0, period: int | Sequence[int] | None = None, phase: float | None = None,
              cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
              threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def simplex_smooth(x: Number, y: Number, z: Number | None = None, /, *, seed: int = 0,
                   period: int | Sequence[int] | None = None, cell: int | Sequence[int] | None = None,
                   arithmetic: Arithmetic = "fast", out: None = None, threads: int | None = None,
                   instruction_set: str | None = None) -> float: ...
@overload
def simplex_smooth(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
                   period: int | Sequence[int] | None = None, cell: Cells | None = None,
                   arithmetic: Arithmetic = "fast", out: Values | None = None, threads: int | None = None,
                   instruction_set: str | None = None) -> Values: ...
def cellular(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
             period: int | Sequence[int] | None = None, jitter: float = 1.0, metric: Metric = "euclidean",
             cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
             threads: int | None = None, instruction_set: str | None = None) -> Values: ...
def cellular_three(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
                   period: int | Sequence[int] | None = None, jitter: float = 1.0, metric: Metric = "euclidean",
                   cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
                   threads: int | None = None, instruction_set: str | None = None) -> Values: ...
def cellular_d(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
               period: int | Sequence[int] | None = None, jitter: float = 1.0, cell: Cells | None = None,
               arithmetic: Arithmetic = "fast", out: Values | None = None, threads: int | None = None,
               instruction_set: str | None = None) -> Values: ...
@overload
def cellular_smooth(x: Number, y: Number, z: Number | None = None, /, *, seed: int = 0,
                    period: int | Sequence[int] | None = None, jitter: float = 1.0,
                    cell: int | Sequence[int] | None = None, arithmetic: Arithmetic = "fast", out: None = None,
                    threads: int | None = None, instruction_set: str | None = None) -> float: ...
@overload
def cellular_smooth(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
                    period: int | Sequence[int] | None = None, jitter: float = 1.0, cell: Cells | None = None,
                    arithmetic: Arithmetic = "fast", out: Values | None = None, threads: int | None = None,
                    instruction_set: str | None = None) -> Values: ...
@overload
def cell_border(x: Number, y: Number, z: Number | None = None, /, *, seed: int = 0,
                period: int | Sequence[int] | None = None, jitter: float = 1.0,
                cell: int | Sequence[int] | None = None, arithmetic: Arithmetic = "fast", out: None = None,
                threads: int | None = None, instruction_set: str | None = None) -> float: ...
@overload
def cell_border(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
                period: int | Sequence[int] | None = None, jitter: float = 1.0, cell: Cells | None = None,
                arithmetic: Arithmetic = "fast", out: Values | None = None, threads: int | None = None,
                instruction_set: str | None = None) -> Values: ...
def curl(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
         period: int | Sequence[int] | None = None, cell: Cells | None = None, arithmetic: Arithmetic = "fast",
         out: Values | None = None, threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def fbm(x: Number, y: Number | None = None, z: Number | None = None, w: Number | None = None, /, *, seed: int = 0,
        noise: str = "perlin", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
        detail: float | None = None, footprint: float | None = None, period: int | Sequence[int] | None = None,
        cell: int | Sequence[int] | None = None, arithmetic: Arithmetic = "fast", out: None = None,
        threads: int | None = None, instruction_set: str | None = None) -> float: ...
@overload
def fbm(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
        w: npt.ArrayLike | None = None, /, *, seed: int = 0, noise: str = "perlin", octaves: int = 6,
        lacunarity: float = 2.0, gain: float = 0.5, detail: float | None = None, footprint: float | None = None,
        period: int | Sequence[int] | None = None, cell: Cells | None = None, arithmetic: Arithmetic = "fast",
        out: Values | None = None, threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def turbulence(x: Number, y: Number | None = None, z: Number | None = None, w: Number | None = None, /, *,
               seed: int = 0, noise: str = "perlin", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
               period: int | Sequence[int] | None = None, cell: int | Sequence[int] | None = None,
               arithmetic: Arithmetic = "fast", out: None = None, threads: int | None = None,
               instruction_set: str | None = None) -> float: ...
@overload
def turbulence(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
               w: npt.ArrayLike | None = None, /, *, seed: int = 0, noise: str = "perlin", octaves: int = 6,
               lacunarity: float = 2.0, gain: float = 0.5, period: int | Sequence[int] | None = None,
               cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
               threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def clouds(x: Number, y: Number | None = None, z: Number | None = None, w: Number | None = None, /, *, seed: int = 0,
           noise: str = "perlin", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
           period: int | Sequence[int] | None = None, cell: int | Sequence[int] | None = None,
           arithmetic: Arithmetic = "fast", out: None = None, threads: int | None = None,
           instruction_set: str | None = None) -> float: ...
@overload
def clouds(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, seed: int = 0, noise: str = "perlin", octaves: int = 6,
           lacunarity: float = 2.0, gain: float = 0.5, period: int | Sequence[int] | None = None,
           cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
           threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def billow(x: Number, y: Number | None = None, z: Number | None = None, w: Number | None = None, /, *, seed: int = 0,
           noise: str = "perlin", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
           period: int | Sequence[int] | None = None, cell: int | Sequence[int] | None = None,
           arithmetic: Arithmetic = "fast", out: None = None, threads: int | None = None,
           instruction_set: str | None = None) -> float: ...
@overload
def billow(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, seed: int = 0, noise: str = "perlin", octaves: int = 6,
           lacunarity: float = 2.0, gain: float = 0.5, period: int | Sequence[int] | None = None,
           cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
           threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def ridged(x: Number, y: Number | None = None, z: Number | None = None, w: Number | None = None, /, *, seed: int = 0,
           noise: str = "perlin", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
           period: int | Sequence[int] | None = None, cell: int | Sequence[int] | None = None,
           arithmetic: Arithmetic = "fast", out: None = None, threads: int | None = None,
           instruction_set: str | None = None) -> float: ...
@overload
def ridged(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, seed: int = 0, noise: str = "perlin", octaves: int = 6,
           lacunarity: float = 2.0, gain: float = 0.5, period: int | Sequence[int] | None = None,
           cell: Cells | None = None, arithmetic: Arithmetic = "fast", out: Values | None = None,
           threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def ping_pong(x: Number, y: Number | None = None, z: Number | None = None, w: Number | None = None, /, *,
              seed: int = 0, noise: str = "perlin", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
              strength: float = 2.0, period: int | Sequence[int] | None = None,
              cell: int | Sequence[int] | None = None, arithmetic: Arithmetic = "fast", out: None = None,
              threads: int | None = None, instruction_set: str | None = None) -> float: ...
@overload
def ping_pong(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
              w: npt.ArrayLike | None = None, /, *, seed: int = 0, noise: str = "perlin", octaves: int = 6,
              lacunarity: float = 2.0, gain: float = 0.5, strength: float = 2.0,
              period: int | Sequence[int] | None = None, cell: Cells | None = None, arithmetic: Arithmetic = "fast",
              out: Values | None = None, threads: int | None = None,
              instruction_set: str | None = None) -> Values: ...
@overload
def weighted(x: Number, y: Number | None = None, z: Number | None = None, w: Number | None = None, /, *,
             seed: int = 0, noise: str = "perlin", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
             strength: float = 1.0, period: int | Sequence[int] | None = None,
             cell: int | Sequence[int] | None = None, arithmetic: Arithmetic = "fast", out: None = None,
             threads: int | None = None, instruction_set: str | None = None) -> float: ...
@overload
def weighted(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
             w: npt.ArrayLike | None = None, /, *, seed: int = 0, noise: str = "perlin", octaves: int = 6,
             lacunarity: float = 2.0, gain: float = 0.5, strength: float = 1.0,
             period: int | Sequence[int] | None = None, cell: Cells | None = None, arithmetic: Arithmetic = "fast",
             out: Values | None = None, threads: int | None = None, instruction_set: str | None = None) -> Values: ...
def fbm_d(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
          noise: str = "perlin_d", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
          period: int | Sequence[int] | None = None, cell: Cells | None = None, arithmetic: Arithmetic = "fast",
          out: Values | None = None, threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def eroded(x: Number, y: Number, z: Number | None = None, /, *, seed: int = 0, noise: str = "perlin_d",
           octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5, strength: float = 1.0,
           period: int | Sequence[int] | None = None, cell: int | Sequence[int] | None = None,
           arithmetic: Arithmetic = "fast", out: None = None, threads: int | None = None,
           instruction_set: str | None = None) -> float: ...
@overload
def eroded(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
           noise: str = "perlin_d", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
           strength: float = 1.0, period: int | Sequence[int] | None = None, cell: Cells | None = None,
           arithmetic: Arithmetic = "fast", out: Values | None = None, threads: int | None = None,
           instruction_set: str | None = None) -> Values: ...
def warp(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
         noise: str = "value", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5, amplitude: float = 1.0,
         period: int | Sequence[int] | None = None, cell: Cells | None = None, arithmetic: Arithmetic = "fast",
         out: Values | None = None, threads: int | None = None, instruction_set: str | None = None) -> Values: ...
def warp_progressive(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, seed: int = 0,
                     noise: str = "value", octaves: int = 6, lacunarity: float = 2.0, gain: float = 0.5,
                     amplitude: float = 1.0, period: int | Sequence[int] | None = None, cell: Cells | None = None,
                     arithmetic: Arithmetic = "fast", out: Values | None = None, threads: int | None = None,
                     instruction_set: str | None = None) -> Values: ...
@overload
def grid(name: str, size: int | Sequence[int], *, step: float | Sequence[float],
         origin: float | Sequence[float] = 0.0, cell: int | Sequence[int] | None = None, seed: int = 0,
         noise: str | None = None, octaves: int | None = None, lacunarity: float | None = None,
         gain: float | None = None, strength: float | None = None, amplitude: float | None = None,
         detail: float | None = None, footprint: float | None = None, period: int | Sequence[int] | None = None,
         phase: float | None = None, jitter: float | None = None, metric: Metric | None = None,
         arithmetic: Arithmetic = "fast", out: Values | None = None, return_range: Literal[False] = False,
         threads: int | None = None, instruction_set: str | None = None) -> Values: ...
@overload
def grid(name: str, size: int | Sequence[int], *, step: float | Sequence[float],
         origin: float | Sequence[float] = 0.0, cell: int | Sequence[int] | None = None, seed: int = 0,
         noise: str | None = None, octaves: int | None = None, lacunarity: float | None = None,
         gain: float | None = None, strength: float | None = None, amplitude: float | None = None,
         detail: float | None = None, footprint: float | None = None, period: int | Sequence[int] | None = None,
         phase: float | None = None, jitter: float | None = None, metric: Metric | None = None,
         arithmetic: Arithmetic = "fast", out: Values | None = None, return_range: Literal[True],
         threads: int | None = None, instruction_set: str | None = None) -> tuple[Values, tuple[float, float]]: ...
@overload
def grid(name: str, size: int | Sequence[int], *, step: float | Sequence[float],
         origin: float | Sequence[float] = 0.0, cell: int | Sequence[int] | None = None, seed: int = 0,
         noise: str | None = None, octaves: int | None = None, lacunarity: float | None = None,
         gain: float | None = None, strength: float | None = None, amplitude: float | None = None,
         detail: float | None = None, footprint: float | None = None, period: int | Sequence[int] | None = None,
         phase: float | None = None, jitter: float | None = None, metric: Metric | None = None,
         arithmetic: Arithmetic = "fast", out: Values | None = None, return_range: bool, threads: int | None = None,
         instruction_set: str | None = None) -> Values | tuple[Values, tuple[float, float]]: ...
def components(name: str, dimensions: int, *, noise: str | None = None) -> tuple[str, ...]: ...
def noises(dimensions: int) -> tuple[str, ...]: ...
def sums(dimensions: int) -> tuple[str, ...]: ...
def instruction_sets() -> tuple[str, ...]: ...
