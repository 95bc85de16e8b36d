"""The Conan package: headers and GLSL, with the CMake files of `cmake --install` (docs/guide/build-systems.md)."""

import re
from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain
from conan.tools.files import copy, load

TOP = Path("..", "..")  # of the repository, seen from here


class Hashnoise(ConanFile):
    name = "hashnoise"
    description = "Procedural noise from hash functions, for shaders and C++"
    topics = ("noise", "procedural", "shaders", "glsl", "header-only")
    license = "MIT"
    url = "https://example.com/hashnoise"
    homepage = "https://example.com/hashnoise"
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    no_copy_source = True

    def set_version(self):
        # It stands once, in the file that every shader includes.
        config = load(self, Path(self.recipe_folder, TOP, "glsl", "hashnoise", "config.glsl"))
        self.version = ".".join(re.findall(r"^#define HN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", config, re.MULTILINE))

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "glsl/*", "include/*", "tools/*.in", "vectors/*"):
            copy(self, pattern, Path(self.recipe_folder, TOP), self.export_sources_folder)
        made = Path(self.recipe_folder, TOP, "build", "vectors")  # by tools/make vectors (docs/develop/publishing.md)
        copy(self, "*.json", made, Path(self.export_sources_folder, "vectors"))

    def package_id(self):
        self.info.clear()  # one package for every compiler

    def generate(self):
        CMakeToolchain(self).generate()

    def package(self):
        cmake = CMake(self)
        cmake.configure(variables={"HASHNOISE_CONFORMANCE": "OFF", "HASHNOISE_GRID": "OFF",
                                   "CMAKE_INSTALL_DOCDIR": "licenses"})  # the folder where Conan wants LICENSE
        cmake.install()

    def package_info(self):
        # find_package finds what was installed, which has hashnoise_GLSL_DIR, too.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["share/cmake/hashnoise"]
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
