"""The site: every page is in it, links are made for it, and in a whole one a link that leads nowhere is reported.

    website_test.py [CLASS...]     without a class as a module of unittest, all but Whole

Whole installs Sphinx. Exit status: as of the tests; 77 PyPI cannot be reached, so there is no site.
"""

from __future__ import annotations

import contextlib
import io
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock
from urllib.parse import quote

from base import chromium, glslang
from base.pieces import is_deleted
from base.pypi import SKIPPED, environment
from base.thorough import THOROUGH
from base.tree import ROOT
from ship.website import command, conf, live, pages

TUTORIAL = (ROOT / "docs" / "guide" / "tutorial.md").read_text(encoding="utf-8")

PAGE = """# One

[there](two.md#a-heading) [top](../README.md) [code](../code) [file](../code/a.c) [out](https://example.com)
"""
TOP = """# Top

[one](docs/one.md) [license](LICENSE)

```{toctree}
:hidden:
docs/one
docs/two
```
"""
# Words of users, and the page that the search of the site has to show first.
FIRST = {"seamless": "reference/noises", "persistence": "reference/fractals", "frequency": "reference/noises", "scale": "reference/noises",
         "domain warp": "reference/fractals", "Worley": "guide/cellular", "turbulence": "reference/fractals",
         "octaves": "reference/fractals", "cellular": "guide/cellular", "golang": "guide/same-bits", "server": "guide/same-bits"}
# Whatever a page loads by itself, from elsewhere.
LOADED = re.compile('<(?:script|img|iframe)[^>]*\\bsrc="(?:https?:)?//|'
                    '<link[^>]*rel="(?:stylesheet|preload)"[^>]*href="(?:https?:)?//')


class Tree(unittest.TestCase):
    """A repository of two pages and a folder."""

    def setUp(self) -> None:
        self.root = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.copy = self.root / "copy"
        self.write("README.md", TOP)
        self.write("docs/one.md", PAGE)
        self.write("docs/two.md", "# Two\n\n## A heading\n\ntext\n")
        self.write("LICENSE", "MIT\n")
        self.write("code/a.c", "int a;\n")
        subprocess.run(["git", "init", "-q", "--template=", self.root], check=True)
        subprocess.run(["git", "-C", self.root, "add", "-A"], check=True)

    def write(self, name: str, text: str) -> None:
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text, encoding="utf-8")

    def copied(self) -> None:
        copy = pages.Copy(self.root, self.copy)
        for name in pages.pages(self.root):
            copy.page(name)


class Links(Tree):
    def test_they_lead_to_what_the_site_has(self) -> None:
        self.assertEqual(pages.pages(self.root), ["README.md", "docs/one.md", "docs/two.md"])
        self.copied()
        text = (self.copy / "docs" / "one.md").read_text()
        self.assertEqual(re.findall(r"\]\(([^)]*)\)", text), ["two.md#a-heading", "../index.md", "../code/README.md",
                                                              "../code/a.c", "https://example.com"])
        self.assertEqual((self.copy / "code" / "README.md").read_text().splitlines()[-1], "- [a.c](a.c)")
        self.assertEqual((self.copy / "LICENSE").read_text(), "MIT\n")

    @unittest.skipIf(is_deleted("playground"), "the playground was deleted")
    def test_the_playground_of_a_release_is_that_of_the_site(self) -> None:
        self.write("docs/one.md", f"# One\n\nOpen {pages.PLAYGROUND}.\n")
        self.copied()
        self.assertIn('Open <a href="../playground.html">playground.html</a>.', (self.copy / "docs" / "one.md").read_text())


class Groups(unittest.TestCase):
    def test_each_page_is_in_one(self) -> None:
        grouped = [name for those in pages.GROUPS.values() for name in those]
        self.assertEqual(len(grouped), len(set(grouped)))
        self.assertEqual([name for name in grouped if not (ROOT / "docs" / f"{name}.md").is_file()], [])
        self.assertEqual(pages.ungrouped(pages.pages(ROOT)), [])

    def test_a_page_that_is_in_none_is_told(self) -> None:
        self.assertEqual(pages.ungrouped(["README.md", "docs/reference/fractals.md", "docs/guide/lost.md",
                                           "docs/measured/results/gpu/README.md"]), ["docs/guide/lost.md"])
        with mock.patch.object(pages, "pages", return_value=["docs/guide/lost.md"]), \
                self.assertRaisesRegex(ValueError, "^docs/guide/lost.md: no group"):
            pages.index()


class Tables(unittest.TestCase):
    def test_rows_have_the_cells_of_their_head(self) -> None:
        for name in pages.pages(ROOT):
            self.assertEqual(pages.torn_rows((ROOT / name).read_text(encoding="utf-8")), [], name)

    def test_a_bar_in_code_tears_a_row(self) -> None:
        row = "| `abs(x)` | `|x|` |"
        self.assertEqual(pages.torn_rows(f"text\n\n| a | b |\n| - | - |\n{row}\n\n| a |\n| `x \\| y` |\n"), [row])


