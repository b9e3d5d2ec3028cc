"""Ellipses, splines and skew blocks of a DXF are approximated together, not one by one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from knifetip.dxf.read import read
from knifetip.geometry import ellipse, spline

_ELLIPSE = (
    "0\nELLIPSE\n8\nCUT\n100\nAcDbEllipse\n10\n{x}\n20\n0\n11\n9\n21\n2\n40\n0.4\n41\n0\n42\n3\n"
)
_SPLINE = (
    "0\nSPLINE\n8\nCUT\n100\nAcDbEntity\n100\nAcDbSpline\n70\n8\n71\n3\n72\n8\n73\n4\n"
    + "".join(f"40\n{knot}\n" for knot in (0, 0, 0, 0, 1, 1, 1, 1))
    + "10\n{x}\n20\n50\n10\n{x}\n20\n60\n10\n9\n20\n70\n10\n5\n20\n75\n"
)
_INSERT = "0\nINSERT\n8\nCUT\n2\nB\n10\n{x}\n20\n99\n41\n1.5\n42\n0.{number}\n50\n30\n"
_BLOCK = (
    "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n0\n2\nB\n70\n0\n10\n0\n20\n0\n"
    "0\nARC\n8\n0\n10\n0\n20\n0\n40\n3\n50\n10\n51\n120\n0\nENDBLK\n8\n0\n0\nENDSEC\n"
)


def _drawing(entity: str, copies: int) -> bytes:
    header = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n"
    body = "".join(entity.format(x=20 * one, number=one + 101) for one in range(copies))
    return f"{header}{_BLOCK}0\nSECTION\n2\nENTITIES\n{body}0\nENDSEC\n0\nEOF\n".encode()


@pytest.mark.parametrize(
    ("module", "entity"), [(ellipse, _ELLIPSE), (spline, _SPLINE), (ellipse, _INSERT)]
)
def test_the_curves_of_a_drawing_are_approximated_together(
    module: Any, entity: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = 0
    fit_spans: Callable[..., Any] = module.fit_spans

    def counted(*arguments: Any) -> Any:
        nonlocal calls
        calls += 1
        return fit_spans(*arguments)

    monkeypatch.setattr(module, "fit_spans", counted)
    one = len(read(_drawing(entity, 1)).bulge)
    assert one > 0
    calls = 0
    drawing = read(_drawing(entity, 50))
    assert len(drawing.bulge) >= 50
    assert calls == 1
