#!/usr/bin/env python3
"""The installed program, moved away from where it was built and installed, and what is installed of builds that have
not built all of it. Usage: install_test.py CMAKE BUILD SOURCE"""

import os
import pathlib
import re
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


def pkg_config(folder, *arguments):
    done = subprocess.run(["pkg-config", *arguments], env={**os.environ, "PKG_CONFIG_PATH": folder},
                          stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout.strip()


class WithoutPrograms(unittest.TestCase):
    """Installs a build of the library alone, which tests share; find_package finds it."""

    options = ()

    @classmethod
    def setUpClass(cls):
        cls.build = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        done = cls.configure(cls.build, SOURCE)
        assert done.returncode == 0, done.stderr

    def setUp(self):
        self.scratch = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.project = self.scratch / "project"
        self.project.mkdir()

    @classmethod
    def configure(cls, build, source, *options):
        return subprocess.run([CMAKE, "-G", "Ninja", "-S", source, "-B", build, "-DHASHNOISE_CONFORMANCE=OFF", *cls.options,
                               *options], capture_output=True, text=True, check=False)

    def built(self):
        library = self.build / "src/grid/libhashnoise-grid.a"
        library.write_text("a library")  # it is only copied
        self.addCleanup(library.unlink)

    def installed(self, name, *options):
        prefix = self.scratch / name
        done = subprocess.run([CMAKE, "--install", self.build, "--prefix", prefix, *options], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return {path.relative_to(prefix).as_posix() for path in prefix.rglob("*")}, done.stdout

    def found(self, name, what="", required="REQUIRED"):
        (self.project / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.16)\nproject(p LANGUAGES CXX)\n"
            f"find_package(hashnoise {required} {what})\nmessage(STATUS \"found: ${{hashnoise_FOUND}};\")\n"
            "foreach(part hashnoise grid)\n  if(TARGET hashnoise::${part})\n    message(STATUS \"has ${part};\")\n"
            "  endif()\nendforeach()\n")
        done = subprocess.run([CMAKE, "-G", "Ninja", "-S", self.project, "-B", self.scratch / f"{name}-found",
                               f"-DCMAKE_PREFIX_PATH={self.scratch / name}"], capture_output=True, text=True, check=False)
        return done.returncode, " ".join((done.stdout + done.stderr).split())  # CMake breaks lines


class Options(WithoutPrograms):
    def test_tests_without_what_they_need_are_refused(self):
        done = self.configure(self.scratch / "build", SOURCE, "-DHASHNOISE_TESTS=ON")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("HASHNOISE_TESTS is ON, and HASHNOISE_CONFORMANCE, which the tests need, is OFF.",
                      " ".join(done.stderr.split()))

    def test_who_lacks_a_package_leaves_out_what_needs_it_by_one_option(self):
        build = self.scratch / "build"
        done = self.configure(build, SOURCE, "-DHASHNOISE_CONFORMANCE=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("CLI11", done.stderr)
        self.assertIn("-DHASHNOISE_CONFORMANCE=OFF builds the library without them", done.stdout)
        done = self.configure(build, SOURCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("hn-conform", done.stdout)


class Headers(WithoutPrograms):
    options = ("-DHASHNOISE_GRID=OFF", "-DCMAKE_INSTALL_LIBDIR=lib/machine")

    def test_nothing_depends_on_the_machine(self):
        files, _ = self.installed("headers")
        self.assertLess({"share/cmake/hashnoise/hashnoise-config.cmake", "share/pkgconfig/hashnoise.pc"}, files)
        self.assertNotIn("lib", files)
        status, said = self.found("headers")
        self.assertEqual(status, 0, said)
        self.assertIn("has hashnoise;", said)

    def test_pkg_config_finds_the_folders_of_each_layout(self):
        apart = self.scratch / "apart"
        for name, data, include, moves in (("usual", "share", "include", True), ("deep", "share/x/y", "a/b", True),
                                           ("include-apart", "share", apart / "include", True),
                                           ("share-apart", apart / "share", "include", False)):
            with self.subTest(name):
                prefix = self.scratch / name
                self.build = self.scratch / "build"
                done = self.configure(self.build, SOURCE, f"-DCMAKE_INSTALL_PREFIX={prefix}",
                                      f"-DCMAKE_INSTALL_DATADIR={data}", f"-DCMAKE_INSTALL_INCLUDEDIR={include}")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.installed(name)
                if moves:
                    prefix = prefix.rename(prefix.with_name(f"{name}-moved"))
                for what in ("--cflags-only-I", "--variable=includedir", "--variable=glsl_dir"):
                    folder = pkg_config(prefix / data / "pkgconfig", what, "hashnoise").removeprefix("-I")
                    self.assertEqual(pathlib.Path(folder).resolve(), (prefix / include).resolve(), what)
                for file in ("hashnoise.hpp", "hashnoise.glsl"):
                    self.assertTrue((prefix / include / "hashnoise" / file).is_file())

    def test_vectors_are_those_of_the_source_alone(self):
        source = self.scratch / "source"
        for name in ("CMakeLists.txt", "LICENSE", "glsl", "include", "tools/hashnoise-config.cmake.in",
                     "tools/hashnoise.pc.in"):
            (source / name).parent.mkdir(parents=True, exist_ok=True)
            (source / name).symlink_to(pathlib.Path(SOURCE, name))
        self.build = self.scratch / "build-of-source"
        done = self.configure(self.build, source)
        self.assertEqual(done.returncode, 0, done.stderr)
        for folder, has in (("build/vectors", False), ("vectors", True)):
            with self.subTest(folder):
                (source / folder).mkdir(parents=True)
                (source / folder / "index.json").write_text("{}\n")
                self.assertEqual("share/hashnoise/vectors/index.json" in self.installed(folder)[0], has)


class PartsOfABuild(WithoutPrograms):
    def test_headers_alone(self):
        files, said = self.installed("nothing-built")
        self.assertLess({"include/hashnoise/hashnoise.hpp", "include/hashnoise/grid.hpp",
                         "include/hashnoise/detail/macros_begin.h", "share/doc/hashnoise/LICENSE"}, files)
        self.assertFalse({file for file in files if "field.hpp" in file or "libhashnoise" in file or "grid-t" in file
                          or "grid.pc" in file})
        self.assertIn("hashnoise::grid is not installed, since it was not built", said)
        status, said = self.found("nothing-built")
        self.assertEqual(status, 0, said)
        self.assertIn("has hashnoise;", said)
        self.assertNotIn("has grid;", said)
        self.assertIn("found: 1;", self.found("nothing-built", "COMPONENTS headers OPTIONAL_COMPONENTS grid other")[1])

    def test_a_version_serves_those_who_ask_for_an_older_one_of_the_same_major_number(self):
        version_file = self.build / "hashnoise-config-version.cmake"
        version = re.search(r'PACKAGE_VERSION "(\d+)\.(\d+)', version_file.read_text())
        major, minor = int(version[1]), int(version[2])
        later = version_file.read_text().replace(f'"{major}.{minor}.', f'"{major}.{minor + 1}.')
        self.addCleanup(version_file.write_text, version_file.read_text())
        version_file.write_text(later)
        self.installed("later")
        for wanted, status in ((f"{major}.{minor}", 0), (f"{major}.{minor + 2}", 1), (f"{major + 1}.0", 1)):
            with self.subTest(wanted):
                self.assertEqual(self.found("later", required=f"{wanted} REQUIRED")[0], status)

    def test_a_component_that_is_missing_is_named(self):
        self.installed("nothing-built")
        grid = ("the component grid is not installed: configure hashnoise with -DHASHNOISE_GRID=ON, build it, and "
                "install it")
        other = "hashnoise has no component other; it has headers and grid"
        for what, reason in (("grid", grid), ("headers grid", grid), ("grid other", grid), ("headers other", other)):
            with self.subTest(what):
                status, said = self.found("nothing-built", f"COMPONENTS {what}")
                self.assertNotEqual(status, 0)
                self.assertIn(f"Reason given by package: {reason}", said)
                status, said = self.found("nothing-built", f"COMPONENTS {what}", "")  # a warning
                self.assertEqual(status, 0, said)
                self.assertIn(f"Reason given by package: {reason}", said)
                self.assertIn("found: 0;", said)
                self.assertNotIn("has hashnoise;", said)  # no half of it

    def test_the_library_where_it_was_built(self):
        self.built()
        files, said = self.installed("grid-built")
        self.assertLess({"include/hashnoise/field.hpp", "lib/libhashnoise-grid.a"}, files)
        self.assertNotIn("not built", said)
        for what in ("COMPONENTS grid", "COMPONENTS headers grid"):
            status, said = self.found("grid-built", what)
            self.assertEqual(status, 0, said)
            self.assertIn("has hashnoise;", said)
            self.assertIn("has grid;", said)
        self.assertIn("hashnoise has no component other", self.found("grid-built", "COMPONENTS other")[1])
        prefix = (self.scratch / "grid-built").rename(self.scratch / "moved")
        folders = f"{prefix}/lib/pkgconfig:{prefix}/share/pkgconfig"
        for what, flags in (("--cflags", [f"-I{prefix}/include"]), ("--libs", [f"-L{prefix}/lib", "-lhashnoise-grid"])):
            given = pkg_config(folders, what, "hashnoise-grid").split()
            self.assertEqual([flag[:2] + os.path.normpath(flag[2:]) for flag in given], flags)
        self.assertIn("-pthread", pkg_config(folders, "--static", "--libs", "hashnoise-grid").split())

    def test_a_component(self):
        self.built()
        self.assertNotIn("lib/libhashnoise-grid.a", self.installed("headers", "--component", "headers")[0])
        files, _ = self.installed("grid", "--component", "grid")
        self.assertIn("lib/libhashnoise-grid.a", files)
        self.assertNotIn("include/hashnoise/hashnoise.hpp", files)


if __name__ == "__main__":
    CMAKE, BUILD, SOURCE = sys.argv[1:4]
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
