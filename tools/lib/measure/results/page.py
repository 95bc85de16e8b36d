"""The page of results: one file without others, for a phone as well."""

from __future__ import annotations

import html
from collections.abc import Iterable, Mapping, Sequence

from base.tree import ROOT, address, version
from measure.gpu import pages as counts
from measure.gpu.chips import chip_named
from measure.results.devices import Device, devices_of, driver_of
from measure.results.digest import APIS, TIMED, UNIT, Digest

STYLE = ROOT / "conformance" / "output" / "style.mustache"
# This page adds to that: ids of cases are long words, and tables that fold need no box to scroll in.
OWN_STYLE = "<style>code, h3 { overflow-wrap: anywhere; } .fold { max-height: none; }</style>\n"
NAMES = {"opengl": "OpenGL", "opengles": "OpenGL ES", "vulkan": "Vulkan", "webgl2": "WebGL2", "webgpu": "WebGPU"}
KINDS = (("HN_FIXED", ("fixed",)), ("hashes and random numbers", ("exact",)), ("floats", ("fast", "precise")),
         ("everything", ("exact", "fast", "fixed", "precise")))
UNIT_COUNTED = "noise2d.perlin.lattice"  # the same, as it is called there
COUNTED = ("ampere", "navi31", "m1")  # chips whose static counts stand beside what was timed


def escaped(text: object) -> str:
    return html.escape(str(text), quote=True)


def table(heads: Sequence[str], rows: Iterable[Sequence[str]], kind: str = "table fold") -> str:
    """Of cells that are HTML. On a phone a row becomes a block, and each cell has its head."""
    head = "".join(f"<th>{escaped(text)}</th>" for text in heads)
    lines = "".join("<tr>" + "".join(
        f"<th scope=row>{cell}</th>" if i == 0 else f'<td data-label="{escaped(heads[i])}">{cell}</td>'
        for i, cell in enumerate(row)) + "</tr>\n" for row in rows)
    return f'<div class="{kind}"><table><thead><tr>{head}</tr></thead><tbody>\n{lines}</tbody></table></div>\n'


def of_devices(good: int, ran: int) -> str:
    kind = "good" if good == ran else "bad"
    return f'<span class="{kind}">{good} of {ran} {"device" if ran == 1 else "devices"}</span>'


def what_holds(devices: Sequence[Device]) -> str:
    rows = []
    for api in APIS:
        for what, arithmetics in KINDS:
            ran = [device for device in devices if device.api == api and device.passes(*arithmetics) is not None]
            if ran:
                cases = sorted(part.ran(*arithmetics) for device in ran for part in device.parts())
                rows.append((f"{what} in {NAMES[api]}",
                             of_devices(sum(bool(device.passes(*arithmetics)) for device in ran), len(ran)),
                             str(cases[0]) if cases[0] == cases[-1] else f"{cases[0]} to {cases[-1]}"))
    return table(("what", "where it holds", "cases on each"), rows)


def anchor(digest: Digest) -> str:
    return f"result-{digest.name.removesuffix('.json')}"


def state(digest: Digest | None, failed: bool) -> str:
    if digest is None:
        return '<span class="faint">none</span>'
    text = f"{escaped(driver_of(digest))}, hashnoise {escaped(digest.version)}"
    return f'<a class="bad" href="#{escaped(anchor(digest))}">{text}</a>' if failed else text


def device_table(devices: Sequence[Device]) -> str:
    return table(("device", "vendor", "API", "system", "newest driver that passes", "last that failed"),
                 [(escaped(device.name), escaped(device.vendor), NAMES[device.api], escaped(device.system),
                   state(device.last(failed=False), False), state(device.last(failed=True), True))
                  for device in devices])


