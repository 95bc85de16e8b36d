"""The library on processors that lack instructions: python3 processors_test.py DIGESTS SET...

qemu runs DIGESTS as each of them; it was compiled for these instruction sets. It takes the instructions that a
processor
has, and prints the same as here. On a processor that has none of them it reports that. Without qemu, and where DIGESTS
is not for x86-64, the test is skipped (status 77)."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import unittest

QEMU = "qemu-x86_64"
DIGESTS, *COMPILED = sys.argv[1:]
# The sets of each processor, the widest first.
PROCESSORS = {"core2duo": [], "Nehalem": ["sse4.1"], "Haswell": ["avx2", "sse4.1"]}


def run(*command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, text=True, check=False)


class Processors(unittest.TestCase):
    def test_the_widest_that_both_have_computes_the_same(self):
        native = run(DIGESTS)
        self.assertEqual(native.returncode, 0, native.stderr)
        compared = 0
        for processor, sets in PROCESSORS.items():
            expected = [name for name in sets if name in COMPILED]
            with self.subTest(processor=processor):
                listed = run(QEMU, "-cpu", processor, DIGESTS, "--list")
                self.assertEqual((listed.returncode, listed.stdout.split()), (0, expected), listed.stderr)
            # The widest by default, which is the one set of a processor in most builds; the others by their names.
            for arguments in [()] * bool(expected) + [(name,) for name in expected[1:]]:
                with self.subTest(processor=processor, arguments=arguments):
                    done = run(QEMU, "-cpu", processor, DIGESTS, *arguments)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual(done.stdout, native.stdout)
                    compared += 1
        self.assertGreater(compared, 0, f"none of {COMPILED} was run")

    def test_a_processor_without_any_of_the_sets_is_told_so(self):
        done = run(QEMU, "-cpu", "core2duo", DIGESTS)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertIn("this processor lacks the instructions that hashnoise::grid was compiled for", done.stderr)
        for name in COMPILED:
            self.assertIn(name, done.stderr)

    def test_instructions_that_a_processor_lacks_are_refused(self):
        done = run(QEMU, "-cpu", "Nehalem", DIGESTS, "avx2")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("avx2", done.stderr)


if __name__ == "__main__":
    if shutil.which(QEMU) is None or os.uname().machine != "x86_64":
        print(f"skipped: there is no {QEMU}, or this is not x86-64")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
