"""The pages are true: their code compiles and runs as it stands there, and tools/make pages makes the
rest."""

import contextlib
import copy
import functools
import io
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
from unittest import mock

from base import cuda
from base.debian import Missing
from base.pieces import is_deleted, was_deleted
from base.png import png
from base.renderer import NotCompiled, Renderer
from base.thorough import in_thorough_runs
from base.tree import ROOT, TOOLS
from catalog.tables import glsl
from ship.pages import command, files, numbers, picture
from ship.recipes import RECIPES
from ship.website import live
from translate.pick.command import SYNTAXES, Choice, picker

PAGES = ("README.md", "llms.txt", "docs/guide/build-systems.md", "docs/guide/cellular.md", "docs/guide/cpu.md", "docs/guide/gpu-computing.md", "docs/guide/hex-tiling.md",
         "docs/reference/knobs.md", "docs/guide/moving.md", "docs/reference/noises.md", "docs/guide/random.md", "docs/guide/same-bits.md", "docs/reference/fractals.md",
         "docs/guide/tutorial.md", "docs/guide/uniform.md")
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PASTED = re.compile(r"^// paste the output of tools/pick ([\w. -]+) here$", re.MULTILINE)


def blocks(language, pages=PAGES):
    return [code for page in pages for name, code in BLOCK.findall((ROOT / page).read_text()) if name == language]


def commands(start, page="README.md"):
    """The commands of a page that begin so, without their comments."""
    return [line.partition("  # ")[0].split() for line in (ROOT / page).read_text().splitlines()
            if line.startswith(f"    {start}")]


def run(*arguments, **options):
    return subprocess.run(arguments, capture_output=True, text=True, check=False, **options)


@functools.cache
def picked(*arguments):
    return run(str(TOOLS / "pick"), *arguments).stdout


def single_file(*arguments):
    return picked("whole", *arguments)


def pasted(code):
    """A shader with the text that its comment names."""
    return PASTED.sub(lambda place: picked(*place[1].split()), code)


# The text around a part of a shader.
HEAD = "#version 330\n#extension GL_GOOGLE_include_directive : require\n"
TAIL = "out vec4 color;\nvoid main() { color = vec4(1.0); }\n"


def compile_glsl(code):
    """By the command of the README, and with single files where they belong. Functions without a main get one."""
    if "#version" not in code:
        code = HEAD + code + TAIL
    with tempfile.TemporaryDirectory() as folder:
        shader = pathlib.Path(folder) / "shader.frag"
        shader.write_text(pasted(code))
        if "#include" in shader.read_text():
            (pathlib.Path(folder) / "hashnoise").symlink_to(ROOT / "glsl" / "hashnoise")
            command, = commands("glslangValidator")
            if "layout(location" in code:  # Vulkan's
                command[command.index("-l")] = "-V"
            return run(*command, cwd=folder)
        return run("glslangValidator", str(shader))


def compile_hlsl(code):
    """Functions for a pixel, by glslang."""
    with tempfile.NamedTemporaryFile("w", suffix=".hlsl") as source:
        source.write(f"{code}float4 main(float4 place : SV_Position) : SV_Target {{ return 1.0; }}\n")
        source.flush()
        return run("glslangValidator", "-D", "-V", "-S", "frag", "-e", "main", "-o", os.devnull, source.name)


# NVIDIA's headers declare this.
CUDA = """#define __CUDACC__ 1
#define __device__ __attribute__((device))
#define __host__ __attribute__((host))
#define __global__ __attribute__((global))
#include <cstddef>
struct uint3 { unsigned x, y, z; };
struct dim3 { unsigned x, y = 1, z = 1; __host__ __device__ dim3(unsigned n) : x(n) {} };
#include <__clang_cuda_builtin_vars.h>
enum cudaError { cudaSuccess };
cudaError cudaConfigureCall(dim3, dim3, std::size_t = 0, void* = nullptr);
cudaError cudaDeviceSynchronize();
template <class T> cudaError cudaMallocManaged(T**, std::size_t);
"""
CLANG_CUDA = ("clang++", "-x", "cuda", "-nocudainc", "-nocudalib", "--cuda-gpu-arch=sm_75")


