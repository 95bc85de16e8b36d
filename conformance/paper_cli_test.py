#!/usr/bin/env python3
"""hn-conform paper as its user meets it: the page, the pictures, and the numbers calculated again from what --dump
writes. Usage: paper_cli_test.py PATH-OF-HN-CONFORM"""

import array
import collections
import concurrent.futures
import copy
import csv
import html.parser
import itertools
import json
import math
import operator
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = ""
WORD = 0xFFFFFFFF

# The paper's table: instructions, ms at 800 x 600, ms at 1024 x 768.
PRINTED = {
    ("Perlin/FNV1", 2): (165, 11.5, 17.5),
    ("Perlin/PartialFNV1", 2): (77, 6.2, 8.7),
    ("Perlin/Jenkins", 2): (309, 14.0, 20.0),
    ("Perlin/PartialJenkins", 2): (133, 7.0, 10.4),
    ("Perlin/Murmur", 2): (93, 7.5, 10.5),
    ("Perlin/Float", 2): (37, 4.6, 8.0),
    ("Perlin/Integer", 2): (66, 21.4, 33.1),
    ("Perlin/FNV1", 3): (473, 23.6, 33.0),
    ("Perlin/PartialFNV1", 3): (209, 13.3, 19.0),
    ("Perlin/Jenkins", 3): (905, 29.0, 40.0),
    ("Perlin/PartialJenkins", 3): (377, 15.4, 22.1),
    ("Perlin/Murmur", 3): (257, 17.0, 23.0),
    ("Perlin/Float", 3): (77, 12.5, 17.5),
    ("Perlin/Integer", 3): (134, 40.1, 60.0),
}
HASH_NAMES = ("fnv1", "partial_fnv1", "jenkins", "partial_jenkins", "murmur")
FORMS = {"as published": "published", "as intended": "intended", "ours": "ours"}


# --- The page ---

class Page(html.parser.HTMLParser):
    """The links of a page, its visible text, and its tables as (heading above, rows of (tag, class, text))."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.tags, self.links, self.texts, self.tables = set(), [], [], []
        self.heading, self.open, self.styles = "", [], ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.add(tag)
        attributes = dict(attributes)
        for name in ("href", "src", "srcset", "data", "poster", "action", "xlink:href"):
            if attributes.get(name) is not None:
                self.links.append(attributes[name])
        self.styles += attributes.get("style") or ""
        if tag in ("meta", "link", "img", "br"):
            return
        self.open.append(tag)
        if tag in ("h2", "h3"):
            self.heading = ""
        if tag == "table":
            self.tables.append((self.heading, []))
        if tag == "tr":
            self.tables[-1][1].append([])
        if tag in ("td", "th"):
            self.tables[-1][1][-1].append([tag, attributes.get("class", ""), ""])

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if self.open and self.open[-1] == tag:
            self.open.pop()

    def handle_endtag(self, tag):
        if tag in self.open:
            while self.open.pop() != tag:
                pass

    def handle_data(self, data):
        if "style" in self.open:
            self.styles += data
            return
        self.texts.append(data)
        if self.open and self.open[-1] in ("h2", "h3"):
            self.heading += data
        if "td" in self.open or "th" in self.open:
            self.tables[-1][1][-1][-1][2] += data

    def text(self):
        return " ".join(self.texts)

    def rows(self):
        return [(heading, row) for heading, rows in self.tables for row in rows]


def page_faults(text, folder, provenance):
    """What a reader of the page would miss: files, things from elsewhere, numbers, where they come from."""
    page = Page(text)
    faults = []
    for link in page.links:
        if re.match(r"[a-z+.-]+:|//|/", link, re.IGNORECASE):
            faults.append(f"a link leads elsewhere: {link}")
        elif not link.startswith("#") and not (folder / link).is_file():
            faults.append(f"there is no file {link}")
    faults += [f"a tag <{tag}>" for tag in sorted(page.tags & {"script", "link", "iframe", "object", "embed", "base"})]
    if re.search(r"url\(|@import", page.styles):
        faults.append("a style loads something")
    faults += [f"the text has {word}" for word in re.findall(r"(?i)\b(?:nan|inf|infinity)\b", page.text())]
    for heading, row in page.rows():
        faults += [f"an empty cell under {heading}: {row}" for _, kind, cell in row if kind == "number" and not cell]
    faults += [f"the page does not say {key}" for key, value in provenance.items() if value not in page.text()]
    return faults


def table_faults(text, rows):
    """Where the page's table is not paper.json's, or is not beside the paper's numbers."""
    counts = {(row["title"], row["form"], row["dimensions"]): row["instructions"]["spirv"] for row in rows}
    faults = []
    seen = set()
    for heading, row in Page(text).rows():
        cells = [cell for _, _, cell in row]
        if heading not in ("2D", "3D") or len(cells) != 15 or cells[0] == "algorithm":
            continue
        dimensions = int(heading[0])
        key = (cells[0], dimensions)
        seen.add((*key, cells[1]))
        if cells[2] != str(counts.get((cells[0], cells[1], dimensions))):
            faults.append(f"{cells[:2]} in {heading}: not the SPIR-V count of paper.json")
        paper = [cells[index] for index in (6, 8, 10, 12, 14)]
        expected = ["not in it"] * 5
        if key in PRINTED:
            instructions, small, large = PRINTED[key]
            _, small_float, large_float = PRINTED["Perlin/Float", dimensions]
            expected = [f"~{instructions}", f"{small:.1f}", f"{small / small_float:.2f}", f"{large:.1f}",
                        f"{large / large_float:.2f}"]
        if paper != expected:
            faults.append(f"{cells[:2]} in {heading}: the paper's numbers are {expected}, not {paper}")
    missing = {(row["title"], row["dimensions"], row["form"]) for row in rows} - seen
    faults += [f"no row of {row}" for row in sorted(missing)]
    faults += [f"the paper's {key} is in no row" for key in PRINTED if key not in {row[:2] for row in seen}]
    return faults


