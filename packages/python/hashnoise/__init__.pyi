"""The types of the package. Docstrings are beside the code; that both have the same functions is tested."""

from collections.abc import Sequence
from typing import Any, Literal, TypeAlias, TypeVar, overload

import numpy as np
import numpy.typing as npt

_Values: TypeAlias = npt.NDArray[np.float32]
_Kind = TypeVar("_Kind", bound=np.float32 | np.float16 | np.uint16)
_Dtype: TypeAlias = (Literal["float32", "float16", "uint16"] | type[np.float32 | np.float16 | np.uint16]
                     | np.dtype[np.float32 | np.float16 | np.uint16])
_Extent: TypeAlias = tuple[float, float]
_Whole: TypeAlias = int | np.integer[Any]
_Number: TypeAlias = float | np.floating[Any] | np.integer[Any]
_Wholes: TypeAlias = _Whole | Sequence[_Whole] | npt.NDArray[np.integer[Any]]
_Vector: TypeAlias = Sequence[_Number] | npt.NDArray[np.floating[Any] | np.integer[Any]]
_Numbers: TypeAlias = _Number | _Vector
_Cells: TypeAlias = npt.ArrayLike | Sequence[npt.ArrayLike]
_Arithmetic: TypeAlias = Literal["fast", "precise", "fixed"]
# tools/make catalog: metrics
_Metric: TypeAlias = Literal["euclidean", "squared", "manhattan", "chebyshev", "hybrid"]
# tools/make catalog: end
# tools/make catalog: names
_Noise: TypeAlias = Literal["perlin", "perlin_d", "value", "value_d", "value_cubic", "simplex", "simplex_d",
                            "simplex_smooth", "cellular", "cellular_three", "cellular_d", "cellular_smooth",
                            "cell_border", "curl", "value_vector", "perlin_vector", "phasor", "random"]
_Fractal: TypeAlias = Literal["fbm", "turbulence", "clouds", "billow", "ridged", "hybrid", "ping_pong", "weighted",
                              "fbm_d", "eroded", "warp", "warp_progressive", "curl_fbm", "perlin_worley"]
# tools/make catalog: end
_Name: TypeAlias = _Noise | _Fractal

__version__: str

