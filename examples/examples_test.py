"""The examples are built and run as docs/guide/engines.md describes, on a display that nobody sees or in a browser.
Their pictures show the land that the twin computes.

    examples_test.py WORK CLASS    WORK is a scratch folder, in which raylib is kept

Exit status: 0 passed, 1 failed, 77 what the class needs cannot be had here.
"""

from __future__ import annotations

import array
import base64
import functools
import glob
import http.server
import os
import re
import shutil
import subprocess
import sys
import threading
import unittest
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent
sys.path.insert(0, str(EXAMPLES.parent / "tools" / "lib"))

from screen import Absent, Screen  # noqa: E402

from base import chromium, cuda, ptx, twin  # noqa: E402
from base.debian import Missing  # noqa: E402
from base.png import read_png  # noqa: E402
from base.tree import ROOT  # noqa: E402
from base.versions import take_newest  # noqa: E402

SKIPPED = 77
PAGE = (ROOT / "docs" / "guide" / "engines.md").read_text(encoding="utf-8")
SIZE = 640, 480
# crates.io has raylib's sources, in the crate that binds them to Rust.
RAYLIB = "6.0.0"


def commands(title: str, start: str, page: str = PAGE) -> list[str]:
    section = re.search(rf"^## {title}\n(.*?)(?=^## |\Z)", page, re.MULTILINE | re.DOTALL)[1]
    return [line.strip() for line in section.splitlines() if line.startswith(f"    {start}")]


def copied(folder: Path, name: str) -> Path:
    """A copy of the repository in an empty folder, as far as an example needs it, beside which its commands are typed;
    and the program `heights`."""
    shutil.rmtree(folder, ignore_errors=True)
    here = folder / "hashnoise"
    here.mkdir(parents=True)
    for part in ("CMakeLists.txt", "catalog", "conformance", "glsl", "include", "src", "tools"):
        (here / part).symlink_to(ROOT / part)
    shutil.copytree(EXAMPLES / name, here / "examples" / name, ignore=shutil.ignore_patterns("target"))
    compile_heights(folder)
    return here


def compile_heights(folder: Path) -> None:
    twin.compile_program("heights", EXAMPLES / "heights.cpp", folder / "heights")


def heights(folder: Path, name: str) -> array.array:
    return array.array("f", subprocess.run([folder / "heights", name], check=True, stdout=subprocess.PIPE).stdout)


def lavapipe() -> str:
    """Its description for the loader of Vulkan."""
    drivers = glob.glob("/usr/share/vulkan/icd.d/lvp_icd*.json")
    if not drivers:
        raise unittest.SkipTest("there is no lavapipe")
    return drivers[0]


class Example(unittest.TestCase):
    """It is built and run by the commands of the page."""

    work: Path
    name: str
    programs: tuple[str, ...] = ()

    @classmethod
    def setUpClass(cls):
        for program in ("cmake", "g++", "ninja", "Xvfb", *cls.programs):
            if shutil.which(program) is None:
                raise unittest.SkipTest(f"there is no {program}")
        cls.variables = {**os.environ, "CMAKE_GENERATOR": "Ninja"}
        cls.prepare()
        cls.folder = cls.work / cls.name
        cls.copy = copied(cls.folder, cls.name)
        configure, build = commands(cls.title, "cmake")
        cls.build, cls.program = build.split(" && ")
        for command in (configure, cls.build):
            cls.type(command)

    @classmethod
    def prepare(cls):
        pass

    @classmethod
    def type(cls, command: str):
        done = subprocess.run(command, shell=True, cwd=cls.folder, env=cls.variables, capture_output=True, text=True,
                              check=False)
        if done.returncode != 0:
            raise AssertionError(f"{command}:\n{done.stdout}\n{done.stderr}")

    def shown(self, wanted) -> tuple[list[bytes], str]:
        with Screen(*SIZE) as screen:
            return screen.run([self.folder / self.program], wanted, variables=self.variables)

    @staticmethod
    def whole(pixels: list[bytes]) -> bool:
        return all(any(row) for row in pixels)

    def assert_the_land_is_where_the_twin_has_it(self, pixels: list[bytes], least: float):
        """The sea is bluer than it is red, and the land is not. Heights below least may be either."""
        land = heights(self.folder, self.name)
        self.assertEqual(len(land), SIZE[0] * SIZE[1])
        flat = b"".join(pixels)
        wrong = [i for i, height in enumerate(land)
                 if (flat[3 * i + 2] > flat[3 * i] + 8) != (height < 0.0) and abs(height) >= least]
        self.assertEqual(len(wrong), 0, f"first at {wrong and divmod(wrong[0], SIZE[0])}")
        self.assertGreater(sum(height < 0.0 for height in land), 1000)
        self.assertGreater(sum(height > 0.0 for height in land), 1000)


