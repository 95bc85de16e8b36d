"""Tests of tools/measure python: with scripts in place of a Python, and with packages that cost a known time."""

from __future__ import annotations

import contextlib
import io
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

from measure import stamps
from measure.python import calls, command


class Command(unittest.TestCase):
    def call(self, script: str, *arguments: str) -> tuple[int, str, Path]:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        python = Path(folder.name) / "python"
        python.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        python.chmod(0o755)
        output = io.StringIO()
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
            try:
                status = command.main(["--python", str(python), "--out", folder.name, *arguments])
            except SystemExit as end:
                status = end.code
        return status, output.getvalue(), Path(folder.name) / "python.csv"

    def test_writes_what_the_python_prints(self):
        status, output, record = self.call('echo "Perlin 2D,hashnoise,0.4.0,1,1,0"; test "$3" = 5', "--rounds", "5")
        self.assertEqual((status, output.strip()), (0, str(record)))
        self.assertIn(f"{command.COLUMNS.strip()},text\nPerlin 2D,hashnoise,0.4.0,1,1,0,",
                      record.read_text(encoding="utf-8"))
        self.assertEqual(stamps.stale(record), [])

    def test_fails_with_the_python(self):
        status, _, record = self.call("exit 3")
        self.assertEqual((status, record.exists()), (1, False))

    def test_refuses_wrong_options(self):
        for arguments in (("--rounds", "2"), ("--rounds", "x"), ("--python", "/nowhere")):
            status, output, _ = self.call("exit 0", *arguments)
            self.assertEqual(status, 2)
            self.assertIn(arguments[0], output)


class Calls(unittest.TestCase):
    def test_are_compared_with_ours(self):
        """Of each round the quotient; what is not installed is left out."""
        clock = iter(range(1000))
        call = calls.Call("Perlin 2D", "", "", lambda module: (module.run, 1))
        ours, theirs, absent = (call._replace(package=name, module=name) for name in ("hashnoise", "theirs", "absent"))
        modules = {"hashnoise": types.SimpleNamespace(run=lambda: None),
                   "theirs": types.SimpleNamespace(run=lambda: [next(clock) for _ in range(3)])}

        def load(name: str) -> object:
            if name not in modules:
                raise ImportError(name)
            return modules[name]

        with mock.patch.object(calls, "CALLS", (ours, theirs, absent)), \
                mock.patch.object(calls.importlib, "import_module", load), \
                mock.patch.object(calls.importlib.metadata, "version", return_value="1.2"), \
                mock.patch.object(calls.time, "perf_counter", lambda: next(clock)):
            found = list(calls.rows(calls.measured(3)))
        self.assertEqual(found, [["Perlin 2D", "hashnoise", "1.2", "1e+09", "1", "0"],
                                 ["Perlin 2D", "theirs", "1.2", "4e+09", "4", "0"]])


if __name__ == "__main__":
    unittest.main()
