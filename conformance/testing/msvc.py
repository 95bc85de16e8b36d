"""How Clang compiles as MSVC would: for lanes_test.py, and for src/grid/tests/elsewhere_test.py."""

from pathlib import Path

# Its words and extensions, templates that are read where they are used, and as_msvc.hpp before all else.
AS_MSVC = ("-fms-extensions", "-fms-compatibility", "-fms-compatibility-version=19.40", "-fdelayed-template-parsing",
           "-include", str(Path(__file__).resolve().with_name("as_msvc.hpp")))
