"""Runs the page of `hn-conform web` in a browser, where there is no hn-conform: on a Mac, on Windows.

    python browse.py PAGE RESULTS BROWSER [OPTION]...     BROWSER is a program of Chromium's kind, and has the options

It writes the results.json of the page to RESULTS, and prints the verdict and the failures. Exit status: 0 all as
expected, 1 not, 2 the page did not come to its end in 25 minutes.
"""

import base64
import contextlib
import gzip
import http.server
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

SECONDS = 25 * 60
# As hn-conform starts it: no page is slow because nobody sees it, and a lost context keeps no other case from its verdict.
OPTIONS = ("--headless=new", "--no-first-run", "--disable-background-timer-throttling", "--disable-gpu-watchdog",
           "--disable-renderer-backgrounding", "--disable-domain-blocking-for-3d-apis")
SUITE = re.compile(r'(?<=<script type="application/gzip" id="suite">)[^<]+')


def suite_of(page: str) -> dict:
    return json.loads(gzip.decompress(base64.b64decode(SUITE.search(page)[0])))


def reporting(page: str, **more: object) -> str:
    """The page with a suite that reports its progress here, and has more besides."""
    suite = suite_of(page) | {"report_to": "event"} | more
    packed = base64.b64encode(gzip.compress(json.dumps(suite).encode())).decode()
    return SUITE.sub(packed, page)


class Listener(http.server.BaseHTTPRequestHandler):
    """Serves one page, and keeps its posts."""

    def do_GET(self):
        if self.path != "/":
            self.send_error(404)
            return
        self.send_response(200)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        self.wfile.write(self.server.page)

    def do_POST(self):
        event = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.server.events.append(event)  # before the page goes on, whose next event another thread takes
        self.send_response(204)
        self.end_headers()
        if event["type"] in ("done", "stopped"):
            self.server.over.set()

    def log_message(self, *_):
        pass


@contextlib.contextmanager
def running(command: list[str]):
    browser = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        yield
    finally:
        if hasattr(os, "killpg"):
            os.killpg(browser.pid, signal.SIGTERM)  # what PATH has may be a script that has started it
        else:
            browser.kill()
        browser.wait()


def last_event(page: str, command: list[str], seconds: float) -> dict:
    """The event at the end of the page, or TimeoutError. The command of the browser lacks the address."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Listener)
    server.page, server.events, server.over = page.encode(), [], threading.Event()
    with server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            with running([*command, f"http://127.0.0.1:{server.server_port}/"]):
                if not server.over.wait(seconds):
                    raise TimeoutError(f"the page has not ended in {seconds} s; its last event: {server.events[-1:]}")
        finally:
            server.shutdown()
    return server.events[-1]


def main(page: str, results: str, browser: str, *options: str) -> int:
    # Windows keeps files of the profile open for a moment.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [browser, *OPTIONS, f"--user-data-dir={profile}", *options]
        try:
            event = last_event(reporting(Path(page).read_text(encoding="utf-8")), command, SECONDS)
        except TimeoutError as error:
            print(error)
            return 2
    print(event["verdict"], event.get("found", event.get("message")), sep="\n")
    if event["type"] == "stopped":
        return 2
    Path(results).write_text(event["results"], encoding="utf-8")
    return 0 if event["verdict"] == "All as expected" else 1


if __name__ == "__main__":
    if len(sys.argv) < 4:
        print(__doc__)
        sys.exit(2)
    sys.exit(main(*sys.argv[1:]))
