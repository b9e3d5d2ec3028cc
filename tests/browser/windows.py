"""Windows of the browser, each with cookies and storage of its own."""

from __future__ import annotations

from typing import Any

from playwright.sync_api import Browser, BrowserContext

#: Continuous motion is drawn ten times a second: without a graphics card a frame takes 10 ms. The
#: first frame after a pause is drawn at once.
FEW_FRAMES = """(() => {
  const request = window.requestAnimationFrame.bind(window), waiting = new Set();
  let last = 0;
  window.requestAnimationFrame = (draw) => {
    const run = (now) => {
      if (!waiting.delete(id)) return;
      last = now;
      draw(now);
    };
    const id = setTimeout(() => request(run), Math.max(0, last + 100 - performance.now()));
    waiting.add(id);
    return id;
  };
  window.cancelAnimationFrame = (id) => waiting.delete(id) && clearTimeout(id);
})();"""


def open_window(browser: Browser, **options: Any) -> BrowserContext:
    """Open a window with options of Playwright, in which continuous motion has few frames.

    Transitions and animations of styles end at once, as for a user who prefers reduced motion.
    """
    context = browser.new_context(**{"reduced_motion": "reduce"} | options)
    context.add_init_script(FEW_FRAMES)
    return context
