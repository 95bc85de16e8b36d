"""The Conan package of a copy of the repository (docs/guide/build-systems.md). tools/pack registries makes ConanCenter's
recipe of the same text."""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain
from conan.tools.files import copy, load, rmdir, save
from conan.tools.layout import basic_layout

required_conan_version = ">=2.0"


class HashnoiseConan(ConanFile):
    name = "hashnoise"
    description = "Procedural noise from hash functions, for shaders and C++"
    license = "MIT"
    topics = ("noise", "procedural", "shaders", "glsl", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    no_copy_source = True

    # begin: of a copy
    def set_version(self):
        # It stands once, in the file that every shader includes.
        config = load(self, os.path.join(self.recipe_folder, "..", "..", "glsl", "hashnoise", "config.glsl"))
        self.version = ".".join(re.findall(r"^#define HN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", config, re.MULTILINE))

    def export_sources(self):
        top = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE", "glsl/*", "include/*", "tools/*.in"):
            copy(self, pattern, top, os.path.join(self.export_sources_folder, "src"))
    # end: of a copy

    def layout(self):
        basic_layout(self, src_folder="src")

    def package_id(self):
        self.info.clear()

    def validate(self):
        check_min_cppstd(self, 20)

    def generate(self):
        CMakeToolchain(self).generate()

    def build(self):
        CMake(self).configure(variables={"HASHNOISE_CONFORMANCE": "OFF", "HASHNOISE_GRID": "OFF",
                                         "CMAKE_INSTALL_DATADIR": "res", "CMAKE_INSTALL_DOCDIR": "licenses"})

    def package(self):
        CMake(self).install()
        # Conan writes its own files for CMake and pkg-config.
        rmdir(self, os.path.join(self.package_folder, "res"))
        save(self, os.path.join(self.package_folder, self._module),
             'set(hashnoise_GLSL_DIR "${CMAKE_CURRENT_LIST_DIR}/../include")\n')

    def package_info(self):
        self.cpp_info.set_property("cmake_build_modules", [self._module])
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []

    @property
    def _module(self):
        return os.path.join("res", "hashnoise-glsl-dir.cmake")
