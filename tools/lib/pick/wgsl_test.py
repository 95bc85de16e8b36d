"""What tools/pick writes in WGSL has the bits of the C++ header with HN_FIXED, and with HN_FAST golden values within the
bound.

    python3 -m pick.wgsl_test HN_CONFORM FOLDER     where pick.languages_test has written points

Exit status: 0 it has, 1 it has not, 77 there is no wgpu here.
"""

from __future__ import annotations

import functools
import sys
import unittest
from collections.abc import Mapping
from pathlib import Path
from unittest import mock

from parsing.syntax import Function
from pick import command
from pick.evaluate import Module
from pick.languages_test import POINTS, SKIPPED, difference, functions, words
from pick.languages_test import module as split_module
from pick.program import Program, chosen, public, read
from pick.shading import LANGUAGES
from pick.values import Node
from pick.wgsl import WgslWriter
from thorough import THOROUGH
from tree import GLSL
from wgsl.device import Absent, Device
from wgsl.evaluation import GROUP
from wgsl.golden import Page, shaders_over
from wgsl.names import wgsl_name, wgsl_type

ARITHMETICS = ("fast", "fixed")
READ = {"float": "bitcast<f32>({})", "int": "bitcast<i32>({})", "uint": "{}", "bool": "{} != 0u"}
WRITE = {"float": "bitcast<u32>({})", "int": "bitcast<u32>({})", "uint": "{}", "bool": "select(0u, 1u, {})"}


@functools.cache
def module(arithmetic: str) -> Module:
    return read(GLSL, command.settings(arithmetic, "lattice"))


def text(*names: str, arithmetic: str = "fixed") -> str:
    of = module(arithmetic)
    return Program(of, chosen(of, names)).text(LANGUAGES["wgsl"])


def calling(of: Module, function: Function) -> str:
    """An entry point that reads the words of arguments and writes those of results, at each point. The module is split:
    a vector is its components."""
    count = 0
    lines: list[str] = []
    arguments: list[str] = []
    outputs: list[str] = []

    def made(type_: str) -> str:
        nonlocal count
        if type_ in of.structs:
            return f"{type_}({', '.join(made(of_field) for _, of_field, _ in of.structs[type_].fields)})"
        parts = []
        for _, scalar in of.parts(type_):
            parts.append(READ[scalar].format(f"inputs[at + {count}u]"))
            count += 1
        return parts[0] if len(parts) == 1 else f"{wgsl_type(type_)}({', '.join(parts)})"

    def written(name: str, type_: str) -> list[str]:
        return [WRITE[scalar].format(".".join((name, *(part.removeprefix("_") for part in path))))
                for path, scalar in of.parts(type_)]

    for i, parameter in enumerate(function.parameters):
        value = f" = {made(parameter.type)}" if of.passed(parameter) else ""
        lines.append(f"var v{i}: {wgsl_type(parameter.type)}{value};")
        arguments.append(f"&v{i}" if parameter.is_set else f"v{i}")
        outputs += written(f"v{i}", parameter.type) if parameter.is_set else []
    call = f"{wgsl_name(function)}({', '.join(arguments)});"
    if function.type == "void":
        lines.append(call)
    else:
        lines.append(f"let result = {call}")
        outputs = [*written("result", function.type), *outputs]
    lines += [f"outputs[{len(outputs)}u * id.x + {i}u] = {value};" for i, value in enumerate(outputs)]
    inside = "".join(f"    {line}\n" for line in lines)
    return f"""
@group(0) @binding(0) var<storage, read> inputs: array<u32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<u32>;
@compute @workgroup_size({GROUP}) fn main(@builtin(global_invocation_id) id: vec3u) {{
  if (id.x < {POINTS}u) {{
    let at = {count}u * id.x;
{inside}  }}
}}
"""


