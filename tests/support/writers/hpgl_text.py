"""Write plotter files (HPGL) for tests."""

from __future__ import annotations

from collections.abc import Sequence

from knifetip.model.drawing import Drawing


def encoded(
    points: Sequence[tuple[str, float, float]], *, places: int = 0, seven_bits: bool = False
) -> bytes:
    """Return the instruction PE with points.

    Each point has flags ("" for none, ":2" for pen 2) and two coordinates with ``places`` binary
    places.
    """
    base, last = (32, 95) if seven_bits else (64, 191)

    def number(value: float) -> bytes:
        whole = round(value * 2**places)
        rest = 2 * whole if whole >= 0 else 1 - 2 * whole
        digits = []
        while rest >= base:
            digits.append(63 + rest % base)
            rest //= base
        return bytes([*digits, last + rest])

    parts = [b"PE", b"7" if seven_bits else b""]
    if places:
        code = 2 * places
        parts += [b">", bytes([last + code])]
    for flags, x, y in points:
        if flags.startswith(":"):
            parts += [b":", bytes([last + 2 * int(flags[1:])])]
        else:
            parts.append(flags.encode())
        parts += [number(x), number(y)]
    return b"".join([*parts, b";"])


def carton() -> bytes:
    """Return a plot of a blank of 200 × 80 mm with a round corner, a hole and three folds.

    Pen 1 draws the cuts, pen 2 the folds.
    """
    folds = "".join(f"PU{x},0;PD{x},3200;" for x in (2000, 4000, 6000))
    outline = "PU0,0;PD8000,0,8000,2400;AA7200,2400,90;PD0,3200,0,0;PU1000,1600;CI320;"
    return f"IN;SP1;{outline}SP2;{folds}PU;SP0;".encode()


def plot_of(drawing: Drawing) -> bytes:
    """Return a plot of a drawing, in which each layer has a pen."""
    parts = ["IN;SC0,40,0,40,2;"]
    for (a, b), bulge, layer in zip(
        drawing.ends.tolist(), drawing.bulge.tolist(), drawing.layer.tolist(), strict=True
    ):
        parts.append(f"SP{layer + 1};PU{a[0]:.9f},{a[1]:.9f};PD")
        if bulge == 0.0:
            parts.append(f"{b[0]:.9f},{b[1]:.9f};")
        else:
            # The point in the middle of the arc, beside the middle of the chord.
            x = (a[0] + b[0] + bulge * (b[1] - a[1])) / 2.0
            y = (a[1] + b[1] - bulge * (b[0] - a[0])) / 2.0
            parts.append(f";AT{x:.9f},{y:.9f},{b[0]:.9f},{b[1]:.9f};")
    return "".join([*parts, "PU;SP0;"]).encode()
