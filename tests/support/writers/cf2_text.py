"""CF2 files for tests, as text."""

from __future__ import annotations


def cf2(*records: str, head: tuple[str, ...] = ("UM", "SCALE,1,1"), subs: str = "") -> bytes:
    """A file whose MAIN holds these records."""
    main = ["$BOF", "V2", "ORDER", "Name: somebody", "END", "MAIN,carton", *head, *records, "END"]
    return "\r\n".join([*main, *filter(None, [subs]), "$EOF", ""]).encode()


def sub(name: str, *records: str) -> str:
    """A subroutine."""
    return "\r\n".join([f"SUB,{name}", *records, "END"])


def line(x1: float, y1: float, x2: float, y2: float, kind: object = 1, bridges: str = "0,0") -> str:
    """A line of type 1: cut."""
    return f"L,2,{kind},0,{x1:g},{y1:g},{x2:g},{y2:g},{bridges}"


def arc(
    x1: float, y1: float, x2: float, y2: float, x: float, y: float, way: int = 1, kind: object = 1
) -> str:
    """An arc about (x, y), to the left for 1, to the right for -1."""
    return f"A,2,{kind},0,{x1:g},{y1:g},{x2:g},{y2:g},{x:g},{y:g},{way},0,0"


def carton() -> bytes:
    """Two cartons, the second one turned: outline with a round corner, a hole, three folds."""
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