class Header(unittest.TestCase):
    """Beside the C++ header."""
    device: Device
    folder: Path

    def differing(self, texts: Mapping[str, str]) -> list[str]:
        """How each text of a function differs from the header; nothing if it does not."""
        of = split_module("fixed")
        known, expected = functions(of, "fixed"), words(self.folder, "fixed", of)
        found = []
        for name, shown in texts.items():
            passed, back = expected[name]
            got = bytes(self.device.run(shown + calling(of, known[name]), passed, len(back), POINTS))
            if differs := difference(known[name], back, got):
                found.append(f"{name}: {differs}")
        return found

    def test_the_bits_are_those_of_the_library(self) -> None:
        names = functions(split_module("fixed"), "fixed")
        self.assertGreater(len(names), 5)
        self.assertEqual(self.differing({name: text(name) for name in names}), [])

    def test_a_hash_of_the_users_is_called(self) -> None:
        """One that is a hash of the library gives the words of that."""
        of = split_module("fixed")
        function, (passed, back) = functions(of, "fixed")["hn_perlin2"], words(self.folder, "fixed", of)["hn_perlin2"]
        found = []
        for options in ({"hash": "pcg"}, {"hash": "custom", "hash_function": "mine"}):
            library = command.read_library(GLSL, command.Choice("wgsl", "fixed", **options))
            shown = Program(library, chosen(library, ["hn_perlin2"])).text(LANGUAGES["wgsl"])
            self.assertEqual("mine(" in shown, options["hash"] == "custom")
            own = text("hn_hash_pcg").replace("hn_hash_pcg", "mine")
            found.append(bytes(self.device.run(own + shown + calling(of, function), passed, len(back), POINTS)))
        self.assertEqual(*found)
        self.assertNotEqual(found[0], back)

    def test_a_fault_of_the_printer_is_noticed(self) -> None:
        def wrong(writer: WgslWriter, condition: Node, yes: Node, no: Node) -> tuple[str, int]:
            return right(writer, condition, no, yes)

        right = WgslWriter._choice
        with mock.patch.object(WgslWriter, "_choice", wrong):
            shown = text("hn_perlin2")
        self.assertNotEqual(shown, text("hn_perlin2"))
        self.assertRegex("".join(self.differing({"hn_perlin2": shown})), f"^hn_perlin2: [1-9][0-9]* of {POINTS} ")


class Bounds(unittest.TestCase):
    """Golden values of HN_FAST, within what the suite allows."""
    device: Device
    program: str
    page: Page

    @classmethod
    def setUpClass(cls) -> None:
        cls.page = Page(cls.program, f"{'*' if THOROUGH else 'noise2d.*'}.lattice.fast.compute.wgsl.golden")

    def wrong(self, change: tuple[str, str] = ("", ""), every: int = 1, only: str = "") -> list[str]:
        cases = [case for case in self.page.cases if not only or case["id"].startswith(only)][::every]
        rows = {case["id"]: ".".join(case["id"].split(".")[:2]) for case in cases}
        known = public(module("fast"))
        shaders = shaders_over([*rows.values()], "HN_FAST", lambda names: text(
            *(name for name in names if name in known), arithmetic="fast"))
        self.assertGreater(len(cases), 0)
        found = []
        for case in cases:
            shader = shaders[rows[case["id"]]]
            self.assertIn(change[0], shader)
            if wrong := self.page.wrong(self.device, case, shader.replace(*change)):
                found.append(f"{case['id']}: {wrong}")
        return found

    def test_they_are_kept(self) -> None:
        self.assertGreater(len(self.page.cases), 285 if THOROUGH else 30)
        self.assertEqual(self.wrong(every=1 if THOROUGH else 8), [])

    def test_a_changed_constant_is_noticed(self) -> None:
        self.assertEqual(len(self.wrong(("* 0.5", "* 0.50002"), only="noise2d.cellular.")), 1)


class Compilation(unittest.TestCase):
    device: Device

    def test_of_every_function(self) -> None:
        """Some of them by default, in each arithmetic others."""
        for turn, arithmetic in enumerate(ARITHMETICS):
            for name in [*public(module(arithmetic))][0 if THOROUGH else turn * 40::1 if THOROUGH else 80]:
                with self.subTest(name=name, arithmetic=arithmetic):
                    self.device.compile(text(name, arithmetic=arithmetic))

    def test_it_can_fail(self) -> None:
        with self.assertRaises(Exception):
            self.device.compile(text("hn_perlin2").replace("-> f32", "-> u32"))


if __name__ == "__main__":
    Bounds.program, Header.folder = sys.argv[1], Path(sys.argv[2]).resolve()
    del sys.argv[1:3]
    try:
        Header.device = Bounds.device = Compilation.device = Device()
    except Absent as reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    unittest.main()
