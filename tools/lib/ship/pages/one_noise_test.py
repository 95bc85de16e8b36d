"""Tests of tools/make one-noise: the page has its quotes, and a quote that changed is noticed."""

import unittest

from base.tree import ROOT
from ship.pages import one_noise


class OneNoise(unittest.TestCase):
    def test_the_page_has_its_quotes(self):
        page = (ROOT / one_noise.NAME).read_text(encoding="utf-8")
        self.assertEqual(one_noise.with_quotes(page), page)
        wrong = page.replace("hn_i_fade(f)", "hn_i_fade(f * f)", 1)
        self.assertNotEqual(wrong, page)
        self.assertEqual(one_noise.with_quotes(wrong), page)

    def test_a_page_without_a_mark_is_refused(self):
        with self.assertRaisesRegex(LookupError, "one-noise: contract"):
            one_noise.with_quotes("# One noise\n")
