"""tools/pick whole: its text compiles by itself, in every language, with nothing but a #version line."""

import functools
import itertools
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from base.debian import Missing, chosen
from base.thorough import THOROUGH, in_thorough_runs, some
from base.tree import GLSL, TOOLS, glsl_files
from translate.parsing.preprocessor import Preprocessor
from translate.single_file.files import INCLUDE, Part, in_order, lines_of, minified, parts
from translate.single_file.godot import expanded

TOOL = TOOLS / "pick", "whole"
FILES = ("hash.glsl", "noise2d.glsl", "noise3d.glsl", "fbm2d.glsl", "fbm3d.glsl", "fbm.glsl", "hashnoise.glsl")
CALLS = {"hash.glsl": "hn_unorm(hn_hash(7u))", "noise2d.glsl": "hn_perlin(vec2(1.5))",
         "noise3d.glsl": "hn_perlin(vec3(1.5))", "fbm2d.glsl": "hn_clouds(vec2(1.5), 5, 2.0, 0.5)"}


@functools.cache  # the same text is looked at again and again
def generate(*arguments):
    return subprocess.run([sys.executable, *TOOL, *arguments], capture_output=True, text=True, check=False)


def compile_shader(text):
    """glslang's opinion: the output of a compilation, and whether it went well."""
    with tempfile.NamedTemporaryFile("w", suffix=".frag") as shader:
        shader.write(text)
        shader.flush()
        done = subprocess.run(["glslangValidator", shader.name], capture_output=True, text=True, check=False)
    return done.returncode == 0, done.stdout


class Read(Preprocessor):
    """The files that a preprocessor reads for one, and how many lines each has."""

    def __init__(self, name, **settings):
        super().__init__(GLSL, settings)
        self.lines = {}
        self._read(glsl_files()[name].read_text(encoding="ascii"), name)

    def _read(self, text, path):
        self.lines[path] = text.count("\n")
        super()._read(text, path)


