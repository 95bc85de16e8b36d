"""The bill of materials of a release: its content, and that it is CycloneDX by the schema of that format.

    sbom_test.py FOLDER     with the checker, cyclonedx-python-lib of requirements.txt, which is installed into FOLDER

Without FOLDER, as a module of unittest, it tests all but the schema. Exit status: as of the tests; 77 PyPI cannot be
reached.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from base.pieces import is_deleted
from base.pypi import environment
from base.tree import ROOT
from ship.release import sbom

FILES = {"hashnoise.glsl": b"// text\n", "hashnoise-1.2.3.tgz": b"npm", "NOTES.md": b"# Notes\n",
         "hashnoise-1.2.3-cp312-abi3-linux_x86_64.whl": b"wheel", "hashnoise_wgsl-1.2.3.zip": b"crate",
         "hashnoise-1.2.3.tar.gz": b"sdist", "hashnoise-1.2.3-source.tar.gz": b"all",
         "hashnoise-rust-1.2.3.zip": b"crate"}
REQUIREMENTS = Path(__file__).with_name("requirements.txt")
# The schema of the version that the file names is in the package.
CHECKER = """
import json, sys
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator
validator = JsonStrictValidator(SchemaVersion.V1_6)
json.dump([str(validator.validate_str(text) or "") for text in json.load(sys.stdin)], sys.stdout)
"""


def made(files: dict[str, bytes] | None = None, seconds: int = 1_700_000_000) -> dict:
    return sbom.bom("1.2.3", seconds, FILES if files is None else files, sbom.of_others())


@unittest.skipIf(any(map(is_deleted, ("npm", "python", "rust", "wesl"))), "a package that needs something was deleted")
class Contents(unittest.TestCase):
    def test_each_file_has_its_checksum(self) -> None:
        said = {one["name"]: one for one in made()["components"] if one["type"] == "file"}
        self.assertEqual(set(said), set(FILES))
        for name, data in FILES.items():
            self.assertEqual(said[name]["hashes"], [{"alg": "SHA-256", "content": hashlib.sha256(data).hexdigest()}])
        self.assertEqual(said["hashnoise-1.2.3.tgz"]["purl"], "pkg:npm/hashnoise@1.2.3")
        self.assertEqual(made()["metadata"]["timestamp"], "2023-11-14T22:13:20Z")

    def test_the_license_of_the_wheel_has_those_of_what_is_compiled_in(self) -> None:
        said = {one["name"]: one["licenses"] for one in made()["components"]}
        for name in FILES:
            wanted = {"expression": "MIT AND BSD-3-Clause"} if name.endswith(".whl") else {"license": {"id": "MIT"}}
            self.assertEqual(said[name], [wanted], name)
        inside = [one for one in made()["components"] if "is compiled into the wheel" in one.get("description", "")]
        self.assertEqual({one["name"]: one["licenses"] for one in inside},
                         {"nanobind": [{"license": {"id": "BSD-3-Clause"}}],
                          "tessil/robin-map": [{"license": {"id": "MIT"}}]})

    def test_it_names_what_packages_need(self) -> None:
        needs = {one["ref"]: one.get("dependsOn", []) for one in made()["dependencies"]}
        wheel, = [name for name in FILES if name.endswith(".whl")]
        names = [reference.partition("@")[0] for reference in needs[wheel]]
        self.assertEqual(names, ["pkg:github/tessil/robin-map", "pkg:pypi/nanobind", "pkg:pypi/numpy"])
        self.assertEqual((needs["hashnoise-1.2.3.tar.gz"], needs["hashnoise-1.2.3-source.tar.gz"]), (needs[wheel], []))
        self.assertEqual(needs["hashnoise-1.2.3.tgz"], ["pkg:npm/three"])
        self.assertEqual(needs["hashnoise_wgsl-1.2.3.zip"], ["pkg:cargo/wesl-core"])
        self.assertEqual(needs["hashnoise-rust-1.2.3.zip"], [])
        self.assertEqual((needs["hashnoise.glsl"], needs["hashnoise"]), ([], sorted(FILES)))
        self.assertEqual(len(made({"hashnoise.glsl": b""})["components"]), 1)

    def test_other_files_have_another_number(self) -> None:
        numbers = {made(files)["serialNumber"] for files in (None, FILES, {**FILES, "NOTES.md": b"# Others\n"})}
        self.assertEqual(len(numbers), 2)

    def test_what_is_needed_and_unknown_is_told(self) -> None:
        with tempfile.TemporaryDirectory() as scratch:
            root = Path(scratch)
            for name in ("packages/npm/package.json", "packages/wesl/Cargo.toml"):
                (root / name).parent.mkdir(parents=True)
                shutil.copy(ROOT / name, root / name)
            text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
            for before, after in (('"nanobind==', '"pybind11==3.0", "nanobind=='), ('["numpy>=1.23"]', '["pandas"]')):
                self.assertIn(before, text)
                (root / "pyproject.toml").write_text(text.replace(before, after), encoding="utf-8")
                with self.assertRaisesRegex(sbom.Unknown, "the license of (pybind11|pandas), which is needed now, is"):
                    sbom.of_others(root)

    def test_no_other_package_needs_anything(self) -> None:
        manifest = (ROOT / "packages" / "rust" / "Cargo.toml").read_text(encoding="utf-8")
        self.assertRegex(manifest, r"\[dependencies\]\s*\Z")


class Schema(unittest.TestCase):
    python: Path | None = None

    def setUp(self) -> None:
        if self.python is None:
            self.skipTest("the test release.sbom has the checker")

    def test_it_is_what_the_schema_wants_and_what_is_not_is_noticed(self) -> None:
        changes = ({}, {"serialNumber": "7"}, {"components": [{"type": "filed", "name": "x"}]}, {"bill": 1},
                   {"metadata": {"timestamp": "today"}})
        # In one process, which takes seconds to read the schema.
        said = json.dumps([sbom.text(made() | change) for change in changes])
        done = subprocess.run([self.python, "-c", CHECKER], input=said, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        right, *wrong = json.loads(done.stdout)
        self.assertEqual(right, "")
        for change, refusal in zip(changes[1:], wrong, strict=True):
            with self.subTest(change):
                self.assertNotEqual(refusal, "")


if __name__ == "__main__":
    folder = Path(sys.argv.pop(1)).resolve()
    if status := environment(folder, REQUIREMENTS):
        sys.exit(status)
    Schema.python = folder / "bin" / "python"
    unittest.main()
