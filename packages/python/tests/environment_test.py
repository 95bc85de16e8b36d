"""Tests of where the tests run: they are skipped where PyPI cannot be reached, and only there."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import environment

from base.testing import called


class Environment(unittest.TestCase):
    made = Path(os.environ["HASHNOISE_ENVIRONMENT"], "venv")  # since it takes long to make another one

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = Path(scratch.name)
        self.folder = self.scratch / "environment"
        self.requirements = self.scratch / "requirements.txt"

    def make(self, requirements: str) -> tuple[int, str]:
        self.requirements.write_text(requirements, encoding="utf-8")
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed), mock.patch("venv.create") as create:
            create.side_effect = lambda folder, **_: folder.symlink_to(self.made)
            return environment.make(self.folder, self.requirements), printed.getvalue()

    def test_no_registry(self):
        """Nothing listens at this address."""
        nowhere = {"PIP_INDEX_URL": "http://127.0.0.1:9/simple", "PIP_CONFIG_FILE": os.devnull,
                   "PIP_EXTRA_INDEX_URL": "", "PIP_NO_INDEX": "", "PIP_FIND_LINKS": ""}
        with mock.patch.dict(os.environ, nowhere):
            status, printed = self.make("no-such-package==1.0\n")
        self.assertEqual(status, environment.SKIPPED, printed)
        self.assertIn("PyPI cannot be reached", printed)
        status, printed = called(environment.main, "run", self.folder, "golden_test")
        self.assertEqual(status, environment.SKIPPED)
        self.assertIn("python.wheel was skipped", printed)

    def test_what_cannot_be_installed_is_no_reason_to_skip(self):
        with mock.patch.dict(os.environ, {"PIP_NO_INDEX": "1"}):
            status, printed = self.make("numpy==0.0.0\n")
        self.assertEqual(status, 1, printed)

    def test_what_is_added_is_installed_once(self):
        added, python = self.scratch / "added", Path("python3")
        installed = []

        def install(python: Path, requirements: Path, folder: Path) -> int:
            installed.append(requirements.read_text(encoding="utf-8"))
            folder.mkdir()
            return 1 if "no-such" in installed[-1] else 0

        with mock.patch("environment.install", install):
            for text, status in (("one", 0), ("one", 0), ("two", 0), ("no-such", 1), ("no-such", 1), ("one", 0)):
                self.requirements.write_text(text, encoding="utf-8")
                self.assertEqual(environment.add(python, self.requirements, added), status)
        self.assertEqual(installed, ["one", "two", "no-such", "no-such", "one"])

    def test_tests_and_programs(self):
        (self.folder / "venv" / "bin").mkdir(parents=True)
        (self.folder / "made").touch()
        with mock.patch("subprocess.run") as started:
            started.return_value.returncode = 3
            for arguments, program in (
                    (["run", str(self.folder), "a_test", "b_test"], ["unittest", "-v", "a_test", "b_test"]),
                    (["call", str(self.folder), "notebook", "-x"], ["notebook", "-x"])):
                self.assertEqual(called(environment.main, *arguments)[0], 3)
                self.assertEqual(started.call_args.args[0][1:], ["-B", "-m", *program])

    def test_bad_usage(self):
        for arguments in ([], ["make"], ["run", "x"], ["call", "x"], ["call", "--with", "x", "y"],
                          ["run", "--with", "x", "y"], ["no_such", "x", "y"]):
            self.assertEqual(called(environment.main, *arguments)[0], 2, arguments)
