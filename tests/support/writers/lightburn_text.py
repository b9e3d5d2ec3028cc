"""Write projects of LightBurn (.lbrn2 and .lbrn) for tests."""

from __future__ import annotations

from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

IDENTITY = "1 0 0 1 0 0"


def project(*elements: str, mirror: str = 'MirrorX="False" MirrorY="False"') -> bytes:
    """Return a project with layers and shapes."""
    inside = "\n".join(elements)
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<LightBurnProject AppVersion="1.7.08" FormatVersion="1" {mirror}>\n'
        '<Thumbnail Source="iVBORw0KGgo="/>\n'
        f"{inside}\n</LightBurnProject>\n"
    ).encode()


def layer(index: int, name: str = "", kind: str = "Cut", **values: object) -> str:
    """Return the settings of a layer."""
    inside = "".join(f'<{key} Value="{value}"/>' for key, value in values.items())
    named = f"<name Value={quoteattr(name)}/>" if name else ""
    return f'<CutSetting type="{kind}"><index Value="{index}"/>{named}{inside}</CutSetting>'


def shape(kind: str, inside: str = "", matrix: str = IDENTITY, **attributes: object) -> str:
    """Return a shape; its layer is 0 if ``attributes`` has no ``CutIndex``."""
    written = "".join(
        f" {key}={quoteattr(str(value))}" for key, value in {"CutIndex": 0, **attributes}.items()
    )
    return f'<Shape Type="{kind}"{written}><XForm>{matrix}</XForm>{inside}</Shape>'


def path(vertices: str, primitives: str, matrix: str = IDENTITY, **attributes: object) -> str:
    """Return a path with packed vertices and primitives."""
    inside = f"<VertList>{vertices}</VertList><PrimList>{primitives}</PrimList>"
    return shape("Path", inside, matrix, **attributes)


def polyline(*points: Sequence[float], layer: int = 0) -> str:
    """Return an open path of lines through points."""
    vertices = "".join(f"V{x} {y}c0x1c1x1" for x, y in points)
    primitives = "".join(f"L{k} {k + 1}" for k in range(len(points) - 1))
    return path(vertices, primitives, CutIndex=layer)


def group(*shapes: str, matrix: str = IDENTITY) -> str:
    """Return a group of shapes."""
    return shape("Group", f"<Children>{''.join(shapes)}</Children>", matrix)


def carton() -> bytes:
    """Return a project with a blank of 200 × 80 mm with a round hole and three folds.

    The layer C02 (red) has the cuts, C01 (blue) the folds.
    """
    return project(
        layer(2, "C02"),
        layer(1, "C01"),
        shape("Rect", matrix="1 0 0 1 100 40", W=200, H=80, Cr=0, CutIndex=2),
        shape("Ellipse", matrix="1 0 0 1 25 40", Rx=8, Ry=8, CutIndex=2),
        *(polyline((x, 0), (x, 80), layer=1) for x in (50, 100, 150)),
    )
