"""words: names that say what they are, names that only seem to, and names that say nothing."""

from __future__ import annotations

import pytest

from knifetip.classification.vocabulary import is_meaningless, name_meaning
from knifetip.model.dieline import LineType
from tests.support.cartons.random_drawings import LANGUAGES

KINDS = (
    LineType.CUT,
    LineType.CREASE,
    LineType.PERFORATION,
    LineType.HALF_CUT,
    LineType.V_GROOVE,
    LineType.IGNORED,
)


@pytest.mark.parametrize("language", LANGUAGES)
def test_names_are_understood_in_this_language(language: str) -> None:
    assert [name_meaning(name).kind for name in LANGUAGES[language]] == list(KINDS)


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("my fold lines", LineType.CREASE),
        ("outline of tray", LineType.CUT),
        ("DieCut_outer", LineType.CUT),
        ("cutLines", LineType.CUT),
        ("Kiss-Cut 2", LineType.HALF_CUT),
        ("v cut 45°", LineType.V_GROOVE),
        ("Coupe mi-chair", LineType.HALF_CUT),
        ("cut + crease", LineType.COMBI),
        ("BIÇAK", LineType.CUT),
        ("ПЕРФОРАЦИЯ", LineType.PERFORATION),
        ("压痕线_2", LineType.CREASE),
        ("GEOMETRY-ENGRAVING", LineType.IGNORED),
    ],
)
def test_words_inside_a_name_are_found(name: str, kind: LineType) -> None:
    said = name_meaning(name)
    assert said.kind == kind
    assert not said.denied


@pytest.mark.parametrize(
    "name", ["SCHNITTKANTEN", "SCHNITTLINIEN", "Faltmarken", "Cutout", "Rillit"]
)
def test_a_false_friend_is_not_the_word_that_it_looks_like(name: str) -> None:
    assert name_meaning(name).kind is None


@pytest.mark.parametrize("name", ["NoCut", "no cut", "nicht schneiden", "не резать нож", "不切割"])
def test_a_word_that_denies_is_heard(name: str) -> None:
    assert name_meaning(name).denied


def test_two_meanings_are_none() -> None:
    assert name_meaning("cut dimensions").kind is None


@pytest.mark.parametrize("name", ["0", "", "Layer 12", "Design", "Ebene 3", "Слой_1", "DEFAULT"])
def test_names_that_say_nothing_are_known(name: str) -> None:
    assert is_meaningless(name)


@pytest.mark.parametrize("name", ["CUT", "Kunde Meier", "die", "NoCut"])
def test_other_names_say_something(name: str) -> None:
    assert not is_meaningless(name)


def test_a_hostile_name_is_only_a_name() -> None:
    assert name_meaning("\x00[" * 1000 + "\ud800").kind is None


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("Fustella Cordone", LineType.CREASE),
        ("Fustella Taglio", LineType.CUT),
        ("CUT-CREASE", LineType.COMBI),
        ("Mi-coupe", LineType.HALF_CUT),
        ("ハーフカット", LineType.HALF_CUT),
        ("半抜き", LineType.HALF_CUT),
        ("نصف قص", LineType.HALF_CUT),
        ("Đường cấn", LineType.CREASE),
        ("Đường cắt", LineType.CUT),
        ("Διαστάσεις", LineType.IGNORED),
        ("BEND_EXTENT", LineType.IGNORED),
        ("OUTER_PROFILES", LineType.CUT),
        ("CRE", LineType.CREASE),
    ],
)
def test_a_word_for_the_whole_die_or_half_of_it_is_not_the_cut(name: str, kind: LineType) -> None:
    assert name_meaning(name).kind == kind
