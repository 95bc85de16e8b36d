"""tools/pack unity: the content of the package, and its command line.

    python3 -m unittest ship.unity.unity_test  names and texts of a few
    python3 -m ship.unity.unity_test           the whole package: Mono compiles its C#, and runs it; glslang, DXC
                                               and FXC compile its HLSL

Exit status: as of the tests; 77 Mono or glslang is not here, or nothing failed without Microsoft's compilers.
"""

from __future__ import annotations

import copy
import json
import re
import struct
import subprocess
import unittest
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from unittest import mock

from base.tree import TOOLS, version
from proof.vectors.files import vectors_folder
from ship.hlsl_nodes import ARITHMETICS, NODES
from ship.packing_support import DEFAULTS, made, run_with_compilers
from ship.unity import files
from translate.hlsl.compilers import missing as missing_compilers
from translate.hlsl.compilers import refusals

NEEDED = {"mcs": "mono-mcs", "mono": "mono-runtime", "glslangValidator": "glslang-tools"}
# As much of Unity as the sample needs, to compile it.
ENGINE = """
namespace UnityEngine {
    public class RequireComponent : System.Attribute { public RequireComponent(System.Type a, System.Type b) {} }
    public class MonoBehaviour { public T GetComponent<T>() where T : new() { return new T(); } }
    public class MeshFilter { public Mesh sharedMesh; }
    public class MeshRenderer {}
    public struct Vector3 {
        public float x, y, z;
        public Vector3(float a, float b, float c) { x = a; y = b; z = c; }
        public Vector3 normalized { get {
            float size = (float)System.Math.Sqrt(x * x + y * y + z * z);
            return new Vector3(x / size, y / size, z / size);
        } }
    }
    public class Mesh { public Vector3[] vertices; public int[] triangles; public void RecalculateNormals() {} }
}
"""
# A render pipeline: macros that Shader Graph's shaders have before the file, and the includes of the sample.
PIPELINE = """
#define real float
#define PI 3.14159265
#define UNITY_MATRIX_M unity_ObjectToWorld
float4x4 unity_ObjectToWorld;
float4 UnityObjectToClipPos(float4 p) { return mul(unity_ObjectToWorld, p); }
"""

Objects = list[dict[str, Any]]


def references(one: Any) -> Iterator[str]:
    """The objects that an object names. A slot's own m_Id is a number."""
    if isinstance(one, dict):
        yield from (found for found in [one.get("m_Id")] if isinstance(found, str) and found)
    for value in one.values() if isinstance(one, dict) else one if isinstance(one, list) else ():
        yield from references(value)


def parsed(text: str) -> Objects:
    return [json.loads(one) for one in text.split("\n\n") if one]


