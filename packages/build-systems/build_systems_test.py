"""The commands of docs/guide/build-systems.md run as they stand there, in an empty folder; the game that comes of it
computes golden values, bit for bit.

    build_systems_test.py ENVIRONMENT WORK CLASS...    with what environment.py makes, in a scratch folder

The page's address leads to a repository that has what the working tree has. Exit status: 0 passed, 1 failed, 77 what a
class needs cannot be had here.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

import environment

TESTS = Path(__file__).resolve().parent
sys.path.insert(0, str(TESTS.parents[1] / "tools" / "lib"))

from base.golden_values import Golden  # noqa: E402
from base.pypi import is_made  # noqa: E402
from base.tree import ROOT, address  # noqa: E402
from ship.registries import files as registries  # noqa: E402

SKIPPED = 77
ADDRESS = f"{address() or 'https://localhost/noise'}.git"
PAGE = (ROOT / "docs" / "guide" / "build-systems.md").read_text(encoding="utf-8").replace("ADDRESS", ADDRESS)
# Files of the repository that a user's build needs.
USED = ("CMakeLists.txt", "LICENSE", "glsl", "include", "meson.build", "packages/conan", "packages/vcpkg", "src",
        "tools/hashnoise-config.cmake.in", "tools/hashnoise-grid.pc.in", "tools/hashnoise.pc.in")
# A library over hashnoise::grid, another over the headers, and who links the first: Perlin noise is 0 at whole positions.
LAND = """#include <hashnoise/field.hpp>
float land(float x) {
  float value = 1.0f;
  hashnoise::Field<2>(hashnoise::Settings{}).fill(hashnoise::Grid<2>{{x, 3.0f}, {1.0f, 1.0f}, {1, 1}}, {&value, 1});
  return value;
}
"""
LAND_OF_HEADERS = """#include <hashnoise/hashnoise.hpp>
float land(float x) { return hashnoise::hn_perlin(hashnoise::vec2(x, 3.0f)); }
"""
MAIN = """#include <cstdio>
float land(float x);
int main() { std::printf("%g\\n", land(5.0f)); }
"""
USER = """cmake_minimum_required(VERSION 3.21)
project(game LANGUAGES CXX)
FIND
add_executable(game main.cpp)
target_link_libraries(game PRIVATE land)
"""
FUNCTIONS = ("noise2d.perlin", "noise3d.simplex", "fbm.fbm2")


def section(title: str) -> str:
    return re.search(rf"^##+ {title}\n(.*?)(?=^##|\Z)", PAGE, re.MULTILINE | re.DOTALL)[1]


def blocks(language: str, title: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", section(title), re.MULTILINE | re.DOTALL)


def commands(title: str) -> list[list[str]]:
    text = re.sub(r"^```.*?^```$", "", section(title), flags=re.MULTILINE | re.DOTALL)
    return [shlex.split(line) for line in text.splitlines() if line.startswith("    ")]


class Way(unittest.TestCase):
    """A folder for a game, the repository that the page's address leads to, and the programs of PyPI."""

    environment: Path
    work: Path
    programs = ("git", "glslangValidator", "ninja", "pkg-config")
    needs_environment = True

    def setUp(self):
        for program in self.programs:
            if shutil.which(program) is None:
                self.skipTest(f"there is no {program}")
        if self.needs_environment and not is_made(self.environment, environment.REQUIREMENTS):
            self.skipTest("build_systems.environment was skipped, or did not run")
        self.folder = self.work / self.id().split(".", 1)[1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.game = self.folder / "game"
        self.game.mkdir(parents=True)
        self.path = os.environ["PATH"]
        self.variables = {**os.environ, "CMAKE_GENERATOR": "Ninja", "GIT_CONFIG_NOSYSTEM": "1",
                          "GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_COUNT": "2",
                          "GIT_CONFIG_KEY_0": f"url.file://{self.folder}/hashnoise.git.insteadOf",
                          "GIT_CONFIG_VALUE_0": ADDRESS, "GIT_CONFIG_KEY_1": "init.defaultBranch",
                          "GIT_CONFIG_VALUE_1": "main"}
        self.make_repository()
        shutil.copy(TESTS / "main.cpp", self.game)

    def make_repository(self):
        repository = self.folder / "hashnoise.git"
        for name in USED:
            (repository / name).parent.mkdir(parents=True, exist_ok=True)
            if (ROOT / name).is_dir():
                shutil.copytree(ROOT / name, repository / name, ignore=shutil.ignore_patterns("__pycache__", "build"))
            else:
                shutil.copy(ROOT / name, repository / name)
        self.call(["git", "init", "--quiet"], repository)
        self.call(["git", "add", "--all"], repository)
        self.call(["git", "-c", "user.name=test", "-c", "user.email=test@example.com", "commit", "--quiet", "--message",
                   "All"], repository)

    def call(self, command: list, folder: Path | None = None, given: str = "", path: str = "") -> str:
        """Runs a command in the folder of the game; path comes before the other places of programs."""
        places = f"{path}:{self.path}" if path else self.path
        program = shutil.which(str(command[0]), path=places)
        self.assertIsNotNone(program, f"there is no program {command[0]}")
        done = subprocess.run([program, *command[1:]], cwd=folder or self.game, input=given, capture_output=True,
                              text=True, check=False, env={**self.variables, "PATH": places})
        self.assertEqual(done.returncode, 0, f"{command}:\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def write(self, name: str, text: str):
        (self.game / name).parent.mkdir(parents=True, exist_ok=True)
        (self.game / name).write_text(text, encoding="utf-8")

    def differing(self, program: Path) -> dict[str, int]:
        """How many golden values of each function the game gets wrong, if any."""
        lines, expected = [], []
        for function in FUNCTIONS:
            golden = Golden(function)
            lines += [" ".join([function, *(f"{word:08x}" for word in words)]) for words in golden.inputs]
            expected += [(function, words[0]) for words in golden.expected]
        self.assertGreater(len(lines), 800)
        values = self.call([program], given="\n".join(lines)).split()
        wrong = {}
        for (function, word), got in zip(expected, values, strict=True):
            if int(got, 16) != word:
                wrong[function] = wrong.get(function, 0) + 1
        return wrong

    def of_registry(self, name: str) -> tuple[Path, Path, str]:
        """A folder of tools/pack registries, the archive that it names, and the address of that archive."""
        archive = self.folder / "v.tar.gz"
        self.call(["git", "archive", "--prefix=hashnoise-1/", "--output", archive, "HEAD"], self.folder / "hashnoise.git")
        with mock.patch.object(registries, "address", return_value="https://github.com/someone/noise"):
            for path, text in registries.package(str(archive)).items():
                self.write(path, text)
            return self.game / name, archive, registries.archive_address()

    def assert_spirv(self, path: Path):
        self.assertEqual(path.read_bytes()[:4], b"\x03\x02\x23\x07")


class CMake(Way):
    """By the CMake of this machine."""

    needs_environment = False

    def cmake(self, *arguments):
        return self.call(["cmake", *arguments])

    def build(self, *options) -> Path:
        self.cmake("-S", ".", "-B", "build", *options)
        self.cmake("--build", "build")
        return self.game / "build" / "game"

    def copied(self):
        self.call(["git", "clone", "--quiet", ADDRESS, "hashnoise"])

    def test_from_git(self):
        from_git, _, _, shader = blocks("cmake", "CMake")
        self.write("CMakeLists.txt", from_git + shader)
        self.write("noise.frag", blocks("glsl", "A shader for Vulkan")[0])
        self.assertEqual(self.differing(self.build()), {})
        self.assert_spirv(self.game / "build" / "noise.spv")

    def test_from_a_copy(self):
        self.copied()
        shutil.rmtree(self.game / "hashnoise" / ".git")  # as in a source archive
        self.write("CMakeLists.txt", blocks("cmake", "CMake")[1])
        self.assertEqual(self.differing(self.build()), {})

    def test_installed(self):
        self.copied()
        for command in commands("CMake"):
            self.call(command)
        shutil.rmtree(self.game / "hashnoise")
        _, _, installed, shader = blocks("cmake", "CMake")
        self.write("CMakeLists.txt", installed + shader)
        self.write("noise.frag", blocks("glsl", "A shader for Vulkan")[0])
        self.assertIn("-DCMAKE_PREFIX_PATH=prefix", section("CMake"))
        self.assertEqual(self.differing(self.build(f"-DCMAKE_PREFIX_PATH={self.game}/prefix")), {})
        self.assert_spirv(self.game / "build" / "noise.spv")
        self.variables["PKG_CONFIG_PATH"] = str(self.game / "prefix" / "share" / "pkgconfig")
        for command in commands("Anything else"):
            self.call(["sh", "-c", " ".join(command)])
        self.assertEqual(self.differing(self.game / "game"), {})
        self.assert_spirv(self.game / "noise.spv")

    def test_a_library_of_yours(self):
        project, config = blocks("cmake", "A library of yours")
        land = self.folder / "land"
        self.call(["git", "clone", "--quiet", ADDRESS, land / "hashnoise"])
        (land / "CMakeLists.txt").write_text(project)
        (land / "land-config.cmake").write_text(config)
        (land / "land.cpp").write_text(LAND)
        self.write("CMakeLists.txt", USER.replace("FIND", "find_package(land REQUIRED)"))
        self.write("main.cpp", MAIN)
        fast = ("-DCMAKE_BUILD_TYPE=Release", "-DHASHNOISE_INSTRUCTION_SETS=native", "-DHASHNOISE_QUICK_BUILD=ON")
        self.cmake("-S", land, "-B", land / "build", *fast)
        self.cmake("--build", land / "build")
        self.cmake("--install", land / "build", "--prefix", "prefix")
        self.assertEqual(self.call([self.build(f"-DCMAKE_PREFIX_PATH={self.game}/prefix")]), "0\n")
        self.write("CMakeLists.txt", USER.replace(
            "FIND", f"find_package(Threads REQUIRED)\ninclude({land}/build/land-targets.cmake)"))
        self.assertEqual(self.call([self.build()]), "0\n")
        # The other answer on the page is for sources that include the headers.
        line, = (" ".join(command) for command in commands("A library of yours"))
        self.assertIn("$<BUILD_INTERFACE:hashnoise::hashnoise>", line)
        (land / "CMakeLists.txt").write_text(project.replace("set(HASHNOISE_INSTALL ON)\n", "").replace(
            "target_link_libraries(land PRIVATE hashnoise::grid)", line).replace(" hashnoise-grid", ""))
        (land / "land.cpp").write_text(LAND_OF_HEADERS)
        self.cmake("-S", land, "-B", land / "without", *fast)
        self.cmake("--build", land / "without")
        self.cmake("--install", land / "without", "--prefix", "without")
        self.assertFalse((self.game / "without" / "include").exists())

    def test_a_changed_constant_is_noticed(self):
        self.copied()
        text = self.game / "hashnoise" / "glsl" / "hashnoise" / "detail" / "word.glsl"
        changed = text.read_text().replace("0x85EBCA77u", "0x85EBCA79u")
        self.assertNotEqual(changed, text.read_text())
        text.write_text(changed)
        self.write("CMakeLists.txt", blocks("cmake", "CMake")[1])
        self.assertEqual(set(self.differing(self.build())), set(FUNCTIONS))


class OldestCMake(CMake):
    """By the oldest CMake that the page promises."""

    needs_environment = True
    test_a_changed_constant_is_noticed = test_a_library_of_yours = None

    def call(self, command, folder=None, given="", path=""):
        return super().call(command, folder, given, str(self.environment / "bin"))

    def test_it_is_the_oldest(self):
        version = re.search(r"\(#cmake\), (\d+\.\d+) and later", PAGE)[1]
        self.assertRegex(self.cmake("--version"), rf"^cmake version {version}\.")
        for text in (*blocks("cmake", "CMake")[:3], (ROOT / "CMakeLists.txt").read_text()):
            self.assertRegex(text, rf"^cmake_minimum_required\(VERSION {version}\b")


class Meson(Way):
    def test_wrap(self):
        wrap, = blocks("ini", "Meson")
        self.write("subprojects/hashnoise.wrap", wrap)
        project, shader = blocks("meson", "Meson")
        self.write("meson.build", project + shader)
        self.write("noise.frag", blocks("glsl", "A shader for Vulkan")[0])
        for command in commands("Meson"):
            output = self.call(command, path=str(self.environment / "bin"))
            if command[1] == "setup":
                self.assertRegex(output, rf"Dependency hashnoise .*found: YES {re.escape(library_version())}\b")
        self.assertEqual(self.differing(self.game / "build" / "game"), {})
        self.assert_spirv(self.game / "build" / "noise.spv")


class Conan(Way):
    def setUp(self):
        super().setUp()
        self.variables["CONAN_HOME"] = str(self.folder / "home")

    def conan(self, *command):
        return self.call([*command], path=str(self.environment / "bin"))

    def test_package(self):
        self.conan("conan", "profile", "detect")
        with (self.folder / "home" / "global.conf").open("a") as configuration:
            configuration.write("tools.cmake.cmaketoolchain:generator=Ninja\n")
        clone, create, *build = commands("Conan")
        self.conan(*clone)
        self.conan(*create)
        requirements, = blocks("ini", "Conan")
        self.assertIn(f"hashnoise/{library_version()}", requirements)
        shutil.rmtree(self.game / "hashnoise")
        self.write("conanfile.txt", requirements)
        _, _, installed, shader = blocks("cmake", "CMake")
        self.write("CMakeLists.txt", installed + shader)
        self.write("noise.frag", blocks("glsl", "A shader for Vulkan")[0])
        for command in build:
            self.conan(*command)
        self.conan("cmake", "--build", "build")
        self.assertEqual(self.differing(self.game / "build" / "game"), {})
        self.assert_spirv(self.game / "build" / "noise.spv")

    def test_its_own_test_can_fail(self):
        self.conan("conan", "profile", "detect")
        clone, create, *_ = commands("Conan")
        self.conan(*clone)
        text = self.game / "hashnoise" / "glsl" / "hashnoise" / "detail" / "word.glsl"
        text.write_text(text.read_text().replace("0x85EBCA77u", "0x85EBCA79u"))
        with self.assertRaisesRegex(AssertionError, "(?s)hn_perlin at .*Error in test"):
            self.conan(*create)

    def test_the_recipe_for_conancenter(self):
        """It gets the archive, tests the package, and puts nothing into it that ConanCenter refuses."""
        recipes, archive, address_ = self.of_registry("conan-center-index")
        data = recipes / "recipes/hashnoise/all/conandata.yml"
        data.write_text(data.read_text().replace(address_, archive.as_uri()))
        self.conan("conan", "profile", "detect")
        create = ("conan", "create", data.parent, "--version", library_version(), "-s")
        with self.assertRaisesRegex(AssertionError, r"Current cppstd \(\w+\) is lower than"):
            self.conan(*create, "compiler.cppstd=17")
        self.conan(*create, "compiler.cppstd=20")
        package, = self.folder.glob("home/p/b/*/p")
        self.assertEqual(refused(package), set())
        self.assertTrue((package / "licenses" / "LICENSE").is_file())
        for name in ("share/x", "lib/hashnoise-config.cmake", "lib/hashnoise.pc"):
            (package / name).parent.mkdir(exist_ok=True)
            (package / name).touch()
        self.assertEqual(refused(package), {"share", "hashnoise-config.cmake", "hashnoise.pc"})
        archive.write_bytes(archive.read_bytes() + b"\0")
        self.conan("conan", "remove", "--confirm", "hashnoise")
        with self.assertRaisesRegex(AssertionError, "sha256 hash failed"):
            self.conan(*create, "compiler.cppstd=20")


def refused(package: Path) -> set[str]:
    """The names that ConanCenter takes in no package: other folders, and files of CMake, pkg-config, libtool and MSVC."""
    folders = {path.name for path in package.iterdir() if path.is_dir()}
    return folders - {"bin", "include", "lib", "licenses", "res"} | {
        path.name for path in package.rglob("*") if re.search(r"^Find.*\.cmake$|onfig\.cmake$|\.(pc|la|pdb)$", path.name)}


class Vcpkg(Way):
    needs_environment = False
    programs = (*Way.programs, "vcpkg")

    def install_port(self, port: str = "hashnoise", ports: Path | None = None) -> Path:
        """Installs the port by the page's commands, or by another folder, and returns the folder of what it installed."""
        clone, install = commands("vcpkg")
        self.call(clone)
        install[install.index("hashnoise")] = port
        if ports:
            install[-1] = f"--overlay-ports={ports}"
        output = self.call([*install, f"--x-install-root={self.folder}/installed", "--binarysource=clear"])
        self.assertNotIn("portfile.cmake: warning", output)
        triplet, = (path for path in (self.folder / "installed").iterdir() if path.name != "vcpkg")
        return triplet

    def test_port(self):
        triplet = self.install_port()
        manifest = self.game / "hashnoise" / "packages" / "vcpkg" / "hashnoise" / "vcpkg.json"
        written = manifest.read_text()
        self.call(["vcpkg", "format-manifest", manifest])
        self.assertEqual(manifest.read_text(), written)  # the registry's tests want this form
        _, _, installed, shader = blocks("cmake", "CMake")
        self.write("CMakeLists.txt", installed + shader)
        self.write("noise.frag", blocks("glsl", "A shader for Vulkan")[0])
        self.call(["cmake", "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={triplet}"])
        self.call(["cmake", "--build", "build"])
        self.assertEqual(self.differing(self.game / "build" / "game"), {})
        self.assert_spirv(self.game / "build" / "noise.spv")

    def test_the_port_for_the_registry(self):
        """It gets the archive, which is among the downloads here."""
        ports, archive, _ = self.of_registry("vcpkg/ports")
        downloads = self.folder / "downloads"
        downloads.mkdir()
        self.variables["VCPKG_DOWNLOADS"] = str(downloads)
        cached = shutil.copy(archive, downloads / f"someone-noise-v{library_version()}.tar.gz")
        triplet = self.install_port(ports=ports)
        for name in ("include/hashnoise/fbm2d.glsl", "share/hashnoise/copyright", "share/hashnoise/hashnoise-config.cmake"):
            self.assertTrue((triplet / name).is_file(), name)
        for folder in (triplet.parent, self.game / "hashnoise"):
            shutil.rmtree(folder)
        cached.write_bytes(archive.read_bytes() + b"\0")
        with self.assertRaises(AssertionError):
            self.install_port(ports=ports)

    def test_grid(self):
        triplet = self.install_port("hashnoise[grid]")
        for build in ("Release", "Debug"):
            self.call(["cmake", "-S", ROOT / "conformance" / "testing" / "consumer", "-B", build,
                       f"-DCMAKE_BUILD_TYPE={build}", f"-DCMAKE_PREFIX_PATH={triplet}"])
            self.call(["cmake", "--build", build])
            self.call([self.game / build / "grid"])


def library_version() -> str:
    config = (ROOT / "glsl" / "hashnoise" / "config.glsl").read_text()
    return ".".join(re.findall(r"^#define HN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", config, re.MULTILINE))


class Files(unittest.TestCase):
    """Tests that need no tool."""

    def test_the_usage_of_the_port_names_what_the_page_does(self):
        usage = (ROOT / "packages" / "vcpkg" / "hashnoise" / "usage").read_text()
        for name in ("find_package(hashnoise", "hashnoise::hashnoise", "hashnoise_GLSL_DIR"):
            self.assertIn(name, usage)
            self.assertIn(name, section("CMake"))


def main(arguments: list[str]) -> int:
    if len(arguments) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    Way.environment, Way.work = (Path(argument).resolve() for argument in arguments[:2])
    suite = unittest.TestSuite(unittest.defaultTestLoader.loadTestsFromTestCase(globals()[name])
                               for name in arguments[2:])
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    if result.wasSuccessful() and len(result.skipped) == result.testsRun:
        print(f"skipped: {result.skipped[0][1]}")
        return SKIPPED
    return 0 if result.wasSuccessful() and not result.skipped else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
