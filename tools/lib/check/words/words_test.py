"""Tests of the linter of words, and that the pages have none."""

import tempfile
import unittest
from pathlib import Path
from unittest import mock

from check.words import lint

HEAD = "# Page\n\nThis page is an example.\n\n"


def found(text: str, head: str = HEAD) -> list[str]:
    return list(lint.faults("docs/x.md", head + text))


class Words(unittest.TestCase):
    def test_the_pages_have_none(self) -> None:
        self.assertEqual(list(lint.faults_of_pages()), [])

    def test_planted_faults_are_found(self) -> None:
        for text, fault in (
                ("There are two, of which one is red.", "'of which': write two sentences"),
                ("A noise of whose points none is 0.", "'of whose': write two sentences"),
                ("The tool says so.", "'says': programs print"),
                ("| a | the command tells |", "'tells': programs print"),
                ("It ends. What is left is 0.", "'What': begin with the subject"),
                ("- Those of the plane are 1.", "'Those': begin with the subject"),
                ("| a | That of a cell |", "'That': begin with the subject"),
                ("**What passes.** All.", "'What': begin with the subject"),
                ("This is dearer.", "'dearer': costs more"),
                (f"| a | {'b' * 251} |", "a cell of")):
            with self.subTest(text=text):
                message, = found(text)
                self.assertIn(f"docs/x.md:5: {fault}", message)

    def test_a_page_begins_with_its_purpose(self) -> None:
        for head in ("# Page\n\n![A picture](x.png)\n\n", "# Page\n\n| a | b |\n| --- | --- |\n\n", "# Page\n\n## Part\n\n"):
            self.assertEqual(found("text", head), ["docs/x.md:1: begin with a sentence that states what the page is for"])

    def test_code_names_headings_and_records_are_left_out(self) -> None:
        for text in ("```glsl\n// what it says\n```\n", "    tool  # says it\n", "`it says`", "[a page](says.md)", "## What it says",
                     "What is it? It is noise.", f"| {'b' * 250} |",
                     "<!-- tools/make readme: x -->\n| it says |\n<!-- end -->\n"):
            self.assertEqual(found(text), [], text)
        self.assertEqual(found("It says.", "# Page\n\n`tools/make faults` writes this page.\n\n"), [])

    def test_the_text_of_the_catalog_is_read(self) -> None:
        text = "<!-- tools/make readme: x -->\n| it says |\n<!-- end -->\n<!-- tools/make catalog: y -->\n| it says |\n<!-- end -->\n"
        self.assertEqual(len(found(text)), 1)
        self.assertIn("docs/x.md:9: ", found(text)[0])

    def test_exceptions_and_folders(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder, "docs", "x.md")
            page.parent.mkdir()
            page.write_text(HEAD + "It says.\n", encoding="utf-8")
            self.assertEqual(len(list(lint.faults_of_pages(Path(folder)))), 1)
            with mock.patch.object(lint, "EXCEPTIONS", {("docs/x.md", "says")}):
                self.assertEqual(list(lint.faults_of_pages(Path(folder))), [])


if __name__ == "__main__":
    unittest.main()
