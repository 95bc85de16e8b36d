"""The library on processors that lack instructions: python3 processors_test.py DIGESTS

DIGESTS is run by qemu as each of them. It takes the instructions that they have, and prints the same as here. Without
qemu, and where DIGESTS is not for x86-64, it is skipped (status 77).
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import unittest

QEMU = "qemu-x86_64"
DIGESTS = sys.argv[1]
PROCESSORS = {"core2duo": "sse2", "Nehalem": "sse4.1", "Haswell": "avx2"}


def run(*command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, text=True, check=False)


class Processors(unittest.TestCase):
    def test_older_ones_compute_the_same(self):
        native = run(DIGESTS)
        self.assertEqual(native.returncode, 0, native.stderr)
        for processor, widest in PROCESSORS.items():
            for arguments in ((), (widest,)):
                with self.subTest(processor=processor, arguments=arguments):
                    done = run(QEMU, "-cpu", processor, DIGESTS, *arguments)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual(done.stdout, native.stdout)

    def test_instructions_that_a_processor_lacks_are_refused(self):
        done = run(QEMU, "-cpu", "core2duo", DIGESTS, "avx2")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("avx2", done.stderr)


if __name__ == "__main__":
    if shutil.which(QEMU) is None or os.uname().machine != "x86_64":
        print(f"skipped: there is no {QEMU}, or this is not x86-64")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
