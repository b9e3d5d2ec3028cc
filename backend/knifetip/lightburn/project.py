"""project: parse the XML of a LightBurn project into its layers and shapes.

``parse_project`` returns a ``Project``.  The parser is Expat.  LightBurn writes no DOCTYPE, so a
file with one is refused before any entity is expanded.

LightBurn does not document its format.  Sources: nuCarve, "Documenting the LightBurn file format"
(2022); threads 42317 and 52174 of the LightBurn forum; and files that LightBurn 1.7 wrote together
with the SVG that it exports for them, which show the directions of the axes.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final
from xml.parsers import expat

from knifetip.errors import NotADrawing
from knifetip.formats.limits import Limits
from knifetip.formats.xml_builder import XmlBuilder

#: Elements of a shape whose text is kept.
_TEXTS: Final = frozenset(("XForm", "VertList", "PrimList"))
#: Beginning of the names of elements with the settings of a layer: CutSetting, CutSetting_Img.
_SETTING: Final = "CutSetting"


@dataclass(slots=True)
class ProjectShape:
    """A shape of a project as the file contains it."""

    number: int  #: in the file, from 1
    attributes: dict[str, str]  #: Type, CutIndex, W, H …
    texts: dict[str, str] = field(default_factory=dict)  #: XForm, VertList and PrimList
    vertices: list[dict[str, str]] = field(default_factory=list)  #: elements V of .lbrn
    primitives: list[dict[str, str]] = field(default_factory=list)  #: elements P of .lbrn
    children: list[ProjectShape] = field(default_factory=list)  #: shapes of a group

    @property
    def kind(self) -> str:
        """Type of the shape: Rect, Path, Group …"""
        return self.attributes.get("Type", "")


@dataclass(slots=True)
class Project:
    """The layers and shapes of a project."""

    #: whether X points to the left, and whether Y points down
    mirror: tuple[bool, bool] = (False, False)
    settings: list[dict[str, str]] = field(default_factory=list)  #: index, name, type … of layers
    shapes: list[ProjectShape] = field(default_factory=list)


def parse_project(data: bytes, limits: Limits) -> Project:
    """Return the layers and shapes of a project, whose content is ``data``.

    Raises
    ------
    NotADrawing
        The file is not the XML of a LightBurn project, has a DOCTYPE, or is truncated or damaged.
    DrawingTooLarge
        The number or depth of elements exceeds the limits.
    """
    builder = _Builder(limits)
    builder.parse(data)
    return builder.project


class _Builder(XmlBuilder):
    """Builds the layers and shapes of one project."""

    def __init__(self, limits: Limits) -> None:
        super().__init__(limits, "LightBurn")
        self.project = Project()
        self._shapes = 0
        self._stack: list[ProjectShape] = []  # open shapes, the outermost first
        self._outside: list[int] = []  # depth of open outlines of texts, which are not read
        self._setting: dict[str, str] | None = None
        self._text: list[str] | None = None

    def restrict(self, parser: expat.XMLParserType) -> None:
        parser.StartDoctypeDeclHandler = _refuse_doctype

    def start(self, name: str, attributes: dict[str, str]) -> None:
        if self._outside:
            return
        if self.depth == 1:
            mirror_x, mirror_y = (
                attributes.get(key, "").lower() == "true" for key in ("MirrorX", "MirrorY")
            )
            self.project.mirror = mirror_x, mirror_y
        elif name == "Shape":
            self._shapes += 1
            shape = ProjectShape(self._shapes, attributes)
            (self._stack[-1].children if self._stack else self.project.shapes).append(shape)
            self._stack.append(shape)
        elif name == "BackupPath":
            self._outside.append(self.depth)
        elif self._stack:
            self._start_in_shape(name, attributes)
        elif name.startswith(_SETTING) and self.depth == 2:
            self._setting = dict(attributes)
            self.project.settings.append(self._setting)
        elif self._setting is not None and "Value" in attributes:
            self._setting[name] = attributes["Value"]

    def _start_in_shape(self, name: str, attributes: dict[str, str]) -> None:
        if name in _TEXTS:
            self._text = []
        elif name == "V":
            self._stack[-1].vertices.append(attributes)
        elif name == "P":
            self._stack[-1].primitives.append(attributes)

    def end(self, name: str) -> None:
        if self._outside:
            if self.depth == self._outside[-1]:
                self._outside.pop()
        elif name == "Shape" and self._stack:
            self._stack.pop()
        elif self._text is not None and name in _TEXTS:
            self._stack[-1].texts[name] = "".join(self._text)
            self._text = None
        elif self._setting is not None and self.depth == 2:
            self._setting = None

    def text(self, text: str) -> None:
        if self._text is not None:
            self._text.append(text)


def _refuse_doctype(*_arguments: object) -> None:
    raise NotADrawing("lightburn.doctype")
