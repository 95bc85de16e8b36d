"""The Rust crate that tools/pack makes: cargo builds it without a warning, its tests hold it to the vectors, and they
notice a change: by the oldest Rust that is here, and by the newest. By default some modules are made, and in thorough
runs all.

Exit status: 0 it is right, 1 not, 77 there is no cargo.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from base.debian import Missing
from base.testing import skipped_without
from base.thorough import THOROUGH, in_thorough_runs
from base.tree import ROOT, version
from base.versions import folders, path_of
from ship.packing import put
from ship.packing_support import refusals
from ship.rust.files import ALL, NEEDED, package

SOME = (*NEEDED, "random")


def check() -> None:
    missing = [program for program in ("cargo", "rustc") if not shutil.which(program)]
    if missing:
        raise Missing(f"there is no {' and no '.join(missing)}: apt-get install cargo")


class Crate(unittest.TestCase):
    folder: Path
    path = os.environ["PATH"]
    tries_faults = True  # by default with one Rust

    @classmethod
    def setUpClass(cls) -> None:
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name)
        put(cls.folder, package(",".join(ALL if THOROUGH else SOME)))

    def cargo(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        # Cargo wants no network, and a warning is an error.
        environment = {**os.environ, "PATH": self.path, "RUSTFLAGS": "-D warnings", "RUSTDOCFLAGS": "-D warnings --cfg docsrs",
                       "CARGO_TERM_COLOR": "never", "CARGO_INCREMENTAL": "0", "CARGO_PROFILE_DEV_DEBUG": "0"}
        return subprocess.run([shutil.which("cargo", path=self.path), *arguments], cwd=self.folder, env=environment,
                              capture_output=True, text=True, check=False)

    def test_it_has_the_values_of_the_library(self) -> None:
        done = self.cargo("test", "--tests", "--offline")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_cargo_finds_no_fault_with_the_text(self) -> None:
        """clippy with its default lints. rustfmt skips tools/pick's text."""
        for words, fault in ((("clippy", "--all-targets"), "\npub fn same(x: f32) -> f32 {\n    x - x\n}\n"),
                             (("fmt", "--check"), "\npub  use fast::*;\n")):
            if not shutil.which(f"cargo-{words[0]}", path=self.path):
                self.skipTest(f"there is no cargo {words[0]}: apt-get install rust-clippy rustfmt")
            offline = ("--offline",) if words[0] == "clippy" else ()
            path = self.folder / "src" / "lib.rs"
            right = path.read_text(encoding="utf-8")
            self.addCleanup(path.write_text, right, encoding="utf-8")
            for text, returned in ((right, 0), *([(right + fault, 1)] if self.tries_faults else [])):
                path.write_text(text, encoding="utf-8")
                done = self.cargo(words[0], *offline, *words[1:])
                self.assertEqual(bool(done.returncode), bool(returned), done.stdout + done.stderr)

    def test_a_change_is_noticed(self) -> None:
        if not self.tries_faults:
            self.skipTest("takes long: tools/test --thorough tries it with each Rust")
        path = self.folder / "src" / "hash.rs"
        right = path.read_text(encoding="utf-8")
        self.addCleanup(path.write_text, right, encoding="utf-8")
        path.write_text(right.replace("0x2C1B3C6D", "0x2C1B3C6F"), encoding="utf-8")
        done = self.cargo("test", "--tests", "--offline", "functions_have")
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"hash\.word with lattice: \d+ rows, such as ")

    def test_what_is_packed(self) -> None:
        done = self.cargo("package", "--list", "--allow-dirty", "--offline")
        self.assertEqual(done.returncode, 0, done.stderr)
        names = set(done.stdout.split("\n"))
        self.assertLess({"Cargo.toml", "LICENSE", "README.md", "src/lib.rs", "src/fixed/place.rs"}, names)
        self.assertEqual({name for name in names if name.startswith(("tests", "vectors"))}, set())
        self.assertIn(f'version = "{version()}"', (self.folder / "Cargo.toml").read_text(encoding="utf-8"))
        self.assertNotRegex((ROOT / "packages" / "rust" / "Cargo.toml").read_text(encoding="utf-8"), r"(?m)^version\b")
        self.assertEqual((self.folder / "LICENSE").read_bytes(), (ROOT / "LICENSE").read_bytes())

    def test_what_a_registry_wants_is_in_the_manifest(self) -> None:
        self.assertEqual(refusals(self.folder, "package", "--offline", path=self.path), [])
        manifest = self.folder / "Cargo.toml"
        right = manifest.read_text(encoding="utf-8")
        self.addCleanup(manifest.write_text, right, encoding="utf-8")
        manifest.write_text(re.sub("(?m)^(description|license) = .*\n", "", right).replace('"noise"', '"no ise"'), encoding="utf-8")
        warned, keyword = refusals(self.folder, "package", "--offline", path=self.path)
        self.assertRegex(warned, "warning: manifest has no description, license")
        self.assertEqual(keyword, 'keyword 1: "no ise"')

    @in_thorough_runs
    def test_crates_io_would_take_it(self) -> None:
        found = refusals(self.folder, "publish", "--dry-run", path=self.path)
        if re.search("does not support API commands|failed to (update|fetch|download|get)", "\n".join(found)):
            self.skipTest(f"crates.io cannot be reached, or not by this cargo: {found[0]}")
        self.assertEqual(found, [])

    @in_thorough_runs
    def test_it_needs_no_std(self) -> None:
        """A program without std has a handler of panics, which would be there twice with it."""
        program = self.folder / "bare.rs"
        program.write_text("#![no_std]\nextern crate hashnoise;\n#[panic_handler]\nfn stop(_: &core::panic::PanicInfo) -> ! { loop {} }\n"
                           "#[no_mangle]\npub extern \"C\" fn word(x: i32) -> u32 { hashnoise::hash::lattice2(x, 4, 7) }\n", encoding="utf-8")
        self.addCleanup(program.unlink)
        path = self.folder / "src" / "lib.rs"
        right = path.read_text(encoding="utf-8")
        self.addCleanup(path.write_text, right, encoding="utf-8")
        rustc = [shutil.which("rustc", path=self.path), "--edition=2021", "-Cpanic=abort", "--out-dir", self.folder / "target"]
        for text, said in ((right, ""), (f"{right}\nextern crate std;\n", "E0152")):
            path.write_text(text, encoding="utf-8")
            for words in (("--crate-type=rlib", "--crate-name=hashnoise", path), ("--crate-type=staticlib", "-L", self.folder / "target", program)):
                done = subprocess.run([*rustc, *words], capture_output=True, text=True, check=False)
            self.assertEqual((said in done.stderr, done.returncode == 0), (True, not said), done.stderr)

    @in_thorough_runs
    def test_its_pages_compile_and_its_comments_are_comments(self) -> None:
        def shown(page: str, heading: str) -> str:
            text = (ROOT / "docs" / "guide" / page).read_text(encoding="utf-8").partition(f"\n{heading}\n")[2]
            return re.search(r"^```rust\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)[1]

        moved = shown("moving.md", "## Rust's fastnoise-lite and noise")
        factor, scale = re.search(r"(\S+) \* hashnoise::fast::simplex2\((\S+) \* x, \2 \* y", moved).groups()
        self.assertIn(f"| `FNL_NOISE_OPENSIMPLEX2` | 2D | `{factor} * hn_simplex({scale} * p, seed)` |",
                      (ROOT / "docs" / "guide" / "moving.md").read_text(encoding="utf-8"))
        test = (f"#[test]\nfn page() {{\n{shown('languages.md', '### Rust')}"
                f"assert!(height.abs() <= 1.0 && grain.abs() <= 1.0);\n}}\n\n{moved}\n"
                f"#[test]\nfn moved() {{\nassert!(noise(150.0, 225.0, 7).abs() <= {factor});\n}}\n")
        (self.folder / "tests" / "page.rs").write_text(test, encoding="utf-8")
        self.addCleanup((self.folder / "tests" / "page.rs").unlink)
        done = self.cargo("test", "--test", "page", "--offline")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for command in (("test", "--doc"), ("doc", "--no-deps")):  # as docs.rs does
            done = self.cargo(*command, "--offline")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


def load_tests(loader: unittest.TestLoader, *_: object) -> unittest.TestSuite:
    found = folders("cargo")
    kinds = [type(f"Crate by {Path(one, 'cargo')}", (Crate,),
                  {"path": path_of(one), "tries_faults": THOROUGH or one == found[0]}) for one in {found[0], found[-1]}]
    return unittest.TestSuite(map(loader.loadTestsFromTestCase, kinds))


if __name__ == "__main__":
    with skipped_without():
        check()
    unittest.main(verbosity=2)
