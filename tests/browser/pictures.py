"""Pictures of the page for its documentation, from a server with drawings and jobs of its own.

python -m tests.browser.pictures             backend/docs/page/*.png, as `make pictures`
python -m tests.browser.pictures --all DIR   all sizes, schemes and languages, to look at
"""

from __future__ import annotations

import argparse
import io
import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime, timedelta
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final, Literal, NamedTuple

import httpx
from PIL import Image
from playwright.sync_api import Browser, Page, ViewportSize, expect, sync_playwright

from knifetip.dxf.samples import samples
from tests.browser.conftest import ROOT, find_chromium, start_browser
from tests.support.serving.server import Running, wait_for_state

DOCS: Final = ROOT / "backend" / "docs" / "page"
#: Width of the pictures in the documentation (pixels), and most bytes of one.
WIDTH: Final = 1000
MOST_BYTES: Final = 150_000
SIZES: Final = {
    "1440": ViewportSize(width=1440, height=900),
    "1024": ViewportSize(width=1024, height=768),
    "820": ViewportSize(width=820, height=1180),
    "390": ViewportSize(width=390, height=844),
}
Scheme = Literal["light", "dark"]
SCHEMES: Final[tuple[Scheme, ...]] = ("light", "dark")
LANGUAGES: Final = ("en", "de")
MACHINE: Final = "demo-table"


class Shown(NamedTuple):
    """Ids of what the pictures show."""

    tray: str
    job: str  #: of the tray, ready to be sent
    sheet: str


class Picture(NamedTuple):
    """A picture: its name, the address of what it shows, and what is visible when it is there."""

    name: str
    address: Callable[[Shown], str]
    test_id: str
    prepare: Callable[[Page], None] = lambda page: None


def _move_tool(page: Page) -> None:
    """Move the tool along more than half of its path."""
    box = page.get_by_test_id("scrubber").locator(".mantine-Slider-root").bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + 0.6 * box["width"], box["y"] + box["height"] / 2.0)


def _without_name(page: Page) -> None:
    """Do not ask for the name of the operator."""
    page.get_by_role("button", name=re.compile("^(No name|Kein Name)$")).last.click()


PICTURES: Final = (
    Picture("work", lambda _: "/", "drawing-row"),
    Picture("lines", lambda shown: f"/drawings/{shown.tray}/lines", "legend-cut"),
    Picture("sheet", lambda shown: f"/layouts/{shown.sheet}/sheet", "sheet-copy"),
    Picture("process", lambda shown: f"/drawings/{shown.tray}/process", "step-process"),
    Picture(
        "check",
        lambda shown: f"/drawings/{shown.tray}/check/jobs/{shown.job}",
        "verdict",
        _move_tool,
    ),
    Picture("fold", lambda shown: f"/drawings/{shown.tray}/fold", "fold-view"),
    Picture("machines", lambda _: "/machines", f"queue-of-{MACHINE}", _without_name),
    Picture("station", lambda _: f"/station/{MACHINE}", "station-state"),
    Picture("library", lambda _: f"/library/machines/{MACHINE}", "library"),
    Picture("history", lambda _: "/history", "history-row"),
)


def fill(client: httpx.Client) -> Shown:
    """Store drawings, a sheet and jobs: one that is done, one that waits, and one that is ready."""
    due = (datetime.now(UTC) + timedelta(days=2)).replace(minute=0, second=0, microsecond=0)

    def upload(name: str, customer: str, order: str) -> str:
        files = {"file": (name, samples()[name])}
        details = {"customer": customer, "external_id": order, "due": due.isoformat()}
        return str(_post(client, "drawings", files=files, data=details)["id"])

    def order(drawing: str, board: str) -> str:
        fields = {"drawing": drawing, "board": board, "machine": MACHINE}
        job = str(_post(client, "jobs", json=fields)["id"])
        wait_for_state(client, job, "ready", seconds=300.0)
        return job

    def release(job: str) -> None:
        client.post(f"/api/jobs/{job}/release").raise_for_status()

    box = upload("rigid-box-blank.dxf", "Bindery Hofer", "A-1042")
    tray = upload("corrugated-tray.dxf", "Fruit Keller", "A-1047")
    carton = upload("tuck-end-carton.dxf", "Pharma Linz", "A-1051")
    done = order(box, "greyboard-2.0")
    release(done)
    wait_for_state(client, done, "done", seconds=600.0, confirm=True)
    waiting, ready = order(carton, "fbb-0.4"), order(tray, "e-flute")
    release(waiting)
    place = {"turn": 0.0, "mirror": False, "gap_x": 5.0, "gap_y": 5.0}
    placed = [
        {"drawing": tray, "x": 10.0, "y": 10.0, "columns": 2, "rows": 2, **place},
        {"drawing": carton, "x": 10.0, "y": 770.0, "columns": 5, "rows": 1, **place},
    ]
    board = {"width": 1600.0, "height": 1200.0, "gap": 5.0, "margin": 10.0, "board": "e-flute"}
    layout = {"name": "Sheet of trays and cartons", "sheet": board, "placed": placed}
    return Shown(tray, ready, str(_post(client, "layouts", json=layout)["id"]))


