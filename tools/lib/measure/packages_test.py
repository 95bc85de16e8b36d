"""Tests of tools/measure python and rust: with scripts in place of a Python, tools/pack and cargo, and with packages
that cost a known time."""

from __future__ import annotations

import contextlib
import io
import os
import types
from unittest import mock

from base.testing import Case, called
from base.tree import version
from measure import calls, packages, python, rust, stamps

LINES = "Perlin 2D,hashnoise,2.0,1.0,2.0\\nPerlin 2D,hashnoise fixed,4.0,3.0,4.0\\nPerlin 2D,noiz,6.0,6.0,6.0\\n"


class Commands(Case):
    def setUp(self) -> None:
        self.enterContext(mock.patch.multiple(rust, TOOLS=self.folder, FOLDER=self.folder))
        self.enterContext(mock.patch.dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}"))
        for name, script in (("pack", "echo build/crate"), ("rustc", "echo rustc 1.63")):
            self.script(name, script)

    def call(self, command, *arguments: object) -> tuple[int, str]:
        return called(command.main, "--out", self.folder, *arguments)

    def rows(self, name: str) -> list[str]:
        self.assertEqual(stamps.stale(self.folder / name), [])
        return [",".join(list(row.values())[:-1]) for row in stamps.read(self.folder / name).rows]

    def test_each_package_is_compared_with_ours(self) -> None:
        """The quotient of each round; the median of the times, and for crates the least."""
        lines = LINES.replace("hashnoise,", "hashnoise,0.4,").replace("fixed,", "fixed,0.4,").replace("noiz,", "vnoise,0.1,")
        status, output = self.call(python, "--python", self.script("python", f'printf "{lines}"; test "$3" = 5'), "--rounds", "5")
        self.assertEqual((status, output.strip()), (0, str(self.folder / "python.csv")))
        self.assertEqual(self.rows("python.csv"), ["Perlin 2D,hashnoise,0.4,2,1,0", "Perlin 2D,hashnoise fixed,0.4,4,2,0.5",
                                                   "Perlin 2D,vnoise,0.1,6,3,1.5"])
        self.script("cargo", f'printf "{LINES}"; test "$7" = 3')
        self.assertEqual(self.call(rust, "--rounds", "3"), (0, f"{self.folder / 'rust.csv'}\n"))
        ours = version()
        self.assertEqual(self.rows("rust.csv"), [
            f"{target},Perlin 2D,{package}" for target in rust.TARGETS
            for package in (f"hashnoise,{ours},1,1,0", f"hashnoise fixed,{ours},3,2,0.5", "noiz,0.6.0,6,3,1.5")])
        self.assertIn('noiz = { version = "=0.6.0"', (self.folder / "Cargo.toml").read_text(encoding="utf-8"))

    def test_what_fails_and_bad_usage(self) -> None:
        broken = self.script("cargo", "exit 101")
        self.assertEqual(self.call(rust)[0], 1)
        self.assertEqual(self.call(python, "--python", broken)[0], 1)
        self.script("pack", "exit 4")
        self.assertEqual(self.call(rust)[0], 4)
        for command, arguments in ((rust, ("--rounds", "2")), (python, ("--rounds", "x")), (python, ("--python", "/nowhere"))):
            status, output = self.call(command, *arguments)
            self.assertEqual(status, 2)
            self.assertIn(arguments[0], output)

    def test_calls_of_packages_that_are_not_there_are_left_out(self) -> None:
        clock = iter(range(1000))
        modules = {"hashnoise": types.SimpleNamespace(run=lambda: None),
                   "theirs": types.SimpleNamespace(run=lambda: [next(clock) for _ in range(3)])}

        def load(name: str) -> object:
            if name not in modules:
                raise ModuleNotFoundError(name, name=lacks)
            return modules[name]

        lacks = "absent"

        make = {"Perlin 2D": dict.fromkeys((packages.OURS, "theirs", "absent"), lambda module: (module.run, 1))}
        with mock.patch.object(calls, "CALLS", make), mock.patch.object(calls.importlib, "import_module", load), \
                mock.patch.object(calls.importlib.metadata, "version", return_value="1.2"), \
                mock.patch.object(calls.time, "perf_counter", lambda: next(clock)), \
                contextlib.redirect_stdout(io.StringIO()) as output:
            calls.main(3)
            lacks = "numpy"  # which a package that is here needs
            self.assertRaises(ModuleNotFoundError, calls.main, 3)
        self.assertEqual(output.getvalue().splitlines(), ["Perlin 2D,hashnoise,1.2,1e+09,1e+09,1e+09",
                                                          "Perlin 2D,theirs,1.2,4e+09,4e+09,4e+09"])