class Search(unittest.TestCase):
    def test_each_heading_with_words_is_on_its_page(self) -> None:
        for name in pages.WORDS:
            text = pages.searched(name, (ROOT / name).read_text(encoding="utf-8"))
            self.assertEqual(text.count("\n```{index} ! "), len(pages.WORDS[name]))
        with self.assertRaisesRegex(ValueError, "docs/guide/cellular.md: no heading 'Cellular noise"):
            pages.searched("docs/guide/cellular.md", "# Cells\n")

    def test_pages_of_measurements_are_not_searched(self) -> None:
        for name, left_out in (("docs/measured/results/gpu/README.md", True), ("docs/reference/snippets/hn_fbm2.md", True),
                               ("docs/measured/results/README.md", False), ("docs/reference/snippets/README.md", False),
                               ("docs/measured/accuracy.md", False)):
            self.assertEqual(pages.searched(name, "text").startswith("---\nnosearch: true\n---\n"), left_out, name)


class Colours(unittest.TestCase):
    def test_code_without_a_language_gets_one(self) -> None:
        for text, language in (("vec3(0.5 + hn_fbm(uv))\n", "glsl"), ("hashnoise/tools/pack unity  # x\n", "sh"),
                               ("cmake -S a -B b\n", "sh"), ('{"schema": 2,\n', "json"), ("q_0 = p\n", "none")):
            self.assertEqual(conf.language_of(text), language, text)


class Usage(unittest.TestCase):
    def test_a_folder_that_is_no_site_stays(self) -> None:
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "mine").touch()
        for out in (folder, folder / "mine"):
            error = io.StringIO()
            with contextlib.redirect_stderr(error), self.assertRaises(SystemExit) as ended:
                command.main(["--out", str(out)])
            self.assertEqual(ended.exception.code, 2)
            self.assertIn(f"{out} is no site", error.getvalue())
        self.assertTrue((folder / "mine").exists())


class Live(unittest.TestCase):
    """The pictures of the tutorial."""

    def test_shaders_compile(self) -> None:
        steps = [step.groups() for step in live.STEP.finditer(TUTORIAL)]
        self.assertEqual([int(number) for number, *_ in steps], list(range(1, 13)))
        for number, _, code in steps if THOROUGH else [steps[8]]:
            with self.subTest(number):
                done = glslang.compiled(live.library(TUTORIAL) + live.shader(code))
                self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_step_has_its_picture_behind_its_code_and_before_its_text(self) -> None:
        text = live.with_pictures(TUTORIAL)
        second = text[text.index("## 2."):text.index("## 3.")]
        self.assertRegex(second, r'hn_value.*\n```\n\n<figure class="live">\n(?:.+\n)+</figure>\n\nThis is value')
        self.assertEqual((text.count("</figure>"), text.count("data-moves")), (12, 1))
        self.assertIn('<a href="../../playground.html#sum=none&amp;noise=value">', text)


@unittest.skipUnless(__name__ == "__main__", "the test site.whole has Sphinx")
class Whole(Tree):
    def refusal(self) -> str:
        self.copied()
        try:
            command.build(self.copy, self.root / "made")
        except command.NoSite as reason:
            self.assertEqual(reason.status, 1)
            return str(reason)
        return ""

    def test_a_link_that_leads_nowhere_is_told(self) -> None:
        self.assertEqual(self.refusal(), "")
        for right, wrong in (("two.md#a-heading", "two.md#a-header"), ("two.md#a-heading", "three.md"),
                             ("../code/a.c", "../code/b.c")):
            with self.subTest(wrong):
                self.write("docs/one.md", PAGE.replace(right, wrong))
                self.assertRegex(self.refusal(), "docs/one.md:3: WARNING: ")

    def test_that_of_the_project(self) -> None:
        out = self.root / "site"
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(command.main(["--out", str(out)]), 0)
        first = (out / "index.html").read_text(encoding="utf-8")
        for name in () if is_deleted("playground") else ("index", "docs/guide/tutorial"):
            self.assertIn('href="playground.html"', first)
            self.assertGreater((out / "playground.html").stat().st_size, 1000)
            self.assertIn('playground.html">playground.html</a>', (out / f"{name}.html").read_text(encoding="utf-8"))
        for page in out.rglob("*.html"):
            self.assertIsNone(LOADED.search(page.read_text(encoding="utf-8")), page)
        self.assertIsNotNone(LOADED.search('<script src="https://example.com/x.js">'))
        if not (program := chromium.found()):
            self.skipTest("there is no Chromium, which would search")
        browser = chromium.command(program, self.root / "profile", "--virtual-time-budget=8000", "--dump-dom")

        def shown(address: str) -> str:
            return subprocess.run([*browser, address], capture_output=True, text=True, check=False).stdout

        for words, right in FIRST.items():
            found = re.findall(r'<li[^>]*><a href="([^"#]*)', shown(f"{(out / 'search.html').as_uri()}?q={quote(words)}"))
            self.assertEqual(found[0], f"docs/{right}.html", words)
            self.assertEqual([page for page in found if "/cpu/" in page or "/snippets/hn_" in page], [], words)
        tutorial = out / "docs" / "guide" / "tutorial.html"
        self.assertEqual(len(re.findall(r'<figure class="live"[^>]* data-drawn=""', shown(tutorial.as_uri()))), 12)
        tutorial.write_text(tutorial.read_text(encoding="utf-8").replace("vec3 color_at(", "vec3 at(", 1),
                            encoding="utf-8")
        page = shown(tutorial.as_uri())
        self.assertGreaterEqual(page.count('class="copybtn'), 12)
        self.assertIn('<span class="kt">vec3</span>', page)
        self.assertEqual(page.count('data-drawn=""'), 11)
        self.assertIn("There is no picture here: ", page)


if __name__ == "__main__":
    if status := environment(command.ENVIRONMENT, command.HERE / "requirements.txt"):
        sys.exit(status if status == SKIPPED else 1)
    unittest.main()
