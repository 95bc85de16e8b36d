# Made by tools/make catalog from catalog/noises.toml, sums.toml and settings.toml.
"""The types of hashnoise.arrays. Arrays may be of any library, and settings may be arrays."""

from collections.abc import Sequence
from typing import Any, Literal

from .. import _Metric, _Noise, _Whole, _Wholes

__all__ = ["perlin", "perlin_d", "value", "value_d", "value_cubic", "simplex", "simplex_d", "simplex_smooth",
           "cellular", "cellular_three", "cellular_d", "cellular_smooth", "cell_border", "curl", "value_vector",
           "perlin_vector", "phasor", "random", "fbm", "turbulence", "clouds", "billow", "ridged", "hybrid",
           "ping_pong", "weighted", "fbm_d", "eroded", "warp", "warp_progressive", "curl_fbm", "perlin_worley"]

def perlin(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
           period: _Wholes | None = None, phase: Any = None, cell: Any = None,
           arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def perlin_d(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
             period: _Wholes | None = None, phase: Any = None, cell: Any = None,
             arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def value(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
          period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def value_d(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
            period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def value_cubic(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
                period: _Wholes | None = None, cell: Any = None,
                arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def simplex(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
            period: _Wholes | None = None, phase: Any = None, cell: Any = None,
            arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def simplex_d(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
              period: _Wholes | None = None, phase: Any = None, cell: Any = None,
              arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def simplex_smooth(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
                   period: _Wholes | None = None, cell: Any = None,
                   arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def cellular(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
             period: _Wholes | None = None, phase: Any = None, jitter: Any = 1.0, metric: _Metric = "euclidean",
             cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def cellular_three(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
                   period: _Wholes | None = None, jitter: Any = 1.0, metric: _Metric = "euclidean", cell: Any = None,
                   arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def cellular_d(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
               period: _Wholes | None = None, jitter: Any = 1.0, cell: Any = None,
               arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def cellular_smooth(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
                    period: _Wholes | None = None, jitter: Any = 1.0, cell: Any = None,
                    arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def cell_border(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
                period: _Wholes | None = None, jitter: Any = 1.0, cell: Any = None,
                arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def curl(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
         period: _Wholes | None = None, phase: Any = None, cell: Any = None,
         arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def value_vector(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
                 period: _Wholes | None = None, cell: Any = None,
                 arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def perlin_vector(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
                  period: _Wholes | None = None, cell: Any = None,
                  arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def phasor(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
           period: _Wholes | None = None, wave: Sequence[Any] | None = None, bandwidth: Any = None, phase: Any = None,
           cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def random(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
           period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def fbm(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
        noise: _Noise = "perlin", octaves: _Whole | None = None, lacunarity: Any = 2.0, gain: Any = 0.5,
        detail: Any = None, footprint: Any = None, period: _Wholes | None = None, cell: Any = None,
        arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def turbulence(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
               noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5,
               period: _Wholes | None = None, cell: Any = None,
               arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def clouds(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
           noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5,
           period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def billow(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
           noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5,
           period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def ridged(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
           noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5,
           period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def hybrid(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
           noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5,
           period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def ping_pong(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
              noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5,
              strength: Any = 2.0, period: _Wholes | None = None, cell: Any = None,
              arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def weighted(x: Any = None, y: Any = None, z: Any = None, w: Any = None, /, *, points: Any = None, seed: Any = 0,
             noise: _Noise = "perlin", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5, strength: Any = 1.0,
             period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def fbm_d(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
          noise: _Noise = "perlin_d", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5,
          period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def eroded(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
           noise: _Noise = "perlin_d", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5, strength: Any = 1.0,
           period: _Wholes | None = None, cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def warp(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
         noise: _Noise = "value_vector", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5,
         amplitude: Any = 1.0, period: _Wholes | None = None, cell: Any = None,
         arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def warp_progressive(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
                     noise: _Noise = "value_vector", octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5,
                     amplitude: Any = 1.0, period: _Wholes | None = None, cell: Any = None,
                     arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def curl_fbm(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0, octaves: _Whole = 6,
             lacunarity: Any = 2.0, gain: Any = 0.5, phase: Any = None, period: _Wholes | None = None, cell: Any = None,
             arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
def perlin_worley(x: Any = None, y: Any = None, z: Any = None, /, *, points: Any = None, seed: Any = 0,
                  octaves: _Whole = 6, lacunarity: Any = 2.0, gain: Any = 0.5, period: _Wholes | None = None,
                  cell: Any = None, arithmetic: Literal["fast", "fixed"] = "fast") -> Any: ...