def csv_faults(path, rows):
    with path.open(newline="") as file:
        lines = list(csv.reader(file))
    faults = [f"{path.name}: {len(line)} cells" for line in lines if len(line) != len(lines[0])]
    if len(lines) != rows + 1:
        faults.append(f"{path.name}: {len(lines) - 1} rows, not {rows}")
    return faults


def picture_faults(data, width, height):
    if data[:8] != b"\x89PNG\r\n\x1a\n" or data[12:16] != b"IHDR":
        return ["no PNG"]
    if data[-8:-4] != b"IEND":
        return ["the PNG has no end"]
    size = struct.unpack(">II", data[16:24])
    return [] if size == (width, height) else [f"{size} pixels, not {(width, height)}"]


# --- Instructions ---

def count_of_listing(listing):
    """The instructions of a listing of spirv-dis, by the page's rule: in functions, without labels and parameters."""
    count, inside = 0, False
    for line in listing.splitlines():
        match = re.match(r"\s*(?:%\S+ = )?(Op\w+)", line)
        opcode = match[1] if match else ""
        inside = inside and opcode != "OpFunctionEnd"
        count += inside and opcode not in ("OpLabel", "OpFunctionParameter")
        inside = inside or opcode == "OpFunction"
    return count


def spirv_faults(row, path):
    listing = subprocess.run(["spirv-dis", "--raw-id", path], capture_output=True, text=True, check=False)
    if listing.returncode != 0:
        return [f"{row['id']}: spirv-dis says {listing.stderr.strip()}"]
    counted, told = count_of_listing(listing.stdout), row["instructions"]["spirv"]
    return [] if counted == told else [f"{row['id']}: {counted} instructions, not {told}"]


