"""load: files of the library, and errors of invalid files."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

import pytest

from knifetip.errors import KnifetipError, LibraryError, ProfileError
from knifetip.library import load
from knifetip.model.board import Deflection
from knifetip.model.dieline import LineType
from knifetip.model.profile import LineRule, LineRules
from knifetip.model.tool import CreaseWheel, Cutter, Knife, VCutter, kind_of

BOARD = """
title = "A board"
material = "greyboard"
caliper = 2.0
grain = 90.0
crease_along = 0.6
crease_across = 0.65
end_clearance = 0.2
groove_depth = 1.3
groove_overcut = 3.0
half_cut_depth = 1.0
perforation = [3.0, 2.0]
short_crease = "press"
"""

MACHINE = """
title = "A table"
width = 1300.0
height = 900.0
dialect = "grblhal"
origin = [20.0, 20.0]
travel_z = 20.0
clearance = 2.0
into_mat = 0.3
settle = 0.15

[axes]
x = { low = 0.0, high = 1400.0, velocity = 1500.0, acceleration = 8000.0 }
y = { low = 0.0, high = 1000.0, velocity = 1500.0, acceleration = 8000.0 }
z = { low = -10.0, high = 60.0, velocity = 500.0, acceleration = 5000.0 }
c = { low = -720.0, high = 720.0, velocity = 3600.0, acceleration = 36000.0 }

[[station]]
number = 3
name = "V-cutter"
datum = { x = -60.0, y = 0.0, z = 0.0, c = 90.0 }
[station.tool]
kind = "v-cutter"
back = 6.0
half_width = 1.5
tilt = 45.0
"""

PROFILE = """
title = "Ours"

[[rule]]
type = "cut"
layer = ["KNIFE", "OUT*"]
colour = [1, 7]

