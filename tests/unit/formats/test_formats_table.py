"""The page about imports lists every format."""

from __future__ import annotations

from tests.benchmarks.import_table import PAGE, formats_table


def test_the_page_about_imports_has_the_table_of_all_formats() -> None:
    assert formats_table() in PAGE.read_text(encoding="utf-8")