def compile_cpp(code, *compiler):
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as source:
        source.write(code)
        source.flush()
        return run(*(compiler or ["g++"]), "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror",
                   "-I", str(ROOT / "include"), source.name)


class Picture(unittest.TestCase):
    def setUp(self):
        self.page = (ROOT / "docs" / "reference" / "noises.md").read_text()
        self.tiles = picture.tiles(self.page, "noise.png")
        self.path = picture.path_of("noise.png")

    def checked(self, *sheets):
        return picture.draw([picture.Sheet(pathlib.Path(path), tiles) for path, tiles in sheets], check=True)

    def test_a_changed_function_and_another_picture_are_noticed(self):
        with contextlib.redirect_stderr(io.StringIO()):
            changed = [*self.tiles[:3], self.tiles[3].replace("6,", "5,")]
            with tempfile.NamedTemporaryFile(suffix=".png") as other:
                other.write(png(1, 1, bytes(3)))  # one black pixel
                other.flush()
                self.assertEqual(self.checked((self.path, changed)), 1)
                self.assertEqual(self.checked((self.path, self.tiles), (other.name, self.tiles)), 1)
                self.assertEqual(self.checked(("/nowhere.png", self.tiles), (self.path, changed)), 2)

    def test_a_changed_step_of_the_tutorial_is_noticed(self):
        page = live.PAGE.read_text()
        self.assertIn("](../images/tutorial.png)", page)
        steps = live.in_cpp(page.replace("vec2(0.25, 4.0)", "vec2(0.25, 2.0)"))
        self.assertEqual(list(steps)[11], "step_12(uv * 8.0)")
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(picture.draw([live.sheet(steps)], True, "\n".join(steps.values())), 1)

    def test_its_code_is_glsl(self):
        pages = [(name, (ROOT / page).read_text()) for name, page in picture.PICTURES.items()]
        lines = "".join(f"  color = vec4({tile}, 1.0);\n" for name, page in pages for tile in picture.tiles(page, name))
        given = "vec3 uneroded(vec2 uv) { return uv.xyx; }\n"
        shader = (f"#version 330\n{single_file('--strip')}{given}in vec2 uv;\nout vec4 color;\nvoid main() {{\n"
                  f"  ivec2 nearest;\n  vec2 offset;\n{lines}}}\n")
        self.assertEqual(compile_glsl(shader).returncode, 0)

    def test_code_that_does_not_compile_is_told(self):
        with self.assertRaisesRegex(ValueError, "(?s)does not compile.*hn_merlin"):
            self.checked((self.path, ["vec3(hn_merlin(uv))"]))
        with self.assertRaisesRegex(ValueError, "no code below its picture noise.png"):
            picture.tiles(self.page.replace("    vec3(", "vec3("), "noise.png")