[[rule]]
type = "V-groove"
layer = "RIEFE"
"""


class Put(Protocol):
    """A function that writes a text to a file and returns the path."""

    def __call__(self, text: str, name: str = ...) -> str:
        """Write ``text`` to a file of this name."""
        ...


@pytest.fixture
def put(tmp_path: Path) -> Put:
    def written(text: str, name: str = "own.toml") -> str:
        path = tmp_path / name
        path.write_text(text, "utf-8")
        return str(path)

    return written


@pytest.mark.parametrize("name", load.names("machines"))
def test_every_machine_of_the_library_is_valid(name: str) -> None:
    assert load.machine(name).name == name
    assert load.machine(name).stations


@pytest.mark.parametrize("name", load.names("boards"))
def test_every_board_of_the_library_is_valid(name: str) -> None:
    assert load.board(name).name == name
    assert 0.0 < load.board(name).groove_depth < load.board(name).caliper


@pytest.mark.parametrize("name", load.names("profiles"))
def test_every_profile_of_the_library_is_valid(name: str) -> None:
    assert load.profile(name).name == name
    assert load.profile(name).rules


def test_the_library_contains_the_files_of_the_first_release() -> None:
    assert "demo-table" in load.names("machines")
    assert {
        "greyboard-1.5",
        "greyboard-2.0",
        "greyboard-3.0",
        "e-flute",
        "b-flute",
        "fbb-0.4",
    } <= (set(load.names("boards")))
    assert "default" in load.names("profiles")


def test_a_custom_board_is_named_after_its_file(put: Put) -> None:
    board = load.board(put(BOARD, "custom.toml"))
    assert (board.name, board.caliper, board.perforation) == ("custom", 2.0, (3.0, 2.0))


def test_a_custom_machine_has_the_values_of_its_file(put: Put) -> None:
    machine = load.machine(put(MACHINE))
    (station,) = machine.stations
    assert station.tool == VCutter(6.0, 1.5, 45.0)
    assert (station.number, station.x, station.c, station.output) == (
        3,
        -60.0,
        90.0,
        -1,
    )
    assert (machine.x.high, machine.origin) == (1400.0, (20.0, 20.0))


def test_a_machine_is_fed_by_hand_by_default(put: Put) -> None:
    assert load.machine(put(MACHINE)).feed == "manual"
    own = MACHINE.replace("into_mat = 0.3", 'into_mat = 0.3\nfeed = "automatic"')
    assert own != MACHINE
    assert load.machine(put(own)).feed == "automatic"
    assert {load.machine(name).feed for name in load.names("machines")} == {"manual"}


def test_a_custom_profile_keeps_the_order_of_its_rules(put: Put) -> None:
    first, second = load.profile(put(PROFILE)).rules
    assert (first.line_type, first.layer, first.colour) == (
        LineType.CUT,
        ("KNIFE", "OUT*"),
        (1, 7),
    )
    assert (second.line_type, second.layer) == (LineType.V_GROOVE, ("RIEFE",))


def test_a_profile_that_extends_another_has_its_rules_first(put: Put) -> None:
    own = load.profile(put('extends = "default"\n' + PROFILE))
    assert own.rules[:-2] == load.profile("default").rules
    assert own.rules[-1].layer == ("RIEFE",)


@pytest.mark.parametrize(
    ("tool", "word"),
    [
        (Knife(10.0, 3.0, 15.0, 1.0, 1.0), "knife"),
        (CreaseWheel(15.0, 0.7, 1.0, 1.0), "crease-wheel"),
        (VCutter(6.0, 1.5, 45.0), "v-cutter"),
        (Cutter(3.0, 1.0, 1.0), "cutter"),
    ],
)
def test_each_tool_has_a_kind_name(tool: Knife | CreaseWheel | VCutter | Cutter, word: str) -> None:
    assert kind_of(tool).name == word


# ── Invalid files ─────────────────────────────────────────────────────────────────────────────────


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("caliper = 2.0\n", "", "caliper is missing"),
        ('title = "A board"\n', "", "title is missing"),
        ("caliper = 2.0", 'caliper = "thick"', "caliper is 'thick', but must be a number"),
        ("caliper = 2.0", "caliper = true", "caliper is true, but must be a number"),
        ("caliper = 2.0", "caliper = nan", "caliper is nan, but must be a number"),
        ("caliper = 2.0", "caliper = inf", "caliper is inf, but must be a number"),
        ("caliper = 2.0", "caliper = 0", "caliper is 0, but must be greater than 0"),
        ("caliper = 2.0", "caliper = -2.0", "caliper is -2.0, but must be greater than 0"),
        (
            "groove_depth = 1.3",
            "groove_depth = 2.5",
            "groove_depth is 2.5 mm, but must be less than",
        ),
        (
            "end_clearance = 0.2",
            "end_clearance = -1",
            "end_clearance is -1, but must be at least",
        ),
        ("[3.0, 2.0]", "[3.0]", "perforation has 1 value, but needs at least 2"),
        ("[3.0, 2.0]", "3.0", "perforation is 3.0, but must be a list"),
        ("[3.0, 2.0]", "[3.0, nan]", "perforation 2 is nan"),
        ('"press"', '"maybe"', "short_crease is 'maybe', but must be 'press' or 'refuse'"),
        ("caliper = 2.0", "caliper = = 2", "Invalid value"),
    ],
)
def test_the_fault_of_an_invalid_board_is_reported(
    put: Put, old: str, new: str, expected: str
) -> None:
    assert old in BOARD
    with pytest.raises(LibraryError, match=r"cannot be (read|used)") as caught:
        load.board(put(BOARD.replace(old, new)))
    assert expected in caught.value.text
    assert caught.value.hint


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            '"v-cutter"',
            '"axe"',
            "station 1 → tool has the unknown kind 'axe'; known kinds are 'knife', 'crease",
        ),
        (
            'kind = "v-cutter"\n',
            "",
            "station 1 → tool does not state its kind: the field 'kind' is missing",
        ),
        ("tilt = 45.0", "tilt = 90.0", "station 1 → tool → tilt is 90.0, but must be less than 90"),
        ("tilt = 45.0", "tilt = nan", "tilt is nan, but must be a number"),
        ("tilt = 45.0", "", "tilt is missing"),
        ("back = 6.0", "back = 0.0", "back is 0.0, but must be greater than 0"),
        ("back = 6.0", "", "back"),
        (
            "back = 6.0",
            "back = 6.0\nlength = 9.0",
            "station 1 → tool → length is not a known field",
        ),
        (
            "number = 3",
            "number = 0",
            "station 1 → number is 0, but must be greater than 0",
        ),
        ("number = 3", "number = 1.5", "number is 1.5, but must be a whole number"),
        ("number = 3", 'number = "three"', "number is 'three', but must be a whole number"),
        ("width = 1300.0", "width = inf", "width is inf"),
        ("origin = [20.0, 20.0]", "origin = 20.0", "origin is 20.0, but must be a list"),
        (
            "high = 1400.0",
            "high = -1.0",
            "axes → x → high is -1, but must be greater than the value "
            "of the field low, which is 0",
        ),
        (
            "velocity = 500.0",
            "velocity = 0.0",
            "axes → z → velocity is 0.0, but must be greater than 0",
        ),
        ("x = { low", "u = { low", "axes → x is missing"),
        (
            "into_mat = 0.3",
            "into_mat = -0.3",
            "into_mat is -0.3, but must be at least 0",
        ),
        (
            "into_mat = 0.3",
            'into_mat = 0.3\nfeed = "robot"',
            "feed is 'robot', but must be 'manual' or 'automatic'",
        ),
        ("into_mat = 0.3", "into_mat = 0.3\nfeed = [1]", "feed is [1]"),
        ("[[station]]", "[station]", ""),
        ("datum = {", "datum = 5 # {", ""),
    ],
)
def test_the_fault_of_an_invalid_machine_is_reported(
    put: Put, old: str, new: str, expected: str
) -> None:
    assert old in MACHINE
    with pytest.raises(LibraryError, match=r"cannot be (read|used)") as caught:
        load.machine(put(MACHINE.replace(old, new)))
    assert expected in caught.value.text


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("travel_z =", "travelz =", "travelz is not a known field; perhaps travel_z is meant"),
        (
            "tilt = 45.0",
            "tilt = 45.0\ntill = 3.0",
            "tool → till is not a known field; perhaps tilt is meant",
        ),
        ("into_mat = 0.3", "into_mat = 0.3\nzebra = 1", "zebra is not a known field."),
    ],
)
def test_a_misspelt_field_is_refused_with_the_nearest_name(
    put: Put, old: str, new: str, expected: str
) -> None:
    with pytest.raises(LibraryError, match="is not a known field") as caught:
        load.machine(put(MACHINE.replace(old, new)))
    assert expected in caught.value.text


def test_an_error_names_the_file_and_the_path_of_its_field(put: Put) -> None:
    file = put(MACHINE.replace("tilt = 45.0", "tilt = 95.0"))
    with pytest.raises(LibraryError) as caught:
        load.machine(file)
    assert repr(file) in caught.value.text
    assert caught.value.source == ("station 1", "tool", "tilt")


def test_a_machine_with_an_unknown_language_is_refused(put: Put) -> None:
    with pytest.raises(LibraryError, match=r"dialect is fanuc, but must be .*grblhal"):
        load.machine(put(re.sub('dialect = ".*"', 'dialect = "fanuc"', MACHINE)))


def test_two_stations_with_one_number_are_refused(put: Put) -> None:
    station = MACHINE[MACHINE.index("[[station]]") :]
    with pytest.raises(LibraryError, match=r"station has the numbers 3, 3"):
        load.machine(put(MACHINE + station))


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('title = "Ours"', "", "title is missing"),
        ('type = "cut"', "", "rule 1 → type is missing"),
        (
            'type = "cut"',
            'type = "burn"',
            "type is 'burn', but must be a line type: unclassified, cut",
        ),
        (
            'layer = "RIEFE"',
            'laser = "RIEFE"',
            "rule 2 → laser is not a known field",
        ),
        ('layer = "RIEFE"', "layer = 20", "rule 2 → layer 1 is 20, but must be text"),
        (
            "colour = [1, 7]",
            'colour = "red"',
            "rule 1 → colour 1 is 'red', but must be a whole number",
        ),
        (
            "colour = [1, 7]",
            "colour = [1.5]",
            "rule 1 → colour 1 is 1.5, but must be a whole number",
        ),
        (
            "colour = [1, 7]",
            "colour = true",
            "rule 1 → colour 1 is True, but must be a whole number",
        ),
        (
            "colour = [1, 7]",
            "colour = 256",
            "rule 1 → colour 1 is 256, but must be a whole number from 1 to 255",
        ),
        (
            "colour = [1, 7]",
            "colour = nan",
            "rule 1 → colour 1 is nan, but must be a whole number",
        ),
        (
            'title = "Ours"',
            'title = "Ours"\nextends = "mine"',
            "extends is 'mine', but must be a profile of the library",
        ),
        (
            'title = "Ours"',
            'title = "Ours"\nextends = 3',
            "extends is 3, but must be text",
        ),
    ],
)
def test_the_fault_of_an_invalid_profile_is_reported(
    put: Put, old: str, new: str, expected: str
) -> None:
    assert old in PROFILE
    with pytest.raises(ProfileError, match=r"cannot be used|extends") as caught:
        load.profile(put(PROFILE.replace(old, new)))
    assert expected in caught.value.text


@pytest.mark.parametrize(
    "text",
    [
        'title = "No rules"',
        'title = "Not tables"\nrule = ["cut", "crease"]',
        'title = "A number"\nrule = 7',
        "",
        "\x00",
        'title = "Deep"\nrule = ' + "[" * 5000 + "]" * 5000,
    ],
    ids=["no rules", "not tables", "a number", "empty", "not text", "deep"],
)
def test_a_profile_without_rules_is_refused(put: Put, text: str) -> None:
    with pytest.raises(ProfileError):
        load.profile(put(text))


def test_a_file_that_is_not_utf8_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "latin.toml"
    path.write_bytes(b'title = "Rillen f\xfcr die Wellpappe"')
    with pytest.raises(ProfileError, match=r"cannot be (read|used)"):
        load.profile(str(path))


@pytest.mark.parametrize("shelf", [load.machine, load.board, load.profile])
@pytest.mark.parametrize(
    "name",
    ["", "nope", "../boards/e-flute", "nowhere.toml", "x" * 5000 + ".toml", "\0.toml"],
)
def test_an_unknown_name_raises_an_error_with_a_hint(shelf: Callable[..., Any], name: str) -> None:
    with pytest.raises(KnifetipError) as caught:
        shelf(name)
    assert caught.value.hint


CUTTER = """kind = "cutter"
radius = 3.0
speed = 18000.0
feed = 9000.0
plunge = 1500.0
"""


def routed(text: str) -> str:
    return MACHINE[: MACHINE.index('kind = "v-cutter"')] + text


def test_a_router_has_a_default_lead_of_one_and_a_half_radii(put: Put) -> None:
    (station,) = load.machine(put(routed(CUTTER))).stations
    assert station.tool == Cutter(3.0, 9000.0, 1500.0, speed=18000.0)
    assert station.tool.lead_in == 4.5


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("speed = -1.0", "speed is -1.0, but must be at least 0"),
        ("lead = 3.0", "the lead-in of 3 mm must be 0 or greater than the tool radius of 3 mm"),
        ("lead = 5.0\napproach = 30.0", "the angle must be between 36.9° and 90°, or negative"),
        ("lead = 5.0\napproach = 0.0", "the angle must be between 36.9° and 90°, or negative"),
        ("step = nan", "step is nan, but must be a number"),
        ("dwell = -0.1", "dwell is -0.1, but must be at least 0"),
        ("teeth = 2", "tool → teeth is not a known field"),
    ],
)
def test_the_fault_of_an_invalid_router_is_reported(put: Put, line: str, expected: str) -> None:
    text = CUTTER.replace("speed = 18000.0\n", "") + line + "\n"
    with pytest.raises(LibraryError, match=r"cannot be (read|used)") as caught:
        load.machine(put(routed(text)))
    assert expected in caught.value.text


def test_a_board_has_the_deflection_of_each_tool(put: Put) -> None:
    given = '\n[deflection.Router]\nx = 0.08\ny = 0.05\n[deflection."Router 6"]\nx = 0.1\ny = 0\n'
    board = load.board(put(BOARD + given))
    assert board.deflection == (Deflection("Router", 0.08, 0.05), Deflection("Router 6", 0.1, 0.0))
    assert load.board(put(BOARD, "bare.toml")).deflection == ()


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("[deflection.Router]\nx = 0.08", "deflection → Router → y is missing"),
        (
            "[deflection.Router]\nx = -0.08\ny = 0.0",
            "deflection → Router → x is -0.08, but must be",
        ),
        ("[deflection]\nRouter = 3", "deflection → Router is 3, but must be a table"),
    ],
)
def test_the_fault_of_an_invalid_deflection_is_reported(
    put: Put, given: str, expected: str
) -> None:
    with pytest.raises(LibraryError) as caught:
        load.board(put(BOARD + "\n" + given + "\n"))
    assert expected in caught.value.text


# ── Profiles that are written and read again ──────────────────────────────────────────────────────


def test_a_colour_may_be_a_true_colour_and_a_block_a_condition(put: Put) -> None:
    text = PROFILE + '[[rule]]\ntype = "crease"\ncolour = [5, "#00AEEF"]\nblock = "LID*"\n'
    rule = load.profile(put(text)).rules[-1]
    assert (rule.colour, rule.true_colour, rule.block) == ((5,), (0x00AEEF,), ("LID*",))
    assert str(rule.conditions) == 'colour 5 or #00aeef, inside the block "LID*"'


@pytest.mark.parametrize("colour", ['"#00AEE"', '"red"', '["#gggggg"]', '[1, "#12345"]'])
def test_an_invalid_true_colour_is_refused(put: Put, colour: str) -> None:
    with pytest.raises(ProfileError, match="rule 3 → colour"):
        load.profile(put(PROFILE + f'[[rule]]\ntype = "cut"\ncolour = {colour}\n'))


def test_a_profile_that_overrules_has_inherited_rules_last(put: Put) -> None:
    own = load.profile(put('extends = "default"\noverrules = true\n' + PROFILE))
    assert own.rules[2:] == load.profile("default").rules
    assert own.rules[1].layer == ("RIEFE",)
    with pytest.raises(ProfileError, match="overrules is 1"):
        load.profile(put('extends = "default"\noverrules = 1\n' + PROFILE))


@pytest.mark.parametrize("name", load.names("profiles"))
def test_every_profile_of_the_library_is_equal_after_writing_and_reading(name: str) -> None:
    rules = load.profile(name)
    again = load.parse_profile(name, tomllib.loads(load.profile_toml(rules)))
    assert again == rules


def test_inherited_rules_are_not_written() -> None:
    default = load.profile("default")
    mine = LineRule(LineType.CREASE, layer=('say "x" \\ \x7f ü',), true_colour=(0x0A0B0C,))
    for rules in ((mine, *default.rules), (*default.rules, mine)):
        own = LineRules("own", "Ours", rules)
        text = load.profile_toml(own, "default")
        assert text.count("[[rule]]") == 1
        assert load.parse_profile("own", tomllib.loads(text)) == own
    with pytest.raises(ProfileError, match="cannot be saved as an extension of"):
        load.profile_toml(LineRules("own", "", (mine,)), "default")


def test_a_profile_without_rules_of_its_own_can_be_written() -> None:
    own = LineRules("own", "Ours", ())
    assert load.parse_profile("own", tomllib.loads(load.profile_toml(own))) == own


def test_a_name_with_a_lone_surrogate_is_written_as_a_matching_pattern() -> None:
    text = load.profile_toml(LineRules("own", "", (LineRule(LineType.CUT, layer=("a\udcffb",)),)))
    assert tomllib.loads(text)["rule"][0]["layer"] == ["a?b"]


def test_names_from_the_network_open_no_file(put: Put) -> None:
    path = put(PROFILE)
    assert load.profile(path).rules
    for shelf in (load.profile, load.machine, load.board):
        with pytest.raises(LibraryError, match="does not exist"):
            shelf(path, files=False)


def test_a_changed_file_is_read_again(put: Put) -> None:
    assert load.profile(put(PROFILE)).title == "Ours"
    assert load.profile(put(PROFILE.replace("Ours", "Mine"))).title == "Mine"
    assert load.profile("default") is load.profile("default")


def test_conventions_are_the_rules_that_the_default_profile_lacks() -> None:
    found = {one.name: one.rules for one in load.conventions()}
    assert "default" not in found
    assert found["lightburn"] == load.profile("lightburn").rules[-2:]
    assert not any(set(rules) & set(load.profile("default").rules) for rules in found.values())
