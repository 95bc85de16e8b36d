# Made by tools/make catalog from catalog/sums.toml and settings.toml.
"""The fractals and the warps, over any noise. help(hashnoise) describes their common options."""

from ._evaluate import evaluated, suggesting

__all__ = ["fbm", "turbulence", "clouds", "billow", "ridged", "hybrid", "ping_pong", "weighted", "fbm_d", "eroded",
           "warp", "warp_progressive", "perlin_worley"]


@suggesting
def fbm(x=None, y=None, z=None, w=None, /, *, points=None, seed=0, noise="perlin", octaves=None, lacunarity=2.0,
        gain=0.5, detail=None, footprint=None, period=None, cell=None, arithmetic="fast", out=None, threads=None,
        instruction_set=None):
    """Fractional Brownian motion (fBm), in 1D to 4D: octaves of noise, each finer, weaker, and rotated.

    octaves    6 if neither they nor a detail are given
    detail     in place of the octaves, without a period: octaves as a float, in [0, 32]. 3.5 is three octaves and half
               of the fourth
    footprint  without a period: the size of a pixel, in cells of the first octave. Octaves that are too fine for it
               fade out
    returns    [-1, 1], mean 0
    source     Musgrave, in "Texturing and Modeling: A Procedural Approach"

    help(hashnoise) explains the other options: `points`, `seed`, `noise`, `lacunarity`, `gain`, `period`, `cell`,
    `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.fbm(0.5, 0.25, seed=7, arithmetic="fixed")
    -0.41556310653686523
    """
    return evaluated("fbm", 1, (x, y, z, w), points, cell, out, threads, fractal="fbm", seed=seed, noise=noise,
                     octaves=octaves, lacunarity=lacunarity, gain=gain, detail=detail, footprint=footprint,
                     period=period, arithmetic=arithmetic, instruction_set=instruction_set)


@suggesting
def turbulence(x=None, y=None, z=None, w=None, /, *, points=None, seed=0, noise="perlin", octaves=6, lacunarity=2.0,
               gain=0.5, period=None, cell=None, arithmetic="fast", out=None, threads=None, instruction_set=None):
    """Turbulence, in 1D to 4D: the mean of the octaves' absolute values. Use it for marble and fire.

    returns  [0, 1], with creases where the noise passes 0
    source   Perlin, "An image synthesizer", 1985; Valdenegro-Toro and Pincheira, fig. 6

    help(hashnoise) explains the other options: `points`, `seed`, `noise`, `octaves`, `lacunarity`, `gain`, `period`,
    `cell`, `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.turbulence(0.5, 0.25, seed=7, arithmetic="fixed")
    0.5065531730651855
    """
    return evaluated("turbulence", 1, (x, y, z, w), points, cell, out, threads, fractal="turbulence", seed=seed,
                     noise=noise, octaves=octaves, lacunarity=lacunarity, gain=gain, period=period,
                     arithmetic=arithmetic, instruction_set=instruction_set)


@suggesting
def clouds(x=None, y=None, z=None, w=None, /, *, points=None, seed=0, noise="perlin", octaves=6, lacunarity=2.0,
           gain=0.5, period=None, cell=None, arithmetic="fast", out=None, threads=None, instruction_set=None):
    """Clouds, in 1D to 4D: the density of a sky, from an fBm.

    returns  [0, 1]: 0 is clear, 1 is dense; with fewer than 1 octave 5/32
    source   after the cloud images of Valdenegro-Toro and Pincheira, fig. 6; the paper has no formula for them

    help(hashnoise) explains the other options: `points`, `seed`, `noise`, `octaves`, `lacunarity`, `gain`, `period`,
    `cell`, `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.clouds(0.5, 0.25, seed=7, arithmetic="fixed")
    0.0
    """
    return evaluated("clouds", 1, (x, y, z, w), points, cell, out, threads, fractal="clouds", seed=seed, noise=noise,
                     octaves=octaves, lacunarity=lacunarity, gain=gain, period=period, arithmetic=arithmetic,
                     instruction_set=instruction_set)