def _post(client: httpx.Client, path: str, **content: Any) -> dict[str, Any]:
    answer = client.post(f"/api/{path}", **content)
    assert answer.is_success, answer.text
    body: dict[str, Any] = answer.json()
    return body


def take(page: Page, url: str, shown: Shown, picture: Picture) -> Image.Image:
    """Open what a picture shows, and return it."""
    page.goto(f"{url}/#{picture.address(shown)}")
    # Only the address after # has changed: the page of the picture before would go on.
    page.reload()
    expect(page.get_by_test_id(picture.test_id).first).to_be_visible()
    picture.prepare(page)
    # Pictures of drawings, the canvas and tooltips follow.
    page.wait_for_timeout(2500)
    return Image.open(io.BytesIO(page.screenshot(animations="disabled"))).convert("RGB")


def for_docs(image: Image.Image) -> bytes:
    """Return a picture as the documentation has it: smaller, as PNG with 256 colours."""
    height = round(image.height * WIDTH / image.width)
    small = image.resize((WIDTH, height), Image.Resampling.LANCZOS)
    target = io.BytesIO()
    # This method keeps the colours of small areas, such as lines and marks.
    few = small.quantize(256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    few.save(target, "PNG", optimize=True)
    return target.getvalue()


def write_docs(browser: Browser, url: str, shown: Shown) -> None:
    """Write the pictures of the documentation."""
    with _window(browser, "1440", "light", "en") as page:
        for picture in PICTURES:
            content = for_docs(take(page, url, shown, picture))
            if len(content) > MOST_BYTES:
                sys.exit(f"{picture.name}.png has {len(content)} bytes; the most are {MOST_BYTES}")
            (DOCS / f"{picture.name}.png").write_bytes(content)


def write_all(browser: Browser, url: str, shown: Shown, folder: Path) -> None:
    """Write each picture in all sizes, schemes and languages to a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for size, scheme, language in product(SIZES, SCHEMES, LANGUAGES):
        with _window(browser, size, scheme, language) as page:
            for picture in PICTURES:
                name = f"{picture.name}-{size}-{scheme}-{language}.png"
                take(page, url, shown, picture).save(folder / name)


@contextmanager
def _window(browser: Browser, size: str, scheme: Scheme, language: str) -> Iterator[Page]:
    context = browser.new_context(
        viewport=SIZES[size], color_scheme=scheme, locale=language, reduced_motion="reduce"
    )
    page = context.new_page()
    page.set_default_timeout(120_000)
    expect.set_options(timeout=120_000)
    yield page
    context.close()


def main() -> None:
    """Run a server, fill it, and write the pictures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--all", type=Path, metavar="DIR", help="folder for pictures of all kinds")
    folder = parser.parse_args().all
    chromium = find_chromium()
    if not chromium:
        sys.exit("There is no Chromium here: install it, or set KNIFETIP_CHROMIUM.")
    with (
        TemporaryDirectory() as data,
        Running(Path(data) / "pictures.sqlite", speed=40.0) as client,
        sync_playwright() as playwright,
    ):
        shown = fill(client)
        url = str(client.base_url).rstrip("/")
        browser = start_browser(playwright, chromium)
        if folder is None:
            write_docs(browser, url, shown)
        else:
            write_all(browser, url, shown, folder)
        browser.close()


if __name__ == "__main__":
    main()
