"""The page of the slowest tests lists tests and folders by their CPU time."""

from __future__ import annotations

from tests.support.cpu_time import slowest_page


def test_tests_and_folders_are_listed_by_their_time() -> None:
    page = slowest_page(
        {
            "tests/unit/dxf/test_a.py::test_b[x/y]": 2.0,
            "tests/browser/test_c.py::test_d": 3.25,
            "tests/unit/dxf/test_a.py::test_e": 2.5,
        }
    )
    rows = [line for line in page.splitlines() if line.startswith("| ") and "`" in line]
    assert rows == [
        "| 3.2 | `browser/test_c.py::test_d` |",
        "| 2.5 | `unit/dxf/test_a.py::test_e` |",
        "| 2.0 | `unit/dxf/test_a.py::test_b[x/y]` |",
        "| 4 | 2 | `unit/dxf` |",
        "| 3 | 1 | `browser` |",
    ]
    assert "3 slowest of 3 measured tests" in page
    assert "They take 8 s together" in page
