"""tools/make results: which digests it refuses, and the page of those that it takes."""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import tempfile
import unittest
import zlib
from html.parser import HTMLParser
from pathlib import Path
from unittest import mock

from base.tree import ROOT, address, version
from measure.results import command, page
from measure.results.devices import device_name, devices_of, release
from measure.results.digest import MOST_BYTES, Earlier, Refused, digest_of, parse, read
from measure.results.sets import FrozenSets, GoldenSets, Sets, write

GOLDEN = """hashnoise golden 2
function {function}
calls hn_{name}
bits 0.4.0
columns x:f32 seed:u32 = {columns}
settings {settings}
rows 2
{rows}
"""


class FewSets(Sets):
    """Five sets, in two digits of bits."""

    def __init__(self) -> None:
        super().__init__(["fbm.fbm2", "hash.word", "hash.word", "noise2d.perlin", "noise2d.value"],
                         ["lattice+fixed:fixed", "lattice:exact", "pcg:exact", "lattice+fixed:fixed",
                          "lattice+fixed:fixed"], "00112233")

    def checksum(self, number: int) -> int:
        return 1000 + number


SETS = FewSets()
VERSIONS = {"0.4.0": SETS}


def digest(**changes: object) -> dict[str, object]:
    """One of a device that is right."""
    part = {"cases": {"fbm.fixed": [3, 0, 0], "fbm.fast": [4, 0, 1], "hash.exact": [9, 0, 2],
                      "noise2d.fixed": [5, 0, 0]},
            "checksums": {"fbm": SETS.combined([0]), "hash": SETS.combined([1, 2]), "noise2d": SETS.combined([3, 4])},
            "sets": "f8", "verdict": "pass"}
    return {"apis": {"opengl": part},
            "device": {"driver": "4.5 Mesa 22.3", "renderer": "llvmpipe (LLVM 15.0, 256 bits)", "vendor": "Mesa/X.org"},
            "failed": [], "format": "hashnoise-digest 1", "golden": SETS.golden, "system": "Linux", "version": "0.4.0",
            **changes}


CASE = "noise2d.perlin.lattice.fixed.fragment.gl330.golden"


def failing(**changes: object) -> dict[str, object]:
    found = digest(failed=[CASE], **changes)
    for part in found["apis"].values():
        part["cases"]["noise2d.fixed"] = [4, 1, 0]
        part["checksums"]["noise2d"] = "deadbeef"
        part["verdict"] = "fail"
    return found


def in_browser(made: dict[str, object], browser: str, renderer: str, vendor: str, *apis: str) -> dict[str, object]:
    part = made["apis"].pop("opengl")
    return {**made, "apis": {api: part for api in apis or ("webgl2",)}, "browser": browser,
            "device": {"renderer": renderer, "vendor": vendor}}


def text_of(found: object) -> str:
    return json.dumps(found, separators=(",", ":"), sort_keys=True)


class Taken(unittest.TestCase):
    def test_what_the_suite_writes_is_taken(self):
        costs = {"noise2d.perlin.fast": 100, "fbm.fbm2.fixed": 800}
        for number, made in enumerate((digest(), failing(), digest(costs=costs),
                                       in_browser(digest(), "Firefox 140", "Mali-G78", "ARM", "webgl2", "webgpu"))):
            with self.subTest(number=number):
                found = digest_of("a.json", parse(text_of(made).encode() + b"\n"), VERSIONS)
                self.assertEqual(found.renderer, made["device"]["renderer"])
        self.assertEqual(digest_of("a.json", failing(), VERSIONS).parts["opengl"].wrong, {"noise2d"})