class Raylib(Example):
    name = "raylib"
    title = "raylib"
    programs = ("cargo", "pkg-config")

    @classmethod
    def prepare(cls):
        """Installs raylib, as its users do."""
        for library in ("xcursor", "xi", "xinerama", "xrandr", "gl"):
            if subprocess.run(["pkg-config", "--exists", library], check=False).returncode != 0:
                raise unittest.SkipTest(f"pkg-config finds no {library}, which raylib is built with")
        prefix = cls.work / f"raylib-{RAYLIB}"
        if not prefix.is_dir():
            sources = cls.sources()
            build = cls.work / "raylib-build"
            shutil.rmtree(build, ignore_errors=True)
            for command in (["cmake", "-S", sources, "-B", build, "-DBUILD_EXAMPLES=OFF", "-DCMAKE_BUILD_TYPE=Debug"],
                            ["cmake", "--build", build], ["cmake", "--install", build, "--prefix", f"{prefix}.new"]):
                done = subprocess.run(command, env=cls.variables, capture_output=True, text=True, check=False)
                if done.returncode != 0:
                    raise AssertionError(f"{command}:\n{done.stdout}\n{done.stderr}")
            os.rename(f"{prefix}.new", prefix)
        cls.variables["CMAKE_PREFIX_PATH"] = str(prefix)
        cls.variables["LIBGL_ALWAYS_SOFTWARE"] = "1"

    @staticmethod
    def sources() -> Path:
        done = subprocess.run(["cargo", "info", f"raylib-sys@{RAYLIB}"], capture_output=True, text=True, check=False)
        home = os.environ.get("CARGO_HOME", Path.home() / ".cargo")
        found = glob.glob(f"{home}/registry/src/*/raylib-sys-{RAYLIB}/raylib")
        if not found:
            raise unittest.SkipTest(f"crates.io gave no raylib-sys {RAYLIB}: {done.stderr.strip()[-200:]}")
        return Path(found[0])

    def test_the_islands(self):
        pixels, output = self.shown(self.whole)
        self.assertNotIn("WARNING: SHADER", output)
        self.assert_the_land_is_where_the_twin_has_it(pixels, 1e-5)
        library = (self.folder / self.program).parent / "fbm_d2d.single.glsl"
        own = library.read_text()
        library.write_text(own.replace("0x85EBCA77u", "0x85EBCA79u"))
        self.addCleanup(library.write_text, own)
        other, _ = self.shown(self.whole)
        with self.assertRaises(AssertionError):
            self.assert_the_land_is_where_the_twin_has_it(other, 1e-5)

    def test_the_lines_of_the_page(self):
        """They stand in the program, but for names; and their command makes the file."""
        command, = commands("raylib", "hashnoise/tools")
        self.type(command)
        self.assertTrue((self.folder / "fbm2d.single.glsl").is_file())
        lines = re.search(r"^```c\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)[1]
        source = (EXAMPLES / "raylib" / "main.c").read_text()
        body = re.search(r"static Shader load_shader.*?\n}\n", source, re.DOTALL)[0]
        changed = source.replace(body, "static Shader load_shader(const char *library_path, const char *path) {\n"
                                 f"(void)path;\n(void)library_path;\n{lines}\nreturn shader;\n}}\n")
        program = self.copy / "examples" / "raylib" / "main.c"
        program.write_text(changed)
        shutil.copy(self.folder / "fbm2d.single.glsl", (self.folder / self.program).parent)
        noise = (self.folder / self.program).parent / "noise.fs"
        noise.write_text(noise.read_text().replace("hn_fbm_d(", "vec3(hn_fbm(").replace("uint(seed))", "uint(seed)))"))
        self.type(self.build)
        pixels, output = self.shown(self.whole)
        self.assertNotIn("WARNING: SHADER", output)
        self.assert_the_land_is_where_the_twin_has_it(pixels, 1e-5)


class Webgl(unittest.TestCase):
    """The page, as its commands serve it, in Chromium: each pixel is as bright as the twin has it."""

    work: Path

    def setUp(self):
        self.browser = chromium.found()
        if self.browser is None:
            self.skipTest("there is no chromium")
        self.folder = self.work / "webgl"
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        (self.folder / "hashnoise").symlink_to(ROOT)
        shutil.copy(EXAMPLES / "webgl" / "index.html", self.folder)
        command, = commands("A page by itself", "hashnoise/tools")
        subprocess.run(command, shell=True, cwd=self.folder, check=True, stdout=subprocess.DEVNULL)
        compile_heights(self.folder)

    def reds(self) -> bytes:
        """The pixels that the page draws, by rows from the bottom: a script makes it write pixels and errors into
        itself."""
        page = self.folder / "index.html"
        text = page.read_text()
        page.write_text(text.replace("</script>", """
          const bytes = new Uint8Array(4 * 640 * 480);
          gl.readPixels(0, 0, 640, 480, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
          document.title = "drawn:" + btoa(Array.from(bytes.filter((_, i) => i % 4 === 0),
                                                      (byte) => String.fromCharCode(byte)).join(""));</script>"""))
        handler = functools.partial(http.server.SimpleHTTPRequestHandler, directory=self.folder)
        handler.log_message = lambda *_: None
        with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            command = chromium.command(self.browser, self.folder / "profile", "--dump-dom",
                                       "--virtual-time-budget=20000")
            done = subprocess.run([*command, f"http://127.0.0.1:{server.server_port}/"], capture_output=True, text=True,
                                  check=True, timeout=120)
            server.shutdown()
        page.write_text(text)
        drawn = re.search("drawn:([^<]*)", done.stdout)
        return base64.b64decode(drawn[1]) if drawn else b""

    def wrong(self) -> int:
        """How many pixels are not as bright as they should be; a float may be rounded to either byte beside it."""
        land = heights(self.folder, "webgl")
        reds = self.reds()
        self.assertEqual(len(reds), len(land))
        rows = (reds[start:start + SIZE[0]] for start in range(len(reds) - SIZE[0], -1, -SIZE[0]))
        return sum(abs(red - 255.0 * min(max(0.5 + height, 0.0), 1.0)) > 0.51
                   for red, height in zip(b"".join(rows), land))

    def test_each_pixel_is_as_the_twin_has_it(self):
        self.assertEqual(self.wrong(), 0)
        library = self.folder / "fbm2d.single.glsl"
        library.write_text(library.read_text().replace("0x85EBCA77u", "0x85EBCA79u"))
        self.assertGreater(self.wrong(), 100_000)


class Bevy(unittest.TestCase):
    """The program, built by cargo, in a window on lavapipe: each pixel of the picture that it writes is as the twin has
    it."""

    work: Path
    CLEAR = ((0.72, 0.83, 0.93), (0.2, 0.42, 0.75))  # below and above, as assets/shaders/clouds.wgsl has them

    def setUp(self):
        for program in ("cargo", "Xvfb"):
            if shutil.which(program) is None:
                self.skipTest(f"there is no {program}")
        self.variables = {**os.environ, "VK_ICD_FILENAMES": lavapipe(), "WGPU_BACKEND": "vulkan",
                          "CARGO_TARGET_DIR": str(self.work / "bevy-target")}
        self.folder = self.work / "bevy"
        self.copy = copied(self.folder, "bevy")

    def type(self, command: str):
        return subprocess.run(command, shell=True, cwd=self.folder, env=self.variables, capture_output=True, text=True,
                              check=False)

    def picture(self, command: str) -> bytes:
        file = self.folder / "clouds.png"
        file.unlink(missing_ok=True)
        with Screen(1280, 720) as screen:
            self.variables["DISPLAY"] = screen.display
            done = self.type(f"{command} -- {file}")
        self.assertTrue(file.is_file(), done.stdout + done.stderr)
        width, height, pixels = read_png(file)
        self.assertEqual((done.returncode, width, height), (0, 1280, 720))
        return pixels

    def wrong(self, pixels: bytes) -> int:
        """How many pixels are more than a step of 255 from what they should be."""
        thickness = heights(self.folder, "bevy")
        self.assertGreater(max(thickness) - min(thickness), 0.5)

        def byte(linear: float) -> float:
            return 255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055)

        count = 0
        for i, thick in enumerate(thickness):
            up = 1 - (i // 1280 + 0.5) / 720
            clear = (low + (high - low) * up for low, high in zip(*self.CLEAR))
            count += any(abs(pixels[3 * i + channel] - byte(colour + (1 - colour) * thick)) > 1
                         for channel, colour in enumerate(clear))
        return count

    def test_each_pixel_is_as_the_twin_has_it(self):
        command, = commands("Bevy and wgpu", "cd hashnoise/examples/bevy")
        before, _, run = command.rpartition(" && ")
        fetched = self.type("cargo fetch --manifest-path hashnoise/examples/bevy/Cargo.toml")
        if fetched.returncode != 0:
            self.skipTest(f"crates.io gave no Bevy: {fetched.stderr.strip()[-200:]}")
        self.assertEqual(self.wrong(self.picture(f"{before} && {run}")), 0)
        library = self.copy / "examples/bevy/assets/shaders/hashnoise.wgsl"
        library.write_text(library.read_text().replace("0x85EBCA77u", "0x85EBCA79u"))
        self.assertGreater(self.wrong(self.picture(f"cd hashnoise/examples/bevy && {run}")), 100_000)


class Vulkan(Example):
    name = "vulkan"
    title = "Vulkan"
    programs = ("glslangValidator", "xwininfo")

    @classmethod
    def prepare(cls):
        cls.variables["VK_ICD_FILENAMES"] = lavapipe()
        if glob.glob("/usr/share/vulkan/explicit_layer.d/VkLayer_khronos_validation.json"):
            cls.variables["VK_INSTANCE_LAYERS"] = "VK_LAYER_KHRONOS_validation"

    def test_the_land(self):
        titles = []

        def whole_with_its_title(pixels):
            done = subprocess.run(["xwininfo", "-root", "-tree"], capture_output=True, text=True, check=False,
                                  env={**os.environ, "DISPLAY": screen.display})
            titles.extend(re.findall(r'"(-?\d+), (-?\d+): (\S+) high"', done.stdout))
            return self.whole(pixels) and bool(titles)

        with Screen(*SIZE) as screen:
            pixels, output = screen.run([self.folder / self.program], whole_with_its_title, variables=self.variables)
        self.assertEqual(output, "")  # the validation has nothing to report
        self.assert_the_land_is_where_the_twin_has_it(pixels, 0.0)
        x, y, height = titles[-1]
        self.assertEqual(subprocess.run([self.folder / "heights", self.name, x, y], check=True, text=True,
                                        stdout=subprocess.PIPE).stdout.strip(), height)


class Cuda(unittest.TestCase):
    """The program is built by the commands of the page. Where there is no GPU it states that, and a CPU runs the PTX of
    its kernel."""

    work: Path
    CALLER = """
void fill(void*);
int main(void) {
  static float heights[640 * 480];
  for (ntid_x = 128, ctaid_y = 0; ctaid_y < 480; ++ctaid_y)
    for (ctaid_x = 0; ctaid_x < 5; ++ctaid_x)
      for (tid_x = 0; tid_x < ntid_x; ++tid_x) fill(heights);
  return fwrite(heights, sizeof heights, 1, stdout) != 1;
}
"""

    def setUp(self):
        try:
            self.nvcc = cuda.toolkit() / "bin" / "nvcc"
        except Missing as why:
            self.skipTest(str(why))
        self.folder = self.work / "cuda"
        self.copy = copied(self.folder, "cuda")

    def of_the_kernel(self) -> array.array:
        """The map that it fills."""
        ptx_file, source, program = (self.folder / f"kernel{suffix}" for suffix in (".ptx", ".c", ""))
        subprocess.run([self.nvcc, "-std=c++20", "-arch=sm_75", f"-I{self.copy / 'include'}", "-ptx", "-o", ptx_file,
                        self.copy / "examples" / "cuda" / "main.cu"], check=True)
        text = "#include <stdio.h>\n" + ptx.to_c(ptx_file.read_text(encoding="ascii")) + self.CALLER
        source.write_text(text.replace("const void*", "void*"), encoding="ascii")
        subprocess.run(["gcc", "-O1", *ptx.FLAGS, source, "-o", program, "-lm"], check=True)
        return array.array("f", subprocess.run([program], check=True, stdout=subprocess.PIPE).stdout)

    def test_the_kernel_has_the_heights_of_the_twin(self):
        self.assertEqual(self.of_the_kernel(), heights(self.folder, "cuda"))
        main = self.copy / "examples" / "cuda" / "main.cu"
        main.write_text(main.read_text().replace("0.5f, 7u", "0.5f, 8u"))
        self.assertNotEqual(self.of_the_kernel(), heights(self.folder, "cuda"))

    def test_the_program_runs(self):
        page = (ROOT / "docs" / "guide" / "gpu-computing.md").read_text()
        configure, build = commands("Perlin noise in CUDA and HIP", "cmake", page)
        for command in (configure, build):
            done = subprocess.run(command, shell=True, cwd=self.folder, capture_output=True, text=True, check=False,
                                  env={**os.environ, "CUDACXX": str(self.nvcc), "CUDAFLAGS": "-Werror all-warnings"})
            self.assertIn(done.returncode, (0, 3), done.stdout + done.stderr)
        if done.returncode:
            self.assertIn("heights: there is no GPU that CUDA can use: ", done.stderr)
        else:
            self.assertIn("\n0 of 307200 heights differ\n", done.stdout)


class Screens(unittest.TestCase):
    work: Path

    def test_a_program_that_draws_nothing(self):
        try:
            with Screen(*SIZE) as screen:
                pixels, output = screen.run(["sh", "-c", "echo nothing; exit 1"], Example.whole)
        except Absent as reason:
            self.skipTest(str(reason))
        self.assertFalse(Example.whole(pixels))
        self.assertEqual(output, "nothing\n")


def main(arguments: list[str]) -> int:
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    example = globals()[arguments[1]]
    example.work = Path(arguments[0]).resolve()
    example.work.mkdir(parents=True, exist_ok=True)
    result = unittest.TextTestRunner(verbosity=2).run(unittest.defaultTestLoader.loadTestsFromTestCase(example))
    if result.wasSuccessful() and result.skipped:
        print(f"skipped: {result.skipped[0][1]}")
        return SKIPPED
    return 0 if result.wasSuccessful() else 1


if __name__ == "__main__":
    take_newest("cargo")
    sys.exit(main(sys.argv[1:]))
