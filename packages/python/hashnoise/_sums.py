# Made by tools/make catalog from catalog/sums.toml and settings.toml.
"""The fractals and the warps, over any noise. help(hashnoise) describes their common options."""

from ._evaluate import functions_of

__all__ = ["fbm", "turbulence", "clouds", "billow", "ridged", "hybrid", "ping_pong", "weighted", "fbm_d", "eroded",
           "warp", "warp_progressive", "curl_fbm", "perlin_worley"]

_fractal = functions_of(__name__, "fractal")

fbm = _fractal("fbm", 1, 4, noise="perlin", octaves=None, lacunarity=2.0, gain=0.5, detail=None, footprint=None,
               doc="""\
Fractional Brownian motion (fBm), in 1D to 4D: octaves of noise, each finer, weaker, and rotated.

octaves    6 if neither they nor a detail are given
detail     in place of the octaves, without a period: octaves as a float, in [0, 32]. 3.5 is three octaves and half of
           the fourth
footprint  without a period: the size of a pixel, in cells of the first octave. Octaves that are too fine for it fade
           out
returns    [-1, 1], mean 0
source     Musgrave, in "Texturing and Modeling: A Procedural Approach"

>>> hashnoise.fbm(0.5, 0.25, seed=7, arithmetic="fixed")
-0.41556310653686523
""")

turbulence = _fractal("turbulence", 1, 4, noise="perlin", octaves=6, lacunarity=2.0, gain=0.5, doc="""\
Turbulence, in 1D to 4D: the mean of the octaves' absolute values. Use it for marble and fire.

returns  [0, 1], with creases where the noise passes 0
source   Perlin, "An image synthesizer", 1985; Valdenegro-Toro and Pincheira, fig. 6

>>> hashnoise.turbulence(0.5, 0.25, seed=7, arithmetic="fixed")
0.5065531730651855
""")

clouds = _fractal("clouds", 1, 4, noise="perlin", octaves=6, lacunarity=2.0, gain=0.5, doc="""\
Clouds, in 1D to 4D: the density of a sky, from an fBm.

returns  [0, 1]: 0 is clear, 1 is dense; with fewer than 1 octave 5/32
source   after the cloud images of Valdenegro-Toro and Pincheira, fig. 6; the paper has no formula for them

>>> hashnoise.clouds(0.5, 0.25, seed=7, arithmetic="fixed")
0.0
""")

billow = _fractal("billow", 1, 4, noise="perlin", octaves=6, lacunarity=2.0, gain=0.5, doc="""\
Billows, in 1D to 4D: twice the turbulence less 1. The round hills are the other side of ridges.

returns  [-1, 1]; with fewer than 1 octave -1
source   as of `turbulence`

>>> hashnoise.billow(0.5, 0.25, seed=7, arithmetic="fixed")
0.013106346130371094
""")

ridged = _fractal("ridged", 1, 4, noise="perlin", octaves=6, lacunarity=2.0, gain=0.5, doc="""\
Ridges, in 1D to 4D: sharp crests where the noise passes 0, with detail on them and smooth valleys between.

returns  [0, 1]: 1 on a crest of every octave
source   Musgrave, in "Texturing and Modeling: A Procedural Approach": his ridged multifractal with the offset 1 and the
         gain 2, divided by the sum of the weights

>>> hashnoise.ridged(0.5, 0.25, seed=7, arithmetic="fixed")
0.12437057495117188
""")

hybrid = _fractal("hybrid", 1, 4, noise="perlin", octaves=6, lacunarity=2.0, gain=0.5, doc="""\
Hybrid terrain, in 1D to 4D: plains are flat and heights are rough.

An octave counts as far as the one before it is high; in full from the middle on.

returns  [0, 1]
source   Musgrave, in "Texturing and Modeling: A Procedural Approach": after his hybrid multifractal with the offset 1,
         of octaves in [0, 1], divided by the sum of the weights

>>> hashnoise.hybrid(0.5, 0.25, seed=7, arithmetic="fixed")
0.15586233139038086
""")

ping_pong = _fractal("ping_pong", 1, 4, noise="perlin", octaves=6, lacunarity=2.0, gain=0.5, strength=2.0, doc="""\
Ping-pong, in 1D to 4D: each octave is folded up and down, which gives the rings of wood and of agate.

strength  how often it folds: half the number of passes from one end to the other while the noise goes from -1 to 1;
          usually 2, in [0, 64]
returns   [-1, 1]
source    FastNoiseLite, FractalType_PingPong

>>> hashnoise.ping_pong(0.5, 0.25, seed=7, arithmetic="fixed")
0.6300945281982422
""")