def faults(objects: Objects, hlsl: str, source: str) -> list[str]:
    """Why a subgraph does not call the function of this text, in the file with this GUID, with each input in its place."""
    of = {one["m_ObjectId"]: one for one in objects}
    graph, named = objects[0], {name for one in objects for name in references(one)}
    if wrong := sorted(named ^ (of.keys() - {graph["m_ObjectId"]})):
        return [f"{one} is not there, or nothing names it" for one in wrong]

    def followed(names: list[dict[str, str]]) -> Objects:
        return [of[one["m_Id"]] for one in names]
    nodes = {one["m_ObjectId"]: one for one in followed(graph["m_Nodes"])}
    slots = {(node, slot["m_Id"]): slot for node, one in nodes.items() for slot in followed(one["m_Slots"])}
    sources: dict[tuple[str, int], list[tuple[str, int]]] = {}
    found = []
    for edge in graph["m_Edges"]:
        begin, end = ((side["m_Node"]["m_Id"], side["m_SlotId"]) for side in (edge["m_OutputSlot"], edge["m_InputSlot"]))
        sources.setdefault(end, []).append(begin)
        kinds = [(slots[at]["m_SlotType"], slots[at]["m_Type"]) if at in slots else None for at in (begin, end)]
        if None in kinds or [kind for kind, _ in kinds] != [1, 0] or kinds[0][1] != kinds[1][1]:
            found.append(f"an edge joins {kinds}")
    inputs = [at for at, slot in slots.items() if slot["m_SlotType"] == 0]
    if sorted(sources) != sorted(inputs) or any(len(one) != 1 for one in sources.values()):
        return [*found, "an input has not one edge"]
    function, = (one for one in nodes.values() if one["m_Type"].endswith("CustomFunctionNode"))
    if function["m_FunctionSource"] != source:
        found.append("the file of the function is another one")
    if not (signature := re.search(rf"^void {function['m_FunctionName']}_float\((.*), out (\w+) Out\)", hlsl, re.MULTILINE)):
        return [*found, f"there is no {function['m_FunctionName']}"]
    wanted = [*(tuple(one.split()) for one in signature[1].split(", ")), (signature[2], "Out")]

    def shown(one: dict[str, Any], name: str) -> tuple[str, str]:
        return re.sub(r".*Vector(\d)\D+", r"float\1", one["m_Type"]).replace("float1", "float"), one[name]
    properties = followed(graph["m_Properties"])
    taken = followed(function["m_Slots"])
    for what, rows in (("slots", [shown(one, "m_ShaderOutputName") for one in taken]),
                       ("properties", [*(shown(one, "m_Name") for one in properties), wanted[-1]]),
                       ("sources", [*(shown(of[nodes[sources[function["m_ObjectId"], one["m_Id"]][0][0]]["m_Property"]["m_Id"]],
                                            "m_Name") for one in taken[:-1]), wanted[-1]])):
        if rows != wanted:
            found.append(f"the {what} are {rows}, and the function takes {wanted}")
    for one in (*properties, *taken[:-1]):
        name = one.get("m_Name") or one["m_ShaderOutputName"]
        value = one["m_Value"]
        numbers = tuple(value.values()) if isinstance(value, dict) else (value,)
        if any(a != b for a, b in zip(numbers, (*(DEFAULTS[name] or (0,)), 0, 0, 0))):
            found.append(f"{name} is {numbers}")
    category, = followed(graph["m_CategoryData"])
    if category["m_ChildObjectList"] != graph["m_Properties"] or of[graph["m_OutputNode"]["m_Id"]]["m_Type"].find("Output") < 0:
        found.append("the category or the output is another one")
    return found


class Text(unittest.TestCase):
    def test_what_unity_imports_is_each_file_and_folder_and_what_it_copies_of_samples(self) -> None:
        self.assertEqual(files.seen(["a/b.cs", "package.json", "Samples~/c/d.cs"]),
                         ["Samples~/c", "Samples~/c/d.cs", "a", "a/b.cs", "package.json"])
        self.assertRegex(files.meta("a", False), r"\AfileFormatVersion: 2\nguid: [0-9a-f]{32}\n\Z")
        self.assertNotEqual(files.meta("a", False), files.meta("b", False))

    def test_each_subgraph_calls_its_function(self) -> None:
        for arithmetic, suffix in ARITHMETICS.items():
            source = files.meta(f"Shaders/HashNoise{suffix}.hlsl", False).split()[-1]
            for form in NODES:
                with self.subTest(form, arithmetic=arithmetic):
                    self.assertEqual(faults(parsed(files.subgraph(form, arithmetic)), files.node(form, arithmetic), source), [])

    def test_what_users_link_keeps_its_guid(self) -> None:
        path = files.file("hn_fbm2", "fast")
        self.assertEqual((path, files.own_guid(path)), ("Graphs/HashNoiseFbm2.shadersubgraph", "a8acc3193a2938578812cfb120d16e54"))
        objects = parsed(files.subgraph("hn_fbm2", "fast"))
        gain, = (one for one in objects if one.get("m_Name") == "Gain")
        self.assertEqual(gain["m_Guid"]["m_GuidSerialized"], "6837ea81-f80a-de9e-b82b-a6d616d114a4")

    def test_a_fault_of_a_subgraph_is_found(self) -> None:
        whole, hlsl = parsed(files.subgraph("hn_fbm2", "fast")), files.node("hn_fbm2", "fast")
        source = files.own_guid("Shaders/HashNoise.hlsl")

        def of(objects: Objects, kind: str) -> Objects:
            return [one for one in objects if one["m_Type"].endswith(kind)]

        def swap(rows: list[Any], i: int, j: int) -> None:
            rows[i], rows[j] = rows[j], rows[i]

        def ports(objects: Objects) -> None:  # Lacunarity and Gain, which are alike
            a, b = (objects[0]["m_Edges"][i]["m_InputSlot"] for i in (2, 3))
            a["m_SlotId"], b["m_SlotId"] = b["m_SlotId"], a["m_SlotId"]
        planted = {
            "ports": ports,
            "properties": lambda objects: swap(objects[0]["m_Properties"], 2, 3),
            "slots": lambda objects: swap(of(objects, "CustomFunctionNode")[0]["m_Slots"], 2, 3),
            "type": lambda objects: of(objects, "Vector1MaterialSlot")[0].update(m_Type="Vector3MaterialSlot"),
            "default": lambda objects: of(objects, "Vector1ShaderProperty")[0].update(m_Value=7.0),
            "name": lambda objects: of(objects, "CustomFunctionNode")[0].update(m_FunctionName="HashNoiseFbm3"),
            "file": lambda objects: of(objects, "CustomFunctionNode")[0].update(m_FunctionSource="0" * 32),
            "edge": lambda objects: objects[0]["m_Edges"].pop(),
            "twice": lambda objects: objects[0]["m_Edges"].append(objects[0]["m_Edges"][0]),
            **{f"without {one['m_Type']} {i}": lambda objects, i=i: objects.pop(i) for i, one in enumerate(whole) if i}}
        self.assertEqual(faults(whole, hlsl, source), [])
        for name, plant in planted.items():
            wrong = copy.deepcopy(whole)
            plant(wrong)
            with self.subTest(name):
                self.assertNotEqual(faults(wrong, hlsl, source), [])
        self.assertNotEqual(faults(whole, hlsl.replace("float Lacunarity, float Gain", "float Gain, float Lacunarity"), source), [])
        self.assertNotEqual(faults(whole, hlsl.replace("float2 Position", "float3 Position"), source), [])

    def test_a_link_needs_an_address(self) -> None:
        for place, found in (("", None),
                             ("https://github.com/a/b", f"https://github.com/a/b/blob/v{version()}/CHANGELOG.md")):
            with mock.patch.object(files, "address", return_value=place):
                self.assertEqual(files.links().get("changelogUrl"), found)


