"""resources: look up and cache the named colour spaces, colours and fonts of content streams.

A content stream contains the names; a resource dictionary defines them.
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
        """Return the resource with the name ``name`` from a resource dictionary.

        ``kind`` is the key of the kind of resource, such as "/Font".  The result may be a
        reference; it is None if the dictionary has no such resource.
        """
        holder = self._file.entry(resources, kind)
        key = f"/{name}"
        return (
            holder.raw_get(key) if isinstance(holder, DictionaryObject) and key in holder else None
        )

    def space(self, resources: DictionaryObject, name: str) -> ColourSpace:
        """Return the colour space with the name ``name`` from a resource dictionary.

        If the dictionary has no such colour space, ``name`` is interpreted as the name of a device
        colour space, such as "DeviceRGB".
        """
        key = id(resources), name
        cached = self._spaces.get(key)
        if cached is None:
            definition = self.find(resources, "/ColorSpace", name)
            cached = parse_colour_space(
                self._file, NameObject(f"/{name}") if definition is None else definition
            )
            self._spaces[key] = cached
        return cached

    def paint(self, space: ColourSpace, components: tuple[float, ...]) -> Paint:
        """Return the colour that a colour space and its components define in a PDF.

        ``space`` is the colour space, ``components`` the value of each component.
        """
        key = id(space), components
        cached = self._paints.get(key)
        if cached is None:
            cached = self._paints[key] = make_paint(self._file, space, list(components))
        return cached

    def font(self, resources: DictionaryObject, name: str) -> Font:
        """Return the font with the name ``name`` from a resource dictionary.

        The constant ``UNDECODABLE``, a font without encoding, is returned if the dictionary has no
        such font.
        """
        key = id(resources), name
        cached = self._fonts.get(key)
        if cached is None:
            node = self._file.resolve(self.find(resources, "/Font", name))
            cached = self._fonts[key] = parse_font(self._file, node)
        return cached
