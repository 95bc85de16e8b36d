"""tools/pack: help and refusals, of every package alike. The tests of a package check its contents."""

from __future__ import annotations

import contextlib
import io
import json
import tempfile
import unittest
import zipfile
from pathlib import Path
from unittest import mock

from base.pieces import was_deleted
from base.testing import Case
from base.tree import ROOT, version
from ship import command, packing, page
from ship.packing_support import lost_links
from ship.recipes import RECIPES

PACKED = [name for name, recipe in RECIPES.items() if not recipe.command]
FOLDERS = [name for name in PACKED if RECIPES[name].has_folder]


def call(*arguments: str) -> tuple[int, str, str]:
    """The status, and the output."""
    with contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(io.StringIO()) as error:
        try:
            status = command.main(arguments)
        except SystemExit as ended:
            status = ended.code
    return status, out.getvalue(), error.getvalue()


class Manifests(unittest.TestCase):
    def test_they_have_the_address_of_the_project(self) -> None:
        with mock.patch.object(packing, "address", return_value="https://example.org/another"):
            for path in (ROOT / "packages").glob("*/package.json"):
                described = json.loads(packing.of_npm(path.read_text(encoding="utf-8"), "name"))
                self.assertEqual(described["repository"]["url"], "git+https://example.org/another.git")
                self.assertEqual(described["homepage"], "https://example.org/another")
            for path in (ROOT / "packages").glob("*/Cargo.toml"):
                self.assertIn('\nrepository = "https://example.org/another"\n', packing.of_cargo(path.read_text(encoding="utf-8")))

    @mock.patch.object(packing, "address", return_value="")
    def test_without_an_address_they_have_no_link(self, _: mock.Mock) -> None:
        self.assertEqual(json.loads(packing.of_npm("{}", "name")), {"name": "name", "version": version()})
        self.assertEqual(packing.of_cargo("[package]\nname = 1\n"), f'[package]\nversion = "{version()}"\nname = 1\n')

    def test_a_package_takes_no_file_of_its_tests(self) -> None:
        for path in (ROOT / "packages").glob("*/tests.cmake"):
            if path.parent.name in PACKED:
                self.assertNotIn(path.name, packing.own_files(path.parent))


class Usage(unittest.TestCase):
    def assert_refused(self, arguments: tuple[str, ...], *said: str) -> None:
        with self.subTest(arguments):
            status, out, error = call(*arguments)
            self.assertEqual((status, out, error.count("\n")), (2, "", 1), error)
            for text in said:
                self.assertIn(text, error)

    def test_help_names_each_package(self) -> None:
        for asked in ("--help", "-h", "help"):
            status, told, error = call(asked)
            self.assertEqual((status, error), (0, ""))
            for name, recipe in RECIPES.items():
                self.assertRegex(told, rf"(?m)^  {name} +{recipe.line.split()[0]}")
            self.assertIn("Exit status: 0 done", told)

    def test_each_package_tells_its_options(self) -> None:
        for name, recipe in RECIPES.items():
            for asked in ("--help", "help"):
                status, told, error = call(name, asked)
                with self.subTest(name):
                    self.assertEqual((status, error), (0, ""))
                    self.assertIn(f"tools/pack {name} ", told)
                    self.assertIn("Exit status: 0 done", told)
                    for option in (*recipe.options, *["zip"] * recipe.has_folder):
                        self.assertIn(f"--{option}", told)

    def test_a_name_that_there_is_not(self) -> None:
        self.assert_refused(("relaese",), "tools/pack: there is no package relaese (did you mean release?)",
                            "tools/pack --help lists them")
        self.assert_refused(("release-all", "out"), "there is no package release-all (did you mean release?)")
        self.assert_refused(("--zip",), "there is no package --zip;")
        self.assert_refused((), "the name of a package is missing; tools/pack --help lists them")
        self.assert_refused(("",), "the name of a package is missing")

    def test_what_is_no_option(self) -> None:
        for name in RECIPES:
            self.assert_refused((name, "--no-such=1"), f"tools/pack {name}: there is no option --no-such; ",
                                f"see tools/pack {name} --help")
        for name in FOLDERS:
            self.assert_refused((name, "--zpi"), "there is no option --zpi (did you mean --zip?)")
        if "blender" in RECIPES:
            self.assert_refused(("blender", "--weel", "a.whl"), "there is no option --weel (did you mean --wheel?)")

    def test_what_is_no_folder(self) -> None:
        for name in (name for name in RECIPES if name != "release"):
            self.assert_refused((name, __file__), f"tools/pack {name}: ", "is a file; it must be a folder")
            self.assert_refused((name, ""), "the folder has no name")
            self.assert_refused((name, "one", "two"), "two is one word too many")

    def test_times_are_numbers(self) -> None:
        with mock.patch.dict("os.environ", SOURCE_DATE_EPOCH="now"):
            for name in PACKED:
                self.assert_refused((name, "folder"), "SOURCE_DATE_EPOCH is a number of seconds, not now")


