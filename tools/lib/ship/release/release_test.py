"""tools/pack release: its files are whole, the same each time, and of a committed tree."""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import subprocess
import tarfile
import tempfile
import unittest
import zipfile
from collections.abc import Callable
from pathlib import Path
from unittest import mock

from base.pieces import is_deleted, was_deleted
from base.tree import ROOT, TOOLS, address, site, version
from base.tree import files as files_of
from catalog import copies
from proof.vectors.files import vectors_folder
from ship.release import files

# Enough of the tree for these tests.
COPIED = [name for name in (
    "CMakeLists.txt", "LICENSE", "catalog", "conformance/expected/golden/hash.word.golden",
    "conformance/web/address.js", "glsl", "include", "packages/npm/package.json", "packages/wesl/Cargo.toml", "tools",
    *(name for name in copies.LINES if not name.startswith("include/"))) if not was_deleted(name)]
PLACE = "https://example.org/a-place"
# The address of the project, or of a page of a registry on it.
ADDRESS = re.compile(rb"https://[A-Za-z0-9_./-]+/hashnoise[A-Za-z0-9_-]*|example\.com")
REGISTRIES = ("https://pypi.org/", "https://www.npmjs.com/", "https://crates.io/")
CHEAP = "single,parts,vectors,headers,source"


def other_addresses(root: Path) -> list[str]:
    """Addresses in files that end like the project's, and are others; and those where nothing is, but in tests."""
    found = [(name, other.decode()) for name in files_of(root) for other in ADDRESS.findall((root / name).read_bytes())]
    return [f"{name}: {other} must be {address() or 'no link'}, as of conformance/web/address.js" for name, other in found
            if other.endswith("/hashnoise") and other not in (address(), site(address())) and not other.startswith(REGISTRIES)
            or other == "example.com" and not name.endswith("_test.py")]


