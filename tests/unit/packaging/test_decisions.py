"""Each page of backend/docs/decisions has a number of its own; links to it give that number."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
DECISIONS = ROOT / "backend" / "docs" / "decisions"
PAGES = sorted(page for page in DECISIONS.glob("*.md") if page.name != "README.md")


def test_each_decision_has_a_number_of_its_own_which_its_heading_repeats() -> None:
    names = [re.fullmatch(r"(\d{4})-[a-z0-9-]+\.md", page.name) for page in PAGES]
    assert [page.name for page, name in zip(PAGES, names, strict=True) if name is None] == []
    numbers = [int(name[1]) for name in names if name is not None]
    assert [number for number, count in Counter(numbers).items() if count > 1] == []
    headings = [page.read_text().partition(".")[0] for page in PAGES]
    assert headings == [f"# {number}" for number in numbers]


def test_the_index_has_each_decision_once_with_its_title() -> None:
    rows = re.findall(
        r"^\| \[(\d+\. .+?)\]\(([^)]+)\) \|", (DECISIONS / "README.md").read_text(), re.M
    )
    headings = {page.name: page.read_text().splitlines()[0].removeprefix("# ") for page in PAGES}
    assert {path: title for title, path in rows} == headings
    assert len(rows) == len(headings)


def test_the_index_states_whether_each_decision_holds_or_which_one_replaces_it() -> None:
    rows = re.findall(
        r"^\| \[(\d+)\. .+?\]\([^)]+\) \| (.+) \|$", (DECISIONS / "README.md").read_text(), re.M
    )
    assert len(rows) == len(PAGES)
    replaced = {number: status for number, status in rows if status != "yes"}
    for number, status in replaced.items():
        found = re.fullmatch(r"(?:no|in part), see \[(\d+)\]\((\d{4})-[a-z0-9-]+\.md\)", status)
        assert found is not None, f"{number}: {status}"
        assert int(found[1]) == int(found[2]) > int(number)
        assert (DECISIONS / status.partition("](")[2].rstrip(")")).is_file()


def test_the_changelog_links_to_decisions_by_their_numbers() -> None:
    text = (ROOT / "CHANGELOG.md").read_text()
    links = re.findall(r"\[ADR ([^\]]+)\]\(([^)]+)\)", text)
    assert links
    for number, path in links:
        assert path.startswith(f"backend/docs/decisions/{int(number):04d}-")
        assert (ROOT / path).is_file()
