"""How Clang compiles as MSVC would: for lanes_test.py, and for src/grid/tests/cross_build_test.py."""

import shlex
import subprocess
from pathlib import Path

# Its words and extensions, templates that are read where they are used, and as_msvc.hpp before all else.
AS_MSVC = ("-fms-extensions", "-fms-compatibility", "-fms-compatibility-version=19.40", "-fdelayed-template-parsing",
           "-include", str(Path(__file__).resolve().with_name("as_msvc.hpp")))
# Compiles all headers, and quickly: nothing is forced inline.
WHOLE_AS_MSVC = ("-DAS_MSVC_WHOLE_LIBRARY", "-D__forceinline=inline", *AS_MSVC)


def _told(compiler: str, *flags: str) -> list[str]:
    """Clang's own options for such options of MSVC."""
    source = Path(__file__).with_name("lanes.cpp")  # which is only looked for
    command = [compiler, "--driver-mode=cl", "--target=x86_64-pc-windows-msvc", *flags, "/O2", "-###", "/c", "--", source]
    printed = subprocess.run(command, capture_output=True, text=True, check=True).stderr
    call, = (line for line in printed.splitlines() if '"-cc1"' in line)
    return shlex.split(call)


def fp_fast(compiler: str) -> tuple[str, ...]:
    """Clang's flags for MSVC's /fp:fast, from its own command line."""
    usual, fast = _told(compiler), _told(compiler, "/fp:fast")
    return ("-fno-math-errno", *(word for flag in fast if flag not in usual for word in ("-Xclang", flag)))
