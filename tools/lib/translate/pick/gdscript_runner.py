"""Scripts that call picked functions, which a real Godot runs without a window."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Sequence
from pathlib import Path

from base.debian import chosen
from translate.pick.gdscript import GDScript
from translate.pick.runners import NotRun, Runner, written_to
from translate.pick.scalars import Part

WRONG = re.compile(r"(?:SCRIPT )?ERROR:.*(?:\n .*)*|WARNING: .*gd.*")
# All warnings of the editor, also those that are silent by default, are errors here: a text has none.
WARNINGS = """unassigned_variable unassigned_variable_op_assign unused_variable unused_local_constant
    unused_private_class_variable unused_parameter shadowed_variable shadowed_variable_base_class
    shadowed_global_identifier unreachable_code standalone_expression standalone_ternary incompatible_ternary
    untyped_declaration unsafe_property_access unsafe_method_access unsafe_cast unsafe_call_argument unsafe_void_return
    return_value_discarded static_called_on_instance redundant_static_unload redundant_await integer_division
    narrowing_conversion int_as_enum_without_cast confusable_identifier confusable_local_declaration
    confusable_local_usage confusable_capture_reassignment inference_on_variant""".split()
PROJECT = "config_version=5\n\n[debug]\n\n" + "".join(f"gdscript/warnings/{name}=2\n" for name in WARNINGS)
WORDS = """static var inputs := StreamPeerBuffer.new()
static var outputs := StreamPeerBuffer.new()


static func put_float(x: float) -> void:
	assert(is_nan(x) or Color(x, 0.0, 0.0).r == x, "no float")
	outputs.put_float(x)


static func put(word: int) -> void:
	outputs.put_u32(word)
"""
MAIN = """extends SceneTree

const Words := preload("words.gd")


func _init() -> void:
	Words.inputs.data_array = FileAccess.get_file_as_bytes("res://inputs")
{runs}	var _opened := FileAccess.open("res://outputs", FileAccess.WRITE).store_buffer(Words.outputs.data_array)
	quit()
"""
CALLS = """const Words := preload("words.gd")
const HashNoise := preload("text{number}.gd")


static func all() -> void:
{call}
"""


class GDScriptRunner(Runner):
    """Each text is a script."""
    syntax = GDScript
    programs = ()
    packages = ""
    whole = True
    read = {"float": "Words.inputs.get_float()", "int": "Words.inputs.get_32()", "uint": "Words.inputs.get_u32()",
            "bool": "Words.inputs.get_u32() != 0"}
    write = {"float": "Words.put_float({})", "int": "Words.put({})", "uint": "Words.put({})",
             "bool": "Words.put(1 if {} else 0)"}
    # A mask that is left out, and a shift without the sign.
    faults = {("mask", "&"): "({0})", ("int", ">>"): "((({0}) & 0xFFFFFFFF) >> ({1}))"}
    loop = "for _point in range({points}):"
    receives = "var r := "
    struct_of = "HashNoise.{type}.new({parts})"
    indent = "    "

    def check(self, lints: bool = False) -> None:
        chosen("godot")

    def called(self, name: str, arguments: Sequence[str], results: Sequence[Part]) -> list[str]:
        return [line.rstrip(";") for line in super().called(f"HashNoise.{name}", arguments, results)]

    def build_and_run(self, texts: Sequence[str], calls: Sequence[str], folder: Path) -> None:
        known: dict[str, int] = {}
        files = {"project.godot": "config_version=5\n", "words.gd": WORDS}
        for i, (text, call) in enumerate(zip(texts, calls)):
            number = known.setdefault(text, len(known))
            files[f"text{number}.gd"] = text
            files[f"run{i}.gd"] = CALLS.format(number=number, call=call.removesuffix(f"{self.indent}}}").rstrip())
        runs = "".join(f'\tpreload("run{i}.gd").all()\n' for i in range(len(texts)))
        written_to(folder, {**files, "main.gd": MAIN.format(runs=runs)})
        self.run_script(folder, "main.gd")

    def lint(self, texts: Sequence[str], folder: Path) -> None:
        """By the language's own parser, with all warnings as errors."""
        names = written_to(folder, {f"text{i}.gd": text for i, text in enumerate(texts)})
        loads = "".join(f'\tvar _{i} := load("{name}")\n' for i, name in enumerate(names))
        written_to(folder, {"project.godot": PROJECT, "main.gd": f"extends SceneTree\n\nfunc _init() -> void:\n{loads}\tquit()\n"})
        self.run_script(folder, "main.gd")

    def run_script(self, folder: Path, script: str) -> str:
        """Godot's output; it prints errors of a script, and goes on as if there were none, but for one turn alone."""
        arguments = ("--quit-after", "1", "--script", script)
        homes = dict.fromkeys(("HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"), str(folder))
        done = subprocess.run([chosen("godot"), "--headless", "--path", folder, *arguments], capture_output=True, text=True,
                              errors="replace", check=False, env={**os.environ, **homes})
        said = done.stdout + done.stderr
        if done.returncode or WRONG.search(said):
            raise NotRun(f"godot {' '.join(arguments)} returned {done.returncode}:\n{said[:4000]}")
        return said
