"""The bill of materials of a release in the format CycloneDX: each file with its checksum, and what others wrote that
is in it or that it needs."""

from __future__ import annotations

import datetime
import hashlib
import json
import re
import tomllib
import uuid
from collections.abc import Iterable, Iterator, Mapping
from fnmatch import fnmatchcase
from pathlib import Path

from base.tree import ROOT

SPECIFICATION = "1.6"
OURS = "hashnoise"
# The licenses of others' work. Where there are two, the user may choose.
LICENSES = {"numpy": "BSD-3-Clause", "nanobind": "BSD-3-Clause", "tessil/robin-map": "MIT", "three": "MIT",
            "wesl-core": "MIT OR Apache-2.0"}
KINDS = {".whl": "pypi", ".tgz": "npm"}  # of package, by the ending of its file
Component = dict[str, object]


class Unknown(Exception):
    """Something of others about which nothing is known."""


def required(text: str) -> tuple[str, str]:
    """A requirement of Python's, such as "numpy>=1.23": the name, and which versions."""
    name, versions = re.fullmatch(r"([\w.-]+)(?:\[[\w,]+\])?(.*)", text).groups()
    return name, versions


def of_others(root: Path = ROOT) -> dict[str, list[Component]]:
    """Software of others, by the names of the files that need it: what pip, npm and cargo install beside a package, and
    what is compiled into a wheel. No other file of a release has or needs anything of that kind: into the twin of the
    npm package nothing is linked, and the add-on for Blender has no wheel in a release."""
    manifests = (("*.whl", "pyproject.toml", of_wheel), ("*[0-9].tar.gz", "pyproject.toml", of_wheel),
                 ("*.tgz", "packages/npm/package.json", of_npm),
                 ("hashnoise_wgsl-*.zip", "packages/wesl/Cargo.toml", of_wesl))
    return {files: [*needed((root / manifest).read_text(encoding="utf-8"))] for files, manifest, needed in manifests
            if (root / manifest).is_file()}


def of_wheel(manifest: str) -> Iterator[Component]:
    project = tomllib.loads(manifest)
    for text in project["project"]["dependencies"]:
        yield component("pypi", *required(text), "required", "pip installs it with the wheel")
    for text in project["build-system"]["requires"]:
        if not text.startswith("scikit-build-core"):
            yield component("pypi", *required(text), "required", "its C++ is compiled into the wheel")
        if required(text)[0] == "nanobind":
            yield component("github", "tessil/robin-map", f"that {text} has inside", "required",
                            "its C++ is compiled into the wheel with nanobind's")


def of_npm(manifest: str) -> Iterator[Component]:
    package = json.loads(manifest)
    for name, versions in package.get("dependencies", {}).items():
        yield component("npm", name, versions, "required", "npm installs it with the package")
    for name, versions in package.get("peerDependencies", {}).items():
        yield component("npm", name, versions, "optional", "a project that has it may use its part of the package")


def of_wesl(manifest: str) -> Iterator[Component]:
    for name, versions in tomllib.loads(manifest)["dependencies"].items():
        yield component("cargo", name, versions, "optional", "cargo builds it with the package, and npm needs nothing")


def component(kind: str, name: str, versions: str, scope: str, how: str) -> Component:
    if name not in LICENSES:
        raise Unknown(f"the license of {name}, which is needed now, is not in tools/lib/ship/release/sbom.py: write it "
                      "there")
    exact = versions.removeprefix("==") if versions.startswith("==") else ""
    reference = f"pkg:{kind}/{name}" + (f"@{exact}" if exact else "")
    return {"type": "library", "bom-ref": reference, "name": name, **({"version": exact} if exact else {}),
            "description": f"{how}; version {exact or versions}", "scope": scope,
            "licenses": [license_of(LICENSES[name])], "purl": reference}


def license_of(name: str) -> dict[str, object]:
    return {"expression": name} if " " in name else {"license": {"id": name}}


def of_file(name: str, data: bytes, version: str) -> Component:
    kind = KINDS.get(Path(name).suffix)
    said = "MIT"
    if kind == "pypi":
        said = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["license"]
    return {"type": "file", "bom-ref": name, "name": name, "version": version,
            "hashes": [{"alg": "SHA-256", "content": hashlib.sha256(data).hexdigest()}],
            "licenses": [license_of(said)], **({"purl": f"pkg:{kind}/{OURS}@{version}"} if kind else {})}


def bom(version: str, seconds: int, files: Mapping[str, bytes], others: Mapping[str, list[Component]]) -> Component:
    """The bill of these files, made at the time of the commit. Its number follows from its contents."""
    made = [of_file(name, data, version) for name, data in sorted(files.items())]
    needed = {name: [one for pattern, those in others.items() if fnmatchcase(name, pattern) for one in those]
              for name in sorted(files)}
    unique = {one["bom-ref"]: one for those in needed.values() for one in those}
    time = datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc)
    said: Component = {
        "metadata": {
            "timestamp": time.strftime("%Y-%m-%dT%H:%M:%SZ"),
            "component": {"type": "library", "bom-ref": OURS, "name": OURS, "version": version,
                          "description": "Procedural noise for shaders, and the same in C++ and other languages",
                          "licenses": [{"license": {"id": "MIT"}}]}},
        "components": made + [unique[reference] for reference in sorted(unique)],
        "dependencies": [{"ref": OURS, "dependsOn": sorted(files)},
                         *({"ref": name, "dependsOn": references(those)} for name, those in needed.items()),
                         *({"ref": reference} for reference in sorted(unique))]}
    number = uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(said, sort_keys=True))
    return {"$schema": f"http://cyclonedx.org/schema/bom-{SPECIFICATION}.schema.json", "bomFormat": "CycloneDX",
            "specVersion": SPECIFICATION, "serialNumber": f"urn:uuid:{number}", "version": 1, **said}


def references(components: Iterable[Component]) -> list[str]:
    return sorted(str(one["bom-ref"]) for one in components)


def text(made: Component) -> str:
    return json.dumps(made, indent=2) + "\n"
