"""What compilers say of the headers where a user goes wrong: python3 header_test.py COMPILER..."""

from __future__ import annotations

import subprocess
import sys
import unittest
from pathlib import Path

INCLUDE = Path(__file__).resolve().parent.parent.parent / "include"
COMPILERS = sys.argv[1:]
HEADERS = ("hashnoise.hpp", "glsl.hpp")
ARITHMETICS = ("HN_FAST", "HN_PRECISE", "HN_FIXED")
NOISES = "#define HN_FBM_NOISE2D(q, seed) hn_value(q, seed)\n#define HN_FBM_NOISE3D(q, seed) hn_value(q, seed)\n"


def including(header: str) -> str:
    return f"#include <hashnoise/{header}>\n"


def says(compiler: str, text: str, *options: str) -> str:
    """What a compiler says of the text; nothing if it takes it without a warning."""
    command = [compiler, "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-I", str(INCLUDE), *options, "-x", "c++", "-"]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=False).stderr


class Headers(unittest.TestCase):
    def test_an_older_language_is_refused_by_its_name(self) -> None:
        for compiler in COMPILERS:
            for header in HEADERS:
                with self.subTest(compiler=compiler, header=header):
                    errors = [line for line in says(compiler, including(header), "-std=c++17").splitlines()
                              if "error:" in line]
                    self.assertIn("hashnoise needs C++20: compile with -std=c++20", errors[0])
                    self.assertEqual(says(compiler, including(header), "-std=c++20"), "")

    def test_the_version_that_msvc_tells_counts(self) -> None:
        for version, refused in (("201703L", True), ("202002L", False)):
            said = says(COMPILERS[0], including("glsl.hpp"), "-std=c++17", f"-D_MSVC_LANG={version}")
            self.assertEqual("hashnoise needs C++20" in said, refused, version)

    def test_a_noise_that_is_defined_after_the_include_is_noticed(self) -> None:
        for compiler in COMPILERS:
            for arithmetic in ARITHMETICS:
                with self.subTest(compiler=compiler, arithmetic=arithmetic):
                    setting = ("-std=c++20", f"-DHN_ARITHMETIC={arithmetic}")
                    late = says(compiler, including("hashnoise.hpp") + NOISES, *setting)
                    for name in ("HN_FBM_NOISE2D", "HN_FBM_NOISE3D"):
                        self.assertRegex(late, rf"error: .*{name}.* redefined")
                    # The same definition once more is no other one.
                    self.assertEqual(says(compiler, NOISES + including("hashnoise.hpp") + NOISES, *setting), "")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
