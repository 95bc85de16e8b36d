"""The words of docs/measured/quality.md."""

HEAD = """# How random the hashes are

{remark}This page reports how random the hashes and the noise of the library are. `tools/measure hashes` writes it. The tool samples the C++ twin (the library's own text), and tests every hash that `HN_HASH` offers in the way in which noise uses it: with the joined coordinates of a cell, and through the gradient stage. `tools/measure hashes --help` documents how to test your own hash, words from a file, or another copy of the library. `--dump` keeps the samples, so that you can calculate all of this again.

**The gate.** Each statistic has a known distribution on a lattice of independent, uniform words. A test fails if a value as extreme as its own has a probability below {alpha} on such a lattice (SMHasher3's limit for a failure). The probability takes the number of comparisons in the test into account. No other limit is chosen: *values* and *comparisons* determine the *floor*, which a random lattice exceeds every second time, and the *allowed* limit. All hashes together make {tests} tests; a random library would fail one with a probability of {chance} at most.

The windows are 1024 x 1024 and 128 x 128 x 128 cells at {origins} origins (around 0, negative, at the end of what `hn_perlin` takes, near 2^31), each with two of {seeds} seeds. The tool also compares {pairs} pairs of seeds, and searches {windows} more windows at random origins for copies. It compares the components of vectors with each other, two in the plane and three in space. These are made of one word (`hn_value_vector`, `hn_perlin_vector`), so they are compared by 12 bits together at most: they have only 24 bits in common, and nothing makes them independent to the last of these. Cells that are too far apart for a window are compared at powers of two, and at the lags after which spread coordinates are nearly the same. The tables show the most improbable value over all of them. Lines that end in "all" test the windows together: they show a weakness that is everywhere, even a small one.

![Autocorrelation and spectrum of the default hash and of two that fail](../images/quality-lattice.png)
"""

QUICK = """**This is a quick run.** It tests the default hash in one window at each of two origins, and the others in one small window.
*values*, *comparisons*, *floor* and *allowed* are those of the first hash. Larger windows have narrower limits.

"""

HASHES = """
## Hashes in {dimensions}D

{verdict} The gradient stage uses {bits} bits of a word, {which}. Tests of "consumed" bits test these.{lower}

"""

LOWER = " The size of the word selects the axes; each bit below the first of these runs decides less than a sixteenth of the selections."

TESTS = """## The tests

`n` is the number of values, `m` is the number of comparisons, and `a` = 2^-20. `peak(D, m)`: the largest of `m` values of the distribution `D` may be `D.isf(a / m)`; with two sides, `D.isf(a / 2m)`. Windows wrap: the neighbour of the last cell is the first.

"""