def order_faults(rows):
    """The five hashes have as many instructions, one after the other, as in the paper; in the listings by as much."""
    faults = []
    for dimensions, (form, _) in itertools.product((2, 3), FORMS.items()):
        found = {row["algorithm"]: (row["instructions"]["spirv"], PRINTED[row["title"], dimensions][0]) for row in rows
                 if row["dimensions"] == dimensions and row["form"] == form and row["algorithm"] in HASH_NAMES}
        by_spirv = sorted(found, key=lambda name: found[name][0])
        by_paper = sorted(found, key=lambda name: found[name][1])
        if by_spirv != by_paper or sorted(found) != sorted(HASH_NAMES):
            faults.append(f"{form}, {dimensions}D: {by_spirv}, in the paper {by_paper}")
        # An evaluation of a listing is an instruction for each of its operations, here as in the paper: none is saved.
        # The rest of the shader differs, by the same number for all of them.
        apart = {spirv - paper for spirv, paper in found.values()}
        if form == "as published" and len(apart) != 1:
            faults.append(f"{form}, {dimensions}D: further apart from the paper than each other by {sorted(apart)}")
        table, = (row["instructions"]["spirv"] for row in rows
                  if row["dimensions"] == dimensions and row["algorithm"] == "float")
        if not all(table < spirv for spirv, _ in found.values()):
            faults.append(f"{form}, {dimensions}D: Perlin/Float has more than a hash")
    return faults


# --- Statistics ---

def floats(data):
    values = array.array("f", data)
    if sys.byteorder == "big":
        values.byteswap()
    return values


def statistics_faults(sample, data):
    """Where a sample's numbers in paper.json are not those of its grid."""
    values = floats(data)
    count = len(values)
    if count != 1 << 20 or not all(map(math.isfinite, values)):
        return [f"{sample['id']}: {count} values, or some that are no numbers"]
    mean = math.fsum(values) / count
    first = [value - mean for value in values]
    second = list(map(operator.mul, first, first))
    variance = math.fsum(second) / count
    third = math.fsum(map(operator.mul, first, second)) / count
    fourth = math.fsum(map(operator.mul, second, second)) / count
    bins = collections.Counter(map(math.floor, [value * 32.0 for value in values]))  # exact: of 1/32, from -1.5
    bins[47] += bins.pop(48, 0)  # 1.5 itself
    expected = {
        "count": (count, 0), "minimum": (min(values), 0), "maximum": (max(values), 0), "mean": (mean, 1e-14),
        "variance": (variance, 1e-13), "skewness": (third / variance ** 1.5, 1e-11),
        "excess_kurtosis": (fourth / variance ** 2 - 3, 1e-11), "zeros": (values.count(0.0) / count, 0),
    }
    faults = [f"{sample['id']}: {key} is {value!r}, not {sample[key]!r}" for key, (value, tolerance) in expected.items()
              if not abs(sample[key] - value) <= tolerance]
    if sample["histogram"] != [bins.pop(bin_, 0) for bin_ in range(-48, 48)] or any(bins.values()):
        faults.append(f"{sample['id']}: another histogram")
    return faults


def statistics_faults_of_file(sample, path):
    return statistics_faults(sample, path.read_bytes())


def chi_square_faults(comparison, samples):
    """Of two histograms, over the bins that have 20 values or more in both together."""
    both = zip(samples[comparison["full"]]["histogram"], samples[comparison["partial"]]["histogram"])
    terms = [(a - b) ** 2 / (a + b) for a, b in both if a + b >= 20]
    right = len(terms) - 1 == comparison["degrees"] and math.isclose(math.fsum(terms), comparison["chi_square"])
    return [] if right else [f"{comparison['full']}: chi-square is {math.fsum(terms)} of {len(terms)} bins"]


# --- The noise, from the formulas ---

def fnv1(key):
    h = 2166136261
    for shift in (0, 8, 16, 24):
        h = (h * 16777619 & WORD) ^ (key >> shift & 255)
    return h


def partial_fnv1(key):
    h = 2166136261
    for _ in range(2):
        h = (h * 16777619 & WORD) ^ key
    return h


def jenkins_of(parts):
    h = 0
    for part in parts:
        h = h + part & WORD
        h = h + (h << 10) & WORD
        h ^= h >> 6
    h = h + (h << 3) & WORD
    h ^= h >> 11
    return h + (h << 15) & WORD