@suggesting
def billow(x=None, y=None, z=None, w=None, /, *, points=None, seed=0, noise="perlin", octaves=6, lacunarity=2.0,
           gain=0.5, period=None, cell=None, arithmetic="fast", out=None, threads=None, instruction_set=None):
    """Billows, in 1D to 4D: twice the turbulence less 1. The round hills are the other side of ridges.

    returns  [-1, 1]; with fewer than 1 octave -1
    source   as of `turbulence`

    help(hashnoise) explains the other options: `points`, `seed`, `noise`, `octaves`, `lacunarity`, `gain`, `period`,
    `cell`, `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.billow(0.5, 0.25, seed=7, arithmetic="fixed")
    0.013106346130371094
    """
    return evaluated("billow", 1, (x, y, z, w), points, cell, out, threads, fractal="billow", seed=seed, noise=noise,
                     octaves=octaves, lacunarity=lacunarity, gain=gain, period=period, arithmetic=arithmetic,
                     instruction_set=instruction_set)


@suggesting
def ridged(x=None, y=None, z=None, w=None, /, *, points=None, seed=0, noise="perlin", octaves=6, lacunarity=2.0,
           gain=0.5, period=None, cell=None, arithmetic="fast", out=None, threads=None, instruction_set=None):
    """Ridges, in 1D to 4D: sharp crests where the noise passes 0, with detail on them and smooth valleys between.

    returns  [0, 1]: 1 on a crest of every octave
    source   Musgrave, in "Texturing and Modeling: A Procedural Approach": his ridged multifractal with the offset 1 and
             the gain 2, divided by the sum of the weights

    help(hashnoise) explains the other options: `points`, `seed`, `noise`, `octaves`, `lacunarity`, `gain`, `period`,
    `cell`, `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.ridged(0.5, 0.25, seed=7, arithmetic="fixed")
    0.12437057495117188
    """
    return evaluated("ridged", 1, (x, y, z, w), points, cell, out, threads, fractal="ridged", seed=seed, noise=noise,
                     octaves=octaves, lacunarity=lacunarity, gain=gain, period=period, arithmetic=arithmetic,
                     instruction_set=instruction_set)


@suggesting
def hybrid(x=None, y=None, z=None, w=None, /, *, points=None, seed=0, noise="perlin", octaves=6, lacunarity=2.0,
           gain=0.5, period=None, cell=None, arithmetic="fast", out=None, threads=None, instruction_set=None):
    """Hybrid terrain, in 1D to 4D: plains are flat and heights are rough.

    An octave counts as far as the one before it is high; in full from the middle on.

    returns  [0, 1]
    source   Musgrave, in "Texturing and Modeling: A Procedural Approach": after his hybrid multifractal with the offset
             1, of octaves in [0, 1], divided by the sum of the weights

    help(hashnoise) explains the other options: `points`, `seed`, `noise`, `octaves`, `lacunarity`, `gain`, `period`,
    `cell`, `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.hybrid(0.5, 0.25, seed=7, arithmetic="fixed")
    0.15586233139038086
    """
    return evaluated("hybrid", 1, (x, y, z, w), points, cell, out, threads, fractal="hybrid", seed=seed, noise=noise,
                     octaves=octaves, lacunarity=lacunarity, gain=gain, period=period, arithmetic=arithmetic,
                     instruction_set=instruction_set)


@suggesting
def ping_pong(x=None, y=None, z=None, w=None, /, *, points=None, seed=0, noise="perlin", octaves=6, lacunarity=2.0,
              gain=0.5, strength=2.0, period=None, cell=None, arithmetic="fast", out=None, threads=None,
              instruction_set=None):
    """Ping-pong, in 1D to 4D: each octave is folded up and down, which gives the rings of wood and of agate.

    strength  how often it folds: half the number of passes from one end to the other while the noise goes from -1 to 1;
              usually 2, in [0, 64]
    returns   [-1, 1]
    source    FastNoiseLite, FractalType_PingPong

    help(hashnoise) explains the other options: `points`, `seed`, `noise`, `octaves`, `lacunarity`, `gain`, `period`,
    `cell`, `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.ping_pong(0.5, 0.25, seed=7, arithmetic="fixed")
    0.6300945281982422
    """
    return evaluated("ping_pong", 1, (x, y, z, w), points, cell, out, threads, fractal="ping_pong", seed=seed,
                     noise=noise, octaves=octaves, lacunarity=lacunarity, gain=gain, strength=strength, period=period,
                     arithmetic=arithmetic, instruction_set=instruction_set)