ROWS = [
    ("autocorrelation", "`sum g(c) g(c + lag) / sum g^2` of each gradient component, over all lags", "normal, standard deviation `1 / sqrt(n)`; peak, two sides", "periods, stripes, linear keys"),
    ("spectral peak", "largest ordinate of the periodogram of each component, over their mean", "exponential; peak", "waves"),
    ("autocorrelation of bits", "the same for the consumed bits (-1, 1), two at a time as the parts of a complex field, in standard deviations", "normal; peak, two sides", "the same in a single bit"),
    ("chi-square of values", "fields of 8 consumed bits, each fourth start; fields of all bits, if there are fewer", "chi-square, 255 degrees of freedom at most; both tails", "uneven values, and too even ones"),
    ("chi-square of neighbours", "6 high or low consumed bits of a cell with 6 of each neighbour, also diagonal neighbours; all bits, if there are fewer", "chi-square, 4095 degrees of freedom at most; both tails", "neighbours that depend on each other"),
    ("pairs of bits", "agreement of any two consumed bits of a word, and of a word and its neighbours, in standard deviations", "normal; peak, two sides", "bits that depend on each other"),
    ("numbers: ...", "the tests with these names, of bits 22 to 15: the high bits of the number that value noise takes from a word", "as above and below", "the same in value noise"),
    ("rectangles", "each bit of the second difference (exclusive or; subtraction) over the corners of rectangles of 1, 2, 4, ... cells, in standard deviations", "normal; peak, two sides", "keys that are sums or exclusive ors"),
    ("blocks", "each consumed bit in each block of 32^2 or 16^3 cells: how often it is set, and how often it equals the next one along each axis, in standard deviations", "normal (binomial); peak, two sides", "a weak part of the window"),
    ("lines", "each consumed bit over the cells that have a coordinate in common", "normal (binomial); peak, two sides", "weak rows"),
    ("directions: frequencies", "chi-square of the counts of the 8 gradients, or of the 12 in space; the contract makes some of these more likely by 0.2% and some less by 0.4%", "chi-square, 7 or 11 degrees of freedom; both tails", "gradients that are preferred"),
    ("directions: others", "gradients that are none of these", "none", "gradients of other directions and lengths"),
    ("isotropy", "mean preference of the structures of the noise for the axes (positive) or the diagonals (negative), as defined below", "normal, around the aim, by the spread of blocks; peak, two sides", "gradients whose shape shows in the noise"),
    ("noise of the gradients", "largest deviation of `hn_perlin` from a multiple of its interpolated gradients", "the rounding of floats", "an isotropy of something other than the noise"),
    ("gradient of the word", "cells where `hn_gradient(cell)` is not the gradient of its word", "none", "tests that judge something other than the noise"),
    ("equal words", "pairs of equal words in a window", "Poisson, `n (n - 1) / 2 / 2^b`, with b the bits that are not the same in all words; both tails", "copies; a counter in disguise"),
    ("equal values", "chi-square of the consumed bits, if they have fewer than 2^20 values", "chi-square; both tails", "the same in the bits that are used"),
    ("copied lines", "the most words that a line shares with another at one shift, or reversed", "Poisson, `length / 2^b`; peak over pairs of lines and shifts", "duplicate rows, shifted and mirrored"),
    ("copied lines, windows", "the same in windows with lines of 1024 cells at many random origins", "as above", "columns that are copies in some windows and not in others"),
    ("copied runs, windows", "pairs of equal runs of cells in these windows", "as copied runs", "the same of the consumed bits alone"),
    ("copied runs", "pairs of equal runs of cells (at least 80 consumed bits), along any axis, in either direction", "Poisson; both tails", "parts of rows that occur twice, mirrored or turned"),
    ("equal words, windows on average", "mean number of equal pairs in windows at random origins, over the expected one", "Student's t, by the spread of the windows", "the same elsewhere"),
    ("avalanche", "each of the 12 low bits of each coordinate of cells in [0, 4096)^n is set: how far the probability that a consumed bit flips is from 1/2", "binomial, normal: `0.5 / sqrt(n)`; peak, two sides", "bits that hardly change"),
    ("avalanche: pairs", "how far the probability that two consumed bits flip alike is from 1/2", "as above", "bits that flip together (bit independence)"),
    ("far pairs", "bits of random cells against those of cells 1, 2, 4, ... 2^24 further", "normal, `1 / sqrt(n)`; peak, two sides", "long periods"),
    ("far pairs: equal words", "equal words among these pairs", "Poisson; both tails", "long periods"),
    ("near returns", "bits of cells, anywhere and within 2^23 of the origin, against those at lags after which a spread coordinate is nearly the same: denominators of a continued fraction; 2^k, up to 2^16; the same in two axes at once, also 2^k back in the other", "normal, `1 / sqrt(n)`; peak, two sides", "cells far apart whose spread coordinates differ in few bits"),
    ("near returns: gradients", "correlation of the gradients of these pairs: the mean of their dot products over that of a gradient with itself", "normal, `1 / sqrt(dimensions n)`; peak, two sides", "fields that look alike far apart"),
    ("near returns: equal words", "equal words among these pairs", "Poisson; both tails", "the same, and joins of coordinates that agree together"),
    ("seeds: correlation", "gradients of two seeds at all shifts, and reflected", "normal; peak, two sides", "seeds that only move or reflect the field"),
    ("seeds: pairs of bits", "agreement of any two bits of the words of two seeds", "normal; peak, two sides", "seeds that flip bits"),
    ("seeds: common words", "pairs of equal words, one from each seed's window", "Poisson, `n^2 / 2^b`; both tails", "seeds that permute the field"),
    ("seeds: common runs", "pairs of equal runs, one from each seed's window", "Poisson; both tails", "copied parts"),
    ("seeds: avalanche", "as avalanche, where each of the 32 bits of the seed flips", "as avalanche", "bits of the seed without effect"),
    ("two components: numbers", "chi-square of the 6 high bits of the numbers of two components of a vector (`hn_value_vector`) at the same point, all windows together", "chi-square, 4095 degrees of freedom; both tails", "components that depend on each other"),
    ("two components: waves", "largest ordinate of the spectrum of the table of these numbers, without those along an axis: the spectral test of congruential generators, as measured", "exponential; peak", "pairs on few lines"),
    ("two components: gradients", "chi-square of the weightiest consumed bits of each of two components (`hn_perlin_vector`): 3 in the plane, 6 in space", "chi-square, 63 or 4095 degrees of freedom; both tails", "gradients that depend on each other"),
    ("two components: parities", "the parity of every selection of these bits, some from either component: how often it is even, in standard deviations", "normal; peak, two sides", "a relation between bits of components"),
    ("three components: ...", "the same of three components, 4 bits of each", "as above, 4095 degrees of freedom", "triples on few planes, although any two components are independent"),
    ("components: correlation", "gradients of two components at all shifts, and reflected", "normal; peak, two sides", "components that are the same field elsewhere"),
    ("components: correlation of numbers", "the same of the numbers of value noise", "normal; peak, two sides", "the same"),
    ("components: pairs of bits", "agreement of any two consumed bits of two components, at the same point and at the next ones along axes", "normal; peak, two sides", "components that have a bit in common"),
    ("components: common runs", "pairs of equal runs, one from each component's window", "Poisson; both tails", "copied parts"),
    ("components: value noise, perlin noise", "correlation of two components of `hn_value_vector` and `hn_perlin_vector` at places in cells, with those at the same place and at 64 places up to three cells away along each axis", "normal, by the spread of the products, `1 / sqrt(n)`; peak, two sides", "noises that depend on each other"),
    ("one component: ...", "the tests with these names, of the words of a further component alone, in two windows (expensive tests in one)", "as above", "a component that is a worse noise than the first"),
    ("one component: equal words", "pairs of equal words; the words are made of 24 bits, so there are many", "Poisson, `n (n - 1) / 2 / 2^24`; both tails", "words that lose bits"),
]

