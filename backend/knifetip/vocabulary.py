"""vocabulary: find the line type that a name suggests, such as cut or crease, in many languages.

The name is that of a layer or of a dash pattern, such as "Schnitt außen", "Línea de hendido" and
"no cut".  The words are in the file ``vocabulary.toml``.  A name is compared word by word, never by
parts of words: the word ``cut`` is not found in ``Cutout``, nor ``Schnitt`` in ``SCHNITTKANTEN``.
A negating word cancels the meaning, and so do two words that contradict each other.  Chinese,
Japanese and Korean do not separate words, so names in these languages are searched for substrings.

A name alone decides nothing; ``decision.by_evidence`` combines it with other evidence.
"""

from __future__ import annotations

import re
import tomllib
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib import resources
from typing import Final

from knifetip.model.dieline import LineType

_CAMEL_CASE: Final = re.compile(r"(?<=[a-zà-ÿ])(?=[A-ZÀ-Þ])")
_SEPARATORS: Final = re.compile(r"[^\w]+|_+|\d+")
#: A part of the thickness of the board, as in "50 % cut".
_DEPTH: Final = re.compile(r"(?<![\d.,])[1-9]\d?\s?%")
#: Letters that Unicode does not decompose into a base letter and an accent.
_LETTERS: Final = str.maketrans({"ł": "l", "ı": "i", "ø": "o", "æ": "ae", "đ": "d", "œ": "oe"})
#: Second halves of "V groove", whose first half is too short to be a word of its own.
_GROOVE_WORDS: Final = ("groove", "grooves", "nut", "nuten")


@dataclass(frozen=True, slots=True)
class NameMeaning:
    """The line type, such as cut or crease, that the name of a layer or dash pattern suggests.

    The line type is None if the name suggests none.  The record also contains the part of the name
    that suggests the line type, and whether the name contains a negating word.
    """

    kind: LineType | None  #: None if no word has a meaning, or if two words contradict each other
    word: str  #: the part of the name that has this meaning
    denied: bool  #: whether the name contains a negating word


@dataclass(frozen=True, slots=True)
class _Vocabulary:
    """The words from ``vocabulary.toml`` that occur in names of layers and dash patterns.

    Each word has a meaning, for example a line type or a negation.
    """

    meanings: Mapping[str, frozenset[LineType]]  #: line types of each word
    before_cut: Mapping[str, LineType]  #: words that make the cut named after them a partial one
    substrings: tuple[tuple[str, LineType], ...]  #: for names without separated words, in order
    negations: frozenset[str]
    negating_substrings: tuple[str, ...]
    whole_die: frozenset[str]
    meaningless: frozenset[str]
    dashed: tuple[str, ...]  #: parts of the names of dashed linetypes
    centre_line: tuple[str, ...]  #: parts of the names of centre-line linetypes


@cache
def _vocabulary() -> _Vocabulary:
    """Return the contents of ``vocabulary.toml``; the file is read at the first call."""
    text = (resources.files(__package__) / "vocabulary.toml").read_text("utf-8")
    data = tomllib.loads(text)
    meanings: dict[str, set[LineType]] = {}
    for kind, languages in data["words"].items():
        for word in _all_words(languages):
            meanings.setdefault(word, set()).add(LineType.from_word(kind))
    negating_substrings = data["negations"].pop("substrings")
    return _Vocabulary(
        {word: frozenset(kinds) for word, kinds in meanings.items()},
        dict(_by_line_type(data["before-cut"])),
        tuple(_by_line_type(data["substrings"])),
        frozenset(_all_words(data["negations"]) + _all_words(data["false-friends"])),
        tuple(negating_substrings.split()),
        frozenset(_all_words(data["whole-die"])),
        frozenset(_all_words(data["meaningless"])),
        tuple(data["linetypes"]["dashed"].split()),
        tuple(data["linetypes"]["centre-line"].split()),
    )


def _all_words(languages: Mapping[str, str]) -> list[str]:
    """Return the words of all languages.

    ``languages`` contains for each language its words, separated by spaces.
    """
    return [word for line in languages.values() for word in line.split()]