class Hostile(unittest.TestCase):
    """Each is refused with a sentence that names the place."""

    def refusal(self, data: bytes) -> str:
        with self.assertRaises(Refused) as caught:
            digest_of("a.json", parse(data), VERSIONS)
        message = str(caught.exception)
        self.assertRegex(message, r"^[ -~]+$")
        self.assertLess(len(message), 500)
        return message

    def change(self, path: str, value: object, made: dict[str, object] | None = None) -> bytes:
        found = json.loads(text_of(made or digest()))
        *way, last = path.split("/")
        place = found
        for key in way:
            place = place[key]
        if value is None:
            del place[last]
        else:
            place[last] = value
        return text_of(found).encode()

    def test_what_is_no_json_of_ours(self):
        text = text_of(digest())
        for data, words in ((b"", "it is not JSON"), (b"{", "it is not JSON"), (b"[]", "the digest is"),
                            (b"null", "the digest is"), (b"1", "the digest is"), (b"[" * 4000, "nested 4000 levels"),
                            (b'{"a":' * 600, "nested 600 levels"), (b"9" * 4000, "the digest is"),
                            (text.replace("{", "{ ", 1).encode(), "not written as the suite writes it"),
                            (text.encode() + b"\n\n", "byte"),
                            (json.dumps(digest(), indent=1).encode(), "byte 1 is 0x0a"),
                            (text.replace('"Linux"', '"Linux","system":"Linux"').encode(), '"system" occurs twice'),
                            (text.replace("[3,0,0]", "[3,NaN,0]").encode(), '"NaN" is a number that no digest has'),
                            (text.replace("[3,0,0]", "[3,-Infinity,0]").encode(), "is a number that no digest has"),
                            (text.replace("[3,0,0]", "[3,1e999,0]").encode(), "is a number that no digest has"),
                            (text.replace("[3,0,0]", "[3.0,0,0]").encode(), "all of them are whole"),
                            (text.replace("Mesa/X.org", "Mesa\u202eX").encode(), "is 0xe2; a digest is one line"),
                            (text.replace("Mesa/X.org", "\x1b[2J").encode(), "is 0x1b"),
                            (text.replace("Mesa/X.org", "a\x00b").encode(), "is 0x00"),
                            (b"\xff\xfe{}", "byte 0 is 0xff"),
                            (text.replace("Mesa/X.org", "\\u003cb\\u003e").encode(), "not written as the suite")):
            with self.subTest(data=data[:60]):
                self.assertIn(words, self.refusal(data))

    def test_wrong_types_and_values(self):
        part = "apis/opengl"
        for path, value, words in (
                ("format", "hashnoise-digest 2", 'format is "hashnoise-digest 2"; it should be "hashnoise-digest 1"'),
                ("format", 1, "format is"), ("format", None, 'has no "format"'),
                ("version", "0.9.0", 'version is "0.9.0"; it should be one of 0.4.0'),
                ("comment", "hello", 'has the key "comment", which no digest has'),
                ("__proto__", {}, "which no digest has"),
                ("golden", "0011223", "golden is"), ("system", "my own system", "system is"),
                ("system", ["Linux"], "system is"),
                ("device", "llvmpipe", "device is"), ("device/serial", "1", 'the key "serial"'),
                ("device/driver", None, 'device has no "driver"'), ("device/vendor", "", "device.vendor is"),
                ("device/renderer", "<script>alert(1)</script>", 'device.renderer is "<script>alert(1)</script>"'),
                ("device/renderer", "a" * 97, "device.renderer is"),
                ("device/renderer", "two  blanks", "device.renderer is"),
                ("device/renderer", "a'b", "device.renderer is"), ("device/renderer", "a&b", "device.renderer is"),
                ("device/driver", "4.5 Mesa 22.3.6", "without the numbers of builds"),
                ("browser", "Chrome 150", "browser is there"), ("apis", {}, "apis has"), ("apis", [], "apis is"),
                ("apis/webgl2", {}, "apis has"), ("apis/direct3d", {}, 'the key "direct3d"'),
                (part, [], "apis.opengl is"), (f"{part}/cases", {}, "apis.opengl.cases is empty"),
                (f"{part}/cases", [1], "apis.opengl.cases is"),
                (f"{part}/cases/fbm", [1, 0, 0], "a key of apis.opengl.cases"),
                (f"{part}/cases/..%2f.fixed", [1, 0, 0], "a key of apis.opengl.cases"),
                (f"{part}/cases/fbm.fixed", [3, 0], "has 2 numbers; it should have three"),
                (f"{part}/cases/fbm.fixed", [3, True, 0], "apis.opengl.cases.fbm.fixed is"),
                (f"{part}/cases/fbm.fixed", [3, "0", 0], "apis.opengl.cases.fbm.fixed is"),
                (f"{part}/cases/fbm.fixed", [-3, 0, 9], "should be from 0 to"),
                (f"{part}/cases/fbm.fixed", [10**30, 0, 0], "should be from 0 to"),
                (f"{part}/cases/fbm.fast", [0, 0, 0], "counts no case"),
                (f"{part}/verdict", "perfect", "apis.opengl.verdict is"),
                (f"{part}/sets", "f", "apis.opengl.sets is"), (f"{part}/sets", "fz", "apis.opengl.sets is"),
                (f"{part}/sets", "ff", "a bit behind the last set"),
                (f"{part}/checksums/fbm", "123", "apis.opengl.checksums.fbm is"),
                (f"{part}/checksums/fbm", 12345678, "apis.opengl.checksums.fbm is"),
                (f"{part}/checksums/FBM", "12345678", "a key of apis.opengl.checksums"),
                ("costs", {}, 'costs has no "noise2d.perlin.fast"'),
                ("costs", {"noise2d.perlin.fast": 90}, "it is 100"),
                ("costs", {"noise2d.perlin.fast": 100, "mine": 3}, 'the key "mine"'),
                ("costs", {"noise2d.perlin.fast": 100, "fbm.fbm2.fast": 0}, "costs.fbm.fbm2.fast is"),
                ("failed", "none", "failed is"), ("failed", [1], "failed[0] is"),
                ("failed", ["../../etc/passwd"], "failed[0] is"), ("failed", [f"{CASE}"] * 13, "failed has 13 cases")):
            with self.subTest(path=path, value=value):
                self.assertIn(words, self.refusal(self.change(path, value)))
        for browser, words in (("Netscape 4", "browser is"), ("Chrome 150.0", "browser is"), ("Chrome", "browser is"),
                               (None, "browser is missing")):
            made = in_browser(digest(), "Chrome 150", "Mali-G78", "ARM")
            self.assertIn(words, self.refusal(self.change("browser", browser, made)))

    def test_what_contradicts_itself(self):
        part = "apis/opengl"
        for path, value, words, made in (
                (f"{part}/checksums/fbm", "12345678", "is 12345678, and the golden files give", digest()),
                (f"{part}/checksums/fbm", "12345678", "is 12345678, and the golden files give", failing()),
                (f"{part}/checksums/fbm", None, "apis.opengl.checksums has nothing of it", digest()),
                (f"{part}/sets", "78", "apis.opengl.sets has nothing of it", digest()),
                (f"{part}/cases/noise2d.fixed", [1, 0, 4], "has 2 sets of noise2d.fixed", digest()),
                (f"{part}/cases/hash.exact", None, "has 2 sets of hash.exact", digest()),
                (f"{part}/verdict", "fail", "counts 0 that failed", digest()),
                (f"{part}/verdict", "pass", "counts 1 that failed", failing()),
                (f"{part}/cases/fbm.fast", [4, 1, 0], "counts 1 that failed", digest()),
                ("failed", [], "failed is empty", failing()), ("failed", [CASE], "counts fewer cases", digest()),
                ("failed", [CASE, CASE], "once more", failing()),
                ("failed", [CASE.replace("noise2d", "fbm")], "counts fewer cases of fbm.fixed", failing())):
            with self.subTest(path=path, value=value):
                self.assertIn(words, self.refusal(self.change(path, value, made)))
        made = digest()
        made["apis"]["opengl"] = {"cases": {"fbm.fast": [0, 0, 3]}, "checksums": {}, "sets": "00", "verdict": "pass"}
        self.assertIn("no case passed", self.refusal(text_of(made).encode()))

    def test_one_of_earlier_golden_files_is_told_apart(self):
        with self.assertRaises(Earlier) as caught:
            digest_of("a.json", digest(golden="76543210"), VERSIONS)
        self.assertIn("golden is 76543210, and that of the golden files of 0.4.0 is 00112233", str(caught.exception))
        with self.assertRaises(Refused) as caught:  # all else has to be right
            digest_of("a.json", digest(golden="76543210", system="mine"), VERSIONS)
        self.assertNotIsInstance(caught.exception, Earlier)