class Numbers(unittest.TestCase):
    """tools/make pages --check, and that it can fail."""

    def check(self):
        output = io.StringIO()
        with contextlib.redirect_stderr(output):
            status = command.main(["--check"])
        return status, output.getvalue()

    def records_alone(self):
        """The tables of records: the others take several times as long."""
        return mock.patch.object(command, "tables", new=lambda: [*command.of_measuring("tables")])

    def test_pictures_and_numbers_are_what_they_should_be(self):
        self.assertEqual(self.check(), (0, ""))

    @mock.patch.object(command, "problems", new=lambda _: [])
    @mock.patch.object(picture, "draw", return_value=1)
    def test_another_picture_is_not_as_it_should_be(self, draw):
        self.assertEqual(self.check()[0], 1)
        drawn = {sheet.path.name for sheet in draw.call_args.args[0]}
        self.assertLess({"noise.png", "metrics.png", "wood.png", "sheet.png", "tutorial.png"}, drawn)

    @mock.patch.object(picture, "draw", new=lambda *_: 0)
    def test_other_numbers_are_noticed(self):
        typical = copy.deepcopy(numbers.typical())
        typical["hn_fbm", 3][1] += 0.1
        with mock.patch.object(numbers, "typical", return_value=typical), \
                mock.patch.object(command, "of_measuring", new=lambda _: ()), \
                mock.patch.object(numbers, "golden_quote", return_value="computes 7 golden values"):
            status, output = self.check()
        self.assertEqual(status, 1)
        self.assertRegex(output, r"docs/reference/noises\.md: the table of `tools/make pages: \w[^`]*` is not what")
        self.assertRegex(output, r"README\.md: it must state 'computes 7 golden values'")

    @unittest.skipIf(is_deleted("measuring"), "measuring was deleted")
    @mock.patch.object(picture, "draw", new=lambda *_: 0)
    def test_other_costs_are_noticed(self):
        from measure import tables
        from measure.gpu import pages as of_gpus
        costs = {**tables.costs(tables.CPU)}
        costs["noise2d.perlin.lattice"] = {**costs["noise2d.perlin.lattice"], "ratio": "9.999"}
        peers = {**tables.peer_costs(tables.GPU)}
        peers["fbm.fbm2.lattice"] = {**peers["fbm.fbm2.lattice"], "ratio": "9.999"}
        gpus = {**of_gpus.costs()}
        gpus["noise2d.perlin.lattice", "m1"] = gpus["noise2d.perlin.lattice", "m1"]._replace(cost="9999")
        with self.records_alone(), mock.patch.object(of_gpus, "costs", return_value=gpus), \
                mock.patch.object(tables, "costs", return_value=costs), \
                mock.patch.object(tables, "peer_costs", return_value=peers):
            status, output = self.check()
        self.assertEqual(status, 1)
        self.assertRegex(output, r"docs/measured/measuring\.md: the table of `[^`]+` is not what it should be")
        self.assertRegex(output, r"README\.md: it must state \".* FastNoiseLite's, and fBm of six octaves 0\.36 times")

    @unittest.skipIf(is_deleted("measuring"), "measuring was deleted")
    @mock.patch.object(picture, "draw", new=lambda *_: 0)
    def test_a_record_without_a_row_is_told(self):
        from measure import tables
        with tempfile.TemporaryDirectory() as folder:
            for renderer in (tables.CPU, tables.GPU):
                record = pathlib.Path(folder) / renderer / "bench.csv"
                record.parent.mkdir()
                record.write_text("id,ratio,spirv,nvidia\n")
            with self.records_alone(), mock.patch.object(tables, "RESULTS", pathlib.Path(folder)), \
                    self.assertRaises(SystemExit) as stop:
                self.check()
            self.assertEqual(stop.exception.code, 2)


class Nodes(unittest.TestCase):
    def test_a_row_has_the_functions_that_the_same_packages_have(self):
        nodes = {"graphs": ("hn_perlin2", "hn_cell_border2_jitter", "hn_perlin2_place"), "materialx": ("hn_perlin2_place",),
                 "blender": ("hn_cell_border2_jitter", "hn_perlin2", "hn_perlin3")}
        with mock.patch.object(files.popular, "nodes", nodes.get):
            self.assertEqual(files.nodes_table().splitlines()[2:], [
                "| `hn_perlin` | 2D | 2D, 3D | |", "| `hn_cell_border` | 2D | 2D | |", "| `hn_perlin` in a tile | 2D | | 2D |"])


