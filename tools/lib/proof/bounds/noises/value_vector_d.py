"""hn_value_vector_d: each component with its derivatives is hn_value_d with words of its own, so it has the same
bounds."""

from proof.bounds.noises import value_d

CASES = tuple((dims, gradient) for dims, gradient in value_d.CASES if dims in (2, 3))
derive = value_d.derive
largest_intermediates = value_d.largest_intermediates