@suggesting
def weighted(x=None, y=None, z=None, w=None, /, *, points=None, seed=0, noise="perlin", octaves=6, lacunarity=2.0,
             gain=0.5, strength=1.0, period=None, cell=None, arithmetic="fast", out=None, threads=None,
             instruction_set=None):
    """Weighted fBm, in 1D to 4D: where an octave is low, the finer ones count less. Valleys are smoother than heights.

    strength  how much less: 0 is `fbm`, 1 leaves nothing of the finer octaves at -1; usually 1, in [0, 1]
    returns   [-1, 1]
    source    FastNoiseLite, SetFractalWeightedStrength

    help(hashnoise) explains the other options: `points`, `seed`, `noise`, `octaves`, `lacunarity`, `gain`, `period`,
    `cell`, `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.weighted(0.5, 0.25, seed=7, arithmetic="fixed")
    -0.32480430603027344
    """
    return evaluated("weighted", 1, (x, y, z, w), points, cell, out, threads, fractal="weighted", seed=seed,
                     noise=noise, octaves=octaves, lacunarity=lacunarity, gain=gain, strength=strength, period=period,
                     arithmetic=arithmetic, instruction_set=instruction_set)


@suggesting
def fbm_d(x=None, y=None, z=None, /, *, points=None, seed=0, noise="perlin_d", octaves=6, lacunarity=2.0, gain=0.5,
          period=None, cell=None, arithmetic="fast", out=None, threads=None, instruction_set=None):
    """Fractional Brownian motion (fBm) and its slope, in 2D and 3D.

    noise    one with derivatives: "perlin_d", "simplex_d" or "value_d"
    returns  planes: the value of `fbm`, and its derivatives along each axis, per cell of the first octave
    source   as of `fbm`

    help(hashnoise) explains the other options: `points`, `seed`, `octaves`, `lacunarity`, `gain`, `period`, `cell`,
    `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.fbm_d(0.5, 0.25, seed=7, arithmetic="fixed")
    array([-0.4155631 ,  1.2902737 , -0.44997787], dtype=float32)
    """
    return evaluated("fbm_d", 2, (x, y, z), points, cell, out, threads, fractal="fbm_d", seed=seed, noise=noise,
                     octaves=octaves, lacunarity=lacunarity, gain=gain, period=period, arithmetic=arithmetic,
                     instruction_set=instruction_set)


@suggesting
def eroded(x=None, y=None, z=None, /, *, points=None, seed=0, noise="perlin_d", octaves=6, lacunarity=2.0, gain=0.5,
           strength=1.0, period=None, cell=None, arithmetic="fast", out=None, threads=None, instruction_set=None):
    """Eroded fBm, in 2D and 3D: smooth slopes, with detail in valleys and on summits.

    An octave counts less where those before it and itself are steep.

    noise     one with derivatives: "perlin_d", "simplex_d" or "value_d"
    strength  how much less: 0 is `fbm`; in [0, 16]. A slope of 1 cell in 1 leaves 1 / (1 + strength)
    returns   [-1, 1]
    source    Quilez, "More noise", 2008: his slopes are not rotated with the octaves

    help(hashnoise) explains the other options: `points`, `seed`, `octaves`, `lacunarity`, `gain`, `period`, `cell`,
    `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.eroded(0.5, 0.25, seed=7, arithmetic="fixed")
    -0.27370214462280273
    """
    return evaluated("eroded", 2, (x, y, z), points, cell, out, threads, fractal="eroded", seed=seed, noise=noise,
                     octaves=octaves, lacunarity=lacunarity, gain=gain, strength=strength, period=period,
                     arithmetic=arithmetic, instruction_set=instruction_set)


