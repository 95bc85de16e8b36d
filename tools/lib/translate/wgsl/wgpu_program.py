"""Evaluates shaders by PyPI's wgpu, which is naga and a driver of Vulkan, Metal or DirectX, of any version from 0.9.5 on.
hn-conform has this file inside, as its driver wgpu (conformance/web/webgpu_evaluator.hpp).

    wgpu_program.py FD     first writes its device into that file, and then an answer for each line that it reads, as
                           lines of JSON
"""

from __future__ import annotations

import importlib
import json
import os
import sys
from pathlib import Path
from types import ModuleType

GROUP = 64  # invocations
NOTHING = b"\xef\xbe\xad\xde"  # where a shader writes nothing


def _sync(of, name: str, **options):
    """A call that older versions have under the plain name."""
    return (getattr(of, f"{name}_sync", None) or getattr(of, name))(**options)


class Device:
    """A shader has its results at binding 0, its points at 1, and uniforms, if it has some, at 2."""

    def __init__(self, wgpu: ModuleType):
        self._wgpu = wgpu
        if not hasattr(wgpu, "gpu"):
            importlib.import_module("wgpu.backends.rs")  # up to 0.9.5
        self._adapter = _sync(getattr(wgpu, "gpu", wgpu), "request_adapter",
                              **{} if hasattr(wgpu, "gpu") else {"canvas": None}, power_preference="high-performance")
        self._device = _sync(self._adapter, "request_device")
        kinds = ("storage", "read-only-storage", "uniform")
        self._layout = self._device.create_bind_group_layout(entries=[
            {"binding": number, "visibility": wgpu.ShaderStage.COMPUTE, "buffer": {"type": kind}}
            for number, kind in enumerate(kinds)])

    def info(self) -> dict[str, str]:
        found = self._adapter.info if hasattr(self._adapter, "info") else self._adapter.request_adapter_info()
        native = sys.modules.get("wgpu.backends.wgpu_native") or sys.modules["wgpu.backends.rs"]
        version = ".".join(map(str, getattr(native, "lib_version_info", native.version_info)))
        return {"vendor": found["vendor"], "renderer": f"{found['device']} ({found['backend_type']})",
                "version": f"wgpu {self._wgpu.__version__}, wgpu-native {version}"}

    def compile(self, code: str | bytes, label: str = ""):
        """A shader module, of WGSL, or of SPIR-V; in GLSL the label names the stage. An error in it is raised."""
        return self._device.create_shader_module(code=code, label=label)

    def pipeline(self, code: str | bytes):
        layout = self._device.create_pipeline_layout(bind_group_layouts=[self._layout])
        return self._device.create_compute_pipeline(
            layout=layout, compute={"module": self.compile(code), "entry_point": "main"})

    def run(self, code: str | bytes, inputs: bytes, size: int, points: int, uniforms: bytes = bytes(16)) -> bytes:
        """A shader's output, so many bytes; it is called for each of the points, GROUP at a time."""
        return self.dispatch(self.pipeline(code), inputs, size, points, uniforms)

    def dispatch(self, pipeline, inputs: bytes, size: int, points: int, uniforms: bytes = bytes(16)) -> bytes:
        device, usage = self._device, self._wgpu.BufferUsage
        contents = ((NOTHING * (size // 4), usage.STORAGE | usage.COPY_SRC), (inputs, usage.STORAGE),
                    (uniforms, usage.UNIFORM))
        buffers = [device.create_buffer_with_data(data=data, usage=use) for data, use in contents]
        group = device.create_bind_group(layout=self._layout, entries=[
            {"binding": number, "resource": {"buffer": buffer, "offset": 0, "size": buffer.size}}
            for number, buffer in enumerate(buffers)])
        encoder = device.create_command_encoder()
        compute = encoder.begin_compute_pass()
        compute.set_pipeline(pipeline)
        compute.set_bind_group(0, group, [], 0, 99)
        compute.dispatch_workgroups(-(-points // GROUP), 1, 1)
        (getattr(compute, "end", None) or compute.end_pass)()
        device.queue.submit([encoder.finish()])
        return bytes(device.queue.read_buffer(buffers[0]))


def answer(device: Device, pipelines: dict, asked: dict) -> None:
    """Compiles a shader; if there are points, evaluates it, and writes the results."""
    path = Path(asked["shader"])
    if asked["form"] == "glsl":
        device.compile(path.read_text(encoding="utf-8"), label="shader.comp")
        return
    if path not in pipelines:
        if len(pipelines) == 16:
            del pipelines[next(iter(pipelines))]
        pipelines[path] = device.pipeline(path.read_bytes() if asked["form"] == "spirv" else path.read_text("utf-8"))
    if "points" in asked:
        uniforms = b"".join(word.to_bytes(4, "little") for word in (*asked["uniforms"], 0, 0))
        results = device.dispatch(pipelines[path], Path(asked["points"]).read_bytes(), 16 * asked["count"],
                                  asked["count"], uniforms)
        Path(asked["results"]).write_bytes(results)


def main(file: int) -> None:
    with open(file, "w", buffering=1, encoding="utf-8") as answers:
        def send(**what: object) -> None:
            answers.write(f"{json.dumps(what)}\n")
        sys.path[:0] = [os.environ["HN_WGPU"]] if os.environ.get("HN_WGPU") else []
        os.environ.setdefault("XDG_RUNTIME_DIR", "/tmp")  # else Wayland's library complains
        try:
            device = Device(importlib.import_module("wgpu"))
            send(**device.info())
        except Exception as error:  # its errors have no common type
            send(absent=f"{type(error).__name__}: {error}")
            return
        pipelines: dict = {}
        for line in sys.stdin:
            try:
                answer(device, pipelines, json.loads(line))
                send()
            except Exception as error:
                send(error=str(error), **{"lost": True} if "lost" in str(error).lower() else {})


if __name__ == "__main__":
    main(int(sys.argv[1]))
