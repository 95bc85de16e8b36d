#!/usr/bin/env python3
"""The installed program, moved away from where it was built and installed. Usage: install_test.py CMAKE BUILD SOURCE"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CMAKE = BUILD = SOURCE = ""
ONE_CASE = "noise2d.perlin.lattice.fast.fragment.gl330.golden"
ONE_FILE = "noise2d.perlin.golden"


class Install(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.elsewhere = pathlib.Path(scratch.name, "elsewhere")
        self.elsewhere.mkdir()
        installed = pathlib.Path(scratch.name, "installed")
        subprocess.run([CMAKE, "--install", BUILD, "--component", "conformance", "--prefix", installed],
                       stdout=subprocess.DEVNULL, check=True)
        self.prefix = installed.rename(installed.with_name("moved"))
        self.program = next(self.prefix.glob("*/hn-conform"))

    def run_case(self, program):
        return subprocess.run([program, "run", "--filter", ONE_CASE], cwd=self.elsewhere, capture_output=True, text=True,
                              check=False)

    def test_it_runs_where_it_was_moved(self):
        for program in (self.program, self.elsewhere / "link"):
            if not program.exists():
                program.symlink_to(self.program)
            with self.subTest(program=program):
                done = self.run_case(program)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertIn("1 pass; ", done.stdout)

    def test_it_reads_its_own_files(self):
        golden = next(self.prefix.rglob(ONE_FILE))
        lines = golden.read_text().split("\n")
        groups = lines[7].split(" = ")
        lattice = next(i for i, setting in enumerate(lines[5].split()) if setting.startswith("lattice:"))
        groups[lattice] = f"7{groups[lattice][1:]}"
        golden.write_text("\n".join([*lines[:7], " = ".join(groups), *lines[8:]]))
        self.assertEqual(self.run_case(self.program).returncode, 1)
        golden.unlink()
        done = self.run_case(self.program)
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"cannot read {golden}", done.stdout)
        folder = next(self.prefix.rglob("expect"))
        shutil.rmtree(folder)
        done = self.run_case(self.program)
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"cannot read the folder {folder}", done.stderr)

    def test_it_does_not_know_where_its_files_came_from(self):
        program = self.program.read_bytes()
        for place in ("conformance/expected/golden", "conformance/run/expect"):
            self.assertNotIn(f"{SOURCE}/{place}".encode(), program)


if __name__ == "__main__":
    CMAKE, BUILD, SOURCE = sys.argv[1:4]
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
