"""Conventions of companies for drawing cartons: seen in files, read about, or conceivable.

Each company has layers, colours, linetypes, a format, a unit, annotations around the carton, and
typical flaws.  ``company_files`` writes files in these conventions.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from tests.support.cartons.plan import Plan, Stroke

#: Layer, colour (an AutoCAD colour index or "#rrggbb") and linetype of a part.
Style = tuple[str, object, str]
SOLID = "CONTINUOUS"


@dataclass(frozen=True)
class House:
    """The conventions of one company for drawing cartons."""

    name: str
    styles: Mapping[str, Style]
    around: tuple[str, ...] = ()  #: keys of ``SURROUNDINGS``: annotations around the carton
    format: str = "dxf"
    header: int | None = 4  #: $INSUNITS of a DXF file, None if it is absent
    scale: float = 1.0  #: file units per millimetre
    flaws: tuple[str, ...] = ()  #: keys of ``FLAWS``

    def style(self, stroke: Stroke) -> Style:
        """Return the layer, colour and linetype in which the company draws a stroke."""
        part = stroke.sample or stroke.part
        return self.styles.get(part) or self.styles[_LIKE.get(part, "dimension")]

    def drawable(self, plan: Plan) -> list[Stroke]:
        """Return the strokes of a plan that can be drawn in the styles of the company.

        A V-groove becomes a crease if the company has no style for V-grooves; a perforation or a
        half-cut is omitted if its style is missing or equal to that of cuts or creases.
        """
        common = (self.styles["outer"], self.styles["crease"])
        out = []
        for stroke in plan.strokes:
            part = stroke.sample or stroke.part
            own = self.styles.get(part)
            if part == "v-groove" and own is None:
                out.append(replace(stroke, part="crease"))
            elif part not in ("perforation", "half-cut") or (own and own not in common):
                out.append(stroke)
        return out


_LIKE = {"inner": "outer"}


def _named(
    cut: str, crease: str, perf: str = "", half: str = "", aside: str = ""
) -> dict[str, Style]:
    """Return styles with one layer per line type (all in colour 7), by the name of the part.

    ``aside`` is the layer of dimensions.  Omitted layers default to that of a similar line type.
    """
    told: dict[str, Style] = {"outer": (cut, 7, SOLID), "crease": (crease, 7, SOLID)}
    told["perforation"] = (perf or crease, 7, SOLID)
    told["half-cut"] = (half or perf or crease, 7, SOLID)
    told["dimension"] = (aside or cut, 7, SOLID)
    return told


def _coloured(layer: str, *colours: object, linetype: str = SOLID) -> dict[str, Style]:
    """Return styles on one layer with one colour per line type, by the name of the part.

    The colours are those of cuts, creases, perforations, half-cuts and dimensions; the last one
    given is repeated for the missing ones.  ``linetype`` is that of creases.
    """
    parts = ("outer", "crease", "perforation", "half-cut", "dimension")
    padded = [*colours, *[colours[-1]] * (5 - len(colours))]
    told: dict[str, Style] = {
        part: (layer, colour, SOLID) for part, colour in zip(parts, padded, strict=True)
    }
    told["crease"] = (layer, padded[1], linetype)
    return told


_ALL = ("dimensions", "frame", "marks", "legend", "grain")
_ARTIOS = {
    "outer": ("Design", 1, SOLID), "crease": ("Design", 2, SOLID),
    "grain": ("Design", 10, SOLID), "dimension": ("Annotation", 20, SOLID),
    "perforation": ("Design", 3, SOLID), "half-cut": ("Design", 4, SOLID),
}  # fmt: skip

HOUSES: tuple[House, ...] = (
    House("ArtiosCAD, layer Design", _ARTIOS, ("dimensions", "grain"), header=None),
    House("ArtiosCAD, inches", _ARTIOS, ("dimensions",), header=None, scale=1 / 25.4),
    House(
        "ArtiosCAD, by line type",
        {
            "outer": ("CUT", 1, SOLID),
            "crease": ("CRE", 2, SOLID),
            "perforation": ("PERF", 3, SOLID),
            "half-cut": ("PCUT", 4, SOLID),
            "dimension": ("Dimensions", 7, SOLID),
            "bleed": ("Bleed", 5, SOLID),
        },
        ("bleed", "dimensions"),
        header=1,
    ),
    House(
        "Main Design layers",
        _named(
            "Main Design Cut",
            "Main Design Crease",
            "Main Design Perf",
            "Main Design Partial Cut",
            "Annotation",
        ),
        ("dimensions",),
    ),
    House(
        "EngView", _named("Knife", "Bend", "Perforation", "Half Cut", "Dimensions"), ("dimensions",)
    ),
    House("Kongsberg", _named("Thru-cut", "Crease", "Perf", "Kiss-cut", "Reference"), ("marks",)),
    House(
        "Zünd, English",
        _named("Thru-Cut", "Crease", "Perforate", "Kiss-Cut", "Regmark"),
        ("marks",),
    ),
    House(
        "Zünd, German",
        _named("Durchschnitt", "Rillen", "Perforieren", "Anschnitt", "Register"),
        ("marks",),
    ),
    House(
        "Prime Center",
        {
            **_named("Die-Cut", "Creasing", "Perforating", "Halfcut", "Text"),
            "bleed": ("Bleed", 3, SOLID),
        },
        ("bleed", "legend"),
    ),
    House(
        "Prinect", _named("Stanzen", "Rillen", "Perforieren", "Ritzen", "Bemaßung"), ("dimensions",)
    ),
    House(
        "German, words",
        _named("Außenkontur Schnitt", "Rilllinien", "Perfo", "Ritzen", "Hilfslinien"),
        _ALL,
    ),
    House("French, words", _named("Coupe", "Rainage", "Perforation", "Mi-chair", "Cotation"), _ALL),
    House(
        "French, filets",
        _named("Filets coupants", "Filets raineurs", "Filets perfo", "Mi-coupe", "Habillage"),
        ("dimensions",),
    ),
    House(
        "Italian, words", _named("Taglio", "Cordone", "Perforazione", "Mezzo taglio", "Quote"), _ALL
    ),
    House(
        "Italian, fustella",
        _named("Fustella Taglio", "Fustella Cordone", "Fustella Strappo", "Mezzotaglio", "Testi"),
        (),
    ),
    House("Spanish, words", _named("Corte", "Hendido", "Perforado", "Medio corte", "Cotas"), _ALL),
    House(
        "Spanish, dobleces",
        _named("CORTE", "DOBLEZ", "PUNTEADO", "MEDIO CORTE", "ACOTADO"),
        ("dimensions",),
    ),
    House("Portuguese, words", _named("Faca corte", "Vinco", "Picote", "Meio corte", "Cotas"), ()),
    House(
        "Polish, words", _named("Cięcie", "Bigowanie", "Perforacja", "Nadcięcie", "Wymiary"), _ALL
    ),
    House("Czech, words", _named("Řez", "Rylování", "Perforace", "Nářez", "Kóty"), ()),
    House("Russian, words", _named("Рез", "Биговка", "Перфорация", "Надсечка", "Размеры"), _ALL),
    House("Ukrainian, words", _named("Різ", "Біговка", "Перфорація", "Надсічка", "Розміри"), ()),
    House("Turkish, words", _named("Bıçak", "Pilyaj", "Perforaj", "Yarım kesim", "Ölçü"), _ALL),
    House("Chinese, words", _named("刀线", "压线", "齿刀线", "半刀线", "尺寸"), _ALL),
    House("Chinese, traditional", _named("刀模線", "壓線", "齒線", "半斷線", "標註"), ()),
    House(
        "Japanese, words", _named("カット線", "折り線", "ミシン目", "ハーフカット", "寸法"), _ALL
    ),
    House("Japanese, trade", _named("抜き型", "罫線", "ミシン", "半抜き", "注記"), ()),
    House("Korean, words", _named("칼선", "접는선", "미싱선", "반칼", "치수"), _ALL),
    House(
        "Vietnamese, words",
        _named("Đường cắt", "Đường cấn", "Đường răng cưa", "Cắt nửa", "Kích thước"),
        (),
    ),
    House(
        "Dutch, words", _named("Snijlijn", "Rillijn", "Perforatie", "Halfsnede", "Maatvoering"), ()
    ),
    House("Swedish, words", _named("Stans", "Bigg", "Perforering", "Halvstans", "Mått"), ()),
    House("Hungarian, words", _named("Vágás", "Bígelés", "Perforálás", "Félvágás", "Méret"), ()),
    House("Arabic, words", _named("قص", "طي", "تخريم", "نصف قص", "أبعاد"), ()),
    House("Greek, words", _named("Κοπή", "Πίκμανση", "Διάτρηση", "Μισοκοπή", "Διαστάσεις"), ()),
    House("SolidWorks sheet metal", _named("OUTER_PROFILES", "BEND_LINES", "", "", "NOTES"), ()),
    House("Fusion 360 sheet metal", _named("OUTER_PROFILES", "BEND", "", "", "BEND_EXTENT"), ()),
    House(
        "Rhino",
        {
            "outer": ("Cut", "#ff0000", SOLID),
            "crease": ("Fold", "#0000ff", SOLID),
            "dimension": ("Annotations", "#000000", SOLID),
        },
        ("dimensions", "grain"),
    ),
    House(
        "One layer, red cut, blue dashed crease",
        _coloured("0", 1, 5, 6, 4, 3, linetype="DASHED"),
        ("dimensions",),
    ),
    House(
        "One layer, red cut, green crease", _coloured("0", 1, 3, 2, 5, 7), ("dimensions", "marks")
    ),
    House("One layer, black cut, red crease", _coloured("0", 7, 1, 3, 4, 8), ("dimensions",)),
    House("One layer, green cut, red crease", _coloured("Layer 1", 3, 1, 5, 6, 7), ()),
    House(
        "One layer, magenta cut, cyan dashed crease",
        _coloured("0", 6, 4, 1, 2, 8, linetype="DASHED"),
        (),
    ),
    House("One layer, blue cut, red crease", _coloured("0", 5, 1, 3, 4, 7), ("legend",)),
    House(
        "One layer, all black, dashed creases", _coloured("0", 7, 7, 7, 7, 7, linetype="DASHED"), ()
    ),
    House("One layer, all black", _coloured("0", 7), ()),
    House("One layer, all black, dimensions", _coloured("0", 7), ("dimensions",)),
    House("One layer, all black, dimensions and frame", _coloured("0", 7), ("dimensions", "frame")),
    House("One layer, all black, in pieces", _coloured("0", 7), flaws=("pieces", "gaps")),
    House("One layer, all black, dashes drawn", _coloured("0", 7), flaws=("dashes",)),
    House("One layer, all black, short creases", _coloured("0", 7), flaws=("short creases",)),
    House("One layer, all black, inner dimensions", _coloured("0", 7), ("inner dimensions",)),
    House("One layer, all black, letters", _coloured("0", 7), ("letters",)),
    House("One layer, all black, bleed", _coloured("0", 7), ("bleed",)),
    House("One layer, all black, three-up", _coloured("0", 7), ("three-up",)),
    House("One layer, all black, six-up", _coloured("0", 7), ("six-up",)),
    House(
        "Two colours, bleed in a third",
        {**_coloured("0", 1, 5, 5, 5, 8), "bleed": ("0", 3, SOLID)},
        ("bleed",),
    ),
    House(
        "Layers CUT and CREASE, everything else on CUT",
        _named("CUT", "CREASE"),
        ("dimensions", "frame", "legend", "marks"),
    ),
    House(
        "Layers CUT and CREASE, letters and grain on CUT",
        _named("CUT", "CREASE"),
        ("letters", "grain"),
    ),
    House("Layers CUT and CREASE, bleed on CUT", _named("CUT", "CREASE"), ("bleed",)),
    House("Layers CUT and CREASE, six-up", _named("CUT", "CREASE"), ("six-up",)),
    House(
        "Layers CUT and CREASE, careless",
        _named("CUT", "CREASE"),
        (),
        flaws=("pieces", "doubles", "gaps"),
    ),
    House(
        "Layers CUT and CREASE, one decimal",
        _named("CUT", "CREASE"),
        (),
        flaws=("rounded", "doubles"),
    ),
    House(
        "Layers CUT and CREASE, inner dimensions on CREASE",
        {**_named("CUT", "CREASE"), "dimension": ("CREASE", 7, SOLID)},
        ("inner dimensions",),
    ),
    House("Layers numbered 1 and 2", _named("1", "2", "3", "4", "5"), ("dimensions",)),
    House(
        "Layers named after colours",
        _named("Red", "Blue", "Green", "Cyan", "Black"),
        ("dimensions",),
    ),
    House(
        "Layers CUT, SCORE, DIMENSION, TITLE",
        {
            "outer": ("CUT", 1, SOLID),
            "crease": ("SCORE", 5, SOLID),
            "dimension": ("DIMENSION", 3, SOLID),
            "frame": ("TITLE", 7, SOLID),
        },
        ("dimensions", "frame"),
    ),
    House(
        "Layers OUTER CUT CONTOUR and INNER CUTS",
        {
            "outer": ("OUTER CUT CONTOUR", "#ed1c24", SOLID),
            "inner": ("INNER CUTS", "#0000ff", SOLID),
            "crease": ("CREASE", "#00a651", SOLID),
            "dimension": ("DIMENSIONS", "#000000", SOLID),
        },
        ("dimensions",),
        "svg",
    ),
    House(
        "Illustrator, layer Die Line",
        {
            "outer": ("Die Line", "#f15a22", SOLID),
            "crease": ("Die Line", "#f15a22", "DASHED"),
            "dimension": ("Labels", "#231f20", SOLID),
        },
        ("dimensions",),
        "svg",
        scale=72 / 25.4,
    ),
    House(
        "Illustrator, layers Cut, Crease, Bleed",
        {
            "outer": ("Cut", "#ec008c", SOLID),
            "crease": ("Crease", "#00aeef", SOLID),
            "bleed": ("Bleed", "#00a651", SOLID),
            "safety": ("Safety", "#fff200", SOLID),
            "glue": ("Glue Area", "#8dc63f", SOLID),
            "dimension": ("Notes", "#000000", SOLID),
        },
        ("bleed", "safety", "glue", "legend"),
        "svg",
        scale=72 / 25.4,
    ),
    House(
        "Illustrator, colours only",
        {
            "outer": ("", "#ed1c24", SOLID),
            "crease": ("", "#2e3192", SOLID),
            "bleed": ("", "#00a651", SOLID),
            "dimension": ("", "#231f20", SOLID),
        },
        ("bleed", "dimensions"),
        "svg",
        scale=72 / 25.4,
    ),
    House(
        "Illustrator, all black",
        {
            "outer": ("", "#000000", SOLID),
            "crease": ("", "#000000", SOLID),
            "dimension": ("", "#000000", SOLID),
        },
        (),
        "svg px",
        scale=72 / 25.4,
    ),
    House(
        "Inkscape, layers",
        {
            "outer": ("Cut Lines", "#1a2cb0", SOLID),
            "crease": ("Crease Lines", "#ff0000", SOLID),
            "dimension": ("Dimensions", "#000000", SOLID),
        },
        ("dimensions",),
        "inkscape",
        scale=96 / 25.4,
    ),
    House(
        "templatemaker.nl",
        {
            "outer": ("", "#0000ff", SOLID),
            "crease": ("", "#ff0000", "DASHED"),
            "dimension": ("", "#00ff00", SOLID),
        },
        (),
        "svg",
    ),
    House(
        "Pacdora",
        {
            "outer": ("cut", "#1a73e8", SOLID),
            "crease": ("crease", "#ea4335", "DASHED"),
            "bleed": ("bleed", "#34a853", SOLID),
            "dimension": ("annotation", "#000000", SOLID),
        },
        ("bleed", "dimensions"),
        "svg",
    ),
    House(
        "Cricut",
        {
            "outer": ("", "#000000", SOLID),
            "crease": ("", "#9b9b9b", SOLID),
            "dimension": ("", "#000000", SOLID),
        },
        (),
        "svg",
    ),
    House("Unit left out, inches", _named("CUT", "CREASE"), header=None, scale=1 / 25.4),
    House("Unit says inches, millimetres drawn", _named("CUT", "CREASE"), header=1),
    House("Unit says metres, millimetres drawn", _named("CUT", "CREASE"), header=6),
)
