"""resources: what the names in a content stream stand for, each looked up once.

"Cut" among the colour spaces of a page -> Space
"""

from __future__ import annotations

from pypdf.generic import DictionaryObject, NameObject

from knifetip.pdf.colours import Paint, Space, paint, space
from knifetip.pdf.document import File
from knifetip.pdf.text import Font, font


class Named:
    """The colour spaces, colours and fonts of a file that were met so far."""

    def __init__(self, file: File) -> None:
        self._file = file
        self._spaces: dict[tuple[int, str], Space] = {}
        self._paints: dict[tuple[int, tuple[float, ...]], Paint] = {}
        self._fonts: dict[tuple[int, str], Font] = {}

    def resource(self, resources: DictionaryObject, kind: str, name: str) -> object:
        """Return a named resource as it is written: a reference, or the thing itself."""
        holder = self._file.entry(resources, kind)
        key = f"/{name}"
        return (
            holder.raw_get(key) if isinstance(holder, DictionaryObject) and key in holder else None
        )

    def space(self, resources: DictionaryObject, name: str) -> Space:
        """Return a colour space by its name."""
        key = id(resources), name
        found = self._spaces.get(key)
        if found is None:
            given = self.resource(resources, "/ColorSpace", name)
            found = space(self._file, NameObject(f"/{name}") if given is None else given)
            self._spaces[key] = found
        return found

    def paint(self, where: Space, given: tuple[float, ...]) -> Paint:
        """Return what so much of each component of a space draws."""
        key = id(where), given
        found = self._paints.get(key)
        if found is None:
            found = self._paints[key] = paint(self._file, where, list(given))
        return found

    def font(self, resources: DictionaryObject, name: str) -> Font:
        """Return a font by its name."""
        key = id(resources), name
        found = self._fonts.get(key)
        if found is None:
            node = self._file.seen(self.resource(resources, "/Font", name))
            found = self._fonts[key] = font(self._file, node)
        return found
