"""Messages of the tests where there is no Godot, or another one."""

from __future__ import annotations

import os
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from engine import WRONG, find

from base.debian import Missing


class Find(unittest.TestCase):
    def with_program(self, command: str) -> tuple[str, str]:
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "godot"
            program.write_text(f"#!/bin/sh\n{command}\n")
            program.chmod(0o755)
            with mock.patch.dict(os.environ, {"HN_GODOT": str(program)}):
                return find()

    def test_versions(self):
        self.assertEqual(self.with_program("echo 4.6.3.stable")[1], "4.6.3.stable")
        self.assertEqual(self.with_program("echo 4.10.stable")[1], "4.10.stable")
        for command, said in (("echo 4.3.stable", "is Godot 4.3.stable; the add-on is for 4.4 and later"),
                              ("echo 3.5.2.stable", "for 4.4 and later"), ("echo what", "prints no version, but 'what'")):
            with self.subTest(command=command), self.assertRaisesRegex(Missing, said):
                self.with_program(command)

    def test_absent(self):
        with mock.patch.dict(os.environ, {"HN_GODOT": "/no/such/godot"}), self.assertRaisesRegex(Missing, "cannot be run"):
            find()
        with mock.patch.dict(os.environ, {"PATH": "/no/such"}):
            os.environ.pop("HN_GODOT", None)
            with self.assertRaisesRegex(Missing, "no godot in the PATH, HN_GODOT names none, and there is no apt-get"), \
                    mock.patch("base.debian.find", return_value=None):
                find()

    def test_what_is_an_error_of_godot(self):
        for line in ("SHADER ERROR: Expected a ';'.", "ERROR: Shader compilation failed.", "SCRIPT ERROR: Parse Error"):
            self.assertTrue(WRONG.search(f"Godot Engine\n{line}\n   at: set_code"), line)
        self.assertFalse(WRONG.search("WARNING: Could not set V-Sync mode.\n     at: set_use_vsync"))
