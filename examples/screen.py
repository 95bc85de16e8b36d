"""A display that nobody sees, whose pixels can be read: Xvfb keeps them in a file, as xwd writes it."""

from __future__ import annotations

import os
import shutil
import struct
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path


class Absent(Exception):
    """There is no Xvfb."""


class Screen:
    """A display of that size for a `with`, on which programs are run."""

    def __init__(self, width: int, height: int):
        if shutil.which("Xvfb") is None:
            raise Absent("there is no Xvfb")
        self.size = width, height

    def __enter__(self) -> Screen:
        self._folder = tempfile.TemporaryDirectory()
        read, write = os.pipe()
        self._server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{self.size[0]}x{self.size[1]}x24", "-fbdir",
             self._folder.name, "-nolisten", "tcp", "-nocursor"], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            self.display = f":{number.readline().strip()}"
        if self.display == ":":
            self.__exit__()
            raise Absent("Xvfb did not start")
        return self

    def __exit__(self, *_):
        self._server.terminate()
        self._server.wait()
        self._folder.cleanup()

    def pixels(self) -> list[bytes]:
        """The rows from the top: red, green and blue of each pixel."""
        data = Path(self._folder.name, "Xvfb_screen0").read_bytes()
        head, = struct.unpack_from(">I", data)
        (width, height, line), (bits,), (colors,) = (struct.unpack_from(form, data, at) for form, at in (
            (">II24xI", 16), (">I", 44), (">I", 76)))
        if (width, height, bits) != (*self.size, 32):
            raise ValueError(f"a screen of {width} x {height} pixels of {bits} bits")
        first = head + 12 * colors
        rows = []
        for y in range(height):
            row = data[first + y * line:first + y * line + 4 * width]  # blue, green, red, nothing
            pixels = bytearray(3 * width)
            pixels[0::3], pixels[1::3], pixels[2::3] = row[2::4], row[1::4], row[0::4]
            rows.append(bytes(pixels))
        return rows

    def run(self, command: list, wanted: Callable[[list[bytes]], bool], seconds: float = 60,
            variables: dict[str, str] | None = None) -> tuple[list[bytes], str]:
        """Runs a program until the screen shows what is wanted, and ends it: the pixels, and what it wrote. If it ends
        by itself or the time is over, the pixels are the last that were seen."""
        with tempfile.TemporaryFile("w+") as output:
            program = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT,
                                       env={**os.environ, **(variables or {}), "DISPLAY": self.display})
            end = time.monotonic() + seconds
            pixels = self.pixels()
            while program.poll() is None and time.monotonic() < end and not wanted(pixels):
                time.sleep(0.1)
                pixels = self.pixels()
            program.terminate()
            program.wait()
            output.seek(0)
            return pixels, output.read()
