"""How long the commands of the README take, by tools/costs.csv."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping

from base import costs
from base.tree import TOOLS
from catalog.tables.markdown import table

CORES = 2
# By command: its build in the table, and the arrays of packages in tools/lib/base/setup.sh.
COMMANDS = {"conform": ("conform", ("conform_packages",)),
            "test": ("test", ("conform_packages", "test_packages"))}
Times = Mapping[str, tuple[float, float, float]]  # by command: seconds for its packages, its build and its run


def packages(arrays: tuple[str, ...]) -> int:
    """How many packages these arrays name."""
    names = " ".join(f'"${{{array}[@]}}"' for array in arrays)
    done = subprocess.run(["bash", "-c", f'source "$1/lib/base/setup.sh" && printf "%s\\n" {names} | sort -u | wc -l', "bash", TOOLS],
                          capture_output=True, text=True, check=True)
    return int(done.stdout)


def times() -> Times:
    """On so many cores that have nothing else to do."""
    recorded = costs.read_file(TOOLS / "costs.csv")

    return {command: (recorded["packages", "each"].value * packages(arrays), recorded["build", build].value / CORES,
                      recorded["run", command].value / CORES) for command, (build, arrays) in COMMANDS.items()}


def times_table(of: Times) -> str:
    rows = [[f"`tools/{command}`", *map(_clock, (*parts, sum(parts)))] for command, parts in of.items()]
    return table(("", "packages", "build", "run", "the first time, minutes"), rows)


def times_quote(of: Times) -> str:
    """The README's times, in whole minutes."""
    first = {command: _minutes(sum(parts)) for command, parts in of.items()}
    return (f"On two cores the suite takes {first['conform']} minutes at first and {_minutes(of['conform'][2])} again, "
            f"`tools/test` {first['test']}.")


def _clock(seconds: float) -> str:
    return f"{round(seconds) // 60}:{round(seconds) % 60:02}"


def _minutes(seconds: float) -> int:
    return max(1, round(seconds / 60))
