"""Commands that make a package refuse what is no folder."""

from __future__ import annotations

import contextlib
import importlib
import io
import unittest

COMMANDS = ("blender", "glsl_noise", "isf", "materialx", "unity", "unreal")


class Usage(unittest.TestCase):
    def test_a_file_is_no_folder(self) -> None:
        for name in COMMANDS:
            command = importlib.import_module(f"ship.{name}.command")
            with self.subTest(name), contextlib.redirect_stderr(io.StringIO()) as error:
                with self.assertRaises(SystemExit) as ended:
                    command.main([__file__])
                self.assertEqual(ended.exception.code, 2)
                self.assertIn("is a file; it must be a folder", error.getvalue())
