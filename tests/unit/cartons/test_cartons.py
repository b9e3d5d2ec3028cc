"""Carton styles: their geometry, measured with shapely and folded with matrices of the tests."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from knifetip.cartons.carton import Carton
from knifetip.cartons.parameters import CartonSize
from knifetip.cartons.registry import STYLES, style_of
from knifetip.errors import ImpossibleCarton, LibraryError
from knifetip.library import load
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from tests.benchmarks.carton_sheet import SHEET, svg_text
from tests.support.cartons.carton_sizes import SIZES, sized
from tests.support.cartons.folded_panels import Folded, faces_of, fold

CASES = [
    pytest.param(code, size, board, id=f"{code} {size} {board}")
    for code, sizes in SIZES.items()
    for size in sizes.dimensions
    for board in sizes.boards
]


def drawn(code: str, dimensions: tuple[float, float, float], board: str, **options: Any) -> Carton:
    style = style_of(code)
    return style.draw(sized(code, dimensions, **options), load.board(board))


def polygon(carton: Carton) -> shapely.Polygon:
    return shapely.Polygon(carton.outline.start)


@pytest.mark.parametrize(("code", "size", "board"), CASES)
def test_a_blank_is_one_area_of_which_each_part_is_a_panel(
    code: str, size: tuple[float, float, float], board: str
) -> None:
    carton = drawn(code, size, board)
    blank = polygon(carton)
    assert blank.is_valid
    assert carton.outline.closed.tolist() == [True]
    faces = faces_of(carton)
    holes = [path for path in carton.cuts if path.closed.all()]
    assert len(faces) == len(carton.panels) + len(holes)
    assert sum(face.area for face in faces) == pytest.approx(blank.area, abs=1e-3)
    for panel in carton.panels:
        inside = [face for face in faces if face.contains(shapely.Point(panel.point))]
        assert len(inside) == 1, panel
        assert inside[0].exterior.distance(shapely.Point(panel.point)) > 0.1, panel
    edges = carton.edges()
    lines = shapely.linestrings(edges.ends)
    # Nothing is drawn outside the blank, and no two lines lie on each other.
    assert shapely.union_all(lines).length == pytest.approx(shapely.length(lines).sum(), abs=1e-3)
    assert blank.buffer(1e-3).covers(shapely.multilinestrings(list(edges.ends)))


@pytest.mark.parametrize(("code", "size", "board"), CASES)
def test_each_panel_but_the_first_turns_around_folds_of_one_other(
    code: str, size: tuple[float, float, float], board: str
) -> None:
    carton = drawn(code, size, board)
    names = [panel.name for panel in carton.panels]
    assert len(set(names)) == len(names)
    bases: dict[str, set[str]] = {}
    for one in carton.folds:
        bases.setdefault(one.panel, set()).add(one.base)
        assert one.angle in (-90.0, 0.0, 90.0)
    assert list(bases) == names[1:]
    for name, found in bases.items():
        (base,) = found
        assert names.index(base) < names.index(name)


def inner(folded: Folded, axis: int, panels: tuple[str, str]) -> float:
    """Return the distance of two parallel panels along an axis (mm)."""
    first, second = (folded.corners(name)[:, axis] for name in panels)
    assert np.ptp(first) == pytest.approx(0.0, abs=1e-6)
    assert np.ptp(second) == pytest.approx(0.0, abs=1e-6)
    return abs(float(first[0] - second[0]))


TUBES = ("fefco-0200", "fefco-0201", "fefco-0203", "fefco-0215", "ecma-a20.20", "ecma-a60.20")


@pytest.mark.parametrize(
    ("code", "size", "board"), [case for case in CASES if case.values[0] in TUBES]
)
def test_a_tube_has_its_inner_dimensions_and_closes_at_the_joint(
    code: str, size: tuple[float, float, float], board: str
) -> None:
    t = load.board(board).caliper
    folded = fold(drawn(code, size, board))
    # The middles of two boards are one caliper farther apart than their inner faces.
    assert inner(folded, 2, ("back", "front")) - t == pytest.approx(size[1])
    assert inner(folded, 0, ("left", "right")) - t == pytest.approx(size[0])
    joint, flap = folded.corners("right"), folded.corners("glue-flap")
    assert 0.0 < joint[:, 2].min() <= max(0.5 * t, 0.3) + 1e-9
    # The glue flap is narrower than the panel to which it is glued, and lies in its plane.
    assert np.ptp(flap[:, 2]) < np.ptp(joint[:, 2])
    assert np.ptp(flap[:, 0]) == pytest.approx(0.0, abs=1e-6)
    assert flap[0, 0] == pytest.approx(joint[0, 0])
    height = np.ptp(folded.corners("left")[:, 1])
    assert size[2] + t <= height + 1e-9 <= size[2] + 3.0 * t + 1e-6


@pytest.mark.parametrize("board", SIZES["fefco-0201"].boards)
@pytest.mark.parametrize("gap", [0.0, 4.0])
@pytest.mark.parametrize("code", ["fefco-0200", "fefco-0201"])
def test_outer_flaps_meet_in_the_middle(code: str, gap: float, board: str) -> None:
    folded = fold(drawn(code, (300.0, 200.0, 150.0), board, gap=gap))
    ends = ("bottom",) if code == "fefco-0200" else ("bottom", "top")
    for end in ends:
        back, front = (folded.corners(f"{end}-{name}")[:, 2] for name in ("back", "front"))
        assert front.min() - back.max() == pytest.approx(gap)
        left, right = (folded.corners(f"{end}-{name}")[:, 0] for name in ("left", "right"))
        assert left.min() >= right.max()
    assert ("top-back" in folded.faces) == (code == "fefco-0201")


@pytest.mark.parametrize("board", SIZES["fefco-0203"].boards)
@pytest.mark.parametrize("size", SIZES["fefco-0203"].dimensions)
def test_outer_flaps_overlap_fully_and_inner_flaps_do_not(
    size: tuple[float, float, float], board: str
) -> None:
    t = load.board(board).caliper
    folded = fold(drawn("fefco-0203", size, board))
    for end in ("bottom", "top"):
        back, front = (folded.corners(f"{end}-{name}")[:, 2] for name in ("back", "front"))
        overlap = back.max() - front.min()
        assert size[1] - 2.0 * max(0.25 * t, 0.5) <= overlap <= size[1] + t
        left, right = (folded.corners(f"{end}-{name}")[:, 0] for name in ("left", "right"))
        assert left.min() >= right.max() - 1e-9


@pytest.mark.parametrize("board", SIZES["fefco-0201"].boards)
def test_slots_are_as_wide_as_the_board_and_a_millimetre(board: str) -> None:
    t = load.board(board).caliper
    carton = drawn("fefco-0201", (300.0, 200.0, 150.0), board)
    flaps = [panel for panel in carton.panels if panel.name.startswith("top-")]
    flaps.sort(key=lambda panel: panel.box[0])
    for one, other in pairwise(flaps):
        assert other.box[0] - one.box[2] == pytest.approx(t + 1.0)


@pytest.mark.parametrize("lids", ["reverse", "straight"])
@pytest.mark.parametrize("board", SIZES["ecma-a20.20"].boards)
@pytest.mark.parametrize("size", SIZES["ecma-a20.20"].dimensions)
def test_tuck_lids_close_on_dust_flaps_and_tuck_inside(
    size: tuple[float, float, float], board: str, lids: str
) -> None:
    t = load.board(board).caliper
    folded = fold(drawn("ecma-a20.20", size, board, lids=lids))
    for end, way in (("top", 1.0), ("bottom", -1.0)):
        lid, dust = folded.corners(f"{end}-lid"), folded.corners(f"{end}-dust-left")
        # The lid lies on the dust flaps.
        assert way * (lid[0, 1] - dust[0, 1]) == pytest.approx(t)
        other = folded.corners(f"{end}-dust-right")
        assert dust[:, 0].min() > other[:, 0].max()
        hinge = "front" if end == "bottom" and lids == "reverse" else "back"
        wall = folded.corners("back" if hinge == "front" else "front")[0, 2]
        tuck = folded.corners(f"{end}-tuck")
        # The middle of the tuck flap is a caliper inside the middle of the panel.
        assert abs(tuck[0, 2] - wall) == pytest.approx(t)
        assert np.ptp(tuck[:, 0]) < size[0]
        # Dust flaps leave room for the tuck flap.
        room = [abs(corners[:, 2] - wall).min() for corners in (dust, other)]
        assert min(room) > 1.5 * t


@pytest.mark.parametrize("code", ["ecma-a60.20", "fefco-0215"])
def test_locking_bottoms_cover_the_base_and_hook_into_each_other(code: str) -> None:
    sizes = SIZES[code]
    for size in sizes.dimensions:
        for board in sizes.boards:
            folded = fold(drawn(code, size, board))
            flaps = {
                name: shapely.Polygon(folded.corners(name)[:, [0, 2]])
                for name in folded.faces
                if name.startswith("bottom-")
            }
            x = folded.corners("back")[:, 0].min()
            t = load.board(board).caliper
            base = shapely.box(x + 0.5 * t, 0.5 * t, x + 0.5 * t + size[0], 0.5 * t + size[1])
            assert base.intersection(shapely.union_all(list(flaps.values()))).area > 0.9 * base.area
            # Each large flap extends over the middle, where it lies on the other one.
            middle = 0.5 * (size[1] + t)
            assert flaps["bottom-back"].bounds[3] > middle
            assert flaps["bottom-front"].bounds[1] < middle
            assert flaps["bottom-back"].intersection(flaps["bottom-front"]).area > 0.0


def test_the_triangles_of_a_crash_lock_bottom_lie_on_the_flap_to_which_they_are_glued() -> None:
    for size in SIZES["ecma-a60.20"].dimensions:
        folded = fold(drawn("ecma-a60.20", size, "fbb-0.5"))
        for tab, flap in (("left", "back"), ("right", "front")):
            triangle, large = (
                shapely.Polygon(folded.corners(name)[:, [0, 2]])
                for name in (f"bottom-glue-{tab}", f"bottom-{flap}")
            )
            assert triangle.intersection(large).area > 0.75 * triangle.area
            # Where it hangs on the small flap, a fold by 45° keeps both distances from the corner.
            start, end = next(
                (one.start, one.end)
                for one in drawn("ecma-a60.20", size, "fbb-0.5").folds
                if one.panel == f"bottom-glue-{tab}"
            )
            assert abs(end[0] - start[0]) == pytest.approx(abs(end[1] - start[1]))


@pytest.mark.parametrize("code", ["fefco-0427", "fefco-0471"])
@pytest.mark.parametrize("board", SIZES["fefco-0427"].boards)
@pytest.mark.parametrize("size", SIZES["fefco-0427"].dimensions)
def test_a_mailer_closes_flush_with_its_double_walls(
    code: str, board: str, size: tuple[float, float, float]
) -> None:
    t = load.board(board).caliper
    carton = drawn(code, size, board)
    folded = fold(carton)
    floor = t if code == "fefco-0471" else 0.0
    assert inner(folded, 0, ("inner-left", "inner-right")) - t == pytest.approx(size[0])
    assert inner(folded, 1, ("front", "back")) - t == pytest.approx(size[1])
    assert inner(folded, 2, ("base", "lid")) - t - floor == pytest.approx(size[2])
    for side in ("left", "right"):
        walls = [
            abs(float(folded.corners(name)[0, 0]))
            for name in (f"inner-{side}", f"front-{side}", f"back-{side}", f"outer-{side}")
        ]
        # Outer wall, ear and inner wall lie on each other.
        assert walls == pytest.approx([walls[0], walls[0] + t, walls[0] + t, walls[0] + 2.0 * t])
        assert folded.corners(f"rim-{side}")[0, 2] == pytest.approx(folded.corners("lid")[0, 2])
        # The flaps of the lid are between the walls, and end above the base.
        flap = folded.corners(f"lid-{side}")
        assert t < walls[0] - abs(float(flap[0, 0])) <= t + max(0.25 * t, 0.5) + 1e-9
        assert flap[:, 2].min() > 0.5 * t + floor
        ears = [folded.corners(f"{one}-{side}")[:, 1] for one in ("front", "back")]
        assert ears[0].max() < ears[1].min()
    assert abs(folded.corners("tuck")[0, 1] - folded.corners("front")[0, 1]) >= t
    if code == "fefco-0471":
        left, right = (folded.corners(f"floor-{side}") for side in ("left", "right"))
        assert left[0, 2] == pytest.approx(t)
        assert 0.0 < right[:, 0].min() - left[:, 0].max() <= max(0.25 * t, 0.5) + 1e-9
        return
    # The tab goes through the slot of the base, which has its width from the board.
    slots = [shapely.Polygon(path.start) for path in carton.cuts]
    assert [slot.bounds[2] - slot.bounds[0] for slot in slots] == pytest.approx([t + 0.5] * 2)
    for side, slot in zip(("left", "right"), slots, strict=True):
        corners = folded.corners(f"inner-{side}")
        tab = corners[corners[:, 2] < 0.0]
        assert len(tab)
        assert all(slot.contains(shapely.Point(x, y)) for x, y, _ in tab)


@pytest.mark.parametrize("board", SIZES["rigid-box"].boards)
@pytest.mark.parametrize("size", SIZES["rigid-box"].dimensions)
def test_a_rigid_box_has_its_inner_dimensions_and_walls_that_do_not_collide(
    size: tuple[float, float, float], board: str
) -> None:
    stock = load.board(board)
    carton = drawn("rigid-box", size, board)
    folded = fold(carton)
    # A wall turns around the middle of the web that the groove leaves.
    face = stock.caliper - 0.5 * (stock.caliper - stock.groove_depth)
    assert inner(folded, 0, ("left", "right")) - 2.0 * face == pytest.approx(size[0])
    assert inner(folded, 1, ("front", "back")) - 2.0 * face == pytest.approx(size[1])
    assert np.ptp(folded.corners("left")[:, 2]) - face == pytest.approx(size[2])
    short, long = folded.corners("left"), folded.corners("back")
    assert 0.0 < long[0, 1] - face - short[:, 1].max() <= 0.2
    assert {one.line_type for one in carton.folds} == {LineType.V_GROOVE}


@pytest.mark.parametrize("code", ["rigid-box", "telescope-tray"])
def test_a_lid_fits_over_its_base(code: str) -> None:
    for size in SIZES[code].dimensions:
        for board in SIZES[code].boards:
            t = load.board(board).caliper
            base, lid = (fold(drawn(code, size, board, part=part)) for part in ("base", "lid"))
            for axis, pair in ((0, ("left", "right")), (1, ("front", "back"))):
                # Half a board on either side, and the play between both.
                room = inner(lid, axis, pair) - inner(base, axis, pair) - 2.0 * t
                layers = 2.0 * t if code == "telescope-tray" and axis == 0 else 0.0
                assert 0.5 <= room - layers <= 2.0 * max(0.25 * t, 0.5) + t


def test_corner_flaps_of_a_telescope_tray_lie_on_the_walls() -> None:
    for size in SIZES["telescope-tray"].dimensions:
        for board in SIZES["telescope-tray"].boards:
            t = load.board(board).caliper
            folded = fold(drawn("telescope-tray", size, board))
            assert inner(folded, 1, ("front", "back")) - t == pytest.approx(size[1])
            assert inner(folded, 0, ("left", "right")) - 3.0 * t == pytest.approx(size[0])
            for side in ("left", "right"):
                wall = abs(float(folded.corners(side)[0, 0]))
                for end in ("front", "back"):
                    flap = folded.corners(f"{end}-{side}")
                    assert wall - abs(float(flap[0, 0])) == pytest.approx(t)
                    assert flap[:, 2].min() > 0.5 * t
                ends = [folded.corners(f"{end}-{side}")[:, 1] for end in ("front", "back")]
                assert ends[0].max() < ends[1].min()


@pytest.mark.parametrize(
    ("code", "size", "parameter"),
    [
        ("fefco-0201", (100.0, 200.0, 100.0), "width"),
        ("fefco-0201", (300.0, 30.0, 100.0), "width"),
        ("fefco-0427", (200.0, 150.0, 10.0), "depth"),
        ("fefco-0427", (200.0, 60.0, 150.0), "depth"),
        ("fefco-0471", (20.0, 150.0, 60.0), "length"),
        ("ecma-a60.20", (40.0, 80.0, 100.0), "length"),
        ("fefco-0215", (30.0, 80.0, 100.0), "length"),
        ("rigid-box", (100.0, 20.0, 30.0), "width"),
        ("telescope-tray", (300.0, 200.0, 10.0), "depth"),
    ],
)
def test_impossible_dimensions_are_refused_with_parameter_and_limit(
    code: str, size: tuple[float, float, float], parameter: str
) -> None:
    with pytest.raises(ImpossibleCarton) as refused:
        drawn(code, size, "b-flute")
    arguments = refused.value.message.arguments
    assert (arguments["parameter"], refused.value.source) == (parameter, (parameter,))
    assert arguments["value"] == size[("length", "width", "depth").index(parameter)]
    assert f"{arguments['limit']:.4g} mm" in str(refused.value)
    # The limit itself is no fault.
    limit = float(arguments["limit"])
    mended = replace_dimension(size, parameter, limit)
    assert refusal(code, mended) != (parameter, limit)


def refusal(code: str, size: tuple[float, float, float]) -> tuple[str, float] | None:
    """Return the parameter and the limit of a refusal, None if the carton is drawn."""
    try:
        drawn(code, size, "b-flute")
    except ImpossibleCarton as reason:
        return reason.source[0], float(reason.message.arguments["limit"])
    return None


def replace_dimension(
    size: tuple[float, float, float], name: str, value: float
) -> tuple[float, float, float]:
    names = ("length", "width", "depth")
    length, width, depth = (
        value if one == name else given for one, given in zip(names, size, strict=True)
    )
    return length, width, depth


def test_dimensions_between_the_limits_never_give_a_crossed_outline() -> None:
    rng = np.random.default_rng(35)
    refused = 0
    for style in STYLES.values():
        for _ in range(30):
            length, width, depth = map(float, rng.uniform(10.0, 500.0, 3).round(1))
            size = (length, width, depth)
            stock: Board = replace(load.board(style.board), caliper=float(rng.uniform(0.2, 7.0)))
            parameters: CartonSize = sized(style.code, size)
            try:
                carton = style.draw(parameters, stock)
            except ImpossibleCarton:
                refused += 1
                continue
            assert polygon(carton).is_valid, (style.code, size, stock.caliper)
            assert len(faces_of(carton)) == len(carton.panels) + sum(
                bool(path.closed.all()) for path in carton.cuts
            ), (style.code, size, stock.caliper)
    assert 50 < refused < 250


def test_an_unknown_style_is_refused_with_those_that_exist() -> None:
    with pytest.raises(LibraryError, match=r"fefco-9999.*does not exist"):
        style_of("fefco-9999")


def test_the_picture_of_the_documentation_shows_the_present_styles() -> None:
    assert svg_text() == (Path(__file__).parents[3] / SHEET).read_text("utf-8")
