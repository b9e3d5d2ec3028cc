"""Benchmark of panning a drawing, beside plain WebGL lines, ``dxf-viewer`` and ``gcode-preview``.

    python -m tests.benchmarks.frames [--edges 20000,100000] [--frames 40] [--shots FOLDER]

The same segments are shown by four pages of one browser without a graphics card, each on a canvas
of the same size, and moved by the same drag.  A frame takes the time from one movement of the mouse
to the second animation frame after it, halved; the median of all frames is printed, with the CPU
time of all processes of the browser for each frame, which depends less on what else the computer
does.  The peers are fetched from npm to ``build/peers``.
"""

from __future__ import annotations

import argparse
import http.server
import socketserver
import statistics
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final, NamedTuple

import numpy as np
from playwright.sync_api import Browser, ViewportSize, sync_playwright
from rich.console import Console
from rich.table import Table

from tests.benchmarks.first_picture import cpu_seconds, drawing, outlines
from tests.browser.conftest import SIZE, find_chromium, start_browser
from tests.support.serving.server import Running

_ROOT: Final = Path(__file__).parents[2]
_PEERS: Final = _ROOT / "build" / "peers"
_PACKAGES: Final = ("gcode-preview@2.18.0", "dxf-viewer@1.0.49", "esbuild@0.25.10")
#: Drags the canvas and returns the times of the frames (ms).
_PAN: Final = """async ([frames, button]) => {
  const canvas = document.querySelector("canvas"), box = canvas.getBoundingClientRect();
  const at = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const tell = (kind, pressed) => canvas.dispatchEvent(new PointerEvent(kind, {
    clientX: at.x, clientY: at.y, bubbles: true, cancelable: true, pointerId: 1,
    pointerType: "mouse", button: kind === "pointermove" ? -1 : button,
    buttons: pressed ? (button === 2 ? 2 : 1) : 0,
  }));
  const frame = () => new Promise((done) => requestAnimationFrame(done));
  const times = [];
  tell("pointerdown", true);
  for (let number = 0; number < frames; number += 1) {
    const begun = performance.now();
    const back = number % 20 < 10 ? 1 : -1;
    at.x += 5 * back;
    at.y += 3 * back;
    tell("pointermove", true);
    await frame();
    await frame();
    times.push((performance.now() - begun) / 2);
  }
  tell("pointerup", false);
  return times;
}"""
_HEAD: Final = """<!doctype html><style>html,body,#view{margin:0;width:100%;height:100%}
canvas{display:block;width:100%;height:100%}</style>"""
_PLAIN: Final = f"""{_HEAD}<canvas></canvas><script type="module">
const canvas = document.querySelector("canvas"), box = canvas.getBoundingClientRect();
canvas.width = box.width; canvas.height = box.height;
const segments = new Float32Array(await (await fetch("segments.bin")).arrayBuffer());
const gl = canvas.getContext("webgl2", {{ antialias: true }}), program = gl.createProgram();
for (const [kind, source] of [
  [gl.VERTEX_SHADER, `attribute vec2 place; uniform vec2 size, shift; void main() {{
    gl_Position = vec4(2.0 * place / size - 1.0 + shift, 0.0, 1.0); }}`],
  [gl.FRAGMENT_SHADER, "void main() {{ gl_FragColor = vec4(1.0, 0.3, 0.3, 1.0); }}"],
]) {{
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  gl.attachShader(program, shader);
}}
gl.linkProgram(program);
gl.useProgram(program);
gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
gl.bufferData(gl.ARRAY_BUFFER, segments, gl.STATIC_DRAW);
const place = gl.getAttribLocation(program, "place");
gl.enableVertexAttribArray(place);
gl.vertexAttribPointer(place, 2, gl.FLOAT, false, 0, 0);
const size = segments.reduce((most, value, at) => {{
  most[at % 2] = Math.max(most[at % 2], value); return most; }}, [0, 0]);
gl.uniform2f(gl.getUniformLocation(program, "size"), ...size);
const shift = gl.getUniformLocation(program, "shift");
const draw = (event) => {{
  if (event) gl.uniform2f(shift, event.clientX / box.width - 0.5, event.clientY / box.height - 0.5);
  gl.clear(gl.COLOR_BUFFER_BIT);
  gl.drawArrays(gl.LINES, 0, segments.length / 2);
}};
let waiting = false;
canvas.onpointermove = (event) => {{
  if (!waiting) requestAnimationFrame(() => {{ waiting = false; draw(event); }});
  waiting = true;
}};
draw();
document.title = "shown";
</script>"""
_DXF: Final = f"""{_HEAD}<div id="view"></div><script type="module">
import {{ DxfViewer }} from "./dxf.js";
const viewer = new DxfViewer(document.getElementById("view"),
  {{ canvasWidth: innerWidth, canvasHeight: innerHeight, antialias: true }});
await viewer.Load({{ url: new URL("drawing.dxf", location.href).href }});
document.title = "shown";
</script>"""
_GCODE: Final = f"""{_HEAD}<canvas></canvas><script type="module">
import {{ init }} from "./gcode.js";
const canvas = document.querySelector("canvas");
canvas.width = innerWidth; canvas.height = innerHeight;
const program = await (await fetch("program.gcode")).text();
const [x, y] = program.match(/^; ([\\d.]+) ([\\d.]+)/).slice(1).map(Number);
const preview = init({{ canvas, buildVolume: {{ x, y, z: 1 }}, renderTravel: false,
  initialCameraPosition: [0, 2.5 * y, 1], extrusionColor: "hotpink" }});
preview.processGCode(program);
document.title = "shown";
</script>"""


