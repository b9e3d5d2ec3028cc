"""The step Check: program lines and slider in step, the section of the board, the compensation."""

from __future__ import annotations

import re
from pathlib import Path
from urllib.parse import urljoin

import pytest
from playwright.sync_api import Page, expect

from knifetip.dxf.samples import samples
from tests.browser.accessibility import record_view
from tests.browser.test_corridor import compile_on, drop

pytestmark = [pytest.mark.browser, pytest.mark.xdist_group("browser"), pytest.mark.timeout(600)]


def test_program_lines_slider_and_section_are_in_step(page: Page, screenshots: Path) -> None:
    drop(page, "rigid-box-blank.dxf", samples()["rigid-box-blank.dxf"])
    compile_on(page, "Greyboard 2.0 mm")
    # One sentence has the figures; its clause about the overcut goes from place to place.
    sentence = page.get_by_test_id("verdict-sentence")
    expect(sentence).to_have_text(
        re.compile(
            r"Cuts your drawing to (?:<\s)?[\d.]+\smm in [\d.:]+\s\w+; "
            r"up to [\d.]+\smm overcut at \d+ places, [\d.]+\smm allowed\."
        )
    )
    expect(page.get_by_test_id("verdict").get_by_text("Machine time")).to_have_count(1)
    page.get_by_test_id("overcuts").click()
    expect(page.get_by_test_id("selection")).to_be_visible()
    page.keyboard.press("Escape")
    address = str(page.get_by_test_id("program").get_attribute("href"))
    program = page.request.get(urljoin(page.url, address)).text()
    # The first move along a groove: at its depth of 1.3 mm, with the feed of the V-cutter.
    text = program.split("\n")
    number = next(at for at, line in enumerate(text, start=1) if line.endswith("F12000"))
    page.get_by_role("button", name=re.compile("^Program lines")).click()
    lines = page.get_by_test_id("program-lines")
    line = lines.get_by_role("option").filter(has_text=re.compile(f"^{number}G"))
    expect(line).to_have_text(f"{number}{text[number - 1]}")

    # From a line to the slider, the tool and the section.
    slider = page.get_by_test_id("scrubber").get_by_role("slider")
    line.click()
    expect(line).to_have_attribute("aria-selected", "true")
    at_line = float(str(slider.get_attribute("aria-valuenow")))
    assert at_line > 0.0
    head = page.get_by_test_id("head-figures")
    expect(head.locator("[data-figure=z] dd")).to_have_text("0.70")
    expect(head.locator("[data-figure=lean] dd")).to_have_text("45.0°")
    section = page.get_by_test_id("section")
    for measure, value in (("caliper", "2.00"), ("base", "0.70"), ("foldAngle", "90.0")):
        expect(section.locator(f"[data-measure={measure}] td")).to_contain_text(value)
    record_view(page, screenshots / "check-1-line.png")

    # From the slider to the line, and from line to line by the keyboard.
    slider.press("End")
    expect(lines).not_to_have_attribute("data-line", str(number))
    assert int(str(lines.get_attribute("data-line"))) > number
    slider.press("Home")
    lines.press("Home")
    expect(lines).to_have_attribute("data-line", "1")
    page.get_by_test_id("program-go-to").fill(str(number))
    expect(lines).to_have_attribute("data-line", str(number))
    assert float(str(slider.get_attribute("aria-valuenow"))) == at_line
    lines.press("ArrowDown")
    expect(lines).to_have_attribute("data-line", str(number + 1))

    # The largest offset: line, tip and head, played from before the move on.
    page.get_by_test_id("show-compensation").click()
    for layer in ("nominal", "tip", "head"):
        expect(page.get_by_test_id(f"layer-{layer}")).to_have_attribute("aria-pressed", "true")
    begin = str(slider.get_attribute("aria-valuenow"))
    expect(slider).not_to_have_attribute("aria-valuenow", begin)
    record_view(page, screenshots / "check-2-compensation.png")
