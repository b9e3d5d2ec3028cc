"""Benchmark of the first picture of a drawing with many edges, from its address to the frame.

    python -m tests.benchmarks.first_picture [EDGES]

A server reads a DXF file of closed polylines on five layers, and a new window opens the address of
the drawing, without a graphics card.  Times are those of the clock, and CPU times of the processes
of the browser, which compare on a busy computer, too.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

import numpy as np
from playwright.sync_api import Browser, CDPSession, sync_playwright

from tests.browser.conftest import SIZE, find_chromium, start_browser
from tests.support.serving.server import Running
from tests.support.writers import dxf_text as text

LAYERS: Final = ("CUT", "CREASE", "PERFORATION", "HALF-CUT", "V-GROOVE")
#: Edges of a polyline.
EDGES: Final = 250
#: Notes when the first call is made that draws most of the edges, and when its frame is shown.
WATCH: Final = """(wanted) => {
  const note = () => {
    window.drawn = performance.now();
    requestAnimationFrame(() => requestAnimationFrame(() => (window.shown = performance.now())));
  };
  for (const [name, at, each] of [
    ["drawArrays", 2, 2], ["drawElements", 1, 6],
    ["drawArraysInstanced", 3, 1], ["drawElementsInstanced", 4, 1],
  ]) {
    const draw = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function (...values) {
      const isMost = values[at] / each >= wanted;
      draw.apply(this, values);
      if (isMost && window.drawn === undefined) note();
    };
  }
}"""
#: Begin and end of each request of the API, in ms since the navigation began.
REQUESTS: Final = """performance.getEntriesByType("resource")
  .filter(({ name }) => name.includes("/api/"))
  .map(({ name, startTime, responseStart, responseEnd, encodedBodySize }) =>
    [new URL(name).pathname + new URL(name).search, startTime, responseStart, responseEnd,
     encodedBodySize])"""


def outlines(edges: int) -> np.ndarray:
    """Return the vertices of closed polylines side by side (n × EDGES × 2, mm)."""
    number = np.arange(edges // EDGES)[:, np.newaxis]
    row, column = np.divmod(number, math.ceil(math.sqrt(1.6 * len(number))))
    angle = np.linspace(0.0, 2.0 * np.pi, EDGES, endpoint=False)
    radius = 10.0 + 1.5 * np.sin(angle * (3 + number % 17))
    x = 25.0 * column + 12.0 + radius * np.cos(angle)
    y = 28.0 * row + 12.0 + radius * np.sin(angle)
    return np.stack([x, y], axis=-1).round(4)


def drawing(edges: int) -> bytes:
    """Return a DXF file of closed polylines on several layers."""

    def polylines() -> Iterator[str]:
        for number, places in enumerate(outlines(edges).tolist()):
            head = ((8, LAYERS[number % 5]), (90, EDGES), (70, 1))
            corners = (pair for place in places for pair in zip((10, 20), place, strict=True))
            yield text.entity("LWPOLYLINE", *head, *corners)

    return text.dxf(*polylines(), units=4)


def cpu_seconds(session: CDPSession) -> dict[str, float]:
    """Return the CPU time of the processes of the browser by their kind."""
    found: dict[str, float] = {}
    for process in session.send("SystemInfo.getProcessInfo")["processInfo"]:
        found[process["type"]] = found.get(process["type"], 0.0) + process["cpuTime"]
    return found


def open_drawing(browser: Browser, url: str, edges: int) -> dict[str, Any]:
    """Open the address of a drawing in a new window; return times in ms, bytes and CPU times."""
    context = browser.new_context(viewport=SIZE)
    context.add_init_script(f"({WATCH})({0.9 * edges})")
    page = context.new_page()
    page.set_default_timeout(600_000)
    system = browser.new_browser_cdp_session()
    before = cpu_seconds(system)
    page.goto(url, wait_until="commit")
    # `wait_for_function` evaluates a text, which the page's Content-Security-Policy refuses.
    while page.evaluate("window.shown") is None:
        page.wait_for_timeout(100)
    after = cpu_seconds(system)
    heap = page.context.new_cdp_session(page)
    heap.send("Performance.enable")
    metrics = {one["name"]: one["value"] for one in heap.send("Performance.getMetrics")["metrics"]}
    found = {
        "drawn": page.evaluate("window.drawn"),
        "shown": page.evaluate("window.shown"),
        "requests": page.evaluate(REQUESTS),
        "cpu": {kind: spent - before.get(kind, 0.0) for kind, spent in after.items()},
        "heap": metrics["JSHeapUsedSize"],
    }
    context.close()
    return found


def main() -> None:
    """Print the figures."""
    edges = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    sys.stdout.reconfigure(line_buffering=True)  # type: ignore[union-attr]  # a TextIOWrapper here
    content = drawing(edges)
    with (
        TemporaryDirectory() as data,
        Running(Path(data) / "first.sqlite") as client,
        sync_playwright() as playwright,
    ):
        begun = time.monotonic()
        answer = client.post("/api/drawings", files={"file": ("many.dxf", content)}, timeout=900.0)
        answer.raise_for_status()
        print(f"upload of {len(content) / 1e6:.1f} MB: {time.monotonic() - begun:.1f} s")
        browser = start_browser(playwright, find_chromium())
        address = f"{str(client.base_url).rstrip('/')}/#/drawings/{answer.json()['id']}/lines"
        for run in range(2):
            found = open_drawing(browser, address, edges)
            print(f"run {run + 1}: drawn after {found['drawn']:.0f} ms", end=", ")
            print(f"shown after {found['shown']:.0f} ms, heap {found['heap'] / 1e6:.0f} MB")
            print("   CPU s:", {kind: round(spent, 2) for kind, spent in found["cpu"].items()})
            for path, begin, first, end, size in found["requests"]:
                print(f"   {begin:6.0f} {first:6.0f} {end:6.0f} ms {size / 1e6:6.2f} MB  {path}")
        browser.close()


if __name__ == "__main__":
    main()