class SingleFile(unittest.TestCase):
    def test_each_file_compiles_by_itself(self):
        versions, options = ("130", "460", "300 es"), ([], ["--strip"], ["--minify"])
        # By default each file with one option and one version, the whole library with each option.
        for (number, name), (other, option) in itertools.product(enumerate(FILES), enumerate(options)):
            if name != "hashnoise.glsl" and option not in some(options, number):
                continue
            body = generate(*option, name).stdout
            self.assertNotIn("#include", body)
            call = CALLS.get(name, "hn_clouds(vec3(1.5), 5, 2.0, 0.5)")
            for version in some(versions, number // len(options) + other):
                precision = "precision mediump float;\n" if version.endswith("es") else ""
                shader = f"#version {version}\n{precision}{body}\nout vec4 o;\nvoid main() {{ o = vec4({call}); }}\n"
                with self.subTest(name=name, options=option, version=version):
                    right, log = compile_shader(shader)
                    self.assertTrue(right, log)

    def test_the_preprocessors_of_c_take_it(self):
        # Their __VERSION__ is a string, but for one that is passed.
        text = '#include "hashnoise.glsl"\nout vec4 o;\nvoid main() { o = vec4(hn_clouds(vec3(1.5), 5, 2.0, 0.5)); }\n'
        for program, version, options in (("gcc", "330", ()), ("clang", "330", ()), ("gcc", "130", ("-undef", "-D__VERSION__=130"))):
            if shutil.which(program):
                with self.subTest(program=program, version=version):
                    done = subprocess.run([program, "-E", "-P", "-xc", f"-I{GLSL}", *options, "-"], input=text,
                                          capture_output=True, text=True, check=False)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    right, log = compile_shader(f"#version {version}\n{done.stdout}")
                    self.assertTrue(right, log)

    def test_a_directive_has_one_hash_sign_and_no_line_a_backtick(self):
        # glslang 14.0 to 14.3 (Godot 4.6, Ubuntu 24.04) refuses a second one, also in the text of an #error in a branch
        # that is not taken. A backtick ends a template of JavaScript, into which people paste the text.
        for name, path in glsl_files().items():
            for number, line in enumerate(path.read_text(encoding="ascii").splitlines(), 1):
                self.assertNotIn("`", line, f"{name}: line {number}")
                if line.lstrip().startswith("#"):
                    self.assertEqual(line.count("#"), 1, f"{name}: line {number}: {line}")

    def test_in_another_language_it_begins_and_ends_the_names_of_that(self):
        for language in ("hlsl", "metal"):
            for options in ([], ["--strip"]):
                with self.subTest(language=language, options=options):
                    lines = generate("--language", language, *options, "noise2d.glsl").stdout.splitlines()
                    self.assertNotIn("#include", "".join(line for line in lines if not line.startswith("//")))
                    for macro in ("vec2", "uvec4", "floatBitsToUint"):
                        self.assertEqual(sum(line.startswith(f"#define {macro} ") for line in lines), 1)
                        self.assertEqual(lines.count(f"#undef {macro}"), 1)

    def test_for_godot_what_no_knob_decides_is_expanded_and_nothing_else_changes(self):
        def tokens(*options, knobs=()):
            command = ["g++", "-E", "-P", "-U__VERSION__", *(f"-D{knob}" for knob in knobs), "-x", "c", "-"]
            done = subprocess.run(command, input=generate(*options).stdout, capture_output=True, text=True, check=True)
            return re.findall(r"\w+|[^\w\s]", re.sub(r"_hn\b", "", done.stdout))

        # By default of the smallest file and of the whole library, in which all others are.
        for name in FILES if THOROUGH else (FILES[0], FILES[-1]):
            with self.subTest(name=name):
                self.assertEqual(tokens("--language", "godot", name), tokens(name))
        text = generate("--language", "godot", "--strip").stdout
        self.assertNotRegex(text, r"(?m)^HN_[A-Z_]+[1-4]D\(")
        # No comment explains how to use them, either.
        self.assertNotRegex(generate("--language", "godot").stdout, r"HN_[A-Z_]+[1-4]D\(")
        self.assertNotRegex(text, r"\bHN_(FN|I_OUT|I_SUMS\w*|I_BITCAST)\b|\bhn_u?i?vec|__cplusplus")
        self.assertLess(len(set(re.findall(r"#define (HN_I_\w+|hn_\w+)", text))), 25)
        # Code that knobs choose is still there.
        self.assertIn("#define HN_I_PRECISE", text)
        self.assertEqual(len(re.findall(r"(?m)^#define hn_i_num2 ", text)), 2)
        for knobs in (["HN_ARITHMETIC=HN_FIXED"], ["HN_HASH=HN_HASH_PCG", "HN_GRADIENT=HN_GRADIENT_SINE"]):
            with self.subTest(knobs=knobs):
                self.assertEqual(tokens("--language", "godot", knobs=knobs), tokens(knobs=knobs))
                self.assertNotEqual(tokens("--language", "godot", knobs=knobs), tokens("--language", "godot"))

    def test_for_godot_only_what_is_known_is_decided(self):
        lines = """#ifndef HN_A_GLSL
            #define HN_A_GLSL
            #ifdef __cplusplus
            #define HN_I_KIND 1
            #elif defined(GL_ES)
            #define HN_I_KIND 2
            #else
            #define HN_I_KIND 3
            #endif
            #define HN_I_OUT(type) out type
            #define HN_KNOB 5
            #if HN_I_KIND == 3
            #if HN_KNOB == 5  // it is
            #define HN_I_VALUE HN_I_KIND
            #elif HN_KNOB == 4
            #define HN_I_VALUE 4
            #endif
            void f(HN_I_OUT(int) a, HN_I_OUT(vec2) b) { g(HN_I_VALUE, HN_I_KIND); }  // HN_I_KIND
            #else
            wrong
            #endif
            #endif""".replace("            ", "").split("\n")
        self.assertEqual(expanded(lines), """#ifndef HN_A_GLSL
            #define HN_A_GLSL
            #define HN_KNOB 5
            #if HN_KNOB == 5  // it is
            #define HN_I_VALUE 3
            #elif HN_KNOB == 4
            #define HN_I_VALUE 4
            #endif
            void f(out int a_hn, out vec2 b_hn) { g(HN_I_VALUE, 3); }  // HN_I_KIND
            #endif""".replace("            ", "").split("\n"))

    def test_for_godot_no_variable_has_a_name_of_users(self):
        """Godot takes it for their uniform of that name."""
        lines = ["struct hn_i_pair {", "  float seed;  // one", "};",
                 "float hn_f(hn_i_pair p, vec2 seed) { for (int i = 0; i < 3; ++i) p.seed += float(i) * seed.x; return p.seed; }"]
        self.assertEqual(expanded(lines), [*lines[:3], "float hn_f(hn_i_pair p_hn, vec2 seed_hn) { for (int i_hn = 0; "
                                           "i_hn < 3; ++i_hn) p_hn.seed += float(i_hn) * seed_hn.x; return p_hn.seed; }"])
        text = generate("--language", "godot", "--strip").stdout
        declared = set(re.findall(r"\b(?:float|int|uint|[iu]?vec\d|hn_i_\w+|HN_I_PLACE\d) (\w+)\b(?!\()",
                                  re.sub(r"(?s)struct .*?\};|#.*?\n", "", text)))
        self.assertGreater(len(declared), 100)
        self.assertEqual({name for name in declared if not name.endswith("_hn")}, set())

    def test_for_godot_precise_is_refused_by_a_sentence(self):
        text = "#define HN_ARITHMETIC HN_PRECISE\n" + generate("--language", "godot").stdout
        done = subprocess.run(["g++", "-E", "-P", "-x", "c", "-"], input=text, capture_output=True, text=True, check=False)
        self.assertIn("#error HN_PRECISE needs", done.stderr)

    @in_thorough_runs
    def test_godot_takes_it(self):
        try:
            program = chosen("godot")
        except Missing as reason:
            self.skipTest(str(reason))
        tried = (("HN_FAST", "hn_fbm", True), ("HN_FIXED", "hn_fbm", True), ("HN_FAST", "absent", False))
        for arithmetic, call, right in tried:
            with self.subTest(arithmetic=arithmetic, call=call), tempfile.TemporaryDirectory() as folder:
                project = pathlib.Path(folder)
                (project / "project.godot").write_text("config_version=5\n")
                (project / "hashnoise.gdshaderinc").write_text(generate("--language", "godot").stdout)
                (project / "user.gdshader").write_text(
                    f"shader_type canvas_item;\n#define HN_ARITHMETIC {arithmetic}\n"
                    f'#include "res://hashnoise.gdshaderinc"\n'
                    f"void fragment() {{ COLOR = vec4({call}(UV, 5, 2.0, 0.5, 7u)); }}\n")
                # To ask for the uniforms compiles the shader.
                (project / "run.gd").write_text(
                    'extends SceneTree\nfunc _init():\n\tload("res://user.gdshader").get_shader_uniform_list()\n'
                    "\tquit()\n")
                done = subprocess.run([program, "--headless", "--path", folder, "--script", "res://run.gd"],
                                      capture_output=True, text=True, check=False)
                self.assertEqual("SHADER ERROR" not in done.stdout + done.stderr, right, done.stdout + done.stderr)

    def test_an_unknown_language_is_named(self):
        done = generate("--language", "fortran")
        self.assertEqual(done.returncode, 2)
        self.assertIn("'glsl', 'hlsl', 'slang', 'metal', 'godot', 'wgsl'", done.stderr)

    def test_the_compilation_can_fail(self):
        right, _ = compile_shader("#version 460\n" + generate("hash.glsl").stdout + "\nvoid main() { absent(); }\n")
        self.assertFalse(right)

    def test_stripped_it_is_the_same_code(self):
        def tokens(text):
            return re.sub(r"//.*", "", text).split()

        whole, stripped = generate().stdout, generate("--strip").stdout
        self.assertEqual(tokens(whole), tokens(stripped))
        self.assertLess(len(stripped), len(whole) * 2 / 3)
        comments = [line for line in stripped.splitlines() if "//" in line]
        self.assertEqual(len(comments), 2, comments)  # where it is from, and its licence
        self.assertIn("MIT License", comments[1])

    def test_minified_it_has_the_same_lines_and_tokens(self):
        def tokens(text):
            return re.findall(r"[\w.]+|[^\w\s]", text)

        for language in ("glsl", "hlsl", "slang", "metal", "godot"):
            with self.subTest(language=language):
                full, small = (generate("--language", language, option).stdout for option in ("--strip", "--minify"))
                lines = list(zip(full.splitlines(), small.splitlines(), strict=True))
                self.assertTrue(all(tokens(one) == tokens(other) for one, other in lines))
                macros = [re.findall(r"#define (\w+\(?)|$", line)[0] for line, _ in lines]
                self.assertEqual([re.findall(r"#define (\w+\(?)|$", line)[0] for _, line in lines], macros)
                self.assertLess(len(small), len(full) * 0.95)
        self.assertEqual(list(minified(["  a = b - -c + d ;", "#define F (a + 1)", "#define G(a) a + 1", "return  // why"])),
                         ["a=b- -c+d;", "#define F (a+1)", "#define G(a) a+1", "return"])

    def test_no_file_stands_in_it_twice(self):
        self.assertEqual(generate().stdout.count("float hn_unorm("), 1)

    def test_the_sums_of_a_dimension_have_no_noise_of_the_other(self):
        for own, other in (("2", "3"), ("3", "2")):
            with self.subTest(dimension=own):
                text = generate(f"fbm{own}d.glsl").stdout
                for function in ("hn_perlin(hn_vec", "hn_octaves(hn_vec"):
                    self.assertIn(f"{function}{own} ", text)
                    self.assertNotIn(f"{function}{other} ", text)

    def test_the_help_names_the_sums_on_the_plane(self):
        self.assertIn("fbm2d.glsl the octave sums on the plane", " ".join(generate("--help").stdout.split()))

    def test_no_macro_that_a_condition_asks_for_names_another(self):
        """As PlayCanvas' preprocessor needs it, which compares the text behind a #define."""
        def naming(lines):
            tested = set(re.findall(r"\bHN_\w+", "".join(line for line in lines if line.startswith("#if "))))
            defined = {match[1]: match[2] for line in lines if (match := re.match(r"#define (HN_\w+) (\w+)", line))}
            return {name for name, value in defined.items() if name in tested and value in defined}
        lines = generate().stdout.splitlines(keepends=True)
        self.assertEqual(naming(lines), set())
        self.assertIn("#define HN_HASH 8  // HN_HASH_LATTICE\n", lines)
        config = (glsl_files()["config.glsl"]).read_text().splitlines(keepends=True)
        self.assertEqual(naming(config), {"HN_HASH", "HN_GRADIENT", "HN_ARITHMETIC"})

    def test_parts_in_order_are_the_library(self):
        found = parts(strip=True)

        for name in FILES:
            with self.subTest(name=name):
                text = "\n".join(line for needed in in_order(name, found) for line in found[needed].lines)
                call = CALLS.get(name, "hn_clouds(vec3(1.5), 5, 2.0, 0.5)")
                right, log = compile_shader(f"#version 330\n{text}\nout vec4 o;\nvoid main() {{ o = vec4({call}); }}\n")
                self.assertTrue(right, log)
        self.assertEqual(found["perlin2d.glsl"].includes, ("detail/direction.glsl", "detail/sine_gradient.glsl"))
        self.assertIsInstance(found["hashnoise.glsl"], Part)

    def test_a_call_on_the_plane_brings_little_text(self):
        """Files and lines that who reads it meets, with the default of each knob."""
        for name, files, lines in (("perlin2d.glsl", 6, 1200), ("simplex2d.glsl", 9, 1560),
                                   ("cellular2d.glsl", 9, 1690), ("fbm_d2d.glsl", 11, 2290)):
            with self.subTest(name=name):
                read = Read(name).lines
                self.assertLessEqual(len(read), files, read)
                self.assertLessEqual(sum(read.values()), lines, read)
        self.assertNotIn("detail/hashes.glsl", Read("perlin2d.glsl").lines)
        self.assertIn("detail/hashes.glsl", Read("perlin2d.glsl", HN_HASH="HN_HASH_PCG").lines)
        self.assertIn("detail/sine_gradient.glsl", Read("perlin2d.glsl", HN_GRADIENT="HN_GRADIENT_SINE").lines)

    def test_includes_stand_above_the_code(self):
        """Else the parts would come in another order than the preprocessor takes them."""
        for name, path in glsl_files().items():
            lines = lines_of(path)
            last = max((number for number, line in enumerate(lines) if INCLUDE.match(line)), default=0)
            above = [line for line in lines[:last] if line and not line.startswith("//") and not INCLUDE.match(line)]
            with self.subTest(path=name):
                self.assertTrue(all(re.fullmatch(r"#(ifndef|define) HN_\w+_GLSL", line) for line in above), above)

    def test_it_writes_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "one.glsl"
            self.assertEqual(generate("--out", str(path)).returncode, 0)
            self.assertEqual(path.read_text(), generate().stdout)
            self.assertEqual(generate("--out", str(path)).stdout, f"{path}\n")
            self.assertEqual(generate("--out", str(path / "below")).returncode, 2)

    def test_errors_below_it_have_their_own_lines(self):
        for option in ("--strip", "--minify", "--language=glsl"):
            right, log = compile_shader(f"#version 330\n{generate(option, 'value1d.glsl').stdout}\nno_such_type x;\n")
            self.assertFalse(right)
            self.assertRegex(log, r"ERROR: \d+:2: ")

    def test_several_have_each_file_once(self):
        done = generate("--strip", "simplex2d.glsl", "hn_unorm", "perlin3d.glsl")
        self.assertIn("from simplex2d.glsl, hash.glsl, perlin3d.glsl.", done.stdout)
        self.assertEqual(done.stdout.count("#define HN_HASH_GLSL"), 1)
        right, log = compile_shader(f"#version 330\n{done.stdout}\nout vec4 o;\n"
                                    "void main() { o = vec4(hn_simplex(vec2(1.5)), hn_perlin(vec3(0.5)), 0.0, 0.0); }\n")
        self.assertTrue(right, log)

    def test_a_function_is_answered_with_its_files(self):
        done = generate("hn_fbm")
        self.assertEqual(done.returncode, 2)
        self.assertIn("hn_fbm is in fbm1d.glsl, fbm2d.glsl, fbm3d.glsl, fbm4d.glsl: name", " ".join(done.stderr.split()))
        self.assertIn("there is no hn_nothing in hashnoise/", " ".join(generate("hn_nothing").stderr.split()))

    def test_an_unknown_file_is_named(self):
        done = generate("xyz")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there are: cell_border2d.glsl, cell_border3d.glsl", done.stderr)
        self.assertIn("did you mean fbm2d.glsl?", generate("fbm2d").stderr)
        for outside in ("../README.md", "/etc/passwd"):
            self.assertEqual(generate(outside).returncode, 2)