CONTROLS = """## What the gate rejects

Each test has a lattice that it must reject, and all tests accept an independent random lattice (Philox). numpy makes the lattices, in the plane; those of components, in space. `tools/lib/measure/hashes/hashes_test.py` has most of them in space as well.

"""

NOISE = """## The noise

The statistics are those of 1024 x 1024 samples, 8 per cell (in 3D of a slice), for 8 seeds, with the standard error of the mean over the seeds. The attained range is that of 2^22 random points. The spectrum is computed under a Hann window. Directions are computed from waves between 0.3 and 1.2 cycles per cell, in sectors of 10 degrees. The ratio of the strongest direction to the weakest is above 1 for any noise, because sectors fluctuate. "Axes" and "diagonals" are the directions within 10 degrees of them. A lattice of squares favours its axes a little.

![Spectrum by frequency and by direction](../images/quality-noise.png)

"""

ISOTROPY = """
### Do its structures have directions?

The spectrum does not show this: it is the same for all gradients that have the same mean square along each axis. The eye sees bars and chains of blobs, and the test measures these. The structure tensor of the noise (products of its derivatives, smoothed by a Gaussian of 3/4 cell) has a main axis at each place, across the structure there. `((n + 2) sum x^4 - 3) / (n - 1)` of its direction, in n dimensions, is 1 along the axes and has the mean 0 over all directions. In the plane it is the cosine of four times the angle, and -1 along the diagonals. The mean is over the half of all places with the steepest slopes, weighted by the cube of the difference of the two largest eigenvalues over the sum of all. The noise is made of the gradients of blocks of 256 x 256 or 32 x 32 x 32 cells, which wrap.

Any noise on a lattice of squares favours its axes and its diagonals; the gradients decide which of them it favours more. The magnitude may be {aim} at most in the plane and {space} in space. Gradients of length 1 in uniform directions have about as much in the plane, and so have the 12 edges of Perlin's "Improving noise" (2002) in space, which the library uses: they are the usual choices if directions must not show. A limit of zero would not be better founded: the number moves by as much if all places count. These are the values for some sets of gradients, made by numpy, with the standard error. The picture shows the first three of them with the same words of the default hash.

![Noise of gradients on four diagonals, of the library, and on the circle, and the directions across its structures](../images/isotropy.png)

"""

