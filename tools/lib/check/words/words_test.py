"""Tests of the linter of words, and that the tree has no such words."""

import subprocess
import tempfile
import unittest
from collections import Counter
from pathlib import Path
from unittest import mock

from check.words import lint

HEAD = "# Page\n\nThis page is an example.\n\n"


def found(text: str, head: str = HEAD) -> list[str]:
    return list(lint.faults("docs/x.md", head + text))


class Words(unittest.TestCase):
    def test_the_tree_has_none(self) -> None:
        self.assertEqual(list(lint.faults_of_tree()), [])

    def test_planted_faults_are_found(self) -> None:
        for text, fault in (
                ("There are two, of which one is red.", "'of which': write two sentences"),
                ("A noise of whose points none is 0.", "'of whose': write two sentences"),
                ("The tool says so.", "'says': programs print"),
                ("Says it is so.", "'Says': programs print"),
                ("| a | the command tells |", "'tells': programs print"),
                ("The notes say so.", "'say': programs print"),
                ("It cannot tell which.", "'tell': programs print"),
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
                     "<!-- tools/make pages: x -->\n| it says |\n<!-- end -->\n"):
            self.assertEqual(found(text), [], text)
        self.assertEqual(found("It says.", "# Page\n\n`tools/make faults` writes this page.\n\n"), [])

    def test_the_text_of_the_catalog_is_read(self) -> None:
        text = "<!-- tools/make pages: x -->\n| it says |\n<!-- end -->\n<!-- tools/make catalog: y -->\n| it says |\n<!-- end -->\n"
        self.assertEqual(len(found(text)), 1)
        self.assertIn("docs/x.md:9: ", found(text)[0])

    def test_faults_in_code_are_found(self) -> None:
        for name, text in (
                ("x.py", "a = 1\n# The tool says so."), ("x.py", 'def f():\n    """The number, as the file tells."""'),
                ("x.py", "\nprint(f'{name} says nothing')"), ("x.py", '"""Head.\n\nWhat is left is 0."""'.replace("\n\n", "\n")),
                ("x.cpp", "int a;  // here\n// Those of the plane."), ("x.cpp", '\nthrow Error("the file tells nothing");'),
                ("x.hpp", "/* A pair,\n * of which one is red. */"), ("x.glsl", "\n// That of a cell is 1."), ("x.js", "\nshow(`${a} is dearer`);"),
                ("x.cmake", '\nmessage(STATUS "The file says so")'), ("x.toml", "\n# What it is."), ("tool", "#!/bin/sh\n# The program says so."),
                ("x.html", "<p>\nThe page tells you.</p>")):
            with self.subTest(name=name, text=text):
                message, = lint.faults_of_code(name, text)
                self.assertTrue(message.startswith(f"{name}:2: "), message)

    def test_names_and_code_are_left_out(self) -> None:
        for name, text in (("x.py", "told = asks['says']  # a name"), ("x.cpp", "bool told = says; // as `told` is"), ("x.sh", "echo $#  says"),
                           ("x.py", "# What is it?")):
            self.assertEqual(list(lint.faults_of_code(name, text)), [], text)

    def test_words_of_comments_have_a_ceiling(self) -> None:
        for text, words, remedy in (
                ("# tools/make writes it of a.glsl.", "rit(?:es|ten)", "generated from"), ("x = 1  # The same of b.", "The same", "name the thing"),
                ('"""Likewise."""', "Likewise", "name the thing"), ("# It ends. Of two one is red.", " )Of ", "begin with the subject"),
                ("# The error is that of b.", "hat|", "repeat the noun"), ("# It returns what is left.", "hat (?:is", "write the noun")):
            with self.subTest(text=text), tempfile.TemporaryDirectory() as folder:
                subprocess.run(["git", "init", "-q", folder], check=True)
                (Path(folder) / "a.py").write_text(f'print("Of that of what is left")\n{text}\n', encoding="utf-8")
                pattern, = lint.counts_of_tree(Path(folder)) + Counter()
                self.assertIn(words, pattern)
                for ceiling, found in ((0, [f"comments have '{pattern}' 1 times, and may 0 times: {remedy}"]), (1, [])):
                    with mock.patch.dict(lint.CEILINGS, {pattern: (ceiling, lint.CEILINGS[pattern][1])}):
                        messages = list(lint.faults_of_tree(Path(folder)))
                        self.assertEqual([message[:len(one)] for message, one in zip(messages, found)], found)
                        self.assertEqual(len(messages), len(found))

    def test_exceptions_and_folders(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            subprocess.run(["git", "init", "-q", folder], check=True)
            for name, text in (("docs/x.md", HEAD + "It says.\n"), ("a/x.py", "# It says so.\n"), ("made/x.py", "# It says so.\n"),
                               ("README.md", "# Name\n\nIt says.\n"), (".gitignore", "made\n")):
                (root / name).parent.mkdir(exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            with mock.patch.object(lint, "NOT_YET", ()):
                found = [message.partition(":")[0] for message in lint.faults_of_tree(root)]
                self.assertEqual(found, ["README.md", "a/x.py", "docs/x.md"])
                with mock.patch.object(lint, "EXCEPTIONS", {"docs/x.md": "says", "a/*": "*"}):
                    self.assertEqual(len(list(lint.faults_of_tree(root))), 1)
            with mock.patch.object(lint, "NOT_YET", ("a/", "docs/")):
                self.assertEqual(len(list(lint.faults_of_tree(root))), 1)