def _by_line_type(table: Mapping[str, str]) -> list[tuple[str, LineType]]:
    """Return pairs of a word and the line type that it means, in the order of ``table``.

    ``table`` contains for each name of a line type its words, separated by spaces.
    """
    return [
        (word, LineType.from_word(kind)) for kind, line in table.items() for word in line.split()
    ]


@lru_cache(maxsize=1 << 17)
def name_meaning(name: str) -> NameMeaning:
    """Return the line type that the name of a layer or dash pattern suggests.

    A line type is, for example, cut or crease.  It is None if the name suggests none, or if its
    words contradict each other.  The result also contains the part of the name that suggests the
    line type, and whether the name contains a negating word, such as "no" in "no cut".
    """
    vocabulary = _vocabulary()
    folded = name.casefold()
    for part, kind in vocabulary.substrings:
        if part in folded:
            negated = any(negation in folded for negation in vocabulary.negating_substrings)
            return NameMeaning(kind, part, negated)
    words = _split_words(name)
    found = _word_meanings(words, vocabulary)
    denied = any(word in vocabulary.negations for word in words)
    if len(found) > 1 and found.get(LineType.CUT) in vocabulary.whole_die:
        del found[LineType.CUT]
    kinds = set(found)
    if kinds == {LineType.CUT, LineType.CREASE} or kinds == {LineType.PERFORATION, LineType.CREASE}:
        return NameMeaning(LineType.COMBI, " ".join(found.values()), denied)
    if len(kinds) == 2 and LineType.CUT in kinds:
        # A partial cut is more specific than a cut.
        partial = kinds & {LineType.HALF_CUT, LineType.PERFORATION, LineType.V_GROOVE}
        kinds = partial or kinds
        found = {kind: found[kind] for kind in kinds}
    if len(kinds) != 1:
        return NameMeaning(None, " ".join(found.values()), denied)
    ((kind, word),) = found.items()
    if kind == LineType.CUT and (depth := _DEPTH.search(name)):
        return NameMeaning(LineType.HALF_CUT, f"{depth[0]} {word}", denied)
    return NameMeaning(kind, word, denied)


def _word_meanings(words: list[str], vocabulary: _Vocabulary) -> dict[LineType, str]:
    """Return the line types that the words of a name mean, each with the words that mean it.

    The keys of the dict are the line types, the values one or two words of the name.  ``words`` are
    the words of the name in lower case.
    """
    meanings = vocabulary.meanings
    found: dict[LineType, str] = {}
    skipped = -1
    for index, word in enumerate(words):
        if index == skipped:
            continue
        following = words[index + 1] if index + 1 < len(words) else ""
        pair = f"{word} {following}"
        if word in vocabulary.before_cut and LineType.CUT in meanings.get(following, ()):
            found[vocabulary.before_cut[word]] = pair
            skipped = index + 1
        elif word == "v" and following in _GROOVE_WORDS:
            found[LineType.V_GROOVE] = pair
            skipped = index + 1
        elif following and word + following in meanings:
            found.update(dict.fromkeys(meanings[word + following], pair))
            skipped = index + 1
        else:
            for kind in meanings.get(word, ()):
                if found.get(kind) in (None, *vocabulary.whole_die):
                    found[kind] = word
    return found


def is_meaningless(name: str) -> bool:
    """Return whether a layer's name has only meaningless words: ``0``, ``Layer 3``, ``Design``."""
    return all(word in _vocabulary().meaningless for word in _split_words(name))


def is_dashed_linetype(name: str) -> bool:
    """Return whether a linetype, given by its lower-case name, is dashed.

    A linetype is the dash pattern of a line in a CAD drawing.
    """
    return any(part in name for part in _vocabulary().dashed)


def is_centre_linetype(name: str) -> bool:
    """Return whether a linetype, given by its lower-case name, is the one for centre lines.

    A linetype is the dash pattern of a line in a CAD drawing.
    """
    return any(part in name for part in _vocabulary().centre_line)


def _split_words(name: str) -> list[str]:
    """Return the words of a name in lower case and without accents."""
    spaced = _CAMEL_CASE.sub(" ", name)
    decomposed = unicodedata.normalize("NFKD", spaced.casefold().translate(_LETTERS))
    bare = "".join(letter for letter in decomposed if not unicodedata.combining(letter))
    return [word for word in _SEPARATORS.split(bare.translate(_LETTERS)) if word]
