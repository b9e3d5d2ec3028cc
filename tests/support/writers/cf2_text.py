"""Write CF2 files for tests."""

from __future__ import annotations


def cf2(*records: str, head: tuple[str, ...] = ("UM", "SCALE,1,1"), subs: str = "") -> bytes:
    """Return a CF2 file with a main section of header records, records and subroutines."""
    main = ["$BOF", "V2", "ORDER", "Name: author", "END", "MAIN,carton", *head, *records, "END"]
    return "\r\n".join([*main, *filter(None, [subs]), "$EOF", ""]).encode()


def sub(name: str, *records: str) -> str:
    """Return a subroutine with some records."""
    return "\r\n".join([f"SUB,{name}", *records, "END"])


def line(x1: float, y1: float, x2: float, y2: float, kind: object = 1, bridges: str = "0,0") -> str:
    """Return a record of a line from (x1, y1) to (x2, y2).

    ``kind`` is the line type of CF2, 1 for cut; ``bridges`` is "number,width".
    """
    return f"L,2,{kind},0,{x1:g},{y1:g},{x2:g},{y2:g},{bridges}"


def arc(
    x1: float, y1: float, x2: float, y2: float, x: float, y: float, way: int = 1, kind: object = 1
) -> str:
    """Return a record of an arc from (x1, y1) to (x2, y2) about the centre (x, y).

    ``way`` is 1 for an arc that turns left and -1 for one that turns right.
    """
    return f"A,2,{kind},0,{x1:g},{y1:g},{x2:g},{y2:g},{x:g},{y:g},{way},0,0"


def carton() -> bytes:
    """Return a file with two copies of a blank, the second one rotated by 180°.

    The blank has an outline with a round corner, a hole and three folds.
    """
    blank = sub(
        "CARTON",
        line(0, 0, 200, 0, bridges="2,6"),
        line(200, 0, 200, 60),
        arc(200, 60, 180, 80, 180, 60),
        line(180, 80, 0, 80),
        line(0, 80, 0, 0),
        arc(33, 40, 33, 40, 25, 40),
        *(line(x, 0, x, 80, 2) for x in (50, 100, 150)),
    )
    return cf2(
        "C,CARTON,0,0,0,1,1",
        "C,CARTON,200,180,180,1,1",
        "T,2,46,0,10,90,0,5,4",
        "Two up",
        head=("UM", "LL,0,0", "UR,200,180", "SCALE,1,1"),
        subs=blank,
    )