class Project(unittest.TestCase):
    """A repository of its own, in which 0.3.0, or whatever it is, was released on a day."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = Path(scratch.name)
        cls.original = cls.scratch / "original"
        cls.original.mkdir()
        for name in COPIED:
            copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
            (cls.original / name).parent.mkdir(parents=True, exist_ok=True)
            copy(ROOT / name, cls.original / name)
        (cls.original / "vectors").mkdir()  # some are enough, and none is committed
        (cls.original / ".gitignore").write_text("/vectors/\n")
        for name in ("index.json", "hash.word.json"):
            shutil.copy(vectors_folder() / name, cls.original / "vectors")
        (cls.original / "CHANGELOG.md").write_text(
            f"# Changelog\n\n## {version()} (2026-11-22)\n\n- It is [there](docs/x.md).\n\n"
            "## 0.0.1 (2025-01-01)\n\n- Old.\n")
        with mock.patch.multiple(copies, released=version, address=lambda: PLACE):
            for name in copies.LINES:
                cls.change(cls.original / name, lambda text, name=name: copies.made(name, text))
        cls.change(cls.original / "conformance/web/address.js", lambda text: text.replace(f'"{address()}"', f'"{PLACE}"'))
        # Fewer files are copied of one pack than of a thousand objects.
        for arguments in (["init", "-q", "--template="], ["add", "-A"], ["commit", "-qm", "All of it"],
                          ["repack", "-adq"]):
            cls.git(cls.original, *arguments)

    @staticmethod
    def change(path: Path, how: Callable[[str], str]) -> None:
        path.write_text(how(path.read_text()))

    @staticmethod
    def git(folder: Path, *arguments: str) -> None:
        someone = {f"GIT_{who}_{what}": "someone@example.com" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
        subprocess.run(["git", "-C", folder, "-c", "gc.auto=0", *arguments], check=True, env=os.environ | someone)

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name) / "project"
        shutil.copytree(self.original, self.root)
        self.out = Path(scratch.name) / "out" / "release"

    def call(self, *arguments: str | Path, out: Path | None = None) -> subprocess.CompletedProcess[str]:
        return subprocess.run([self.root / "tools" / "pack", "release", *arguments, out or self.out],
                              capture_output=True, text=True, check=False)

    def refused(self, status: int, said: str, *arguments: str | Path) -> None:
        done = self.call(*arguments)
        self.assertEqual((done.returncode, done.stdout), (status, ""), done.stderr)
        self.assertRegex(done.stderr, said)
        self.assertFalse(self.out.parent.exists() and list(self.out.parent.iterdir()))


class Makes(Project):
    def test_the_same_files_each_time_with_their_checksums(self):
        other = self.out.parent / "other"
        for out in (self.out, other):
            done = self.call("--only", CHEAP, out=out)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout, f"{out}\n")
            others = [name for name in files.PARTS if name not in CHEAP.split(",")]
            self.assertIn(f"Without {', '.join(others)}.", done.stderr)
        names = {path.name for path in self.out.iterdir()}
        self.assertEqual(names, {path.name for path in other.iterdir()})
        for name in names:
            self.assertEqual((self.out / name).read_bytes(), (other / name).read_bytes(), name)
        with zipfile.ZipFile(next(self.out.glob("*-vectors.zip"))) as packed:
            self.assertEqual(packed.namelist(), ["vectors/hash.word.json", "vectors/index.json"])
            self.assertEqual(packed.read("vectors/index.json"), (vectors_folder() / "index.json").read_bytes())
        with tarfile.open(next(self.out.glob("*-source.tar.gz"))) as packed:
            top = f"hashnoise-{version()}"
            self.assertLess({f"{top}/vectors/index.json", f"{top}/vectors/hash.word.json", f"{top}/LICENSE"},
                            {*packed.getnames()})
        listed = json.loads((self.out / f"hashnoise-{version()}.cdx.json").read_text())["components"]
        self.assertEqual({one["name"] for one in listed},
                         names - {"SHA256SUMS", f"hashnoise-{version()}.cdx.json"})
        checked = ["sha256sum", "--check", "--quiet", "SHA256SUMS"]
        self.assertEqual(subprocess.run(checked, cwd=self.out, check=False).returncode, 0)
        self.assertEqual(len((self.out / "SHA256SUMS").read_text().splitlines()), len(names) - 1)
        with (self.out / "hashnoise.glsl").open("a") as made:
            made.write("\n")
        self.assertNotEqual(subprocess.run(checked, cwd=self.out, capture_output=True, check=False).returncode, 0)
        self.assertEqual((self.out / "NOTES.md").read_text(), f"# hashnoise {version()}\n\n- It is there.\n")

    def test_parts_that_stand_alone(self):
        self.assertEqual(self.call("--only", "parts").returncode, 0)
        archive, = self.out.glob("*.zip")
        with zipfile.ZipFile(archive) as packed:
            names = set(packed.namelist())
            part = packed.read("glsl/cellular2d.glsl").decode("ascii")
        for language in ("glsl", "hlsl", "metal"):
            self.assertLess({f"{language}/{name}.{language}" for name in ("fbm2d", "perlin3d", "hash")}, names)
        self.assertNotIn("hn_fbm", part)
        shader = self.out / "shader.frag"
        shader.write_text(f"#version 330\n{part}\nout vec4 o;\nvoid main() {{ o = hn_cellular(vec2(1.5)).xyxy; }}\n")
        done = subprocess.run(["glslangValidator", shader], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_headers_that_compile_where_they_are_put(self):
        self.assertEqual(self.call("--only", "headers").returncode, 0)
        archive, = self.out.glob("*.zip")
        with zipfile.ZipFile(archive) as packed:
            packed.extractall(self.out)
        here = self.out / f"hashnoise-{version()}"
        source = self.out / "game.cpp"
        source.write_text("#include <hashnoise/hashnoise.hpp>\n#include <hashnoise/grid.hpp>\n"
                          "float height(float x) { return hashnoise::hn_perlin(x, 7u); }\n")
        done = subprocess.run(["g++", "-std=c++20", "-fsyntax-only", "-I", here / "include", source],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((here / "share" / "cmake" / "hashnoise" / "hashnoise-config.cmake").is_file())
        self.assertTrue((here / "LICENSE").is_file())
        self.assertTrue((here / "share" / "hashnoise" / "vectors" / "index.json").is_file())
        self.assertFalse((here / "include" / "hashnoise" / "field.hpp").exists())  # of a library that is not there

    @unittest.skipIf(is_deleted("npm"), "npm was deleted")
    def test_a_tool_that_fails_or_makes_another_version_is_noticed(self):
        script = self.root / "tools" / "lib" / "ship" / "npm" / "pack.sh"
        for command, said in (("touch $1/hashnoise-9.9.9.tgz", "npm was made, but has another name"),
                              ("exit 4", "npm .* ended with status 4")):
            with self.subTest(command=command):
                script.write_text(f"{command}\n")
                self.refused(1, said, "--trial", "--only", "npm")

    @unittest.skipIf(is_deleted("python"), "python was deleted")
    def test_the_wheels_of_other_machines(self):
        """The release has them with their checksums. Wheels of another version are refused, and a folder without any."""
        wheels, name = self.out.parent.parent / "wheels", f"hashnoise-{version()}-cp312-abi3-win_amd64.whl"
        wheels.mkdir()
        self.refused(2, "wheels has 0 wheels; it takes a folder of wheels named hashnoise-", "--wheels", wheels)
        (wheels / name).write_bytes(b"wheel")
        self.refused(2, "and the part python", "--wheels", wheels, "--only", "single")
        (self.root / "tools/lib/ship/python/wheel.sh").write_text(f"touch $1/hashnoise-{version()}.tar.gz\n")
        self.assertEqual(self.call("--trial", "--only", "python", "--wheels", wheels).returncode, 0)
        sums = (self.out / "SHA256SUMS").read_text()
        self.assertIn(f"{hashlib.sha256(b'wheel').hexdigest()}  {name}\n", sums)
        self.assertIn(f"  hashnoise-{version()}.tar.gz\n", sums)
        shutil.rmtree(self.out.parent)
        (wheels / "hashnoise-0.0.1-cp312-abi3-win_amd64.whl").touch()
        self.refused(2, "wheels has hashnoise-0.0.1-cp312-abi3-win_amd64.whl;", "--wheels", wheels)


class Refuses(Project):
    def test_a_tree_that_is_not_what_is_committed(self):
        (self.root / "glsl" / "mine.glsl").write_text("// not in any commit\n")
        self.refused(1, r"--trial makes one all the same\nglsl/mine\.glsl: it is not as it is committed\n\Z",
                     "--only", "single")
        done = self.call("--trial", "--only", "single")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("This is a trial", done.stderr)

    def test_files_that_disagree(self):
        """A new number in config.glsl alone, no day, a record of another text, and no address."""
        self.change(self.root / "glsl/hashnoise/config.glsl", lambda text: re.sub(
            r"(HN_VERSION_M\w+) \d+", r"\1 77", text))
        self.change(self.root / "conformance/web/address.js", lambda text: text.replace(PLACE, ""))
        self.change(self.root / "CHANGELOG.md", lambda text: text.replace("2026-11-22", "2026-13-99"))
        record = self.root / "docs/measured/results/gcc.csv"
        record.parent.mkdir(parents=True)
        record.write_text("# date: 2026-11-22\n# by: a chip\n# hashnoise: 0.1.0\nnoise,text\nperlin2,01234567\n")
        self.git(self.root, "add", ".")
        self.git(self.root, "commit", "-qam", "Begin the next version")
        patch = version().split(".")[2]
        new = f"77.77.{patch}"
        said = [f'CHANGELOG.md: the first heading is "## {version()} (2026-13-99)", and must be "## {new} (DAY)"',
                *["results/gcc.csv: all rows are of another text; tools/measure cpu measures them"] * (
                    not is_deleted("measuring")),
                "conformance/web/address.js: it has no address, and must have the project's; write it there",
                f"CITATION.cff: repository-code: {PLACE} license: must be license:; ",
                *[f'vcpkg.json: "version": "{version()}" must be "version": "{new}"; tools/make catalog writes it'] * (
                    not is_deleted("vcpkg")),
                "must be #define HN_I_NAMESPACE v77_77; tools/make catalog writes it"]
        self.refused(1, "(?s)" + "".join(f"(?=.*{re.escape(one)})" for one in said), "--only", "single")

    def test_what_is_a_day(self):
        words = ("2026-11-22", "2026-13-99", "20261122", "not released")
        self.assertEqual([day for day in words if files.is_day(day)], ["2026-11-22"])

    def test_a_version_that_the_changelog_does_not_have(self):
        with self.assertRaisesRegex(files.NoRelease, "has no part on 7.0.0"):
            files.notes("## 0.7.0 (2026-01-01)\n\n- Something.\n", "7.0.0")

    def test_a_folder_that_exists(self):
        self.out.mkdir(parents=True)
        done = self.call("--trial", "--only", "single")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("exists; name another folder", done.stderr)

    def test_a_folder_that_cannot_be_made(self):
        self.out = self.root / "LICENSE" / "release"
        done = self.call("--trial", "--only", "single")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn(f"the folder {self.out} cannot be made", done.stderr)

    def test_a_tree_without_git(self):
        shutil.rmtree(self.root / ".git")
        self.refused(1, "is no git repository", "--only", "single")

    def test_parts_that_there_are_not(self):
        self.refused(2, "there is no part ruby; there are check, single, parts, vectors", "--only", "ruby")
        self.refused(2, "no part is left", "--without", ",".join(files.PARTS))
        self.refused(2, "not allowed with", "--only", "single", "--without", "npm")

    def test_the_help_names_each_part(self):
        printed = subprocess.run([TOOLS / "pack", "release", "--help"], capture_output=True, text=True, check=True).stdout
        named = re.search(r"PARTS are names with commas between: ([^.]*)\.", printed)[1]
        self.assertEqual(tuple(re.split(r",\s+", named)), files.PARTS)

    def test_a_tag_of_another_version(self):
        self.refused(2, f"the version is {version()}, so its tag is v{version()} and not v9.9.9", "--tag", "v9.9.9")
        self.refused(2, "there is no part ruby", "--tag", f"v{version()}", "--only", "ruby")

    def test_a_page_without_the_program_that_makes_it(self):
        self.assertEqual(files.PARTS[0], "check", "it is refused before what takes minutes")
        with mock.patch.object(files, "HN_CONFORM", ROOT / "build" / "nowhere" / "hn-conform"), \
                self.assertRaisesRegex(files.NoRelease, "there is no build/nowhere/hn-conform.*tools/conform builds it"):
            files.Release.check(mock.Mock(folder=self.out))


class Addresses(unittest.TestCase):
    def test_each_file_has_that_of_the_project(self):
        """It changes when the project gets a public place: then each file that has another is named here."""
        self.assertEqual(other_addresses(ROOT), [])
        root = Path(self.enterContext(tempfile.TemporaryDirectory()))
        other = f"{PLACE}/hashnoise"
        for name in ("page.md", "page_test.py"):
            (root / name).write_text(f"{other}.git {address()} {other}_wgsl https://pypi.org/project/hashnoise me@example.com")
        self.assertEqual(other_addresses(root), [
            f"{name}: {one} must be {address() or 'no link'}, as of conformance/web/address.js"
            for name, one in (("page.md", other), ("page.md", "example.com"), ("page_test.py", other))])


class Version(unittest.TestCase):
    def test_it_is_the_one_of_cmake_and_of_the_changelog(self):
        self.assertEqual(files.newest((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))[0], version())