LOOKS = """
### What each noise shows of its lattice

This table has the noises of the library side by side, with 8 seeds each and the standard error. In the plane the four numbers are the means of the cosine of two, four, six and eight times an angle: of one axis alone, of the axes of squares, of the sides of triangles, of the axes and the diagonals of squares alike. In space the number is the one above. Without a preferred direction the number is 0.

*Structures* uses the directions across the strongest structures, as above. *Spectrum* uses the directions of the waves of a field, weighted by their power. All noises are sampled with four points to a step of their lattice, and smoothed alike: a step of 2D simplex noise is half a cell. *Slices* is the least deviation of a slice across z over the greatest, at 8 heights of a cell: 1 if all slices are alike.

`hn_perlin_worley` has one octave, because further octaves have lattices of their own. Its billows are a little denser at some places of a cell than at others, as the distances of cellular noise are. Of its variance {fixed} is the same in each cell, and its spectrum shows this part. Without this part the spectrum has {rest}. This noise is tested: its structures may have {structures}, that part of the variance {most}, the spectrum without it {waves}, and its slices must have {slices}.

With a [phase](../reference/noises.md#loops-gradients-that-rotate) gradients rotate. On the plane the set of them differs the most after an eighth of a turn, and structures prefer the diagonals there. In space their preference is the same at each phase.

![Perlin noise, simplex noise, smooth simplex noise, and the directions across their structures](../images/looks.png)

"""

STRIPES = """
### What stripes show of theirs

`hn_phasor` has a direction, the direction of its wave. So the test looks at the spectrum around that wave, of the value and the quadrature as a complex field in a tile, for {seeds} seeds, in cycles per cell:

- *Centre* is the distance of the mean frequency from the wave. It may be {away}.
- *Width* is the deviation of the frequencies, along the wave and across it, with the standard error. Behind it is the deviation of the weight by which a point fades, within the frequencies that samples show. The width may differ from that by {width}%. Stripes break more often the wider it is.
- *Round* has the means of the cosines, as above, of the directions away from the wave: 0 if the spectrum is the same on all sides. They may be {round}.
- *Even* is the least deviation of the field at a place of a cell over the greatest, among places that are spread over the cell: 1 if the lattice does not show. It shows little: the sum of the squares of the weights, which is the mean energy, is nearly the same everywhere. The least allowed is {even2} in 2D and {even3} in 3D, which the present weights reach. `n.x / length(n)` and values computed from the angle do not fade.
- *Steady* is how well these values follow the wave at the places where they follow it least: the mean cosine of the error of the angle after a step of {step} of a cell along the wave. It has no limit.
- *Seeds* is the largest squared correlation of the fields of two seeds, over all shifts, in units of its mean, and behind it the limit by chance, as for the tests of the gate.

"""

SUMS = """
### What octave sums show of their lattices

If octaves are not rotated, they have the same axes, and the traces of these axes add up. These are the fourth harmonics of `hn_fbm` with a lacunarity of 2 and a gain of 1/2: the means of the cosine of four times an angle, for 8 seeds, with the standard error. *Spectrum* uses the waves of the slopes of {waves} octaves, from {least} to {most} cycles per cell of the first octave, weighted by their power. *Structures* uses the directions across the structures of {octaves} octaves: the structure tensor of the slopes, smoothed by a Gaussian of half a cell and of a cell of the first octave, weighted by the cube of its coherence. The first number may be {limit} at most, which is half of the number of sums without rotation. The last columns have sums without rotation: with a period octaves must not be rotated, and the period is longer than the pictures. In space the rotation is a compromise between the three axes.

"""

REPEATS = """A tile of {period} cells should not repeat inside. All of its octaves but the first are compared with themselves, moved by a half, a fourth and an eighth of the period along an axis or a diagonal. If each octave repeated after the same number of its own cells, the largest correlation would be 1.

"""

SINE = """## For comparison: the sine gradient

`HN_GRADIENT_SINE` is the paper's gradient: the hash as published, neither spread nor mixed, and as weak as published. Here it is measured at the origin with seed 0. It has no limit.

"""
