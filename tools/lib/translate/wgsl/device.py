"""WGSL on this machine outside of a browser: PyPI's wgpu, which is naga and a driver of Vulkan, Metal or DirectX."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Sequence
from types import ModuleType

from base.debian import Missing
from base.pypi import installed
from translate.wgsl.evaluation import GROUP

WGPU = "wgpu==0.32.0"
INPUT_WORDS = 16
OUTPUT_WORDS = 4
Absent = Missing  # why there is no wgpu here


def find_wgpu() -> ModuleType:
    """The package, which is installed if nobody has it."""
    os.environ.setdefault("XDG_RUNTIME_DIR", "/tmp")  # else Wayland's library complains
    try:
        return importlib.import_module("wgpu")
    except ImportError:
        folder = installed(WGPU)
    sys.path.insert(0, str(folder))
    importlib.invalidate_caches()
    try:
        return importlib.import_module("wgpu")
    except ImportError as error:
        raise Absent(f"{WGPU} cannot be imported from {folder}: {error}") from error


class Device:
    def __init__(self) -> None:
        self._wgpu = find_wgpu()
        try:
            self._device = self._wgpu.gpu.request_adapter_sync().request_device_sync()
        except Exception as error:  # its errors have no common type
            raise Absent(f"wgpu finds no device here: {error}") from error

    def __str__(self) -> str:
        info = self._device.adapter.info
        return f"{info['device']} ({info['backend_type']})"

    def compile(self, text: str | bytes):
        """A shader module, of WGSL or of SPIR-V; an error in it is raised."""
        return self._device.create_shader_module(code=text)

    def compile_glsl(self, text: str) -> None:
        """Compiles a fragment shader in GLSL, which naga reads as well."""
        self._device.create_shader_module(code=text, label="shader.frag")  # the label names the stage

    def evaluate(self, text: str, inputs: Sequence[Sequence[int]]) -> list[tuple[int, ...]]:
        """The words that come out of a shader for each point: those that go in are as many as its columns."""
        words = b"".join(word.to_bytes(4, "little") for point in inputs
                         for word in (*point, *[0] * (INPUT_WORDS - len(point))))
        results = self.run(text, words, 4 * OUTPUT_WORDS * len(inputs), len(inputs)).cast("I").tolist()
        return [tuple(results[i:i + OUTPUT_WORDS]) for i in range(0, len(results), OUTPUT_WORDS)]

    def run(self, text: str | bytes, inputs: bytes, size: int, points: int) -> memoryview:
        """A shader's output, so many bytes; it is called for each of the points, GROUP at a time."""
        device, usage = self._device, self._wgpu.BufferUsage
        pipeline = device.create_compute_pipeline(
            layout="auto", compute={"module": self.compile(text), "entry_point": "main"})
        source = device.create_buffer_with_data(data=inputs, usage=usage.STORAGE)
        target = device.create_buffer(size=size, usage=usage.STORAGE | usage.COPY_SRC)
        entries = [{"binding": number, "resource": {"buffer": buffer}} for number, buffer in enumerate((source, target))]
        group = device.create_bind_group(layout=pipeline.get_bind_group_layout(0), entries=entries)
        encoder = device.create_command_encoder()
        compute = encoder.begin_compute_pass()
        compute.set_pipeline(pipeline)
        compute.set_bind_group(0, group)
        compute.dispatch_workgroups(-(-points // GROUP))
        compute.end()
        device.queue.submit([encoder.finish()])
        return memoryview(device.queue.read_buffer(target)).cast("B")