class Writing(Case):
    """Whatever the files are."""

    def made(self, name: str, *options: str, **variables: str) -> Path:
        content = {"page.md": "# Page\n", "src/library": b"\0"}
        with mock.patch.object(packing, "files_of", return_value=content), mock.patch.dict("os.environ", variables):
            status, out, error = call(name, *options, str(self.folder))
        self.assertEqual((status, error), (0, ""))
        return Path(out.strip())

    def test_each_has_its_name(self) -> None:
        for name in PACKED:
            recipe = RECIPES[name]
            with self.subTest(name):
                made = self.made(name, *["--zip"] * recipe.has_folder)
                self.assertEqual(made, self.folder / f"{recipe.zip_name}-{version()}.zip")
                top = f"{recipe.name}-{version()}/" if recipe.has_folder else ""
                with zipfile.ZipFile(made) as packed:
                    found = {path: packed.read(path) for path in packed.namelist()}
                self.assertEqual(found, {f"{top}page.md": b"# Page\n", f"{top}src/library": b"\0"})
                if recipe.has_folder:
                    made = self.made(name)
                    self.assertEqual(made, self.folder / f"{recipe.name}-{version()}")
                    self.assertEqual({path.relative_to(self.folder).as_posix(): path.read_bytes()
                                      for path in made.rglob("*") if path.is_file()}, found)

    @unittest.skipUnless("godot" in PACKED, "it was deleted")
    def test_what_a_registry_asks_stands_beside_it(self) -> None:
        with mock.patch.object(packing, "beside", return_value={"-form.md": "text"}):
            made = self.made("godot")
        self.assertEqual((self.folder / f"{made.stem}-form.md").read_text(encoding="utf-8"), "text")

    @unittest.skipUnless(FOLDERS, "all were deleted")
    def test_times_are_those_of_the_variable(self) -> None:
        one = self.made(FOLDERS[0], "--zip").read_bytes()
        self.assertEqual(self.made(FOLDERS[0], "--zip").read_bytes(), one)
        other = self.made(FOLDERS[0], "--zip", SOURCE_DATE_EPOCH="1700000000")
        self.assertNotEqual(other.read_bytes(), one)
        self.assertEqual(zipfile.ZipFile(other).infolist()[0].date_time[:3], (2023, 11, 14))

    @unittest.skipUnless(FOLDERS, "all were deleted")
    def test_what_an_earlier_run_left_goes_and_what_cargo_made_stays(self) -> None:
        made = self.made(FOLDERS[0])
        for name in ("old/file", "target/built", "Cargo.lock"):
            (made / name).parent.mkdir(exist_ok=True)
            (made / name).touch()
        self.assertEqual(self.made(FOLDERS[0]), made)
        self.assertEqual({path.name for path in made.iterdir()}, {"page.md", "src", "target", "Cargo.lock"})

    @unittest.skipUnless(FOLDERS, "all were deleted")
    def test_a_folder_that_cannot_be_made(self) -> None:
        (self.folder / "file").touch()
        with mock.patch.object(packing, "files_of", return_value={}):
            status, out, error = call(FOLDERS[0], str(self.folder / "file" / "below"))
        self.assertEqual((status, out), (2, ""))
        self.assertIn("below cannot be made: Not a directory", error)


class Pages(unittest.TestCase):
    PAGE = """\
# Name

<!-- in a package:
    install name

It is there.
-->

    make name    # here

Here is more.
<!-- end -->

[One](more.md#part), [`hn_two`](../x.hpp), [all](../../src/), [here](#name), [else](https://example.org/a_(b)).

```cpp
return [x](float) { return a[1](y); };  // [no](link.md)
```

`[no](link.md)`
"""

    def made(self, text: str, address: str = "https://example.org/another") -> str:
        root = Path(self.enterContext(tempfile.TemporaryDirectory()))
        path = root / "packages" / "name" / "page.md"
        path.parent.mkdir(parents=True)
        path.write_text(text, encoding="utf-8")
        with mock.patch.multiple(page, ROOT=root, address=lambda: address):
            return page.of_package(path)

    def test_links_lead_to_this_version_of_the_project(self) -> None:
        files = f"https://example.org/another/blob/v{version()}"
        self.assertEqual(self.made(self.PAGE), f"""\
# Name

    install name

It is there.

[One]({files}/packages/name/more.md#part), [`hn_two`]({files}/packages/x.hpp), [all]({files}/src), \
[here](#name), [else](https://example.org/a_(b)).
{self.PAGE[self.PAGE.index("```cpp") - 1:]}""")

    def test_without_an_address_their_words_stay(self) -> None:
        self.assertIn("\n\nOne, `hn_two`, all, [here](#name), [else](https://example.org/a_(b)).\n\n```cpp",
                      self.made(self.PAGE, ""))
        for text, there, gone in (("[![A](a.png)](b.md#c)", "[![A](X/a.png)](X/b.md#c)", "A"),
                                  ("[a`[`](b)", "[a`[`](X/b)", "a`[`"),
                                  ("[1] (see [two\nwords](b))", "[1] (see [two\nwords](X/b))", "[1] (see two\nwords)")):
            self.assertEqual((page.relinked(text, "X/{}".format), page.relinked(text, lambda _: "")), (there, gone))

    def test_no_link_of_a_package_is_lost(self) -> None:
        """The tests release.whole and python.source open packages."""
        pages = {path.relative_to(ROOT).as_posix(): page.of_package(path)
                 for folder in ("packages", "docs/guide") for path in sorted((ROOT / folder).rglob("*.md"))}
        self.assertEqual(lost_links(pages, ()), [])
        self.assertGreater(len(pages), 10)

    def test_one_that_is_lost_is_reported(self) -> None:
        names = ("a/page.md", "a/more.md")
        self.assertEqual(lost_links({"a/page.md": self.PAGE}, names), ["a/page.md: ../x.hpp", "a/page.md: ../../src/"])
        self.assertEqual(lost_links({"a/page.md": self.made(self.PAGE)}, names), [])

    def test_pages_of_registries_begin_with_the_command_of_the_registry(self) -> None:
        for name, command_ in (("javascript", "npm install hashnoise"), ("python", "pip install hashnoise")):
            path = ROOT / "docs" / "guide" / f"{name}.md"
            if was_deleted(path.relative_to(ROOT).as_posix()):
                continue
            text = page.of_package(path)
            self.assertRegex(text, rf"\A# [^\n]+\n\n[^\n]+\n\n    {command_}\n\n")
            self.assertNotIn("<!-- in a package", text)