def evidence(digest: Digest) -> str:
    """The failed cases, with commands that repeat them."""
    parts = []
    for api, part in digest.parts.items():
        failed = sum(numbers[1] for numbers in part.counts.values())
        if not failed:
            continue
        groups = ", ".join(sorted(group for group, numbers in part.counts.items() if numbers[1]))
        wrong = f" The checksums of {escaped(', '.join(sorted(part.wrong)))} are not those of other devices." \
            if part.wrong else ""
        parts.append(f"<p>{NAMES[api]}: {failed} {'case' if failed == 1 else 'cases'} failed, of {escaped(groups)}."
                     f"{wrong}</p>")
    cases = "".join(f"<li><code>{escaped(case)}</code></li>" for case in digest.failed)
    command = f"hn-conform run --filter '{digest.failed[0]}'" if digest.failed else "hn-conform run"
    file = f"{address()}/blob/main/docs/measured/results/devices/{digest.name}"
    return (f'<article id="{escaped(anchor(digest))}"><h3>{escaped(digest.renderer)}, {escaped(driver_of(digest))}, '
            f"{escaped(digest.system)}</h3>{''.join(parts)}<p>Among them:</p><ul>{cases}</ul>"
            f"<p>On such a device this shows the first: <code>{escaped(command)}</code>. "
            f'<a href="{escaped(file)}">The whole digest</a></p></article>\n')


def cost_table(devices: Sequence[Device]) -> str:
    measured: dict[str, Mapping[str, int]] = {}
    for device in devices:
        for digest in device.newest:
            if digest.costs:
                measured[f"{device.name}, {NAMES[device.api]}, timed"] = digest.costs
    if not measured:
        return ('<p class="faint">Nobody has sent times yet. The page that checks a browser takes them, and so does '
                "<code>hn-conform run --timings</code>.</p>\n")
    static = counts.costs()
    rows = []
    for function in TIMED:
        for arithmetic, setting in (("fast", "lattice"), ("fixed", "lattice+fixed")):
            name = f"{function}.{arithmetic}"
            cells = [f"{costs[name] / 100:.2f}" if name in costs else "" for costs in measured.values()]
            for chip in COUNTED:
                one, unit = (static.get((subject, chip)) for subject in (f"{function}.{setting}", UNIT_COUNTED))
                cells.append(f"{float(one.cost) / float(unit.cost):.2f}" if one and unit and one.cost else "")
            if any(cells[:len(measured)]):
                rows.append((escaped(name), *cells))
    heads = ["function", *measured, *(f"{chip_named(chip).title}, counted" for chip in COUNTED)]
    return (f"<p>As multiples of <code>{UNIT}</code> on the same device. Counted columns are a compiler's counts of "
            f"the same shader.</p>\n{table(heads, rows, 'table')}")


def page(digests: Sequence[Digest]) -> str:
    devices = devices_of(digests)
    # Each API has its own word for the vendor, and a browser its name behind that of the device.
    names = {(device.name.rpartition(",")[0] or device.name).casefold() for device in devices}
    failing = [digest for digest in digests if digest.failed]
    facts = (f"{len(digests)} results of {len(names)} devices, "
             f"{len(devices)} with each API and browser counted by itself.") if digests else "There are no results yet."
    failures = "".join(map(evidence, failing)) or '<p class="good">No result that was sent has a failure.</p>\n'
    sections = [("Results",
                 what_holds(devices) + "<p>Of each device the newest driver counts that somebody ran.</p>"),
                ("Devices", device_table(devices)), ("Failures", failures), ("Costs", cost_table(devices))]
    body = "".join(f"<h2>{title}</h2>\n{content}" for title, content in sections)
    return (f'<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f"<title>hashnoise on devices</title>\n<link rel=\"icon\" href=\"data:,\">\n"
            f"{STYLE.read_text(encoding='utf-8')}{OWN_STYLE}</head>\n<body>\n<h1>hashnoise on devices</h1>\n"
            f"<p>What people's devices returned when they ran the conformance suite of hashnoise, whose newest version "
            f"is {escaped(version())}. {facts} A device that passes returned the bits that the golden files have.</p>\n"
            f'<p><a href="{escaped(address())}">The project, and how to send a result</a></p>\n{body}</body>\n'
            "</html>\n")
