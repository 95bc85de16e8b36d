"""The functions in most use exist, and so do their packages."""

from __future__ import annotations

import unittest

from base.tree import GLSL
from catalog import popular
from translate.pick.command import Choice, read_library

WHO = {"graphs", "blender", "materialx"}


def unknown(lists: dict) -> list[str]:
    """Entries of the lists that are no function, no form of one, or no package."""
    known = read_library(GLSL, Choice("glsl", "fixed")).forms
    forms = {name.removeprefix("hn_") for name in known}
    functions = {function.name.removeprefix("hn_") for function in known.values()}
    return [*(name for name in (*lists["nodes"], *lists["snippets"]) if name not in forms),
            *(who for have in lists["nodes"].values() for who in have if who not in WHO),
            *(name for of in lists["rust"].values() for name in of["functions"] if name not in functions)]


class Asked(unittest.TestCase):
    def test_it_is_there(self) -> None:
        self.assertEqual(unknown(popular._lists()), [])

    def test_what_is_not_is_noticed(self) -> None:
        for list_, entry in (("nodes", {"perlin5": ["graphs"]}), ("nodes", {"perlin2": ["grahps"]}),
                             ("snippets", {"perln2": "noise"}),
                             ("rust", {"fbm": {"functions": ["fmb"], "dimensions": 3}})):
            with self.subTest(entry):
                self.assertEqual(len(unknown({**popular._lists(), list_: entry})), 1)

    def test_each_package_has_some(self) -> None:
        for who in WHO:
            self.assertIn("hn_fbm2", popular.nodes(who))
        self.assertEqual(popular.modules()["perlin"], (("hn_perlin",), 4))
        self.assertEqual(popular.snippets()["hn_perlin2"], "gradient noise on the plane")