class Files(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        mocked = mock.patch.object(command, "known_versions", lambda: VERSIONS)
        mocked.start()
        self.addCleanup(mocked.stop)

    def put(self, name: str, made: dict[str, object]) -> Path:
        path = self.folder / name
        path.write_text(text_of(made) + "\n", encoding="ascii")
        return path

    def call(self, *arguments: object) -> tuple[int, str, str]:
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                status = command.main(list(map(str, arguments)))
            except SystemExit as end:
                status = end.code
        return status, out.getvalue(), err.getvalue()

    def test_files_that_are_none(self):
        self.put("a.json", digest())
        self.assertEqual(self.call("--check", self.folder)[0], 0)
        os.symlink("/etc/passwd", self.folder / "link.json")
        os.symlink("a.json", self.folder / "alias.json")
        os.mkfifo(self.folder / "pipe.json")
        (self.folder / "deep.json").mkdir()
        (self.folder / "large.json").write_bytes(b" " * (MOST_BYTES + 1))
        (self.folder / "run.sh").write_text("true")
        self.put("A B.json", digest())
        status, _, err = self.call("--check", self.folder)
        self.assertEqual(status, 1)
        for words in ("alias.json: it is a link", "link.json: it is a link", "pipe.json: it is no file",
                      "deep.json: it is no file",
                      f"large.json: it is larger than {MOST_BYTES} bytes", 'run.sh: its name is "run.sh"',
                      'A B.json: its name is "A B.json"'):
            self.assertIn(words, err)
        self.assertEqual(len(err.splitlines()), 7)
        self.assertEqual(self.call("--check", self.folder / "link.json")[0], 1)

    def test_bad_usage_is_status_2(self):
        for arguments in (("--check", "--freeze"), ("--page", self.folder, "--freeze"), ("--check", self.folder / "nothing.json"),
                          ("--freeze", "--earlier"), ("--page",)):
            with self.subTest(arguments=arguments):
                self.assertEqual(self.call(*arguments)[0], 2)
        (self.folder / "file.json").write_text(text_of(digest()))
        self.assertEqual(self.call("--page", self.folder / "file.json", self.folder)[0], 2)

    def test_earlier_ones_are_left_out_where_that_is_allowed(self):
        self.put("old.json", digest(golden="76543210"))
        self.assertEqual(self.call("--check", self.folder)[0], 1)
        status, out, _ = self.call("--check", "--earlier", self.folder)
        self.assertEqual((status, out.splitlines()[-1]), (0, "0 digests are right"))
        self.assertIn("left out: ", out)

    def test_a_page_is_not_made_of_what_is_refused(self):
        self.put("bad.json", digest(system="<b>"))
        self.assertEqual(self.call("--page", self.folder / "page", self.folder)[0], 1)
        self.assertFalse((self.folder / "page").exists())


class Reader(HTMLParser):
    """The text of a page, and what it loads."""

    def __init__(self) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self.loads: list[str] = []
        self.ids: set[str] = set()
        self.links: list[str] = []
        self.in_cell = False

    def handle_starttag(self, tag, attrs):
        found = dict(attrs)
        self.ids.add(found.get("id", ""))
        if tag == "a":
            self.links.append(found["href"])
        elif "src" in found or tag in ("script", "iframe", "object") or (tag == "link" and found["href"] != "data:,"):
            self.loads.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

            self.in_cell = True

    def handle_endtag(self, tag):
        self.in_cell = self.in_cell and tag not in ("td", "th")

    def handle_data(self, data):
        if self.in_cell:
            self.rows[-1][-1] += data


ARC = "ANGLE (Intel, Intel(R) Arc(TM) A770 Graphics (0x000056A0) Direct3D11 vs_5_0 ps_5_0, D3D11)"
SWIFTSHADER = "ANGLE (Google, Vulkan 1.3 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver-5.0)"
M1 = "ANGLE (Apple, ANGLE Metal Renderer: Apple M1, Unspecified Version)"


def made_up() -> dict[str, dict[str, object]]:
    """Fourteen digests of ten devices."""
    def native(renderer: str, vendor: str, driver: str, made=digest) -> dict[str, object]:
        return made(device={"driver": driver, "renderer": renderer, "vendor": vendor})

    return {
        "amd-1": native("AMD Radeon RX 6600 (navi23, LLVM 15.0, DRM 3.49)", "AMD", "4.6 Mesa 22.3", failing),
        "amd-2": native("AMD Radeon RX 6600 (navi23, LLVM 17.0, DRM 3.57)", "AMD", "4.6 Mesa 24.1"),
        "amd-again": native("AMD Radeon RX 6600 (navi23, LLVM 17.0, DRM 3.57)", "AMD", "4.6 Mesa 24.1"),
        "nvidia": native("NVIDIA GeForce RTX 3060/PCIe/SSE2", "NVIDIA Corporation", "4.6 NVIDIA 535.183"),
        "intel": native("Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "Intel", "4.6 Mesa 9.2", failing),
        "intel-newer": native("Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "Intel", "4.6 Mesa 10.0"),
        "llvmpipe": digest(costs={"fbm.fbm2.fixed": 1234, "noise2d.perlin.fast": 100}),
        "mali": in_browser(digest(system="Android"), "Chrome 150", "Mali-G78", "ARM", "webgl2", "webgpu"),
        "adreno": in_browser(failing(system="Android"), "Chrome 150", "Adreno (TM) 640", "Qualcomm"),
        "apple": in_browser(digest(system="iOS"), "Safari 26", "Apple GPU", "Apple Inc.", "webgl2", "webgpu"),
        "arc-old": in_browser(digest(system="Windows"), "Edge 148",
                              ARC, "Google Inc. (Intel)"),
        "arc": in_browser(failing(system="Windows"), "Edge 150",
                          ARC, "Google Inc. (Intel)"),
        "swiftshader": in_browser(digest(), "Chrome 150", SWIFTSHADER, "Google Inc. (Google)"),
        "m1": in_browser(digest(system="macOS"), "Firefox 140", M1, "Google Inc. (Apple)"),
    }


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.text = page.page([digest_of(f"{name}.json", made, VERSIONS) for name, made in made_up().items()])
        cls.reader = Reader()
        cls.reader.feed(cls.text)
        cls.rows = {row[0]: row[1:] for row in cls.reader.rows}

    def test_ten_devices_are_counted_once_each(self):
        self.assertIn("14 results of 10 devices", self.text)
        self.assertEqual(self.rows["HN_FIXED in OpenGL"], ["4 of 4 devices", "8"])
        self.assertEqual(self.rows["HN_FIXED in WebGL2"], ["4 of 6 devices", "8"])
        self.assertEqual(self.rows["floats in WebGL2"], ["6 of 6 devices", "4"])
        self.assertEqual(self.rows["everything in WebGPU"], ["2 of 2 devices", "21"])
        self.assertNotIn("HN_FIXED in Vulkan", self.rows)

    def test_it_says_how_much_was_run(self):
        fewer = in_browser(digest(), "Chrome 150", "Mali-G78", "ARM")
        fewer["apis"]["webgl2"]["cases"]["fbm.fast"] = [1, 0, 4]
        devices = [fewer, in_browser(digest(), "Chrome 150", "Mali-G610", "ARM")]
        reader = Reader()
        reader.feed(page.page([digest_of("a.json", made, VERSIONS) for made in devices]))
        self.assertIn(["floats in WebGL2", "2 of 2 devices", "1 to 4"], reader.rows)

    def test_the_newest_driver_that_passes_and_the_last_that_failed(self):
        self.assertEqual(self.rows["AMD Radeon RX 6600"], ["AMD", "OpenGL", "Linux", "4.6 Mesa 24.1, hashnoise 0.4.0",
                                                           "4.6 Mesa 22.3, hashnoise 0.4.0"])
        # 10.0 is newer than 9.2.
        self.assertEqual(self.rows["Mesa Intel(R) UHD Graphics 620"][3:], ["4.6 Mesa 10.0, hashnoise 0.4.0",
                                                                          "4.6 Mesa 9.2, hashnoise 0.4.0"])
        self.assertEqual(self.rows["Intel(R) Arc(TM) A770 Graphics, Edge"][3:], ["Edge 148, hashnoise 0.4.0",
                                                                                "Edge 150, hashnoise 0.4.0"])
        self.assertEqual(self.rows["NVIDIA GeForce RTX 3060/PCIe/SSE2"][4], "none")
        self.assertEqual(self.rows["Adreno (TM) 640, Chrome"][3], "none")

    def test_a_failure_of_the_same_driver_outweighs_a_pass(self):
        both = [digest_of("a.json", digest(), VERSIONS), digest_of("b.json", failing(), VERSIONS)]
        device, = devices_of(both)
        self.assertIs(device.passes("fixed"), False)
        self.assertIsNone(device.last(failed=False))
        self.assertEqual(device.last(failed=True).name, "b.json")

    def test_failures_have_their_evidence(self):
        self.assertIn(f"<code>{CASE}</code>", self.text)
        for link in self.reader.links:
            self.assertTrue(link.startswith(address()) or link[1:] in self.reader.ids, link)
        self.assertEqual(sum(link.startswith("#") for link in self.reader.links), 4)
        self.assertIn("The checksums of noise2d are not those of other devices.", self.text)

    def test_costs_stand_beside_static_counts(self):
        row = self.rows["fbm.fbm2.fixed"]
        self.assertEqual(row[0], "12.34")
        self.assertTrue(all(float(cell) > 1 for cell in row[1:]), row)

    def test_it_is_one_file_for_a_phone(self):
        self.assertEqual(self.reader.loads, [])
        self.assertIn('name="viewport"', self.text)
        self.assertNotRegex(self.text, r"url\(|@import")

    def test_what_stands_in_a_digest_is_text(self):
        # No such digest is taken; if one were, it would be text all the same.
        evil = '"><script>alert(1)</script>'
        made = digest_of("a.json", failing(), VERSIONS)
        for field in ("renderer", "vendor", "driver", "system", "version", "name"):
            changed = made.__class__(**{**vars(made), field: "1.0" if field == "version" else evil})
            self.assertNotIn("<script", page.page([changed]), field)
        self.assertNotIn("<script", page.page([made.__class__(**{**vars(made), "failed": (evil,)})]))

    def test_without_results(self):
        self.assertIn("There are no results yet.", page.page([]))


class Names(unittest.TestCase):
    def test_releases_are_numbers(self):
        self.assertLess(release("4.6 Mesa 9.2"), release("4.6 Mesa 10.0"))
        self.assertEqual(release("4.5 (Compatibility Profile) Mesa 22.3"), (22, 3))
        self.assertEqual(release("Vulkan 1.3, Mesa 22.3 (LLVM 15.0)"), (22, 3))
        self.assertEqual(release("Chrome 150"), (150,))
        self.assertEqual(release("unknown"), ())

    def test_a_device_is_not_its_driver(self):
        for renderer, name in (("llvmpipe (LLVM 15.0, 256 bits)", "llvmpipe"), ("Mali-G78", "Mali-G78"),
                               ("ANGLE (Mesa/X.org, llvmpipe (LLVM 15.0 256 bits), OpenGL ES 3.2)", "llvmpipe"),
                               ("ANGLE (Samsung Xclipse 920) on Vulkan 1.1", "Samsung Xclipse 920"),
                               ("ANGLE (NVIDIA, NVIDIA GeForce GTX 980 Direct3D11 vs_5_0 ps_5_0), or similar",
                                "NVIDIA GeForce GTX 980"),
                               ("ANGLE (NVIDIA GeForce GTX 1080 Direct3D11 vs_5_0 ps_5_0)", "NVIDIA GeForce GTX 1080"),
                               ("ANGLE (AMD, AMD Radeon (TM) Graphics (renoir, LLVM 15.0, DRM 3.49), OpenGL 4.6)",
                                "AMD Radeon (TM) Graphics"),
                               ("ANGLE (AMD, Vulkan 1.3 (AMD Radeon RX 6600 (RADV NAVI23) (0x000073FF)), radv)",
                                "AMD Radeon RX 6600"),
                               ("llvmpipe, or similar", "llvmpipe"), (ARC, "Intel(R) Arc(TM) A770 Graphics"),
                               (SWIFTSHADER, "SwiftShader Device"), (M1, "Apple M1")):
            self.assertEqual(device_name(renderer), name)


class Golden(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

        def put(function: str, columns: str, settings: str, *rows: str) -> None:
            (self.folder / f"{function}.golden").write_text(GOLDEN.format(
                function=function, name=function.partition(".")[2], columns=columns, settings=settings,
                rows="\n".join(rows)))

        put("noise2d.perlin_d", "value:f64", "lattice:fast lattice+fixed:fixed",
            "00000000 00000007 = 3fb999a000000000 = 3fe0000000000000", "00000000 00000008 = - = bfe0000000000000")
        put("noise2d.perlin", "value:f64 cx:i32", "lattice+fixed:fixed",
            "00000000 00000007 = 3fe0000000000000 ffffffff", "00000000 00000008 = 8000000000000000 00000002")
        put("hash.word", "value:u32", "fnv1:exact pcg:exact", "00000000 00000007 = 00000001 = 00000002",
            "00000000 00000008 = 01020304 = 00000003", "digest fnv1 origin=0 size=4 fnv1a64=0123456789abcdef")

    def test_sets_and_their_checksums(self):
        sets = GoldenSets(self.folder)
        self.assertEqual(list(zip(sets.functions, sets.settings)),
                         [("hash.word", "fnv1:exact"), ("hash.word", "pcg:exact"),
                         ("noise2d.perlin", "lattice+fixed:fixed"),
                          ("noise2d.perlin_d", "lattice+fixed:fixed")])
        words = [b"\1\0\0\0\4\3\2\1", b"\2\0\0\0\3\0\0\0", b"\0\0\0\x3f\xff\xff\xff\xff\0\0\0\x80\2\0\0\0",
                 b"\0\0\0\x3f\0\0\0\xbf"]
        self.assertEqual([sets.checksum(number) for number in range(4)], list(map(zlib.crc32, words)))
        before = sets.golden
        with (self.folder / "hash.word.golden").open("a") as file:
            file.write("\n")
        self.assertNotEqual(GoldenSets(self.folder).golden, before)

    def test_they_are_kept_for_later(self):
        sets = GoldenSets(self.folder)
        path = self.folder / "versions" / "1.2.3.csv"
        write(path, sets)
        kept = FrozenSets(path)
        self.assertEqual((kept.functions, kept.settings, kept.golden), (sets.functions, sets.settings, sets.golden))
        self.assertEqual(kept.combined(range(4)), sets.combined(range(4)))
        self.assertEqual(set(command.known_versions(path.parent)), {"1.2.3", version()})
        path.write_text("something,else\n")
        with self.assertRaisesRegex(ValueError, "tools/make results --freeze writes it"):
            FrozenSets(path)


class Constants(unittest.TestCase):
    """Constants in C++, in JavaScript and here are the same."""

    def test_they_agree(self):
        report = ROOT / "conformance" / "report"
        cpp = (report / "digest.hpp").read_text() + (report / "digest.cpp").read_text()
        web = (ROOT / "conformance" / "web" / "digest.js").read_text()
        for name, value in (("kMostDigestBytes", MOST_BYTES), ("kMostNameBytes", 96), ("kMostFailed", 12),
                            ("kMostBytesRead", 400)):
            self.assertRegex(cpp, rf"{name} = {value};")
            self.assertRegex(web, rf"{name} = {value};")
        for text in (cpp, web):
            self.assertIn('"hashnoise-digest 1"', text)
        from measure.results.digest import BROWSERS, TIMED
        whereabouts = (ROOT / "conformance" / "web" / "whereabouts.js").read_text().partition("kSystems")[0]
        browsers = re.findall(r'\["([A-Za-z ]+)", /', whereabouts)
        self.assertEqual(sorted(browsers), sorted(BROWSERS))
        timed_text = (ROOT / "conformance" / "library" / "timed.hpp").read_text()
        timed, = re.findall(r"kTimed = \{(.*?)\};", timed_text, re.DOTALL)
        self.assertEqual(tuple(re.findall(r'"(.*?)"', timed)), TIMED)


class Committed(unittest.TestCase):
    def test_a_digest_of_the_folder_with_one_wrong_bit_is_refused(self):
        versions = command.known_versions()
        path = next(path for path in sorted(command.RESULTS.glob("*.json")))
        found = json.loads(path.read_text())
        if found["golden"] != versions[found["version"]].golden:
            self.skipTest("the digests are of earlier golden files")
        read(path, versions)
        part = next(iter(found["apis"].values()))
        group = sorted(part["checksums"])[0]
        part["checksums"][group] = f"{int(part['checksums'][group], 16) ^ 1:08x}"
        with self.assertRaisesRegex(Refused, "and the golden files give"):
            digest_of(path.name, found, versions)


if __name__ == "__main__":
    unittest.main()
