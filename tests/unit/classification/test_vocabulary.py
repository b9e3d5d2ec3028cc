"""Names with a meaning, names that only resemble them, and names without meaning."""

from __future__ import annotations

import pytest

from knifetip.model.dieline import LineType
from knifetip.vocabulary import is_meaningless, name_meaning
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
    meaning = name_meaning(name)
    assert meaning.kind == kind
    assert not meaning.denied


@pytest.mark.parametrize(
    "name", ["SCHNITTKANTEN", "SCHNITTLINIEN", "Faltmarken", "Cutout", "Rillit"]
)
def test_a_false_friend_has_no_meaning(name: str) -> None:
    assert name_meaning(name).kind is None


@pytest.mark.parametrize("name", ["NoCut", "no cut", "nicht schneiden", "не резать нож", "不切割"])
def test_a_negating_word_is_found(name: str) -> None:
    assert name_meaning(name).denied


def test_two_contradictory_words_have_no_meaning() -> None:
    assert name_meaning("cut dimensions").kind is None


@pytest.mark.parametrize("name", ["0", "", "Layer 12", "Design", "Ebene 3", "Слой_1", "DEFAULT"])
def test_these_names_are_meaningless(name: str) -> None:
    assert is_meaningless(name)


@pytest.mark.parametrize("name", ["CUT", "Kunde Meier", "die", "NoCut"])
def test_other_names_are_not_meaningless(name: str) -> None:
    assert not is_meaningless(name)


def test_a_hostile_name_has_no_meaning() -> None:
    assert name_meaning("\x00[" * 1000 + "\ud800").kind is None


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("Fustella Cordone", LineType.CREASE),
        ("filet rainant", LineType.CREASE),
        ("filet coupant", LineType.CUT),
        ("Creasing knife", LineType.CREASE),
        ("contour de pli", LineType.CREASE),
        ("contour cut crease", LineType.COMBI),
        ("PerfCutContour", LineType.PERFORATION),
        ("50 % cut", LineType.HALF_CUT),
        ("150 % cut", LineType.CUT),
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
def test_words_for_the_whole_die_and_for_partial_cuts_are_not_cuts(
    name: str, kind: LineType
) -> None:
    assert name_meaning(name).kind == kind