def murmur(key):
    key = key * 1540483477 & WORD
    key ^= key >> 24
    return (10 * 1540483477 & WORD) ^ (key * 1540483477 & WORD)


HASHES = {"fnv1": fnv1, "partial_fnv1": partial_fnv1,
          "jenkins": lambda key: jenkins_of([key >> shift & 255 for shift in (0, 8, 16, 24)]),
          "partial_jenkins": lambda key: jenkins_of([key]), "murmur": murmur}


def sine(word):
    """Of float(int(word))."""
    word &= WORD
    signed = word - (1 << 32) if word >> 31 else word
    return math.sin(struct.unpack("<f", struct.pack("<f", signed))[0])


def sine_gradient(name, cell):
    last, words = 0, []
    for coordinate in cell:
        last = HASHES[name](last + coordinate % (1 << 20) & WORD)
        words.append(last)
    return [sine(last + word) for word in words]


def permutation():
    """SplitMix64 from a state made of the word "permutation"; Fisher and Yates."""
    state = 0
    for character in b"permutation":
        state = (state ^ character) * 0x100000001B3 % (1 << 64)
    numbers = list(range(256))
    for i in range(255, 0, -1):
        state = (state + 0x9E3779B97F4A7C15) % (1 << 64)
        z = state
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 % (1 << 64)
        z = (z ^ z >> 27) * 0x94D049BB133111EB % (1 << 64)
        j = (z ^ z >> 31) >> 32
        j = j * (i + 1) >> 32
        numbers[i], numbers[j] = numbers[j], numbers[i]
    return numbers


PERMUTATION = permutation()
TABLE_2D = [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)]
TABLE_3D = [(1, 1, 0), (-1, 1, 0), (1, -1, 0), (-1, -1, 0), (1, 0, 1), (-1, 0, 1), (1, 0, -1), (-1, 0, -1),
            (0, 1, 1), (0, -1, 1), (0, 1, -1), (0, -1, -1), (1, 1, 0), (-1, 1, 0), (0, -1, 1), (0, -1, -1)]


def table_gradient(cell):
    index = 0
    for coordinate in cell:
        index = PERMUTATION[index + coordinate & 255]
    return TABLE_2D[index & 7] if len(cell) == 2 else TABLE_3D[index & 15]


def perlin(gradient, position):
    value = 0.0
    cell = [math.floor(x) for x in position]
    fraction = [x - c for x, c in zip(position, cell)]
    weight = [6 * t ** 5 - 15 * t ** 4 + 10 * t ** 3 for t in fraction]
    for corner in itertools.product((0, 1), repeat=len(position)):
        ramp = sum(g * (f - o) for g, f, o in
                   zip(gradient([c + o for c, o in zip(cell, corner)]), fraction, corner))
        value += ramp * math.prod(w if o else 1 - w for w, o in zip(weight, corner))
    return value


def position_of(index, dimensions):
    """Where statistics_faults' values are, as the page tells."""
    if dimensions == 2:
        j, i = divmod(index, 1024)
        return [n * (2 + 341 / 1024) + 1 / 2048 for n in (i, j)]
    rest, i = divmod(index, 128)
    k, j = divmod(rest, 128)
    return [i * (2 + 41 / 128) + 1 / 256, j * (2 + 41 / 128) + 1 / 256, k * (2 + 41 / 64) + 1 / 128]


def noise_differences(sample, data, points=400):
    """How far the values of some points are from those calculated here."""
    name, form = sample["id"].split(".")[:2]
    gradient = table_gradient if form == "table" else lambda cell: sine_gradient(name, cell)
    values = floats(data)
    indices = [number * 611953 % (1 << 20) for number in range(points)]
    return [abs(values[i] - perlin(gradient, position_of(i, sample["dimensions"]))) for i in indices]


# --- Tests ---

