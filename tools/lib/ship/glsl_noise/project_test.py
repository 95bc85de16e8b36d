"""The package in place of glsl-noise: by its name for glslify, and by an alias of Vite in drei, which Chromium draws.

    python3 -m ship.glsl_noise.project_test FOLDER      FOLDER has the packages of tools/lib/base/javascript

Exit status: 0 all is right, 1 not, 77 npm's packages or a Node.js are not here.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

from base.javascript import environment
from base.tree import TOOLS
from ship.glsl_noise.files import NAME, PACKAGE, package
from ship.packing import put

TESTS = PACKAGE / "tests"
SKIPPED = 77


def main(packages: Path) -> int:
    if not (packages / environment.MADE).exists():
        print(f"{packages} has no packages: javascript.packages was skipped, or did not run")
        return SKIPPED
    # Node.js looks in the folder above for a missing one.
    project = packages / "glsl-noise"
    if status := environment.make(project, TESTS):
        return status
    put(project / NAME, package())
    page = package()["README.md"]
    # As on the page, and by its own name.
    command, = re.findall(rf"^    npm install (.*{NAME})-VERSION$", page, re.MULTILINE)
    install = [TOOLS / "lib" / "base" / "node", "npm", "install", "--prefer-offline", "--no-save", "--no-audit", "--no-fund"]
    done = subprocess.run([*install, command, f"{NAME}@file:{NAME}"], cwd=project, capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
        return 1
    for name, block in zip(("all.js", "drei.js"), re.findall(r"^```js\n(.*?)^```$", page, re.MULTILINE | re.DOTALL),
                           strict=True):
        (project / name).write_text(block, encoding="utf-8")
    for path in TESTS.iterdir():
        if path.suffix != ".json":
            shutil.copy(path, project)
    return subprocess.run([TOOLS / "lib" / "base" / "node", "node", "drop_in.mjs"], cwd=project, check=False).returncode and 1


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
