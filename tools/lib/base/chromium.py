"""Headless Chromium, which draws on SwiftShader."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

# The first is Chromium without what draws windows, which starts in less than half of the time.
PROGRAMS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")


def found() -> str | None:
    """The first of them that is in PATH."""
    return next(filter(None, map(shutil.which, PROGRAMS)), None)


def command(program: str, profile: Path, *options: str) -> list[str]:
    """Put the address behind it. The folder of the profile is made if it is not there."""
    return [program, "--headless=new", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-first-run",
            "--disable-background-networking", "--disable-dev-shm-usage",  # it is small in containers
            f"--user-data-dir={profile}", *(["--no-sandbox"] if os.geteuid() == 0 else []), *options]
