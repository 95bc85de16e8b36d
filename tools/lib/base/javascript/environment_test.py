"""The folder of packages: what makes a test skipped, and what does not."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.javascript import environment


def made_by(status: int, said: str) -> int:
    """make's result if npm ends like this."""
    done = mock.Mock(returncode=status, stdout=said, stderr="")
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()), \
            mock.patch.object(environment.subprocess, "run", return_value=done):
        return environment.make(Path(folder) / "packages")


class Environment(unittest.TestCase):
    def test_without_a_network_tests_are_skipped(self):
        self.assertEqual(made_by(1, "npm error code ENOTFOUND"), environment.SKIPPED)

    def test_another_failure_is_one(self):
        self.assertEqual(made_by(1, "npm error code EINTEGRITY"), 1)

    def test_what_is_there_is_not_made_again(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "packages"
            with mock.patch.object(environment.subprocess, "run", return_value=mock.Mock(returncode=0)) as run:
                self.assertEqual([environment.make(path), environment.make(path)], [0, 0])
                self.assertEqual(run.call_count, 1)
                (path / environment.MADE).write_text("of another list", encoding="utf-8")
                environment.make(path)
                self.assertEqual(run.call_count, 2)

    def test_without_packages_nothing_is_run(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
            self.assertEqual(environment.run(Path(folder), ["node", "--version"]), environment.SKIPPED)
        self.assertIn("javascript.packages", said.getvalue())

    def test_other_arguments_are_bad_usage(self):
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(environment.main(["make"]), 2)
