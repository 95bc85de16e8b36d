"""Files kept in build/ are made anew where they or their inputs changed."""

from __future__ import annotations

from base.cache import cached
from base.testing import Case


class Cached(Case):
    def setUp(self) -> None:
        self.root = self.folder
        self.source = self.root / "source"
        self.source.write_text("one")
        self.made = 0

    def make(self) -> dict[str, str]:
        self.made += 1
        return {"a": self.source.read_text(), "b": "2"}

    def look(self) -> dict[str, str]:
        folder = cached(self.root / "build" / "things", [self.source], self.make)
        return {path.name: path.read_text() for path in folder.iterdir()}

    def test_it_is_made_once(self) -> None:
        for _ in range(3):
            self.assertEqual(self.look(), {"a": "one", "b": "2"})
        self.assertEqual(self.made, 1)

    def test_it_is_made_anew_where_something_is_another(self) -> None:
        self.look()
        for path, text in ((self.source, "two"), (self.root / "build/things/b", "3"), (self.root / "build/things/c", "")):
            path.write_text(text)
            self.assertEqual(self.look(), {"a": self.source.read_text(), "b": "2"})
        (self.root / "build" / "things" / "a").unlink()
        self.assertEqual(self.look(), {"a": "two", "b": "2"})
        self.assertEqual(self.made, 5)
