"""resources: look up and cache the named colour spaces, colours and fonts of content streams.

A content stream refers to them by names, which a resource dictionary defines.
"""

from __future__ import annotations

from pypdf.generic import DictionaryObject, NameObject

from knifetip.pdf.colours import ColourSpace, Paint, make_paint, parse_colour_space
from knifetip.pdf.document import PdfFile
from knifetip.pdf.text import Font, parse_font


class Resources:
    """Finds and caches the named colour spaces, colours and fonts of a PDF."""

    def __init__(self, file: PdfFile) -> None:
        self._file = file
        self._spaces: dict[tuple[int, str], ColourSpace] = {}
        self._paints: dict[tuple[int, tuple[float, ...]], Paint] = {}
        self._fonts: dict[tuple[int, str], Font] = {}

    def find(self, resources: DictionaryObject, kind: str, name: str) -> object:
        """Return the resource of one kind with the name ``name`` from a resource dictionary.

        ``kind`` is the key of the kind, such as "/Font".  The result may be a reference; it is None
        if the dictionary has no such resource.
        """
        holder = self._file.entry(resources, kind)
        key = f"/{name}"
        return (
            holder.raw_get(key) if isinstance(holder, DictionaryObject) and key in holder else None
        )

    def space(self, resources: DictionaryObject, name: str) -> ColourSpace:
        """Return the colour space with the name ``name`` from a resource dictionary.

        If the dictionary has no such colour space, ``name`` is the name of a device colour space,
        such as "DeviceRGB".
        """
        key = id(resources), name
        found = self._spaces.get(key)
        if found is None:
            given = self.find(resources, "/ColorSpace", name)
            found = parse_colour_space(
                self._file, NameObject(f"/{name}") if given is None else given
            )
            self._spaces[key] = found
        return found

    def paint(self, where: ColourSpace, given: tuple[float, ...]) -> Paint:
        """Return the colour that a PDF defines by a colour space and components.

        ``where`` is the colour space, ``given`` the value of each of its components.
        """
        key = id(where), given
        found = self._paints.get(key)
        if found is None:
            found = self._paints[key] = make_paint(self._file, where, list(given))
        return found

    def font(self, resources: DictionaryObject, name: str) -> Font:
        """Return the font with the name ``name`` from a resource dictionary.

        ``UNDECODABLE`` is returned if the dictionary has no such font.
        """
        key = id(resources), name
        found = self._fonts.get(key)
        if found is None:
            node = self._file.resolve(self.find(resources, "/Font", name))
            found = self._fonts[key] = parse_font(self._file, node)
        return found