class Code(unittest.TestCase):
    def test_shaders_compile_without_a_warning(self):
        self.assertGreaterEqual(len(blocks("glsl")), 5)
        for code in blocks("glsl"):
            with self.subTest(code=code):
                done = compile_glsl(code)
                self.assertEqual(done.returncode, 0, done.stdout)
                self.assertNotIn("WARNING", done.stdout)

    def test_a_driver_takes_the_first_shader_and_steps_of_the_tutorial(self):
        """As their readers give it to a driver, which knows no #include."""
        renderer = Renderer(8)
        code, = blocks("glsl", ["README.md"])
        pixels = renderer.draw(renderer.program(pasted(code)))
        self.assertGreater(max(pixels[::4]) - min(pixels[::4]), 0.2)
        self.assertRaises(NotCompiled, renderer.program, code)
        page = (ROOT / "docs" / "guide" / "tutorial.md").read_text()
        whole = live.STEP.search(page)[3]
        for _, _, step in live.STEP.findall(page):
            with self.subTest(step=step):
                code = single_file("--strip", *live.INCLUDE.findall(step)) + live.AROUND.sub("", step)
                shader = re.sub(r"(?m)^#(?:extension|include).*\n", "", whole)
                renderer.program(re.sub(r"(?m)^vec3 color_at.*\n", lambda _: code, shader))  # noqa: B023

    def test_hlsl_compiles(self):
        code, = blocks("hlsl", ["docs/guide/random.md"])
        self.assertEqual(compile_hlsl(code).returncode, 0)
        self.assertNotEqual(compile_hlsl(code.replace("mask.Load", "mask.Lode")).returncode, 0)

    def test_cpp_compiles(self):
        self.assertGreaterEqual(len(blocks("cpp")), 3)
        for code in blocks("cpp"):
            with self.subTest(code=code):
                done = compile_cpp(code)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_cuda_compiles(self):
        code, = blocks("cuda")
        self.assertEqual(compile_cpp(CUDA + code, *CLANG_CUDA).stderr, "")
        host = compile_cpp(CUDA + code.replace("__host__ __device__ ", ""), *CLANG_CUDA)
        self.assertIn("call to __host__ function from __global__ function", host.stderr)

    @in_thorough_runs
    def test_nvcc_compiles_cuda(self):
        code, = blocks("cuda")
        (_, *words), = commands("nvcc", "docs/guide/gpu-computing.md")
        try:
            nvcc = cuda.toolkit() / "bin" / "nvcc"
        except Missing as why:
            self.skipTest(str(why))
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "heights.cu").write_text(code)
            words = [word.replace("hashnoise/", f"{ROOT}/") for word in words]
            done = run(nvcc, *words, cwd=folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_functions_that_pages_name_exist(self):
        known = {function.name for function in glsl.declarations()}
        for page in ["README.md", "docs/guide/moving.md", "docs/reference/fractals.md", "docs/reference/noises.md", "docs/guide/cellular.md",
                     "docs/guide/random.md", "docs/guide/tutorial.md"]:
            named = set(re.findall(r"\b(hn_\w+)\(", (ROOT / page).read_text()))
            self.assertGreater(len(named), 5, page)
            self.assertLessEqual(named, known, page)

    def test_both_compilations_can_fail(self):
        self.assertNotEqual(compile_glsl(blocks("glsl")[0].replace("hn_fbm", "hn_fmb")).returncode, 0)
        self.assertNotEqual(compile_cpp(blocks("cpp")[0].replace("hn_fbm", "hn_fmb")).returncode, 0)

    def test_commands_that_make_single_files_work(self):
        lines = commands("tools/pick whole", "docs/guide/languages.md")
        self.assertGreaterEqual(len(lines), 4)
        with tempfile.TemporaryDirectory() as folder:
            for line in lines:
                done = run(str(ROOT / line[0]), *line[1:], cwd=folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue((pathlib.Path(folder) / line[line.index("--out") + 1]).is_file())
            size = round((pathlib.Path(folder) / "hashnoise.single.glsl").stat().st_size / 1000)
            self.assertIn(f"`tools/pick whole --strip --out noise.glsl`, {size} kB", (ROOT / "README.md").read_text())

    def test_commands_that_the_table_names_work(self):
        table = (ROOT / "README.md").read_text().partition("## Use it where you are")[2].partition("\n## ")[0]
        named = [line.split() for line in re.findall(r"`(tools/[^`]+)`", table)]
        self.assertGreaterEqual(len(named), 7)
        with tempfile.TemporaryDirectory() as folder:
            for line in named:
                if was_deleted(line[0]) or (line[0] == "tools/pack" and line[1] not in RECIPES):
                    continue
                with self.subTest(command=line):
                    # Commands that build or install something first have tests of their own.
                    words = line if "--out" in line else [*line, "--help"]
                    done = run(str(ROOT / words[0]), *words[1:], cwd=folder)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    if "--out" in line:
                        self.assertTrue((pathlib.Path(folder) / line[line.index("--out") + 1]).stat().st_size)

    def test_single_files_around_a_noise_of_ones_own(self):
        code, = (code for code in blocks("glsl", ["docs/reference/fractals.md"]) if "dots" in code)
        code = re.sub(r"^#extension.*\n", "", code, flags=re.MULTILINE)
        code = code.replace('"hashnoise/fbm2d.glsl"', '"hashnoise/hashnoise.glsl"')
        code = re.sub(r'^#include "hashnoise/(.*)"$', lambda name: single_file("--strip", name[1]), code, flags=re.MULTILINE)
        code = re.sub(r"layout\(location = 0\) ", "", code).replace("#version 450", "#version 330")
        self.assertEqual(compile_glsl(code).returncode, 0)


class ForMachines(unittest.TestCase):
    """llms.txt, whose shaders Code and wgsl.wgpu_test compile."""
    text = (ROOT / "llms.txt").read_text()

    def test_it_begins_as_llmstxt_org_says(self):
        self.assertRegex(self.text, r"\A# hashnoise\n\n> [^\n]+\n")
        lists = re.findall(r"^## (?:Docs|Optional)\n\n((?:- \[.*\]\(.*\).*\n)+)", self.text, re.MULTILINE)
        self.assertEqual(len(lists), 2)

    def test_calls_in_other_languages_take_what_picked_functions_take(self):
        rows = dict(re.findall(r"^\| ([A-Z][\w+#, ]*) \| `(.*)` \|$", self.text, re.MULTILINE))
        pick = picker()
        for heading, language in (("Rust", "rust"), ("C#", "csharp"), ("C", "c"), ("Java", "java"), ("Go", "go"),
                                  ("GDScript", "gdscript"), ("JavaScript, TypeScript", "javascript"), ("JavaScript, TypeScript", "typescript")):
            if language not in SYNTAXES:
                continue
            with self.subTest(language):
                name, arguments = re.fullmatch(r"(?:\w+\.)?(\w+)\((.*)\)", rows[heading]).groups()
                written = pick(["hn_fbm2"], Choice(language))
                declared = re.search(rf"(?:fn|(?:static )?func|function|public static float|HN_INLINE float) {name}\((.*?)\)",
                                     written, re.DOTALL)
                self.assertEqual(arguments.count(","), declared[1].rstrip(", \n").count(","))
        code = f"#include <hashnoise/hashnoise.hpp>\nfloat f(float x, float y) {{ return {rows['C++']}; }}"
        self.assertEqual(compile_cpp(code).returncode, 0)


class Readme(unittest.TestCase):
    def test_it_is_short(self):
        self.assertLess(len((ROOT / "README.md").read_bytes()), 8000)

    def test_links_lead_somewhere(self):
        for page in [ROOT / "README.md", ROOT / "llms.txt", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.md")]:
            for target in re.findall(r"\]\(([^)#\s]+)(?:#[\w-]+)?\)", page.read_text()):
                if "://" not in target:
                    file = os.path.relpath(page.parent / target, ROOT)
                    self.assertTrue((page.parent / target).exists() or was_deleted(file), f"{page.name}: {target}")