class Frames(NamedTuple):
    """Frames of one page: time and CPU time of each (ms), and the size of the canvas."""

    time: float
    cpu: float
    canvas: ViewportSize


class Wanted(NamedTuple):
    """A page that is measured: frames, folder for its picture, button of the mouse that pans it,
    and whether its title says when it shows the drawing.
    """

    name: str
    frames: int
    shots: Path | None
    button: int = 0
    titled: bool = True


def bundle_peers() -> None:
    """Fetch the peers and make a module of each."""
    if (_PEERS / "dxf.js").is_file():
        return
    _PEERS.mkdir(parents=True, exist_ok=True)
    (_PEERS / "package.json").write_text("{}", encoding="utf-8")
    npm = [sys.executable, str(_ROOT / "frontend" / "build.py"), "npm", "--prefix", str(_PEERS)]
    subprocess.run([*npm, "install", "--no-audit", "--no-fund", *_PACKAGES], check=True)
    for name, package in (("gcode", "gcode-preview"), ("dxf", "dxf-viewer")):
        bundle = ["exec", "--", "esbuild", "--bundle", "--format=esm", "--log-level=warning"]
        source = _PEERS / "node_modules" / package
        subprocess.run([*npm, *bundle, str(source), f"--outfile={_PEERS / name}.js"], check=True)


def write_pages(folder: Path, drawing: bytes, segments: np.ndarray) -> None:
    """Write the pages of the peers, and the drawing as each of them reads it.

    Parameters
    ----------
    segments
        Ends of the segments (n × 2 × 2, mm).
    """
    for name, page in (("plain", _PLAIN), ("dxf-viewer", _DXF), ("gcode-preview", _GCODE)):
        (folder / f"{name}.html").write_text(page, encoding="utf-8")
    for module in ("dxf.js", "gcode.js"):
        (folder / module).write_bytes((_PEERS / module).read_bytes())
    (folder / "drawing.dxf").write_bytes(drawing)
    (folder / "segments.bin").write_bytes(segments.astype("<f4").tobytes())
    width, height = segments.max(axis=(0, 1)).tolist()
    lines, last = [f"; {width} {height}", "G21", "G90", "M83"], None
    for (x, y), (to_x, to_y) in segments.tolist():
        if last != (x, y):
            lines.append(f"G0 X{x:.4f} Y{y:.4f} Z0.2")
        lines.append(f"G1 X{to_x:.4f} Y{to_y:.4f} E1")
        last = (to_x, to_y)
    (folder / "program.gcode").write_text("\n".join(lines), encoding="ascii")


