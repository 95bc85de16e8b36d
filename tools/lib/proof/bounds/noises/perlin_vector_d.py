"""hn_perlin_vector_d: each component with its derivatives is hn_perlin_d with words of its own, so it has the same
bounds."""

from proof.bounds.noises import perlin_d

CASES = tuple((dims, gradient) for dims, gradient in perlin_d.CASES if dims in (2, 3))
derive = perlin_d.derive
largest_intermediates = perlin_d.largest_intermediates
