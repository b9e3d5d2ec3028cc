"""tuck: lids with a tuck flap, and the dust flaps beside them, at an end of a tube.

The dust flaps fold first and the lid lies on them, so that the crease of the lid is t farther out.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Final

from pydantic import Field

from knifetip.cartons import allowances
from knifetip.cartons.draft import Draft
from knifetip.cartons.parameters import CartonSize, check_least, check_most
from knifetip.cartons.tube import PANELS, Flap, Tube
from knifetip.model.board import Board

#: Part of the length that a slit lock takes at either end of the crease of a tuck flap.
_LOCK: Final = 0.12
#: Part of the width that a dust flap has as its length.
_DUST: Final = 0.6


class TuckCarton(CartonSize):
    """Parameters of a carton with a tuck lid."""

    joint: Annotated[float, Field(ge=8.0, le=40.0)] = Field(
        default=12.0, title="Glue flap", description="Width of the glue flap (mm)"
    )
    tuck: Annotated[float, Field(ge=6.0, le=60.0)] = Field(
        default=14.0, title="Tuck flap", description="Length of the tuck flap of the lid (mm)"
    )


@dataclass(frozen=True, slots=True)
class TuckEnd:
    """An end of a tube that is closed by a lid with a tuck flap, between two dust flaps."""

    tube: Tube
    lid: float  #: from the crease of the lid to that of the tuck flap (mm)
    tuck: float  #: length of the tuck flap (mm)
    dust: float  #: length of the dust flaps (mm)

    @classmethod
    def from_size(cls, tube: Tube, size: TuckCarton, board: Board) -> TuckEnd:
        """Return the end that suits a carton.

        Raises
        ------
        ImpossibleCarton
            A dimension does not permit it.
        """
        t = board.caliper
        inset = _dust_inset(t)
        check_least("length", size.length, 20.0 + 2.0 * inset, board)
        check_least("width", size.width, max(2.0 * inset + 8.0, size.joint + 2.0), board)
        check_least("depth", size.depth, size.tuck + 6.0, board)
        check_most("tuck", size.tuck, max(6.0, size.width), board)
        # The lid ends where the tuck flap lies on the inside of the front.
        dust = min(_DUST * size.width + 4.0, 0.5 * size.length - allowances.play(t))
        return cls(tube, size.width, size.tuck, dust)

    def flaps(self, draft: Draft, back: int, *, top: bool) -> list[Flap]:
        """Return a flap for each panel, and add all to a draft.

        Parameters
        ----------
        draft
            The draft of the carton.
        back
            Number of the panel on which the lid hangs, 0 or 2.
        top
            Whether this is the end at the top.
        """
        flaps: list[Flap] = []
        for panel in range(4):
            if panel == back:
                flaps.append(self._lid(draft, panel, top))
            elif panel % 2:
                flaps.append(self._dust(draft, panel, top))
            else:
                flaps.append(self.tube.no_flap(panel))
        return flaps

    def _lid(self, draft: Draft, panel: int, top: bool) -> Flap:
        t = self.tube.caliper
        a, b = self.tube.span(panel)
        # The lid is as wide as the tuck flap, which goes between the side panels.
        inset = 0.5 * t + allowances.play(t)
        u, v, step = a + inset, b - inset, t
        ridge, end = step + self.lid, step + self.lid + self.tuck
        lock = _LOCK * (v - u)
        place = "top" if top else "bottom"

        def at(x: float, y: float) -> tuple[float, float]:
            return self.tube.point((x, y), top=top)

        lid, flap = f"{place}-lid", f"{place}-tuck"
        draft.panel(lid, (*at(u, step), *at(v, ridge)), PANELS[panel], (at(u, step), at(v, step)))
        crease = at(u + lock, ridge), at(v - lock, ridge)
        draft.panel(flap, (*at(u, ridge), *at(v, end)), lid, crease)
        draft.slit(at(u, ridge), at(u + lock, ridge))
        draft.slit(at(v, ridge), at(v - lock, ridge))
        r = min(0.6 * self.tuck, 0.2 * (v - u))
        return [(a, 0.0), (u, step), (u, end, r), (v, end, r), (v, step), (b, 0.0)]

    def _dust(self, draft: Draft, panel: int, top: bool) -> Flap:
        a, b = self.tube.span(panel)
        inset = _dust_inset(self.tube.caliper)
        u, v, long = a + inset, b - inset, self.dust
        place = "top" if top else "bottom"
        start, end, far = (self.tube.point(one, top=top) for one in ((u, 0.0), (v, 0.0), (v, long)))
        draft.panel(f"{place}-dust-{PANELS[panel]}", (*start, *far), PANELS[panel], (start, end))
        slope = 0.15 * (v - u)
        return [
            (u, 0.0),
            (u, 0.4 * long),
            (u + slope, long),
            (v - slope, long),
            (v, 0.4 * long),
            (v, 0.0),
        ]


def _dust_inset(t: float) -> float:
    """Return the distance of a dust flap from the creases beside it (mm).

    It lies beside the tuck flap, which lies on the inside of the front.
    """
    return 1.5 * t + allowances.play(t)
