"""Pages in a browser, all in one start of it: what runs in them, what they ask for, and what is read there."""
from __future__ import annotations

import json
import re
import shutil
import subprocess
import threading
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from html import unescape
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from tempfile import TemporaryDirectory

_PATIENCE_S = 120
_BUDGET_MS = 3000  # budget of the browser's own time, ms, which passes at once while nothing is fetched
_FRAMES = """<!DOCTYPE html><meta charset="utf-8"><script>
const found = {};
function of(name) { return found[name] = found[name] || {ran: 0}; }
function ran(place) { of(place.location.pathname.split("/")[1]).ran += 1; }
onload = () => setTimeout(() => {
  for (const frame of document.querySelectorAll("iframe")) {
    const page = frame.contentDocument, all = [...page.querySelectorAll("*")];
    page.querySelectorAll("style").forEach(one => one.remove());
    Object.assign(of(frame.name), {
      words: page.documentElement.textContent,
      handlers: all.flatMap(one => [...one.attributes]).filter(one => /^on/i.test(one.name)
        || /(href|src|srcdoc|action|data)$/i.test(one.name) && /^\\s*(javascript|vbscript):/i.test(one.value)).length,
    });
  }
  document.body.innerHTML = "<pre></pre>";
  document.querySelector("pre").textContent = "FOUND" + JSON.stringify(found) + "END";
}, 500);
</script><body>%s</body>"""


@dataclass
class SeenPage:
    """One page as it was shown."""

    words: str  # all text of it, its title among it
    ran: int  # how often anything of it called ``parent.ran(self)``
    handlers: int  # attributes that would run something, if it were clicked at least
    asked: list[str] = field(default_factory=list)  # addresses that were asked for because of it


@cache
def browser() -> str | None:
    """The chromium of this machine."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def see(pages: Mapping[str, str]) -> dict[str, SeenPage]:
    """Pages by names of letters, each in a frame of its own, come from a server that hears whatever they ask for."""
    asked: list[str] = []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            name, _, rest = self.path[1:].partition("/")
            text = frames if self.path == "/" else pages.get(name) if rest == "page.html" else None
            if text is None:
                asked.append(self.path)
            self.send_response(200 if text is not None else 404)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.end_headers()
            self.wfile.write((text or "").encode())

        def log_message(self, format: str, *arguments: object) -> None:
            pass

    frames = _FRAMES % "".join(f'<iframe name="{name}" src="/{name}/page.html"></iframe>' for name in pages)
    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        shown = _shown(f"http://127.0.0.1:{server.server_port}/")
    finally:
        server.shutdown()
        server.server_close()
    match = re.search("<pre>FOUND(.*)END</pre>", shown, re.DOTALL)
    assert match is not None, shown[-500:]
    seen = {name: SeenPage(**load) for name, load in json.loads(unescape(match.group(1))).items()}
    for path in asked:
        if (name := path.split("/")[1]) in seen:
            seen[name].asked.append(path)
    return seen


def _shown(address: str) -> str:
    program = browser()
    assert program is not None
    with TemporaryDirectory(prefix="seam_inspector_", ignore_cleanup_errors=True) as profile:
        command = [
            program, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}", "--no-proxy-server",
            f"--virtual-time-budget={_BUDGET_MS}", "--dump-dom", address,
        ]  # fmt: skip
        made = subprocess.run(command, capture_output=True, text=True, timeout=_PATIENCE_S, check=False)
    return made.stdout or made.stderr