@unittest.skipUnless(__name__ == "__main__", "the test unity.package writes all functions")
class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.root, cls.folder = made(cls, "unity")

    def run_in(self, *words: str | Path) -> str:
        done = subprocess.run([str(word) for word in words], cwd=self.root, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def blocks(self, language: str) -> list[str]:
        return re.findall(rf"```{language}\n(.*?)```", (self.folder / "README.md").read_text(), re.DOTALL)

    def scripts(self) -> list[Path]:
        return sorted(self.folder.rglob("*.cs"))

    def test_it_says_what_it_is(self) -> None:
        described = json.loads((self.folder / "package.json").read_text())
        self.assertEqual((described["name"], described["version"]), (files.NAME, version()))
        for sample in described["samples"]:
            self.assertTrue((self.folder / sample["path"]).is_dir())
        guids = [path.read_text() for path in self.folder.rglob("*.meta")]
        self.assertEqual(len(set(guids)), len(guids))
        for path in self.folder.rglob("*.meta"):
            self.assertEqual("folderAsset: yes\nDefaultImporter:\n" in path.read_text(), path.with_suffix("").is_dir())
        shaders = "".join(path.read_text() for path in self.folder.rglob("*.hlsl"))
        self.assertEqual(sorted(path.stem for path in self.folder.glob("Graphs/*.shadersubgraph")),
                         sorted(re.findall(r"^void (\w+)_float\(", shaders, re.MULTILINE)))
        namespaces = re.findall(r"(?m)^namespace (\w+) \{$", "".join(path.read_text() for path in self.scripts()))
        self.assertEqual(namespaces, ["Hashnoise"] * len(self.scripts()))

    def test_openupm_gets_each_file(self) -> None:
        """npm packs what OpenUPM takes, and leaves out files with some names."""
        def packed() -> set[str]:
            done = self.run_in(TOOLS / "lib" / "base" / "node", "npm", "pack", "--dry-run", "--json", "--offline", self.folder)
            return {one["path"] for one in json.loads(done)[0]["files"]}

        def there() -> set[str]:
            return {path.relative_to(self.folder).as_posix() for path in self.folder.rglob("*") if path.is_file()}
        self.assertEqual(packed(), there())
        left_out = self.folder / "Runtime" / "HashNoise.cs.orig"
        left_out.touch()
        self.addCleanup(left_out.unlink)
        self.assertEqual(there() - packed(), {"Runtime/HashNoise.cs.orig"})

    def test_csharp_has_the_values_of_the_vectors(self) -> None:
        rows, calls = [], ""
        for name, arguments in (("noise2d.perlin", "ffu"), ("fbm.fbm2", "ffiffu")):
            settings = json.loads((vectors_folder() / f"{name}.json").read_text())["settings"]
            of_name = next(setting for setting in settings if setting["name"] == "lattice+fixed")["rows"]
            self.assertGreater(len(of_name), 10)
            rows += of_name
            call = ", ".join({"f": "Number(0x{}u)", "i": "unchecked((int)0x{}u)", "u": "0x{}u"}[one] for one in arguments)
            method = f"{name.rpartition('.')[2].rstrip('2').title()}2"
            calls += "".join(f"        Show(HashNoiseFixed.{method}({call.format(*row['words'].split())}));\n"
                             for row in of_name)
        (self.root / "engine.cs").write_text(ENGINE)
        (self.root / "main.cs").write_text(f"""using Hashnoise;
class Run {{
    static float Number(uint bits) {{ return System.BitConverter.ToSingle(System.BitConverter.GetBytes(bits), 0); }}
    static void Show(float x) {{
        System.Console.WriteLine("{{0:x8}}", System.BitConverter.ToUInt32(System.BitConverter.GetBytes(x), 0));
    }}
    static void Main() {{
{calls}        Show(NoiseTerrain.HeightAt(0.5f, 0.25f) / 2.0f);
        Show(HashNoiseFixed.Fbm2(0.5f, 0.25f, 6, 2.0f, 0.5f, 7u));
    }}
}}
""")
        self.run_in("mcs", "-langversion:7.2", "-warn:4", "-warnaserror", "-out:main.exe", "engine.cs", "main.cs",
                    *self.scripts())
        *values, of_sample, expected = self.run_in("mono", "main.exe").split()
        self.assertEqual(values, [struct.pack(">f", row["out"][0]).hex() for row in rows])
        self.assertEqual(of_sample, expected)

    def test_the_normal_of_the_page_is_that_of_the_land(self) -> None:
        code, = self.blocks("csharp")
        (self.root / "engine.cs").write_text(ENGINE)
        (self.root / "normal.cs").write_text(f"""using Hashnoise;
using UnityEngine;
class Normal {{
    static Vector3 At(float x, float z, out float y) {{
        const float cells = 0.3f, height = 5f;
        {code.replace("float y", "y")}
        return normal;
    }}
    static void Main() {{
        float left, right, back, front, unused;
        At(1.99f, 3f, out left); At(2.01f, 3f, out right); At(2f, 2.99f, out back); At(2f, 3.01f, out front);
        Vector3 normal = At(2f, 3f, out unused);
        System.Console.WriteLine((normal.x * 0.02f + normal.y * (right - left)) + " "
                                 + (normal.z * 0.02f + normal.y * (front - back)) + " " + normal.x + " " + normal.z);
    }}
}}
""")
        self.run_in("mcs", "-langversion:7.2", "-warn:4", "-warnaserror", "-main:Normal", "-out:normal.exe",
                    "engine.cs", "normal.cs", *self.scripts())
        along_x, along_z, x, z = map(float, self.run_in("mono", "normal.exe").split())
        self.assertLess(max(abs(along_x), abs(along_z)), 2e-4)
        self.assertGreater(min(abs(x), abs(z)), 0.05)

    def refusals(self, stage: str, entry: str, text: str) -> dict[str, str]:
        path = self.root / "shader.hlsl"
        path.write_text(text)
        packages = self.root / "Packages"
        packages.mkdir(exist_ok=True)
        if not (packages / files.NAME).exists():
            (packages / files.NAME).symlink_to(self.folder)
        (self.root / "UnityCG.cginc").write_text(PIPELINE)
        return refusals(path, stage, entry)

    def calls_of(self, shader: str) -> str:
        """A shader that calls each node's functions in the file."""
        nodes = re.findall(r"^void (\w+)\(((?:[^()]|\n)*)\)", (self.folder / shader).read_text(), re.MULTILINE)
        self.assertEqual(len(nodes), (1 if "Fixed" in shader else 2) * len(files.NODES))
        lines = []
        for i, (name, parameters) in enumerate(nodes):
            *given, (_, of_out, _) = ((" " + one).split()[-3:] if "out " in one else one.split()
                                      for one in parameters.split(", "))
            passed = ", ".join(f"({of})uv.x" for of, _ in given)
            lines.append(f"  {of_out} n{i};\n  {name}({passed}, n{i});\n  sum += n{i}.x;\n")
        return ('#include "UnityCG.cginc"\n' f'#include "Packages/{files.NAME}/{shader}"\n'
                f'#include "Packages/{files.NAME}/{shader}"\n'
                f"float4 frag(float2 uv : TEXCOORD0) : SV_Target {{\n  float sum = 0.0;\n{''.join(lines)}  return sum;\n}}\n")

    def test_each_node_compiles(self) -> None:
        for shader in ("Shaders/HashNoise.hlsl", "Shaders/HashNoiseFixed.hlsl"):
            with self.subTest(shader):
                self.assertEqual(self.refusals("frag", "frag", self.calls_of(shader)), {})

    def test_one_shader_may_have_both(self) -> None:
        both = "".join(f'#include "Packages/{files.NAME}/Shaders/HashNoise{suffix}.hlsl"\n' for suffix in ("", "Fixed"))
        self.assertEqual(self.refusals("frag", "frag", both + "float4 frag(float2 uv : TEXCOORD0) : SV_Target {\n"
                                       "  return hn_perlin(uv, 7u) - hn_fixed_perlin(uv, 7u);\n}\n"), {})
        wrong = self.refusals("frag", "frag", both + "float4 frag(float2 uv : TEXCOORD0) : SV_Target {\n"
                              "  return hn_no_such(uv, 7u);\n}\n")
        self.assertEqual(set(wrong), {"glslang"} if missing_compilers() else {"glslang", "DXC", "FXC"})

    def test_the_sample_and_the_page_compile(self) -> None:
        sample, = self.folder.rglob("*.shader")
        program = sample.read_text().partition("HLSLPROGRAM")[2].partition("ENDHLSL")[0]
        for stage, entry in (("vert", "vert"), ("frag", "frag")):
            self.assertEqual(self.refusals(stage, entry, program), {})
        block, _ = self.blocks("hlsl")
        include, _, code = block.partition("\n")
        self.assertEqual(self.refusals("frag", "frag", f"{include}\nfloat4 frag(float2 uv : TEXCOORD0) : SV_Target {{\n"
                                       f"{code}  return height + tiled;\n}}\n"), {})

    def test_the_texts_of_other_functions_stand_beside_it(self) -> None:
        for words in re.findall(r"^    tools/pick (.*)$", (self.folder / "README.md").read_text(), re.MULTILINE):
            self.run_in(TOOLS / "pick", *words.split())
        _, block = self.blocks("hlsl")
        main = (f'#include "Packages/{files.NAME}/Shaders/HashNoise.hlsl"\n{block}'
                "float4 frag(float2 uv : TEXCOORD0) : SV_Target {\n  float n;\n"
                "  Hybrid3_float(float3(uv, 0.5), 6, 2, 0.5, 7, n);\n  return n + hn_perlin(uv, 7u);\n}\n")
        self.assertEqual(self.refusals("frag", "frag", main), {})
        (self.root / "both.cs").write_text("""using Hashnoise;
class Both {
    static float At(float x) { return Hybrid.Hybrid3(x, 0f, 0f, 6, 2f, 0.5f, 7u) + HashNoise.Perlin2(x, 0f, 7u); }
}
""")
        (self.root / "engine.cs").write_text(ENGINE)
        self.run_in("mcs", "-langversion:7.2", "-target:library", "-out:both.dll", "engine.cs", "both.cs",
                    "Assets/Hybrid.cs", *self.scripts())
        shared = self.root / "Assets" / "Hybrid.hlsl"
        shared.write_text(re.sub(r"\bmy_", "hn_", shared.read_text()))
        self.assertIn("glslang", self.refusals("frag", "frag", main.replace("my_hybrid", "hn_hybrid")))


if __name__ == "__main__":
    run_with_compilers("Package", NEEDED)
