"""Check a page against WCAG 2.2 levels A and AA and best practice, with axe-core."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Page

AXE = Path(__file__).resolve().parents[2] / "frontend/node_modules/axe-core/axe.min.js"
# Of rules that pass, one node each is listed; their number is enough here.
RUN = """async () => {
  const { passes, violations } = await axe.run(document, { resultTypes: ["violations"] });
  return [passes.length, violations.map(({ id, help, nodes }) =>
    `${id}: ${help}: ${nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`)];
}"""


FADED_IN = """() => {
  for (const animation of document.getAnimations())
    if (animation.effect.getComputedTiming().endTime !== Infinity) animation.finish();
}"""


def record_view(page: Page, screenshot: Path) -> None:
    """Take a screenshot of what the page shows now, and assert that it is accessible."""
    page.screenshot(path=screenshot)
    assert_accessible(page)


def assert_accessible(page: Page) -> None:
    """Assert that axe-core finds no violation in what the page shows now.

    What fades in has too little contrast until it is there: animations that end are finished.
    """
    page.evaluate(FADED_IN)
    # Evaluated by the debugger, because the page's Content-Security-Policy refuses other scripts.
    page.evaluate(AXE.read_text())
    passed, violations = page.evaluate(RUN)
    assert passed > 0, "axe-core checked nothing"
    assert not violations, "\n".join(violations)
