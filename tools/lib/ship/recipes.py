"""The packages of tools/pack: a row for each package. A row counts while its folder is here."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Option(NamedTuple):
    """An option of one package; its package() takes its value."""
    metavar: str
    help: str


class Recipe(NamedTuple):
    """A package is a folder with files, or one zip file of that folder, unless it has a command of its own."""
    line: str                            # its product
    name: str = ""                       # of the folder and of the zip file, before -VERSION
    of_zip: str = ""                     # that of the zip file, if it is another one
    more: str = ""                       # the rest of its help
    has_vectors: bool = False            # which a compiler is needed to make
    options: dict[str, Option] = {}
    is_zip: bool = False                 # always: the files are for a folder that a user has
    command: str = ""                    # the module of its own command line

    @property
    def zip_name(self) -> str:
        return self.of_zip or self.name

    @property
    def needs(self) -> str:
        return ("Python is needed, and to make the vectors g++ with the library fmt." if self.has_vectors else
                "Nothing but Python is needed.")

    @property
    def has_folder(self) -> bool:
        """Whether a folder is written: not with --zip."""
        return bool(self.name) and not self.is_zip


RECIPES = {name: recipe for name, recipe in {
    "npm": Recipe("the npm package: GLSL and WGSL as modules, nodes of three.js, heights", command="ship.npm.command"),
    "python": Recipe("the Python package, as a wheel", command="ship.python.command"),
    "rust": Recipe(
        "the Rust crate", "hashnoise", "hashnoise-rust",
        "It has tools/pick's text of the functions in most use, with HN_FAST and with HN_FIXED, and "
        "the vectors to which `cargo test` holds it. It takes some minutes. --only place,perlin,hash makes some "
        "modules, which is for tests: place and hash are always needed.",
        True, {"only": Option("MODULES", "these modules, with commas between")}),
    "wesl": Recipe(
        "the package for WESL, for npm and for cargo", "hashnoise_wgsl",
        more="npm and cargo both take the folder. It has every function, with HN_FAST and with HN_FIXED; what a shader "
        "does not call is left out when it is linked."),
    "unity": Recipe(
        "the package for Unity", "com.hashnoise.noise",
        more="Unity's Package Manager takes the folder. It has nodes for Shader Graph, HLSL and C#, of the "
        "functions in most use."),
    "unreal": Recipe(
        "the plugin for Unreal", "hashnoise-unreal",
        more="A project in C++ has it in its folder Plugins: files of HLSL that materials include. Its folder Nodes "
        "has texts to paste into the graph of a material, in any project, of the functions in most use.",
        options={"engine": Option("VERSION", "the version of Unreal for which it is, such as 5.6: Fab wants a zip file for each")}),
    "blender": Recipe(
        "the add-on for Blender", "hashnoise-blender",
        more="Blender 4.2 and later install the zip file from the disk as an extension. It has node groups for "
        "Cycles, and an operator that displaces meshes by the Python package. With --wheel it has a wheel of that "
        "package, which Blender then installs with it: tools/pack python makes one for this machine. It must be for "
        "the Python of your Blender, which is 3.11 in 4.2 and in 5.0.",
        options={"wheel": Option("FILE", "the Python package, which it then has")}),
    "materialx": Recipe(
        "nodes for MaterialX", "hashnoise-materialx",
        more="MaterialX loads the folder `hashnoise` in it: nodes of the functions in most use, for its generators of "
        "GLSL, Metal's language, Slang and OSL."),
    "isf": Recipe(
        "looks in the Interactive Shader Format (ISF)", "hashnoise-isf",
        more="Each file is a generator with controls."),
    "godot": Recipe(
        "the add-on for Godot 4.4 and later", "hashnoise-godot", is_zip=True,
        more="It has addons/hashnoise/ as a project has it: the parts of the library, each as one .gdshaderinc, nodes for "
        "visual shaders, and examples. Beside it are the form of Godot's Asset Store, filled in, and its picture."),
    "registries": Recipe(
        "what ConanCenter, vcpkg and OpenUPM take by a pull request", "hashnoise-registries",
        more="Each of its folders has the name of a registry's repository, and files to copy into it. They are of the "
        "version that has been released, and have the sums of GitHub's archive of its tag.",
        options={"archive": Option("FILE", "that archive; the files have its sums")}),
    "release": Recipe("all that a release has, from a clean tree", command="ship.release.command"),
}.items() if Path(__file__).with_name(name).is_dir()}
