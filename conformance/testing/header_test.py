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
# Sums over several noises in one file: of the library and of the user's.
SUMS = """
namespace hashnoise {
HN_FBM2D(fbm_of_simplex, hn_simplex)
HN_RIDGED2D(ridged_of_value, hn_value)
HN_WEIGHTED_PERIOD3D(weighted_of_value, hn_value)
inline float mine(ivec2 cell, vec2 f, uint seed) { return f.x - f.y + static_cast<float>((unsigned(cell.x) ^ seed) & 1u); }
HN_PING_PONG2D(ping_pong_of_mine, mine)
HN_FBM_LIMITED2D(limited_of_mine, mine)
}  // namespace hashnoise

float all_of_them(float x) {
  using namespace hashnoise;
  const vec2 p(x, 0.5f);
  return fbm_of_simplex(p, 5, 2.0f, 0.5f) + ridged_of_value(ivec2(3, 4), p, 5, 2.0f, 0.5f, 7u) +
         weighted_of_value(vec3(x), ivec3(4), 5, 2.0f, 0.5f, 1.0f, 7u) + ping_pong_of_mine(p, 5, 2.0f, 0.5f, 2.0f) +
         limited_of_mine(p, 4.5f, 2.0f, 0.5f, 7u) + limited_of_mine(p, 0.01f, 5, 2.0f, 0.5f, 7u);
}
"""


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

    def test_sums_over_several_noises_live_in_one_file(self) -> None:
        for compiler in COMPILERS:
            for arithmetic in ARITHMETICS:
                with self.subTest(compiler=compiler, arithmetic=arithmetic):
                    setting = ("-std=c++20", f"-DHN_ARITHMETIC={arithmetic}")
                    self.assertEqual(says(compiler, including("hashnoise.hpp") + SUMS, *setting), "")

    def test_a_sum_over_what_is_no_noise_is_refused(self) -> None:
        for compiler in COMPILERS:
            wrong = "namespace hashnoise {\nHN_FBM2D(wrong, hn_lattice)\n}\n"
            self.assertRegex(says(compiler, including("hashnoise.hpp") + wrong, "-std=c++20"), "error: .*hn_lattice")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