class Paper(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.out = pathlib.Path(folder.name) / "out"
        cls.arguments = ["paper", "--rounds", "3", "--dump", "--out", str(cls.out)]
        cls.done = subprocess.run([PROGRAM, *cls.arguments], capture_output=True, text=True, check=False)
        if cls.done.returncode != 0:
            raise AssertionError(f"status {cls.done.returncode}: {cls.done.stderr}")
        cls.page = (cls.out / "index.html").read_text()
        cls.data = json.loads((cls.out / "paper.json").read_text())
        cls.samples = {sample["id"]: sample for sample in cls.data["statistics"]["samples"]}

    def grid(self, sample_id):
        return (self.out / "grids" / f"{sample_id}.f32").read_bytes()

    def provenance(self):
        keys = ("renderer", "gl_version", "glsl_version", "date", "command", "version")
        return {key: self.data[key] for key in keys}

    # The page.

    def test_it_says_where_the_page_is(self):
        self.assertIn(f"{self.out}/index.html", self.done.stdout)
        self.assertIn("llvmpipe", self.done.stdout)

    def test_the_page_is_complete_and_loads_nothing_from_elsewhere(self):
        self.assertEqual(page_faults(self.page, self.out, self.provenance()), [])
        page = Page(self.page)
        self.assertEqual(sum(link.endswith(".png") for link in page.links), 3 * (18 * 2 + 1))
        self.assertRegex(self.data["date"], r"^20\d\d-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertEqual(self.data["command"], " ".join(["hn-conform", *self.arguments]))
        self.assertEqual(self.data["driver"], "osmesa")

    def test_a_page_with_a_fault_is_seen(self):
        for old, new, fault in (
            ("fnv1.intended.clouds.png", "fnv2.intended.clouds.png", "there is no file fnv2"),
            ('src="', 'src="https://example.org/', "leads elsewhere: https://example.org/"),
            ('src="', 'src="//example.org/', "leads elsewhere: //"),
            ("</body>", "<script>1</script></body>", "a tag <script>"),
            ("</style>", "body { background: url(https://example.org/x.png) }</style>", "a style loads"),
            ("</style>", '@import "x.css";</style>', "a style loads"),
            ("1.00 ± 0.00", "nan ± 0.00", "the text has nan"),
            ('<td class="number">~165</td>', '<td class="number"></td>', "an empty cell under 2D"),
            (self.data["date"], "", "does not say date"),
            ("<code>hn-conform paper", "<code>hn-conform pap", "does not say command"),
        ):
            with self.subTest(new=new):
                self.assertIn(old, self.page)
                faults = page_faults(self.page.replace(old, new, 1), self.out, self.provenance())
                self.assertTrue(any(fault in found for found in faults), faults)

    def test_the_table_stands_beside_the_papers(self):
        self.assertEqual(table_faults(self.page, self.data["table"]["rows"]), [])

    def test_a_wrong_number_in_the_table_is_seen(self):
        rows = self.data["table"]["rows"]
        for old, new in (("~165", "~164"), (">33.1<", ">33.2<"), (">4.65<", ">4.64<"), ("Perlin/Murmur<", "Murmur<")):
            with self.subTest(new=new):
                self.assertIn(old, self.page)
                self.assertNotEqual(table_faults(self.page.replace(old, new, 1), rows), [])
        changed = copy.deepcopy(rows)
        changed[1]["instructions"]["spirv"] += 1
        self.assertNotEqual(table_faults(self.page, changed), [])

    def test_the_files_that_are_told_exist(self):
        for name, rows in (("table.csv", 38), ("statistics.csv", 36), ("period.csv", 40), ("bandwidth.csv", 70)):
            self.assertEqual(csv_faults(self.out / name, rows), [])
        side = self.data["figures"]["side"]
        self.assertGreaterEqual(side, 512)
        self.assertEqual([sheet["file"] for sheet in self.data["figures"]["sheets"]],
                         ["sheet.intended.png", "sheet.published.png", "sheet.ours.png"])
        for sheet in self.data["figures"]["sheets"]:
            self.assertEqual(picture_faults((self.out / sheet["file"]).read_bytes(), 3 * side, 6 * side), [])
            figures = [figure["file"] for row in sheet["rows"] for figure in row["figures"]]
            self.assertEqual(len(set(figures)), 18)
            pictures = {(self.out / figure).read_bytes() for figure in figures}
            self.assertEqual(len(pictures), 18)
            for picture in pictures:
                self.assertEqual(picture_faults(picture, side, side), [])

    def test_a_picture_with_a_fault_is_seen(self):
        picture = (self.out / "fnv1.intended.noise.png").read_bytes()
        self.assertEqual(picture_faults(picture, 512, 513), ["(512, 512) pixels, not (512, 513)"])
        self.assertEqual(picture_faults(picture[1:], 512, 512), ["no PNG"])
        self.assertEqual(picture_faults(picture[:-20], 512, 512), ["the PNG has no end"])

    # The numbers.

    def test_times_and_periods_are_numbers_that_can_be(self):
        for row in self.data["table"]["rows"]:
            for timing in row["timing"]:
                self.assertGreater(timing["milliseconds"], 0.0)
        for curve in self.data["bandwidth"]["curves"]:
            self.assertEqual(len(curve["milliseconds"]), 7)
            self.assertGreater(min(curve["milliseconds"]), 0.0)
        rows = self.data["periods"]["rows"]
        self.assertEqual({row["verdict"] for row in rows}, {"as stated"})
        self.assertEqual({row["period"] for row in rows}, {256, 1048576, 48, 999983})

    def test_instructions_are_those_that_spirv_dis_shows(self):
        rows = self.data["table"]["rows"]
        self.assertEqual(len({row["id"] for row in rows}), 38)
        self.assertEqual(len(list((self.out / "spirv").iterdir())), 38)
        for row in rows:
            self.assertEqual(spirv_faults(row, self.out / "spirv" / f"{row['id']}.spv"), [])

    def test_a_wrong_count_is_seen(self):
        row = copy.deepcopy(self.data["table"]["rows"][1])
        other = self.out / "spirv" / "jenkins.published.2d.spv"
        self.assertRegex(spirv_faults(row, other)[0], r"fnv1.published.2d: \d+ instructions, not \d+")
        row["instructions"]["spirv"] -= 1
        self.assertEqual(len(spirv_faults(row, self.out / "spirv" / f"{row['id']}.spv")), 1)
        self.assertIn("spirv-dis says", spirv_faults(row, self.out / "paper.json")[0])

    def test_instructions_are_in_the_papers_order(self):
        self.assertEqual(order_faults(self.data["table"]["rows"]), [])

    def test_another_order_is_seen(self):
        for form, algorithm, change, fault in (
            ("ours", "murmur", -100, "ours, 2D"),
            ("as published", "fnv1", 1, "apart"),
            ("as intended", "jenkins", -200, "as intended, 2D"),
            ("tables in textures", "float", 60, "Perlin/Float has more"),
        ):
            rows = copy.deepcopy(self.data["table"]["rows"])
            row = next(row for row in rows if row["form"] == form and row["algorithm"] == algorithm)
            row["instructions"]["spirv"] += change
            self.assertTrue(any(fault in found for found in order_faults(rows)), algorithm)

    def test_statistics_are_those_of_the_grids(self):
        self.assertEqual(len(self.samples), 36)
        samples = list(self.samples.values())
        paths = [self.out / "grids" / f"{sample['id']}.f32" for sample in samples]
        with concurrent.futures.ProcessPoolExecutor() as pool:
            faults = list(pool.map(statistics_faults_of_file, samples, paths))
        self.assertEqual(list(itertools.chain(*faults)), [])

    def test_a_changed_byte_of_a_grid_is_seen(self):
        sample = self.samples["murmur.intended.3d"]
        grid = bytearray(self.grid(sample["id"]))
        # Of a number between 1/8 and 1/4: the lowest byte, the sign.
        at = 4 * next(i for i, value in enumerate(floats(grid)) if 0.125 <= value < 0.25)
        for byte, change, faults in ((at, 0x80, ("mean",)), (at + 3, 0x80, ("mean", "skewness", "histogram"))):
            grid[byte] ^= change
            found = statistics_faults(sample, grid)
            grid[byte] ^= change
            for fault in faults:
                self.assertTrue(any(fault in text for text in found), found)
        self.assertEqual(len(statistics_faults(sample, grid[:-4])), 1)

    def test_a_changed_statistic_is_seen(self):
        grid = self.grid("fnv1.ours.2d")
        changed = copy.deepcopy(self.samples["fnv1.ours.2d"])
        changed["histogram"][40] += 1
        for key in ("count", "minimum", "maximum", "mean", "variance", "skewness", "excess_kurtosis", "zeros"):
            changed[key] += 1e-9
        self.assertEqual(len(statistics_faults(changed, grid)), 9)

    def test_chi_square_is_that_of_the_histograms(self):
        comparisons = self.data["statistics"]["partial_against_full"]
        self.assertEqual(len(comparisons), 12)
        for comparison in comparisons:
            self.assertEqual(chi_square_faults(comparison, self.samples), [])
        wrong = {**comparisons[0], "degrees": comparisons[0]["degrees"] + 1}
        self.assertEqual(len(chi_square_faults(wrong, self.samples)), 1)

    def test_noise_is_that_of_the_formulas(self):
        largest = {}
        for sample in self.samples.values():
            form = sample["id"].split(".")[1]
            if form in ("intended", "table"):
                differences = noise_differences(sample, self.grid(sample["id"]))
                largest[form] = max(largest.get(form, 0.0), *differences)
        print("largest differences from the formulas:", {form: f"{value:.2g}" for form, value in largest.items()})
        self.assertEqual(set(largest), {"intended", "table"})
        for form, value in largest.items():
            self.assertLessEqual(value, 2.0 ** -10, form)

    def test_another_noise_is_seen(self):
        for sample_id, other in (("fnv1.intended.2d", "partial_fnv1.intended.2d"),
                                 ("murmur.intended.3d", "murmur.published.3d"), ("float.table.2d", "fnv1.ours.2d")):
            self.assertGreater(max(noise_differences(self.samples[sample_id], self.grid(other))), 0.25)
        grid = bytearray(self.grid("fnv1.intended.2d"))
        for sign in range(3, len(grid), 4):
            grid[sign] ^= 0x80
        self.assertGreater(max(noise_differences(self.samples["fnv1.intended.2d"], grid)), 0.25)


class Usage(unittest.TestCase):
    def call(self, *arguments):
        """Mistakes are told before anything is measured."""
        start = time.monotonic()
        done = subprocess.run([PROGRAM, "paper", *map(str, arguments)], capture_output=True, text=True, check=False)
        self.assertLess(time.monotonic() - start, 10.0)  # a run takes about a minute
        return done

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_bad_usage_is_status_2_and_says_what_would_be_right(self):
        (self.folder / "file").write_text("")
        out = ["--out", self.folder / "out"]
        for arguments, expected in (
            ([*out, "--driver", "voodoo"], "there are: osmesa, egl"),
            ([*out, "--driver", "egl-device:many"], "there are: osmesa, egl"),
            (["--out", self.folder / "file" / "out"], "--out wants a folder that can be written"),
            (["--out", "/proc/paper"], "--out wants a folder that can be written"),
            ([*out, "--rounds", "2"], "rounds"),
            ([*out, "--rounds", "-3"], "rounds"),
            ([*out, "--rounds", "many"], "rounds"),
            ([*out, "--glsl", self.folder], "a copy of every file of glsl/"),
            ([*out, "--frobnicate"], "frobnicate"),
        ):
            with self.subTest(arguments=arguments):
                done = self.call(*arguments)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(expected, done.stderr + done.stdout)

    def test_a_driver_that_is_not_here_is_status_3(self):
        done = self.call("--out", self.folder / "out", "--driver", "egl-device:99")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("egl-device:99 cannot be used here", done.stderr)

    def test_help_is_status_0(self):
        self.assertEqual(self.call("--help").returncode, 0)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
