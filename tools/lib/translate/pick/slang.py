"""The compiler of Slang: a library of C in a package of PyPI, which has no program for it."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from pathlib import Path

from translate.pick.runners import NotRun
from translate.wgsl.device import Absent, installed

PACKAGE = "slangpy==0.43.1"
# The numbers of SlangCompileTarget in slang.h.
TARGETS = {"hlsl": 5, "spirv": 6, "metal": 24, "wgsl": 28}
SOURCE = 1  # of SlangSourceLanguage: Slang
STAGES = {"vertex": 1, "fragment": 5, "compute": 6}  # of SlangStage


class Slang:
    def __init__(self, package: str = PACKAGE) -> None:
        folder = installed(package, "--no-deps")
        libraries = sorted([*folder.glob("slang*/libslang-compiler.so*"), *folder.glob("slang*/bin/libslang.so")])
        if not libraries:
            raise Absent(f"{package} has no compiler here")
        self._slang = ctypes.CDLL(str(libraries[0]))
        for name, result, parameters in (
                ("CreateSession", ctypes.c_void_p, [ctypes.c_char_p]),
                ("CreateCompileRequest", ctypes.c_void_p, [ctypes.c_void_p]),
                ("DestroyCompileRequest", None, [ctypes.c_void_p]),
                ("SetCodeGenTarget", None, [ctypes.c_void_p, ctypes.c_int]),
                ("AddSearchPath", None, [ctypes.c_void_p, ctypes.c_char_p]),
                ("AddPreprocessorDefine", None, [ctypes.c_void_p, *[ctypes.c_char_p] * 2]),
                ("AddTranslationUnit", ctypes.c_int, [ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p]),
                ("AddTranslationUnitSourceString", None, [ctypes.c_void_p, ctypes.c_int, *[ctypes.c_char_p] * 2]),
                ("AddEntryPoint", ctypes.c_int, [ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_int]),
                ("Compile", ctypes.c_int, [ctypes.c_void_p]),
                ("GetDiagnosticOutput", ctypes.c_char_p, [ctypes.c_void_p]),
                ("GetEntryPointCode", ctypes.c_void_p,
                 [ctypes.c_void_p, ctypes.c_int, ctypes.POINTER(ctypes.c_size_t)])):
            function = getattr(self._slang, f"sp{name}")
            function.restype, function.argtypes = result, parameters
        self._session = self._slang.spCreateSession(None)

    def compiled(self, text: str, target: str = "wgsl", folder: Path | None = None,
                 macros: Mapping[str, str] | None = None, entry: str = "main", stage: str = "compute") -> bytes:
        """An entry point, with modules of a folder and macros, which modules see as well; raises NotRun."""
        slang = self._slang
        request = slang.spCreateCompileRequest(self._session)
        try:
            slang.spSetCodeGenTarget(request, TARGETS[target])
            if folder:
                slang.spAddSearchPath(request, str(folder).encode())
            for name, value in (macros or {}).items():
                slang.spAddPreprocessorDefine(request, name.encode(), value.encode())
            unit = slang.spAddTranslationUnit(request, SOURCE, b"")
            slang.spAddTranslationUnitSourceString(request, unit, b"shader.slang", text.encode("ascii"))
            point = slang.spAddEntryPoint(request, unit, entry.encode(), STAGES[stage])
            if slang.spCompile(request) != 0:
                raise NotRun(slang.spGetDiagnosticOutput(request).decode())
            size = ctypes.c_size_t()
            code = slang.spGetEntryPointCode(request, point, ctypes.byref(size))
            return ctypes.string_at(code, size.value)
        finally:
            slang.spDestroyCompileRequest(request)
