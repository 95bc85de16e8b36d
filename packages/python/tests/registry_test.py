"""PyPI would take the wheel and the source distribution, by the command of docs/develop/publishing.md: twine reads their
metadata, as PyPI does. cibuildwheel takes the settings of pyproject.toml, and makes by them, on the machines of the workflow
`release`, a wheel for each Python."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import golden
import source_test

PAGE = (golden.ROOT / "docs" / "develop" / "publishing.md").read_text(encoding="utf-8")
WORKFLOW = (golden.ROOT / ".github" / "workflows" / "release.yml").read_text(encoding="utf-8")
WHEELS = Path(sys.prefix).parent / "wheels"  # beside the environment


class Registry(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "dist").mkdir()
        self.wheel, = WHEELS.glob("*.whl")

    def checked(self) -> subprocess.CompletedProcess[str]:
        program, *words = re.search(r"^\| PyPI \| `(twine check [^`]*)`", PAGE, re.MULTILINE)[1].split()
        files = [name for word in words for name in (map(str, self.folder.glob(word)) if "*" in word else [word])]
        self.assertTrue(files[-1].endswith((".whl", ".tar.gz")))
        return subprocess.run([sys.executable, "-m", program, *files], capture_output=True, text=True, check=False)

    def test_it_is_taken(self) -> None:
        shutil.copy(self.wheel, self.folder / "dist")
        source_test.built(golden.ROOT, str(self.folder / "dist"))
        done = self.checked()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(done.stdout.count("PASSED"), 2)

    def test_one_without_a_description_or_a_name_is_refused(self) -> None:
        for before, after in ((r"(?s)\n\n.*", "\n\n"), ("(?m)^Name: .*\n", "")):
            copy = self.folder / "dist" / self.wheel.name
            with zipfile.ZipFile(self.wheel) as right, zipfile.ZipFile(copy, "w") as wrong:
                for name in right.namelist():
                    data = right.read(name)
                    if name.endswith(".dist-info/METADATA"):
                        changed = re.sub(before, after, data.decode("utf-8"))
                        self.assertNotEqual(changed.encode("utf-8"), data)
                        data = changed.encode("utf-8")
                    wrong.writestr(name, data)
            with self.subTest(before):
                self.assertNotEqual(self.checked().returncode, 0)


class Wheels(unittest.TestCase):
    """For which machines and Pythons there is a wheel: without Docker cibuildwheel still lists them."""

    # By the machines of the workflow: the platform, its name of the processor, and the wheels.
    MACHINES = {"ubuntu-latest": ("linux", "x86_64", {"manylinux_x86_64", "musllinux_x86_64"}),
                "ubuntu-24.04-arm": ("linux", "aarch64", {"manylinux_aarch64", "musllinux_aarch64"}),
                "macos-latest": ("macos", "arm64", {"macosx_arm64"}),
                "macos-15-intel": ("macos", "x86_64", {"macosx_x86_64"}),
                "windows-latest": ("windows", "AMD64", {"win_amd64"})}

    def listed(self, settings: Path, platform: str, processor: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, "-m", "cibuildwheel", "--platform", platform, "--archs", processor,
                               "--config-file", settings, "--print-build-identifiers", golden.ROOT],
                              capture_output=True, text=True, check=False)

    def faults(self, settings: Path) -> list[str]:
        """Wheels that are missing, and wheels of Pythons without a global lock."""
        found = []
        for platform, processor, wanted in self.MACHINES.values():
            done = self.listed(settings, platform, processor)
            if done.returncode != 0:
                return done.stderr.splitlines()[:1]
            names = set(done.stdout.split())
            found += sorted({f"cp3{minor}-{wheel}" for minor in range(10, 15) for wheel in wanted} - names)
            found += [name for name in names if name.partition("-")[2] not in wanted or "t-" in name]
        return found

    def test_each_machine_has_its_wheels(self) -> None:
        self.assertEqual(self.faults(golden.ROOT / "pyproject.toml"), [])
        machines = re.search(r"^ +machine: \[(.*, .*-latest)\]$", WORKFLOW, re.MULTILINE)[1]
        self.assertEqual(set(machines.split(", ")), set(self.MACHINES))
        version, = re.findall(r"^cibuildwheel==.*", (source_test.TESTS / "registry.txt").read_text(), re.MULTILINE)
        self.assertIn(f"pip install {version}\n", WORKFLOW)

    def test_settings_with_a_fault_are_noticed(self) -> None:
        text = (golden.ROOT / "pyproject.toml").read_text(encoding="utf-8")
        settings = Path(self.enterContext(tempfile.TemporaryDirectory())) / "settings.toml"
        for before, after, said in (('"cp3??t-*"', '"cp311-*"', "cp311-manylinux_x86_64"), ('"cp3??t-*"', '""', "cp314t-"),
                                    ("test-command", "test-comand", "test-comand")):
            settings.write_text(text.replace(before, after), encoding="utf-8")
            with self.subTest(after):
                self.assertIn(said, "\n".join(self.faults(settings)))
