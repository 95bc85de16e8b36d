"""The README's lines for three.js draw the second tile of its picture, in Chromium.

three comes from npm's registry. Exit status: 0 they do, 1 they do not, 77 three cannot be had here.
"""

import base64
import contextlib
import functools
import hashlib
import http.server
import io
import json
import queue
import re
import subprocess
import sys
import tarfile
import tempfile
import threading
import urllib.error
import urllib.request
from pathlib import Path

from tree import ROOT, TOOLS

THREE = "https://registry.npmjs.org/three/-/three-0.180.0.tgz"
INTEGRITY = (  # sha512, as npm's registry has it
    "o+qycAMZrh+TsE01GqWUxUIKR1AL0S8pq7zDkYOQw8Gq"
    "fX8b8VoCKYUoHbhiX5j+7hr8XsuHDVU6+gkQJQKg9w==")
SKIPPED = 77
SECONDS = 120  # for Chromium
TILE = 256  # pixels of a side; as picture.cpp
SECOND_TILE = 260  # its first column
CHROMIUM = ("chromium", "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")

PAGE = """<!doctype html>
<script type="importmap">{"imports": {"three": "./three.module.js"}}</script>
<script type="module">
const tell = (what) => fetch("told", {method: "POST", body: JSON.stringify(what)});
addEventListener("error", (event) => tell({error: String(event.message)}));
addEventListener("unhandledrejection", (event) => tell({error: String(event.reason)}));
const wrong = [];
console.error = (...what) => wrong.push(what.join(" "));
const THREE = await import("three");
const {material} = await import("./material.js");
const renderer = new THREE.WebGLRenderer({preserveDrawingBuffer: true});
renderer.setSize(SIDE, SIDE, false);
const scene = new THREE.Scene();
scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));
renderer.render(scene, new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1));
const image = new Image();
image.src = "noise.png";
await image.decode();
const pixels = (source, left) => {
  const context = new OffscreenCanvas(SIDE, SIDE).getContext("2d");
  context.drawImage(source, left, 0, SIDE, SIDE, 0, 0, SIDE, SIDE);
  return context.getImageData(0, 0, SIDE, SIDE).data;
};
const drawn = pixels(renderer.domElement, 0);
const printed = pixels(image, LEFT);
let furthest = 0;
for (let i = 0; i < drawn.length; ++i) furthest = Math.max(furthest, Math.abs(drawn[i] - printed[i]));
tell({furthest, wrong, three: THREE.REVISION});
</script>
"""


def three_js() -> dict[str, bytes]:
    """The files of three, by name."""
    with urllib.request.urlopen(THREE, timeout=60) as answer:
        packed = answer.read()
    found = base64.b64encode(hashlib.sha512(packed).digest()).decode()
    if found != INTEGRITY:
        raise ValueError(f"{THREE} is another file: its sha512 is {found}")
    with tarfile.open(fileobj=io.BytesIO(packed)) as package:
        return {name: package.extractfile(f"package/build/{name}").read() for name in ("three.module.js", "three.core.js")}


def site(material: str) -> dict[str, bytes]:
    """What the page loads, by path. A bundler makes a module of a file with ?raw; so is it one here."""
    library = subprocess.run([TOOLS / "single-file", "--strip"], capture_output=True, text=True, check=True).stdout
    page = PAGE.replace("SIDE", str(TILE)).replace("LEFT", str(SECOND_TILE))
    return {"/": page.encode(), "/material.js": material.encode(),
            "/hashnoise.single.glsl?raw": f"export default {json.dumps(library)};".encode(),
            "/noise.png": (ROOT / "docs" / "images" / "noise.png").read_bytes()}


class Site(http.server.BaseHTTPRequestHandler):
    def __init__(self, files: dict[str, bytes], told: queue.Queue, *arguments):
        self.files, self.told = files, told
        super().__init__(*arguments)

    def do_GET(self):
        body = self.files.get(self.path)
        self.send_response(404 if body is None else 200)
        kind = "text/html" if self.path == "/" else "image/png" if self.path.endswith("png") else "text/javascript"
        self.send_header("Content-Type", kind)
        self.end_headers()
        self.wfile.write(body or b"")

    def do_POST(self):
        self.told.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(200)
        self.end_headers()

    def log_message(self, *_):
        pass


def draw(files: dict[str, bytes]) -> dict:
    """What the page tells of its picture."""
    told: queue.Queue = queue.Queue()
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Site, files, told)) as server, \
            tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        browser = subprocess.Popen([*CHROMIUM, f"--user-data-dir={profile}", f"http://127.0.0.1:{server.server_port}/"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            with contextlib.suppress(queue.Empty):
                return told.get(timeout=SECONDS)
            return {"error": f"Chromium said nothing for {SECONDS} s"}
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()


def right(answer: dict) -> bool:
    """A step of 8 bits is what rounding may make of the bound of HN_FAST."""
    return not answer.get("error") and not answer["wrong"] and answer["furthest"] <= 1


def main() -> int:
    try:
        three = {f"/{name}": text for name, text in three_js().items()}
    except (urllib.error.URLError, TimeoutError) as error:
        print(f"skipped: {THREE} cannot be had here: {error}")
        return SKIPPED
    code = re.search(r"^```js\n(.*?)^```$", (ROOT / "README.md").read_text(), re.MULTILINE | re.DOTALL)[1]
    answer = draw(three | site(code))
    print(answer)
    faulty = draw(three | site(code.replace("6, 2.0", "5, 2.0")))
    print("with a fault:", faulty)
    broken = draw(three | site(code.replace("hn_fbm", "hn_fmb")))
    print("with a mistake:", broken.get("error") or broken["wrong"][0][:200])
    return 0 if right(answer) and not right(faulty) and not right(broken) else 1


if __name__ == "__main__":
    sys.exit(main())
