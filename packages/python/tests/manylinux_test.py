"""A wheel for other machines, which tools/pack python names by the oldest glibc that it runs with, and checks."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import golden

NAME = re.compile(r"hashnoise-[\d.]+-(cp\d+-(?:cp\d+|abi3))-(manylinux_2_\d+_\w+)\.whl")


def tags(wheel: Path) -> list[str]:
    """The wheel's metadata."""
    with zipfile.ZipFile(wheel) as archive:
        name, = (name for name in archive.namelist() if name.endswith(".dist-info/WHEEL"))
        return re.findall(r"(?m)^Tag: (\S+)$", archive.read(name).decode())


class Manylinux(unittest.TestCase):
    def test_a_wheel(self):
        """Linked with the library that the build has, as that of python.wheel is."""
        scratch = self.enterContext(tempfile.TemporaryDirectory())
        done = subprocess.run([golden.ROOT / "tools" / "pack", "python", "--python", sys.executable, "--manylinux",
                               "--library", os.environ["HASHNOISE_LIBRARY"], scratch],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        wheel = Path(done.stdout.splitlines()[-1])
        python, platform = NAME.fullmatch(wheel.name).groups()
        self.assertIn("abi3" if sys.version_info >= (3, 12) else f"cp3{sys.version_info.minor}", python)
        self.assertIn(f"{python}-{platform}", tags(wheel))

    def test_a_name_for_this_machine_alone_is_noticed(self):
        self.assertIsNone(NAME.fullmatch("hashnoise-0.4.0-cp312-abi3-linux_x86_64.whl"))
        self.assertIsNotNone(NAME.fullmatch("hashnoise-0.4.0-cp312-abi3-manylinux_2_34_x86_64.whl"))