weighted = _fractal("weighted", 1, 4, noise="perlin", octaves=6, lacunarity=2.0, gain=0.5, strength=1.0, doc="""\
Weighted fBm, in 1D to 4D: where an octave is low, the finer ones count less. Valleys are smoother than heights.

strength  how much less: 0 is `fbm`, 1 leaves nothing of the finer octaves at -1; usually 1, in [0, 1]
returns   [-1, 1]
source    FastNoiseLite, SetFractalWeightedStrength

>>> hashnoise.weighted(0.5, 0.25, seed=7, arithmetic="fixed")
-0.32480430603027344
""")

fbm_d = _fractal("fbm_d", 2, 3, noise="perlin_d", octaves=6, lacunarity=2.0, gain=0.5, doc="""\
Fractional Brownian motion (fBm) and its slope, in 2D and 3D.

noise    one with derivatives: "perlin_d", "simplex_d" or "value_d"
returns  planes: the value of `fbm`, and its derivatives along each axis, per cell of the first octave
source   as of `fbm`

>>> hashnoise.fbm_d(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.4155631 ,  1.2902737 , -0.44997787], dtype=float32)
""")

eroded = _fractal("eroded", 2, 3, noise="perlin_d", octaves=6, lacunarity=2.0, gain=0.5, strength=1.0, doc="""\
Eroded fBm, in 2D and 3D: smooth slopes, with detail in valleys and on summits.

An octave counts less where those before it and itself are steep.

noise     one with derivatives: "perlin_d", "simplex_d" or "value_d"
strength  how much less: 0 is `fbm`; in [0, 16]. A slope of 1 cell in 1 leaves 1 / (1 + strength)
returns   [-1, 1]
source    Quilez, "More noise", 2008: his slopes are not rotated with the octaves

>>> hashnoise.eroded(0.5, 0.25, seed=7, arithmetic="fixed")
-0.27370214462280273
""")

warp = _fractal("warp", 2, 3, noise="value_vector", octaves=6, lacunarity=2.0, gain=0.5, amplitude=1.0, doc="""\
Domain warping, in 2D and 3D: a displacement for a position, before another noise is evaluated there.

noise      one of vectors: "value_vector", "perlin_vector" or "curl"; values beyond [-1, 1] count as the nearer end
amplitude  the largest displacement along an axis, in cells, in [0, 64]
returns    planes: the displacement along each axis, in [-amplitude, amplitude]
source     Quilez, "Domain warping", 2002

>>> hashnoise.warp(0.5, 0.25, seed=7, arithmetic="fixed")
array([ 0.00859165, -0.26816893], dtype=float32)
""")

warp_progressive = _fractal("warp_progressive", 2, 3, noise="value_vector", octaves=6, lacunarity=2.0, gain=0.5,
                            amplitude=1.0, doc="""\
The displacement of `warp`, in 2D and 3D, where the octaves before an octave displace it, too.

It draws strands and eddies.

noise      one of vectors: "value_vector", "perlin_vector" or "curl"; values beyond [-1, 1] count as the nearer end
amplitude  the largest displacement along an axis, in cells, in [0, 64]
returns    planes: the displacement along each axis, in [-amplitude, amplitude]
source     as of `warp`

>>> hashnoise.warp_progressive(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.21678829, -0.21608591], dtype=float32)
""")

curl_fbm = _fractal("curl_fbm", 2, 3, octaves=6, lacunarity=2.0, gain=0.5, phase=None, doc="""\
Octaves of curl noise, in 2D and 3D: velocities of a flow with eddies of all sizes, which neither gathers nor spreads
what it carries.

Each octave is rotated back, and nothing is cut off: so the sum has no divergence, either.

phase    as of `curl`, the same in all octaves
returns  planes: the velocity along each axis, the mean of the octaves of `curl` by their weights
source   docs/reference/contract.md, section 7; Bridson, Hourihan, Nordenstam, "Curl-noise for procedural fluid flow",
         2007

>>> hashnoise.curl_fbm(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.14785004,  1.1209087 ], dtype=float32)
""")

perlin_worley = _fractal("perlin_worley", 3, 3, octaves=6, lacunarity=2.0, gain=0.5, doc="""\
Perlin-Worley noise, in 3D: round billows where the points of cellular noise are, and wisps of Perlin noise between
them.

It is what volumes of clouds are made of. A cloud is where it is above a threshold: 98 of 100 values are from 0.6 to
0.88. Experimental: a later version may return other values.

octaves  of Perlin noise; the first three have billows, too
returns  [0, 1], continuous
source   Schneider and Vos, "The Real-time Volumetric Cloudscapes of Horizon: Zero Dawn", 2015;
         docs/reference/contract.md, section 25

>>> hashnoise.perlin_worley(0.5, 0.25, 0.75, seed=7, arithmetic="fixed")
0.823091983795166
""")

SUMS = {name: globals()[name] for name in __all__}
