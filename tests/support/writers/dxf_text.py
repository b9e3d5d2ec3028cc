"""Write DXF files for tests, tag by tag."""

from __future__ import annotations

from itertools import pairwise

Tag = tuple[int, object]
#: A coordinate, or text that a damaged file has in its place.
Number = float | str


def tags(*pairs: Tag) -> str:
    """Return pairs of group code and value as DXF lines."""
    return "".join(f"{code}\n{value}\n" for code, value in pairs)


def entity(kind: str, *pairs: Tag) -> str:
    """Return an entity with some pairs of group code and value; on layer 0 if they have no
    layer.
    """
    layer = () if any(code == 8 for code, _ in pairs) else ((8, "0"),)
    return tags((0, kind), *layer, *pairs)


def line(x1: Number, y1: Number, x2: Number, y2: Number, *pairs: Tag) -> str:
    return entity("LINE", *pairs, (10, x1), (20, y1), (11, x2), (21, y2))


def rectangle(width: Number, height: Number, *pairs: Tag) -> str:
    """Return the four lines of a rectangle whose lower left corner is the origin."""
    corners = [(0, 0), (width, 0), (width, height), (0, height), (0, 0)]
    return "".join(line(*a, *b, *pairs) for a, b in pairwise(corners))


def insert(block: str, x: Number = 0.0, y: Number = 0.0, *pairs: Tag) -> str:
    return entity("INSERT", (2, block), (10, x), (20, y), *pairs)


def block(name: str, *entities: str, base: tuple[float, float] = (0.0, 0.0)) -> str:
    head = tags((0, "BLOCK"), (8, "0"), (2, name), (70, 0), (10, base[0]), (20, base[1]))
    return head + "".join(entities) + tags((0, "ENDBLK"), (8, "0"))


def layer(name: str, colour: int = 7, flags: int = 0, linetype: str = "CONTINUOUS") -> str:
    return tags((0, "LAYER"), (2, name), (70, flags), (62, colour), (6, linetype))


def dxf(
    *entities: str,
    blocks: tuple[str, ...] = (),
    layers: tuple[str, ...] = (),
    units: object = 4,
    version: str = "AC1009",
) -> bytes:
    """Return a DXF file with some entities; ``units`` is $INSUNITS, None to omit it."""
    header = tags((9, "$ACADVER"), (1, version))
    if units is not None:
        header += tags((9, "$INSUNITS"), (70, units))
    table = tags((0, "TABLE"), (2, "LAYER"), (70, len(layers))) + "".join(layers)
    sections = [("HEADER", header), ("TABLES", table + tags((0, "ENDTAB")))]
    if blocks:
        sections.append(("BLOCKS", "".join(blocks)))
    sections.append(("ENTITIES", "".join(entities)))
    text = "".join(
        tags((0, "SECTION"), (2, name)) + body + tags((0, "ENDSEC")) for name, body in sections
    )
    return (text + tags((0, "EOF"))).encode()
