"""Reads what digests state of devices: each device counts once, whoever sends results of it and however often."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

from measure.results.digest import BROWSER_APIS, Digest, Part

# Its vendor, its device and its driver; browsers leave out one or two of them, and Firefox marks it as inexact.
ANGLE = re.compile(r"ANGLE \((?:[^,()]+, )?(.+?)(?:, [^,()]+(?: \([^()]*\))?)?\)(?: on .*)?")
# The part of ANGLE's names that names how it reaches the device.
BACKENDS = re.compile(r"^(?:ANGLE Metal Renderer: |Vulkan [\d.]+ \(|OpenGL(?: ES)? )|"
                      r" (?:Direct3D\w+|OpenGL(?: ES)? [\d.]+|\(0x[0-9A-Fa-f]+\)).*$")
# Drivers that number their releases in a string that has other numbers besides.
RELEASE = re.compile(r"\b(?:Mesa|NVIDIA|Build|SwiftShader driver|Adreno|V@|v1\.r)[ -]?(\d+(?:\.\d+)?)")
NUMBER = re.compile(r"\d+(?:\.\d+)?")


def device_name(renderer: str) -> str:
    """Without the driver that draws: "llvmpipe" of "llvmpipe (LLVM 15.0, 256 bits)"."""
    name = renderer.removesuffix(", or similar")
    if found := ANGLE.fullmatch(name):
        name = BACKENDS.sub("", found[1])
    return re.sub(r"(?:, | \()(?!R\)|TM\)).*$", "", name).strip() or renderer


def numbers_of(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


def release(driver: str) -> tuple[int, ...]:
    """The key that orders the releases of a driver."""
    found = RELEASE.search(driver)
    every = NUMBER.findall(driver)
    return numbers_of(found[1]) if found else numbers_of(every[-1]) if every else ()


def driver_of(digest: Digest) -> str:
    return digest.browser or digest.driver


@dataclass
class Device:
    """On one API: a device that has two counts in each."""
    name: str
    vendor: str
    system: str
    api: str
    digests: list[Digest] = field(default_factory=list)  # the newest driver last

    @property
    def newest(self) -> list[Digest]:
        """Digests of the newest driver with the newest library: several if several people sent one."""
        last = order(self.digests[-1])
        return [digest for digest in self.digests if order(digest) == last]

    def parts(self) -> list[Part]:
        return [digest.parts[self.api] for digest in self.newest]

    def passes(self, *arithmetics: str) -> bool | None:
        """Whether nothing of these arithmetics failed; None if nothing ran."""
        if not any(part.ran(*arithmetics) for part in self.parts()):
            return None
        return not any(part.failed(*arithmetics) for part in self.parts())

    def last(self, failed: bool) -> Digest | None:
        """The newest one that passed, or that failed. Of one driver that has both, the one that failed counts."""
        bad = {order(digest) for digest in self.digests if is_bad(digest.parts[self.api])}
        return next((digest for digest in reversed(self.digests) if (order(digest) in bad) is failed
                     and is_bad(digest.parts[self.api]) is failed), None)


def is_bad(part: Part) -> bool:
    return any(numbers[1] for numbers in part.counts.values())


def order(digest: Digest) -> tuple[tuple[int, ...], tuple[int, ...]]:
    return numbers_of(digest.version), release(driver_of(digest))


def devices_of(digests: Iterable[Digest]) -> list[Device]:
    """By vendor, name and API. One browser's result proves nothing about another, so each has a row of its own."""
    found: dict[tuple[str, ...], Device] = {}
    for digest in sorted(digests, key=order):
        for api in digest.parts:
            name = device_name(digest.renderer)
            if api in BROWSER_APIS:
                name = f"{name}, {digest.browser.rpartition(' ')[0] or digest.browser}"
            key = (digest.vendor.casefold(), name.casefold(), api, digest.system)
            found.setdefault(key, Device(name, digest.vendor, digest.system, api)).digests.append(digest)
    return [found[key] for key in sorted(found)]
