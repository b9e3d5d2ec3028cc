"""Run an attack: make mutants, verify them, and measure the damage of the accepted ones."""

from __future__ import annotations

import re
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from random import Random

from tests.attack.damage import Oracle
from tests.attack.mutation import mutate
from tests.attack.subjects import Subject

#: Comments of languages that are not dialects of RS274/NGC.
_COMMENTS = {"hpgl": rb'CO"[^"\n]*";?', "mcx314": rb"(?m)^;.*$"}
#: Share of mutants with two changes; half of these begin with an accepted single mutant.
_DOUBLE = 0.5
_POOL = 40


@dataclass(frozen=True)
class Escape:
    """An accepted mutant that does damage."""

    number: int
    subject: str
    changes: str
    damage: str
    text: bytes

    def __str__(self) -> str:
        return f"{self.number} {self.subject}: {self.changes}: {self.damage}"


@dataclass
class Tally:
    """Counts of an attack, by subject and fate."""

    fates: dict[str, Counter[str]] = field(default_factory=lambda: defaultdict(Counter))
    kinds: dict[str, Counter[str]] = field(default_factory=lambda: defaultdict(Counter))
    seconds: float = 0.0

    @property
    def escapes(self) -> int:
        """Number of mutants that escaped."""
        return sum(fates["escape"] for fates in self.fates.values())

    def add(self, subject: str, changes: str, fate: str) -> None:
        """Count one mutant."""
        self.fates[subject][fate] += 1
        for change in changes.split(" + "):
            self.kinds[re.split(r" at | \d", change)[0]][fate] += 1

    def table(self) -> str:
        """Return all counts as text."""
        columns = ("refused", "equal", "harmless", "escape")
        lines = []
        for counts in (self.fates, self.kinds):
            lines.append(f"{'':34}" + "".join(f"{name:>10}" for name in columns))
            for name, fates in counts.items():
                row = "".join(f"{fates[column]:>10}" for column in columns)
                lines.append(f"{name:34}{row}")
        total = sum(sum(fates.values()) for fates in self.fates.values())
        rate = total / self.seconds if self.seconds else 0.0
        lines.append(f"{total} mutants, {self.escapes} escapes, {rate:.0f} per second")
        return "\n".join(lines)


def run(subjects: Sequence[Subject], count: int, seed: int, tally: Tally) -> Iterator[Escape]:
    """Verify ``count`` mutants of the subjects, count their fates, and yield the escapes."""
    rng, begin = Random(seed), time.perf_counter()
    oracles = {subject.name: Oracle(subject) for subject in subjects}
    for oracle in oracles.values():
        assert oracle.base.contacts
    pools: dict[str, list[tuple[str, bytes]]] = defaultdict(list)
    others = [subject.text for subject in subjects]
    # The work of an earlier program must not be done again.
    others += [work.text for subject in subjects for work in subject.earlier]
    number = 0
    while number < count:
        subject = rng.choice(subjects)
        made = _mutant(subject, pools[subject.name], others, rng)
        if made is None:
            continue
        number += 1
        changes, text = made
        if plain(text, subject.language) == plain(subject.text, subject.language):
            tally.add(subject.name, changes, "equal")
            continue
        if not subject.accepts(text):
            tally.add(subject.name, changes, "refused")
            continue
        damage = oracles[subject.name].damage(text)
        tally.add(subject.name, changes, "escape" if damage else "harmless")
        if damage:
            yield Escape(number, subject.name, changes, damage, text)
        elif " + " not in changes:
            pool = pools[subject.name]
            if len(pool) < _POOL:
                pool.append((changes, text))
            else:
                pool[rng.randrange(_POOL)] = changes, text
        tally.seconds = time.perf_counter() - begin


def _mutant(
    subject: Subject, pool: list[tuple[str, bytes]], others: Sequence[bytes], rng: Random
) -> tuple[str, bytes] | None:
    changes, text = "", subject.text
    if rng.random() < _DOUBLE:
        if pool and rng.random() < 0.5:
            changes, text = rng.choice(pool)
        elif first := mutate(text, others, rng):
            changes, text = first
        else:
            return None
    second = mutate(text, others, rng)
    if second is None:
        return None
    return f"{changes} + {second[0]}" if changes else second[0], second[1]


def plain(text: bytes, language: str) -> bytes:
    """Return the words of a program without comments, spaces and empty lines."""
    comment = _COMMENTS.get(language, rb"\([^()\n]*\)|;[^\n]*")
    lines = (
        re.sub(rb"[ \t\r]+", b"", line).upper() for line in re.sub(comment, b"", text).split(b"\n")
    )
    return b"\n".join(line for line in lines if line)