# tools/make catalog: functions
@overload
def perlin(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
           points: None = None, seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None,
           cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def perlin(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, period: _Wholes | None = None,
           phase: _Number | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
           out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def perlin(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
           seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None, cell: _Cells | None = None,
           arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def perlin_d(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
             w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, period: _Wholes | None = None,
             phase: _Number | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
             out: _Values | None = None, threads: _Whole | None = None,
             instruction_set: str | None = None) -> _Values: ...
@overload
def perlin_d(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
             seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None, cell: _Cells | None = None,
             arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
             instruction_set: str | None = None) -> _Values: ...
@overload
def value(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
          points: None = None, seed: _Whole = 0, period: _Wholes | None = None,
          cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
          threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def value(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
          w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, period: _Wholes | None = None,
          cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
          threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def value(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
          period: _Wholes | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
          out: _Values | None = None, threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def value_d(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
            w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, period: _Wholes | None = None,
            cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
            threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def value_d(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
            seed: _Whole = 0, period: _Wholes | None = None, cell: _Cells | None = None,
            arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
            instruction_set: str | None = None) -> _Values: ...
@overload
def value_cubic(x: _Number, y: _Number | None = None, z: _Number | None = None, /, *, points: None = None,
                seed: _Whole = 0, period: _Wholes | None = None, cell: _Whole | Sequence[_Whole] | None = None,
                arithmetic: _Arithmetic = "fast", out: None = None, threads: _Whole | None = None,
                instruction_set: str | None = None) -> float: ...
@overload
def value_cubic(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None, /, *,
                points: None = None, seed: _Whole = 0, period: _Wholes | None = None, cell: _Cells | None = None,
                arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
                instruction_set: str | None = None) -> _Values: ...
@overload
def value_cubic(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
                period: _Wholes | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
                out: _Values | None = None, threads: _Whole | None = None,
                instruction_set: str | None = None) -> _Values: ...
@overload
def simplex(x: _Number, y: _Number, z: _Number | None = None, w: _Number | None = None, /, *, points: None = None,
            seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None,
            cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
            threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def simplex(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, w: npt.ArrayLike | None = None, /, *,
            points: None = None, seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None,
            cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
            threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def simplex(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
            seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None, cell: _Cells | None = None,
            arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
            instruction_set: str | None = None) -> _Values: ...
@overload
def simplex_d(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, w: npt.ArrayLike | None = None, /, *,
              points: None = None, seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None,
              cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
              threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def simplex_d(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
              seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None, cell: _Cells | None = None,
              arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
              instruction_set: str | None = None) -> _Values: ...
@overload
def simplex_smooth(x: _Number, y: _Number, z: _Number | None = None, /, *, points: None = None, seed: _Whole = 0,
                   period: _Wholes | None = None, cell: _Whole | Sequence[_Whole] | None = None,
                   arithmetic: _Arithmetic = "fast", out: None = None, threads: _Whole | None = None,
                   instruction_set: str | None = None) -> float: ...
@overload
def simplex_smooth(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
                   seed: _Whole = 0, period: _Wholes | None = None, cell: _Cells | None = None,
                   arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
                   instruction_set: str | None = None) -> _Values: ...
@overload
def simplex_smooth(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
                   period: _Wholes | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
                   out: _Values | None = None, threads: _Whole | None = None,
                   instruction_set: str | None = None) -> _Values: ...
@overload
def cellular(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
             seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None, jitter: _Number = 1.0,
             metric: _Metric = "euclidean", cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
             out: _Values | None = None, threads: _Whole | None = None,
             instruction_set: str | None = None) -> _Values: ...
@overload
def cellular(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
             period: _Wholes | None = None, phase: _Number | None = None, jitter: _Number = 1.0,
             metric: _Metric = "euclidean", cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
             out: _Values | None = None, threads: _Whole | None = None,
             instruction_set: str | None = None) -> _Values: ...
@overload
def cellular_three(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
                   seed: _Whole = 0, period: _Wholes | None = None, jitter: _Number = 1.0,
                   metric: _Metric = "euclidean", cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
                   out: _Values | None = None, threads: _Whole | None = None,
                   instruction_set: str | None = None) -> _Values: ...
@overload
def cellular_three(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
                   period: _Wholes | None = None, jitter: _Number = 1.0, metric: _Metric = "euclidean",
                   cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
                   threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def cellular_d(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
               seed: _Whole = 0, period: _Wholes | None = None, jitter: _Number = 1.0, cell: _Cells | None = None,
               arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
               instruction_set: str | None = None) -> _Values: ...
@overload
def cellular_d(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
               period: _Wholes | None = None, jitter: _Number = 1.0, cell: _Cells | None = None,
               arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
               instruction_set: str | None = None) -> _Values: ...
@overload
def cellular_smooth(x: _Number, y: _Number, z: _Number | None = None, /, *, points: None = None, seed: _Whole = 0,
                    period: _Wholes | None = None, jitter: _Number = 1.0, cell: _Whole | Sequence[_Whole] | None = None,
                    arithmetic: _Arithmetic = "fast", out: None = None, threads: _Whole | None = None,
                    instruction_set: str | None = None) -> float: ...
@overload
def cellular_smooth(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
                    seed: _Whole = 0, period: _Wholes | None = None, jitter: _Number = 1.0, cell: _Cells | None = None,
                    arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
                    instruction_set: str | None = None) -> _Values: ...
@overload
def cellular_smooth(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
                    period: _Wholes | None = None, jitter: _Number = 1.0, cell: _Cells | None = None,
                    arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
                    instruction_set: str | None = None) -> _Values: ...
@overload
def cell_border(x: _Number, y: _Number, z: _Number | None = None, /, *, points: None = None, seed: _Whole = 0,
                period: _Wholes | None = None, jitter: _Number = 1.0, cell: _Whole | Sequence[_Whole] | None = None,
                arithmetic: _Arithmetic = "fast", out: None = None, threads: _Whole | None = None,
                instruction_set: str | None = None) -> float: ...
@overload
def cell_border(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
                seed: _Whole = 0, period: _Wholes | None = None, jitter: _Number = 1.0, cell: _Cells | None = None,
                arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
                instruction_set: str | None = None) -> _Values: ...
@overload
def cell_border(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
                period: _Wholes | None = None, jitter: _Number = 1.0, cell: _Cells | None = None,
                arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
                instruction_set: str | None = None) -> _Values: ...
@overload
def curl(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
         seed: _Whole = 0, period: _Wholes | None = None, phase: _Number | None = None, cell: _Cells | None = None,
         arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
         instruction_set: str | None = None) -> _Values: ...
@overload
def curl(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
         period: _Wholes | None = None, phase: _Number | None = None, cell: _Cells | None = None,
         arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
         instruction_set: str | None = None) -> _Values: ...
@overload
def value_vector(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
                 seed: _Whole = 0, period: _Wholes | None = None, cell: _Cells | None = None,
                 arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
                 instruction_set: str | None = None) -> _Values: ...
@overload
def value_vector(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
                 period: _Wholes | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
                 out: _Values | None = None, threads: _Whole | None = None,
                 instruction_set: str | None = None) -> _Values: ...
@overload
def perlin_vector(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
                  seed: _Whole = 0, period: _Wholes | None = None, cell: _Cells | None = None,
                  arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
                  instruction_set: str | None = None) -> _Values: ...
@overload
def perlin_vector(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
                  period: _Wholes | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
                  out: _Values | None = None, threads: _Whole | None = None,
                  instruction_set: str | None = None) -> _Values: ...
@overload
def phasor(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
           seed: _Whole = 0, period: _Wholes | None = None, wave: _Vector | None = None,
           bandwidth: _Number | None = None, phase: _Number | None = None, cell: _Cells | None = None,
           arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def phasor(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
           period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
           phase: _Number | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
           out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def random(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
           points: None = None, seed: _Whole = 0, period: _Wholes | None = None,
           cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def random(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, period: _Wholes | None = None,
           cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def random(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
           seed: _Whole = 0, period: _Wholes | None = None, cell: _Cells | None = None,
           arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def fbm(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
        points: None = None, seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole | None = None,
        lacunarity: _Number = 2.0, gain: _Number = 0.5, detail: _Number | None = None, footprint: _Number | None = None,
        period: _Wholes | None = None, cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast",
        out: None = None, threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def fbm(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
        w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, noise: _Noise = "perlin",
        octaves: _Whole | None = None, lacunarity: _Number = 2.0, gain: _Number = 0.5, detail: _Number | None = None,
        footprint: _Number | None = None, period: _Wholes | None = None, cell: _Cells | None = None,
        arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
        instruction_set: str | None = None) -> _Values: ...
@overload
def fbm(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
        noise: _Noise = "perlin", octaves: _Whole | None = None, lacunarity: _Number = 2.0, gain: _Number = 0.5,
        detail: _Number | None = None, footprint: _Number | None = None, period: _Wholes | None = None,
        cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
        threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def turbulence(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
               points: None = None, seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6,
               lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
               cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
               threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def turbulence(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
               w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, noise: _Noise = "perlin",
               octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
               cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
               threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def turbulence(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
               seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: _Number = 2.0,
               gain: _Number = 0.5, period: _Wholes | None = None, cell: _Cells | None = None,
               arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
               instruction_set: str | None = None) -> _Values: ...
@overload
def clouds(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
           points: None = None, seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6,
           lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
           cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def clouds(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, noise: _Noise = "perlin",
           octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
           cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def clouds(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
           seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: _Number = 2.0,
           gain: _Number = 0.5, period: _Wholes | None = None, cell: _Cells | None = None,
           arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def billow(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
           points: None = None, seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6,
           lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
           cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def billow(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, noise: _Noise = "perlin",
           octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
           cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def billow(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
           seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: _Number = 2.0,
           gain: _Number = 0.5, period: _Wholes | None = None, cell: _Cells | None = None,
           arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def ridged(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
           points: None = None, seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6,
           lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
           cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def ridged(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, noise: _Noise = "perlin",
           octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
           cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def ridged(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
           seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: _Number = 2.0,
           gain: _Number = 0.5, period: _Wholes | None = None, cell: _Cells | None = None,
           arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def hybrid(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
           points: None = None, seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6,
           lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
           cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def hybrid(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
           w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, noise: _Noise = "perlin",
           octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
           cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
           threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def hybrid(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
           seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: _Number = 2.0,
           gain: _Number = 0.5, period: _Wholes | None = None, cell: _Cells | None = None,
           arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def ping_pong(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
              points: None = None, seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6,
              lacunarity: _Number = 2.0, gain: _Number = 0.5, strength: _Number = 2.0, period: _Wholes | None = None,
              cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
              threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def ping_pong(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
              w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, noise: _Noise = "perlin",
              octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, strength: _Number = 2.0,
              period: _Wholes | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
              out: _Values | None = None, threads: _Whole | None = None,
              instruction_set: str | None = None) -> _Values: ...
@overload
def ping_pong(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
              seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: _Number = 2.0,
              gain: _Number = 0.5, strength: _Number = 2.0, period: _Wholes | None = None, cell: _Cells | None = None,
              arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
              instruction_set: str | None = None) -> _Values: ...
@overload
def weighted(x: _Number, y: _Number | None = None, z: _Number | None = None, w: _Number | None = None, /, *,
             points: None = None, seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6,
             lacunarity: _Number = 2.0, gain: _Number = 0.5, strength: _Number = 1.0, period: _Wholes | None = None,
             cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
             threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def weighted(x: npt.ArrayLike, y: npt.ArrayLike | None = None, z: npt.ArrayLike | None = None,
             w: npt.ArrayLike | None = None, /, *, points: None = None, seed: _Whole = 0, noise: _Noise = "perlin",
             octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, strength: _Number = 1.0,
             period: _Wholes | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
             out: _Values | None = None, threads: _Whole | None = None,
             instruction_set: str | None = None) -> _Values: ...
@overload
def weighted(x: None = None, y: None = None, z: None = None, w: None = None, /, *, points: npt.ArrayLike,
             seed: _Whole = 0, noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: _Number = 2.0,
             gain: _Number = 0.5, strength: _Number = 1.0, period: _Wholes | None = None, cell: _Cells | None = None,
             arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
             instruction_set: str | None = None) -> _Values: ...
@overload
def fbm_d(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
          seed: _Whole = 0, noise: _Noise = "perlin_d", octaves: _Whole = 6, lacunarity: _Number = 2.0,
          gain: _Number = 0.5, period: _Wholes | None = None, cell: _Cells | None = None,
          arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
          instruction_set: str | None = None) -> _Values: ...
@overload
def fbm_d(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
          noise: _Noise = "perlin_d", octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5,
          period: _Wholes | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
          out: _Values | None = None, threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def eroded(x: _Number, y: _Number, z: _Number | None = None, /, *, points: None = None, seed: _Whole = 0,
           noise: _Noise = "perlin_d", octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5,
           strength: _Number = 1.0, period: _Wholes | None = None, cell: _Whole | Sequence[_Whole] | None = None,
           arithmetic: _Arithmetic = "fast", out: None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> float: ...
@overload
def eroded(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
           seed: _Whole = 0, noise: _Noise = "perlin_d", octaves: _Whole = 6, lacunarity: _Number = 2.0,
           gain: _Number = 0.5, strength: _Number = 1.0, period: _Wholes | None = None, cell: _Cells | None = None,
           arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def eroded(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
           noise: _Noise = "perlin_d", octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5,
           strength: _Number = 1.0, period: _Wholes | None = None, cell: _Cells | None = None,
           arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
           instruction_set: str | None = None) -> _Values: ...
@overload
def warp(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
         seed: _Whole = 0, noise: _Noise = "value_vector", octaves: _Whole = 6, lacunarity: _Number = 2.0,
         gain: _Number = 0.5, amplitude: _Number = 1.0, period: _Wholes | None = None, cell: _Cells | None = None,
         arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
         instruction_set: str | None = None) -> _Values: ...
@overload
def warp(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
         noise: _Noise = "value_vector", octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5,
         amplitude: _Number = 1.0, period: _Wholes | None = None, cell: _Cells | None = None,
         arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
         instruction_set: str | None = None) -> _Values: ...
@overload
def warp_progressive(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
                     seed: _Whole = 0, noise: _Noise = "value_vector", octaves: _Whole = 6, lacunarity: _Number = 2.0,
                     gain: _Number = 0.5, amplitude: _Number = 1.0, period: _Wholes | None = None,
                     cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
                     threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def warp_progressive(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
                     noise: _Noise = "value_vector", octaves: _Whole = 6, lacunarity: _Number = 2.0,
                     gain: _Number = 0.5, amplitude: _Number = 1.0, period: _Wholes | None = None,
                     cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
                     threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def curl_fbm(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None, /, *, points: None = None,
             seed: _Whole = 0, octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5,
             phase: _Number | None = None, period: _Wholes | None = None, cell: _Cells | None = None,
             arithmetic: _Arithmetic = "fast", out: _Values | None = None, threads: _Whole | None = None,
             instruction_set: str | None = None) -> _Values: ...
@overload
def curl_fbm(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
             octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, phase: _Number | None = None,
             period: _Wholes | None = None, cell: _Cells | None = None, arithmetic: _Arithmetic = "fast",
             out: _Values | None = None, threads: _Whole | None = None,
             instruction_set: str | None = None) -> _Values: ...
@overload
def perlin_worley(x: _Number, y: _Number, z: _Number, /, *, points: None = None, seed: _Whole = 0, octaves: _Whole = 6,
                  lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
                  cell: _Whole | Sequence[_Whole] | None = None, arithmetic: _Arithmetic = "fast", out: None = None,
                  threads: _Whole | None = None, instruction_set: str | None = None) -> float: ...
@overload
def perlin_worley(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike, /, *, points: None = None, seed: _Whole = 0,
                  octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
                  cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
                  threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
@overload
def perlin_worley(x: None = None, y: None = None, z: None = None, /, *, points: npt.ArrayLike, seed: _Whole = 0,
                  octaves: _Whole = 6, lacunarity: _Number = 2.0, gain: _Number = 0.5, period: _Wholes | None = None,
                  cell: _Cells | None = None, arithmetic: _Arithmetic = "fast", out: _Values | None = None,
                  threads: _Whole | None = None, instruction_set: str | None = None) -> _Values: ...
# tools/make catalog: end

# tools/make catalog: grid
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: Literal["float32"] | None = None, range: _Vector | None = None,
         out: None = None, return_range: Literal[False] = False, threads: _Whole | None = None,
         instruction_set: str | None = None) -> _Values: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: Literal["float16"], range: _Vector | None = None, out: None = None,
         return_range: Literal[False] = False, threads: _Whole | None = None,
         instruction_set: str | None = None) -> npt.NDArray[np.float16]: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: Literal["uint16"], range: _Vector | None = None, out: None = None,
         return_range: Literal[False] = False, threads: _Whole | None = None,
         instruction_set: str | None = None) -> npt.NDArray[np.uint16]: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: type[_Kind] | np.dtype[_Kind], range: _Vector | None = None,
         out: None = None, return_range: Literal[False] = False, threads: _Whole | None = None,
         instruction_set: str | None = None) -> npt.NDArray[_Kind]: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: _Dtype | None = None, range: _Vector | None = None,
         out: npt.NDArray[_Kind], return_range: Literal[False] = False, threads: _Whole | None = None,
         instruction_set: str | None = None) -> npt.NDArray[_Kind]: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: Literal["float32"] | None = None, range: _Vector | None = None,
         out: None = None, return_range: Literal[True], threads: _Whole | None = None,
         instruction_set: str | None = None) -> tuple[_Values, _Extent]: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: Literal["float16"], range: _Vector | None = None, out: None = None,
         return_range: Literal[True], threads: _Whole | None = None,
         instruction_set: str | None = None) -> tuple[npt.NDArray[np.float16], _Extent]: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: Literal["uint16"], range: _Vector | None = None, out: None = None,
         return_range: Literal[True], threads: _Whole | None = None,
         instruction_set: str | None = None) -> tuple[npt.NDArray[np.uint16], _Extent]: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: type[_Kind] | np.dtype[_Kind], range: _Vector | None = None,
         out: None = None, return_range: Literal[True], threads: _Whole | None = None,
         instruction_set: str | None = None) -> tuple[npt.NDArray[_Kind], _Extent]: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: _Dtype | None = None, range: _Vector | None = None,
         out: npt.NDArray[_Kind], return_range: Literal[True], threads: _Whole | None = None,
         instruction_set: str | None = None) -> tuple[npt.NDArray[_Kind], _Extent]: ...
@overload
def grid(name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None,
         first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None,
         lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None,
         amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None,
         period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None,
         phase: _Number | None = None, jitter: _Number | None = None, metric: _Metric | None = None,
         arithmetic: _Arithmetic = "fast", dtype: _Dtype | None = None, range: _Vector | None = None,
         out: npt.NDArray[Any] | None = None, return_range: bool, threads: _Whole | None = None,
         instruction_set: str | None = None) -> npt.NDArray[Any] | tuple[npt.NDArray[Any], _Extent]: ...
# tools/make catalog: end
def components(name: _Name, dimensions: _Whole, *, noise: _Noise | None = None) -> tuple[str, ...]: ...
def noises(dimensions: _Whole) -> tuple[_Noise, ...]: ...
def fractals(dimensions: _Whole) -> tuple[_Fractal, ...]: ...
def instruction_sets() -> tuple[str, ...]: ...
