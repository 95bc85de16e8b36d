"""tools/measure languages: it counts what differs, and refuses what it does not know."""

from __future__ import annotations

from unittest import mock

from base.testing import Case, called
from measure import languages, stamps
from translate.pick.runners import RUNNERS, CRunner


class Wrong(CRunner):
    """Its hn_perlin2 returns another bit at some points."""
    def build(self, texts, calls, folder):
        wrong = calls[0].replace("put_float(value);", "put_float(value > 0.5f ? -value : value);")
        assert wrong != calls[0]
        return super().build(texts, [wrong, *calls[1:]], folder)


class Languages(Case):
    def setUp(self) -> None:
        self.enterContext(mock.patch.object(languages, "FUNCTIONS", ("hn_perlin2", "hn_random2")))

    def call(self, *arguments: str) -> tuple[int, str]:
        return called(languages.main, "--out", self.folder, *arguments)

    def rows(self) -> list[list[str]]:
        path = self.folder / "languages.csv"
        self.assertEqual(stamps.stale(path), [])
        return [list(row.values())[:4] for row in stamps.read(path).rows]

    def test_a_text_with_the_bits_of_the_library(self) -> None:
        status, printed = self.call("--points", "400", "c")
        self.assertEqual((status, self.rows()), (0, [["c", name, "200", "0"] for name in languages.FUNCTIONS]), printed)

    def test_a_text_with_other_bits(self) -> None:
        with mock.patch.dict(RUNNERS, c=Wrong):
            status, printed = self.call("--points", "400", "c")
        self.assertEqual(status, 1, printed)
        (_, name, _, count), *others = self.rows()
        self.assertTrue(name == "hn_perlin2" and 2 <= int(count) <= 60, count)
        self.assertEqual({row[3] for row in others}, {"0"})

    def test_bad_usage(self) -> None:
        for arguments, said in ((["--points", "0"], "'0' is not a whole number from 1 on"),
                                (["basic"], "there is no language basic; it is one of c, csharp, go")):
            with self.subTest(arguments):
                status, printed = self.call(*arguments)
                self.assertEqual(status, 2)
                self.assertIn(said, printed)

    def test_a_language_without_a_compiler(self) -> None:
        with mock.patch.object(CRunner, "programs", ("no-such-compiler",)):
            status, printed = self.call("c")
        self.assertEqual(status, 4)
        self.assertIn("c is left out: there is no no-such-compiler", printed)