@suggesting
def warp(x=None, y=None, z=None, /, *, points=None, seed=0, noise="value_vector", octaves=6, lacunarity=2.0, gain=0.5,
         amplitude=1.0, period=None, cell=None, arithmetic="fast", out=None, threads=None, instruction_set=None):
    """Domain warping, in 2D and 3D: a displacement for a position, before another noise is evaluated there.

    noise      one of vectors: "value_vector", "perlin_vector" or "curl"; values beyond [-1, 1] count as the nearer end
    amplitude  the largest displacement along an axis, in cells, in [0, 64]
    returns    planes: the displacement along each axis, in [-amplitude, amplitude]
    source     Quilez, "Domain warping", 2002

    help(hashnoise) explains the other options: `points`, `seed`, `octaves`, `lacunarity`, `gain`, `period`, `cell`,
    `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.warp(0.5, 0.25, seed=7, arithmetic="fixed")
    array([ 0.00859165, -0.26816893], dtype=float32)
    """
    return evaluated("warp", 2, (x, y, z), points, cell, out, threads, fractal="warp", seed=seed, noise=noise,
                     octaves=octaves, lacunarity=lacunarity, gain=gain, amplitude=amplitude, period=period,
                     arithmetic=arithmetic, instruction_set=instruction_set)


@suggesting
def warp_progressive(x=None, y=None, z=None, /, *, points=None, seed=0, noise="value_vector", octaves=6, lacunarity=2.0,
                     gain=0.5, amplitude=1.0, period=None, cell=None, arithmetic="fast", out=None, threads=None,
                     instruction_set=None):
    """The displacement of `warp`, in 2D and 3D, where the octaves before an octave displace it, too.

    It draws strands and eddies.

    noise      one of vectors: "value_vector", "perlin_vector" or "curl"; values beyond [-1, 1] count as the nearer end
    amplitude  the largest displacement along an axis, in cells, in [0, 64]
    returns    planes: the displacement along each axis, in [-amplitude, amplitude]
    source     as of `warp`

    help(hashnoise) explains the other options: `points`, `seed`, `octaves`, `lacunarity`, `gain`, `period`, `cell`,
    `arithmetic`, `out`, `threads` and `instruction_set`.

    >>> hashnoise.warp_progressive(0.5, 0.25, seed=7, arithmetic="fixed")
    array([-0.21678829, -0.21608591], dtype=float32)
    """
    return evaluated("warp_progressive", 2, (x, y, z), points, cell, out, threads, fractal="warp_progressive",
                     seed=seed, noise=noise, octaves=octaves, lacunarity=lacunarity, gain=gain, amplitude=amplitude,
                     period=period, arithmetic=arithmetic, instruction_set=instruction_set)


@suggesting
def perlin_worley(x=None, y=None, z=None, /, *, points=None, seed=0, octaves=6, lacunarity=2.0, gain=0.5, period=None,
                  cell=None, arithmetic="fast", out=None, threads=None, instruction_set=None):
    """Perlin-Worley noise, in 3D: round billows where the points of cellular noise are, and wisps of Perlin noise
    between them.

    It is what volumes of clouds are made of. A cloud is where it is above a threshold: 98 of 100 values are from 0.6 to
    0.88. Experimental: a later version may return other values.

    octaves  of Perlin noise; the first three have billows, too
    returns  [0, 1], continuous
    source   Schneider and Vos, "The Real-time Volumetric Cloudscapes of Horizon: Zero Dawn", 2015;
             docs/reference/contract.md, section 25

    help(hashnoise) explains the other options: `points`, `seed`, `lacunarity`, `gain`, `period`, `cell`, `arithmetic`,
    `out`, `threads` and `instruction_set`.

    >>> hashnoise.perlin_worley(0.5, 0.25, 0.75, seed=7, arithmetic="fixed")
    0.823091983795166
    """
    return evaluated("perlin_worley", 3, (x, y, z), points, cell, out, threads, fractal="perlin_worley", seed=seed,
                     octaves=octaves, lacunarity=lacunarity, gain=gain, period=period, arithmetic=arithmetic,
                     instruction_set=instruction_set)


SUMS = {name: globals()[name] for name in __all__}
