"""The source distribution has the build's inputs, and not the rest of the repository. The wheel has the licenses of
the parts compiled into it, which the source distribution does not have. Both have the page that PyPI shows."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zlib
from email import message_from_string
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from unittest import mock

import golden

from base.tree import VECTORS
from ship.packing_support import lost_links
from ship.python import metadata

TESTS = Path(__file__).resolve().parent
BUILD = "import scikit_build_core.build, sys; print(scikit_build_core.build.build_sdist(sys.argv[1]))"
PAGE = "from ship.python.metadata import PAGE, of_package; print(of_package(PAGE), end='')"


def built(place: Path, folder: str) -> Path:
    done = subprocess.run([sys.executable, "-B", "-c", BUILD, folder], cwd=place, capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return Path(folder) / done.stdout.splitlines()[-1]


class Source(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.archive = built(golden.ROOT, scratch.name)
        with tarfile.open(cls.archive) as archive:
            archive.extractall(scratch.name)
        cls.root = Path(scratch.name) / cls.archive.name.removesuffix(".tar.gz")

    def missing_headers(self) -> str:
        """Files that the preprocessor misses, of those that the sources include."""
        compiler = shutil.which("c++") or self.skipTest("there is no compiler c++")
        said = ""
        for source in sorted((self.root / "src" / "grid").glob("*.cpp")):
            done = subprocess.run([compiler, "-std=c++20", f"-I{self.root / 'include'}", "-DHASHNOISE_X86",
                                   "-DHASHNOISE_TABLE=sse41_fast", "-DHN_ARITHMETIC=1", "-M", source],
                                  capture_output=True, text=True, check=False)
            said += done.stderr
        return said

    def test_what_the_build_reads(self):
        for name in ("CMakeLists.txt", "LICENSE", "pyproject.toml", "docs/guide/python.md", "src/CMakeLists.txt"):
            self.assertTrue((self.root / name).is_file(), name)
        for folder in ("glsl/hashnoise", "glsl/hashnoise/detail", "include/hashnoise", "packages/python/hashnoise",
                       "vectors", "arrays"):
            origin = VECTORS.with_name(folder) if folder in ("vectors", "arrays") else golden.ROOT / folder
            names, copied = ({path.name for path in of.iterdir() if path.is_file()}
                             for of in (origin, self.root / folder))
            self.assertEqual(copied, names)
        for path in self.root.rglob("CMakeLists.txt"):
            for name in re.findall(r"^ *include\((\S*/\S*)\)", path.read_text(encoding="utf-8"), re.M):
                self.assertTrue((path.parent / name).is_file(), (path, name))
        self.assertEqual(self.missing_headers(), "")

    def test_without_a_build_it_has_what_a_clone_makes(self):
        """The vectors and the text of hashnoise.arrays."""
        with tempfile.TemporaryDirectory() as folder:
            with tarfile.open(self.archive) as ours, tarfile.open(built(self.root, folder)) as again:
                self.assertEqual(ours.getnames(), again.getnames())
            with mock.patch.object(metadata, "VECTORS", Path(folder, "none")), mock.patch("subprocess.run") as run:
                provider = metadata.Provider()
                provider.build_state("sdist")
                provider.dynamic_metadata({}, {})
            self.assertEqual([call.args[0][1:] for call in run.call_args_list],
                             [[golden.ROOT / "tools" / "make", "vectors"], ["-B", "-m", "ship.python.arrays"]])

    def test_a_file_that_is_missing_is_noticed(self):
        path = self.root / "glsl" / "hashnoise" / "perlin2d.glsl"
        self.addCleanup(path.write_bytes, path.read_bytes())
        path.unlink()
        self.assertIn("perlin2d.glsl", self.missing_headers())

    def test_it_is_small(self):
        vectors = sum(len(zlib.compress(path.read_bytes())) for path in (self.root / "vectors").iterdir())
        self.assertLess(self.archive.stat().st_size - vectors, 1_000_000)
        self.assertFalse((self.root / "conformance" / "expected").exists())

    def test_the_version_is_that_of_the_shaders(self):
        text = (golden.ROOT / "glsl" / "hashnoise" / "config.glsl").read_text(encoding="ascii")
        numbers = re.findall(r"^#define HN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", text, re.M)
        self.assertEqual(self.root.name, f"hashnoise-{'.'.join(numbers)}")

    def test_the_backend_is_that_of_the_project(self):
        project = (golden.ROOT / "pyproject.toml").read_text(encoding="utf-8")
        pinned = re.findall(r'"(scikit-build-core==\S+)"', project)
        self.assertEqual(len(pinned), 1)
        self.assertIn(pinned[0], (TESTS / "requirements.txt").read_text(encoding="utf-8").split())

    def test_its_digest_is_that_of_the_clone_and_of_the_wheel(self):
        installed = distribution("hashnoise").locate_file("hashnoise/sources.sha256").read_text(encoding="ascii")
        self.assertEqual(metadata.digest(), installed)
        with mock.patch.object(metadata, "ROOT", self.root):
            self.assertEqual(metadata.digest(), installed)

    def test_an_object_is_kept_while_ninja_sees_what_changes(self):
        path, objects = self.root / "src" / "grid" / "plan.cpp", self.root / "build" / "python"
        with mock.patch.multiple(metadata, ROOT=self.root, DIGEST=objects.with_name("sources.sha256"), OBJECTS=objects):
            metadata.note_digest()
            for change, kept in ((lambda: None, True), (path.touch, True), (lambda: os.utime(path, (1, 1)), False)):
                objects.mkdir(exist_ok=True, parents=True)
                change()
                metadata.note_digest()
                self.assertEqual(objects.exists(), kept)

    def test_its_license_is_ours_alone(self):
        said = message_from_string((self.root / "PKG-INFO").read_text(encoding="utf-8"))
        self.assertEqual((said.get_all("License-File"), said.get_all("Dynamic")), (["LICENSE"], ["License-File"]))

    def test_a_wheel_of_it_has_the_page_that_it_has(self):
        done = subprocess.run([sys.executable, "-B", "-c", PAGE], cwd=self.root / "tools" / "lib", capture_output=True,
                              text=True, check=True)
        page = message_from_string((self.root / "PKG-INFO").read_text(encoding="utf-8")).get_payload()
        self.assertEqual(done.stdout.rstrip(), page.rstrip())
        self.assertEqual(distribution("hashnoise").metadata.get_payload().rstrip(), page.rstrip())


class Wheel(unittest.TestCase):
    """The one that is installed here."""

    def test_its_page_is_one_for_a_registry(self):
        page = distribution("hashnoise").metadata.get_payload()
        self.assertTrue(page.partition("\n\n    ")[2].startswith("pip install hashnoise\n"), page[:200])
        self.assertEqual(lost_links({"README.md": page}, ()), [])

    def test_it_has_the_licenses_of_what_is_compiled_in(self):
        wheel = distribution("hashnoise")
        self.assertEqual(wheel.metadata["License-Expression"], "MIT AND BSD-3-Clause")
        texts = {Path(name).name: wheel.read_text(f"licenses/{name}") or ""
                 for name in wheel.metadata.get_all("License-File")}
        self.assertEqual(set(texts), {"LICENSE", "nanobind.txt", "robin_map.txt"})
        self.assertEqual(texts["LICENSE"], (golden.ROOT / "LICENSE").read_text(encoding="utf-8"))
        for name, author, words in (("nanobind.txt", "Wenzel Jakob", "Redistributions in binary form must reproduce"),
                                    ("robin_map.txt", "Thibaut Goetghebuer-Planchon", "\nall copies or substantial")):
            self.assertRegex(texts[name], rf"Copyright \(c\) \d+ {author}")
            self.assertIn(words, texts[name])
            self.assertTrue(texts[name].endswith((" DAMAGE.\n", "SOFTWARE.\n")), texts[name][-80:])

    def test_one_without_them_is_not_built(self):
        for found in (mock.Mock(side_effect=PackageNotFoundError("nanobind")),
                      mock.Mock(return_value=mock.Mock(**{"read_text.return_value": None,
                                                          "locate_file.return_value": __file__}))):
            with mock.patch.object(metadata, "distribution", found), \
                    self.assertRaisesRegex(metadata.NoLicense, "nanobind"):
                metadata.Provider().dynamic_metadata({}, {})