class _Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_: Any) -> None:
        """Print nothing for a request."""


@contextmanager
def serve_folder(folder: Path) -> Iterator[str]:
    """Serve the files of a folder; yields its address."""
    handler = partial(_Quiet, directory=str(folder))
    with socketserver.ThreadingTCPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}"
        server.shutdown()


def panned(browser: Browser, url: str, view: ViewportSize, wanted: Wanted) -> Frames:
    """Open a page, drag its canvas, and return what a frame takes."""
    context = browser.new_context(viewport=view)
    page = context.new_page()
    page.set_default_timeout(300_000)
    page.goto(url)
    if wanted.titled:
        page.wait_for_function("document.title === 'shown'")
    else:
        page.wait_for_load_state("networkidle")
    page.wait_for_timeout(3000)
    system = browser.new_browser_cdp_session()
    page.evaluate(_PAN, [4, wanted.button])
    before = sum(cpu_seconds(system).values())
    times = page.evaluate(_PAN, [wanted.frames, wanted.button])
    after = sum(cpu_seconds(system).values())
    if wanted.shots is not None:
        page.screenshot(path=wanted.shots / f"{wanted.name}.png")
    box = page.locator("canvas").first.bounding_box()
    assert box is not None
    canvas = ViewportSize(width=round(box["width"]), height=round(box["height"]))
    context.close()
    spent = 1000.0 * (after - before) / (2 * wanted.frames)
    return Frames(statistics.median(times), spent, canvas)


def compare(browser: Browser, edges: int, wanted: Wanted) -> Table:
    """Return a table of the pages that show a drawing."""
    content, vertices = drawing(edges), outlines(edges)
    segments = np.stack([vertices, np.roll(vertices, -1, axis=1)], axis=2).reshape(-1, 2, 2)
    table = Table(
        f"{len(segments):,} segments", "ms a frame", "ms of CPU", "× plain", "CPU × plain"
    )
    with (
        TemporaryDirectory() as data,
        Running(Path(data) / "frames.sqlite") as client,
        serve_folder(Path(data)) as address,
    ):
        write_pages(Path(data), content, segments)
        answer = client.post("/api/drawings", files={"file": ("many.dxf", content)}, timeout=900.0)
        answer.raise_for_status()
        own = f"{str(client.base_url).rstrip('/')}/#/drawings/{answer.json()['id']}/lines"
        found = {"knifetip": panned(browser, own, SIZE, wanted._replace(titled=False))}
        # The others have a page of the size of its canvas.
        view = found["knifetip"].canvas
        for name, button in (("plain", 0), ("dxf-viewer", 0), ("gcode-preview", 2)):
            one = wanted._replace(name=name, button=button)
            found[name] = panned(browser, f"{address}/{name}.html", view, one)
    plain = found["plain"]
    for name, page in found.items():
        ratios = page.time / plain.time, page.cpu / plain.cpu
        table.add_row(
            name, f"{page.time:.0f}", f"{page.cpu:.0f}", *(f"{one:.1f}" for one in ratios)
        )
    return table


def main() -> None:
    """Print a table for each number of edges."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--edges", default="20000,100000", help="of the drawings, by commas")
    parser.add_argument("--frames", type=int, default=40, help="of each page")
    parser.add_argument("--shots", type=Path, help="folder for a picture of each page")
    said = parser.parse_args()
    if said.shots:
        said.shots.mkdir(parents=True, exist_ok=True)
    bundle_peers()
    with sync_playwright() as playwright:
        browser = start_browser(playwright, find_chromium())
        for edges in map(int, said.edges.split(",")):
            wanted = Wanted("knifetip", said.frames, said.shots)
            Console(width=100).print(compare(browser, edges, wanted))
        browser.close()


if __name__ == "__main__":
    main()
