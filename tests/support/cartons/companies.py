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
class Company:
    """The conventions of one company for drawing cartons."""

    name: str
    styles: Mapping[str, Style]
    surroundings: tuple[str, ...] = ()  #: keys of ``SURROUNDINGS``: annotations around the carton
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


def _styles_by_layer(
    cut: str, crease: str, perf: str = "", half: str = "", dimension: str = ""
) -> dict[str, Style]:
    """Return styles with one layer per line type (all in colour 7), by the name of the part.

    ``dimension`` is the layer of dimensions.  Omitted layers default to that of a similar line
    type.
    """
    styles: dict[str, Style] = {"outer": (cut, 7, SOLID), "crease": (crease, 7, SOLID)}
    styles["perforation"] = (perf or crease, 7, SOLID)
    styles["half-cut"] = (half or perf or crease, 7, SOLID)
    styles["dimension"] = (dimension or cut, 7, SOLID)
    return styles


def _styles_by_colour(layer: str, *colours: object, linetype: str = SOLID) -> dict[str, Style]:
    """Return styles on one layer with one colour per line type, by the name of the part.

    The colours are those of cuts, creases, perforations, half-cuts and dimensions; the last one
    given is repeated for the missing ones.  ``linetype`` is that of creases.
    """
    parts = ("outer", "crease", "perforation", "half-cut", "dimension")
    padded = [*colours, *[colours[-1]] * (5 - len(colours))]
    styles: dict[str, Style] = {
        part: (layer, colour, SOLID) for part, colour in zip(parts, padded, strict=True)
    }
    styles["crease"] = (layer, padded[1], linetype)
    return styles


_ALL = ("dimensions", "frame", "marks", "legend", "grain")
_ARTIOS = {
    "outer": ("Design", 1, SOLID), "crease": ("Design", 2, SOLID),
    "grain": ("Design", 10, SOLID), "dimension": ("Annotation", 20, SOLID),
    "perforation": ("Design", 3, SOLID), "half-cut": ("Design", 4, SOLID),
}  # fmt: skip

COMPANIES: tuple[Company, ...] = (
    Company("ArtiosCAD, layer Design", _ARTIOS, ("dimensions", "grain"), header=None),
    Company("ArtiosCAD, inches", _ARTIOS, ("dimensions",), header=None, scale=1 / 25.4),
    Company(
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
    Company(
        "Main Design layers",
        _styles_by_layer(
            "Main Design Cut",
            "Main Design Crease",
            "Main Design Perf",
            "Main Design Partial Cut",
            "Annotation",
        ),
        ("dimensions",),
    ),
    Company(
        "EngView",
        _styles_by_layer("Knife", "Bend", "Perforation", "Half Cut", "Dimensions"),
        ("dimensions",),
    ),
    Company(
        "Kongsberg",
        _styles_by_layer("Thru-cut", "Crease", "Perf", "Kiss-cut", "Reference"),
        ("marks",),
    ),
    Company(
        "Zünd, English",
        _styles_by_layer("Thru-Cut", "Crease", "Perforate", "Kiss-Cut", "Regmark"),
        ("marks",),
    ),
    Company(
        "Zünd, German",
        _styles_by_layer("Durchschnitt", "Rillen", "Perforieren", "Anschnitt", "Register"),
        ("marks",),
    ),
    Company(
        "Prime Center",
        {
            **_styles_by_layer("Die-Cut", "Creasing", "Perforating", "Halfcut", "Text"),
            "bleed": ("Bleed", 3, SOLID),
        },
        ("bleed", "legend"),
    ),
    Company(
        "Prinect",
        _styles_by_layer("Stanzen", "Rillen", "Perforieren", "Ritzen", "Bemaßung"),
        ("dimensions",),
    ),
    Company(
        "German, words",
        _styles_by_layer("Außenkontur Schnitt", "Rilllinien", "Perfo", "Ritzen", "Hilfslinien"),
        _ALL,
    ),
    Company(
        "French, words",
        _styles_by_layer("Coupe", "Rainage", "Perforation", "Mi-chair", "Cotation"),
        _ALL,
    ),
    Company(
        "French, filets",
        _styles_by_layer(
            "Filets coupants", "Filets raineurs", "Filets perfo", "Mi-coupe", "Habillage"
        ),
        ("dimensions",),
    ),
    Company(
        "Italian, words",
        _styles_by_layer("Taglio", "Cordone", "Perforazione", "Mezzo taglio", "Quote"),
        _ALL,
    ),
    Company(
        "Italian, fustella",
        _styles_by_layer(
            "Fustella Taglio", "Fustella Cordone", "Fustella Strappo", "Mezzotaglio", "Testi"
        ),
        (),
    ),
    Company(
        "Spanish, words",
        _styles_by_layer("Corte", "Hendido", "Perforado", "Medio corte", "Cotas"),
        _ALL,
    ),
    Company(
        "Spanish, dobleces",
        _styles_by_layer("CORTE", "DOBLEZ", "PUNTEADO", "MEDIO CORTE", "ACOTADO"),
        ("dimensions",),
    ),
    Company(
        "Portuguese, words",
        _styles_by_layer("Faca corte", "Vinco", "Picote", "Meio corte", "Cotas"),
        (),
    ),
    Company(
        "Polish, words",
        _styles_by_layer("Cięcie", "Bigowanie", "Perforacja", "Nadcięcie", "Wymiary"),
        _ALL,
    ),
    Company("Czech, words", _styles_by_layer("Řez", "Rylování", "Perforace", "Nářez", "Kóty"), ()),
    Company(
        "Russian, words",
        _styles_by_layer("Рез", "Биговка", "Перфорация", "Надсечка", "Размеры"),
        _ALL,
    ),
    Company(
        "Ukrainian, words",
        _styles_by_layer("Різ", "Біговка", "Перфорація", "Надсічка", "Розміри"),
        (),
    ),
    Company(
        "Turkish, words",
        _styles_by_layer("Bıçak", "Pilyaj", "Perforaj", "Yarım kesim", "Ölçü"),
        _ALL,
    ),
    Company("Chinese, words", _styles_by_layer("刀线", "压线", "齿刀线", "半刀线", "尺寸"), _ALL),
    Company(
        "Chinese, traditional", _styles_by_layer("刀模線", "壓線", "齒線", "半斷線", "標註"), ()
    ),
    Company(
        "Japanese, words",
        _styles_by_layer("カット線", "折り線", "ミシン目", "ハーフカット", "寸法"),
        _ALL,
    ),
    Company("Japanese, trade", _styles_by_layer("抜き型", "罫線", "ミシン", "半抜き", "注記"), ()),
    Company("Korean, words", _styles_by_layer("칼선", "접는선", "미싱선", "반칼", "치수"), _ALL),
    Company(
        "Vietnamese, words",
        _styles_by_layer("Đường cắt", "Đường cấn", "Đường răng cưa", "Cắt nửa", "Kích thước"),
        (),
    ),
    Company(
        "Dutch, words",
        _styles_by_layer("Snijlijn", "Rillijn", "Perforatie", "Halfsnede", "Maatvoering"),
        (),
    ),
    Company(
        "Swedish, words", _styles_by_layer("Stans", "Bigg", "Perforering", "Halvstans", "Mått"), ()
    ),
    Company(
        "Hungarian, words",
        _styles_by_layer("Vágás", "Bígelés", "Perforálás", "Félvágás", "Méret"),
        (),
    ),
    Company("Arabic, words", _styles_by_layer("قص", "طي", "تخريم", "نصف قص", "أبعاد"), ()),
    Company(
        "Greek, words",
        _styles_by_layer("Κοπή", "Πίκμανση", "Διάτρηση", "Μισοκοπή", "Διαστάσεις"),
        (),
    ),
    Company(
        "SolidWorks sheet metal",
        _styles_by_layer("OUTER_PROFILES", "BEND_LINES", "", "", "NOTES"),
        (),
    ),
    Company(
        "Fusion 360 sheet metal",
        _styles_by_layer("OUTER_PROFILES", "BEND", "", "", "BEND_EXTENT"),
        (),
    ),
    Company(
        "Rhino",
        {
            "outer": ("Cut", "#ff0000", SOLID),
            "crease": ("Fold", "#0000ff", SOLID),
            "dimension": ("Annotations", "#000000", SOLID),
        },
        ("dimensions", "grain"),
    ),
    Company(
        "One layer, red cut, blue dashed crease",
        _styles_by_colour("0", 1, 5, 6, 4, 3, linetype="DASHED"),
        ("dimensions",),
    ),
    Company(
        "One layer, red cut, green crease",
        _styles_by_colour("0", 1, 3, 2, 5, 7),
        ("dimensions", "marks"),
    ),
    Company(
        "One layer, black cut, red crease", _styles_by_colour("0", 7, 1, 3, 4, 8), ("dimensions",)
    ),
    Company("One layer, green cut, red crease", _styles_by_colour("Layer 1", 3, 1, 5, 6, 7), ()),
    Company(
        "One layer, magenta cut, cyan dashed crease",
        _styles_by_colour("0", 6, 4, 1, 2, 8, linetype="DASHED"),
        (),
    ),
    Company("One layer, blue cut, red crease", _styles_by_colour("0", 5, 1, 3, 4, 7), ("legend",)),
    Company(
        "One layer, all black, dashed creases",
        _styles_by_colour("0", 7, 7, 7, 7, 7, linetype="DASHED"),
        (),
    ),
    Company("One layer, all black", _styles_by_colour("0", 7), ()),
    Company("One layer, all black, dimensions", _styles_by_colour("0", 7), ("dimensions",)),
    Company(
        "One layer, all black, dimensions and frame",
        _styles_by_colour("0", 7),
        ("dimensions", "frame"),
    ),
    Company("One layer, all black, in pieces", _styles_by_colour("0", 7), flaws=("pieces", "gaps")),
    Company("One layer, all black, dashes drawn", _styles_by_colour("0", 7), flaws=("dashes",)),
    Company(
        "One layer, all black, short creases", _styles_by_colour("0", 7), flaws=("short creases",)
    ),
    Company(
        "One layer, all black, inner dimensions", _styles_by_colour("0", 7), ("inner dimensions",)
    ),
    Company("One layer, all black, letters", _styles_by_colour("0", 7), ("letters",)),
    Company("One layer, all black, bleed", _styles_by_colour("0", 7), ("bleed",)),
    Company("One layer, all black, three-up", _styles_by_colour("0", 7), ("three-up",)),
    Company("One layer, all black, six-up", _styles_by_colour("0", 7), ("six-up",)),
    Company(
        "Two colours, bleed in a third",
        {**_styles_by_colour("0", 1, 5, 5, 5, 8), "bleed": ("0", 3, SOLID)},
        ("bleed",),
    ),
    Company(
        "Layers CUT and CREASE, everything else on CUT",
        _styles_by_layer("CUT", "CREASE"),
        ("dimensions", "frame", "legend", "marks"),
    ),
    Company(
        "Layers CUT and CREASE, letters and grain on CUT",
        _styles_by_layer("CUT", "CREASE"),
        ("letters", "grain"),
    ),
    Company("Layers CUT and CREASE, bleed on CUT", _styles_by_layer("CUT", "CREASE"), ("bleed",)),
    Company("Layers CUT and CREASE, six-up", _styles_by_layer("CUT", "CREASE"), ("six-up",)),
    Company(
        "Layers CUT and CREASE, careless",
        _styles_by_layer("CUT", "CREASE"),
        (),
        flaws=("pieces", "doubles", "gaps"),
    ),
    Company(
        "Layers CUT and CREASE, one decimal",
        _styles_by_layer("CUT", "CREASE"),
        (),
        flaws=("rounded", "doubles"),
    ),
    Company(
        "Layers CUT and CREASE, inner dimensions on CREASE",
        {**_styles_by_layer("CUT", "CREASE"), "dimension": ("CREASE", 7, SOLID)},
        ("inner dimensions",),
    ),
    Company("Layers numbered 1 and 2", _styles_by_layer("1", "2", "3", "4", "5"), ("dimensions",)),
    Company(
        "Layers named after colours",
        _styles_by_layer("Red", "Blue", "Green", "Cyan", "Black"),
        ("dimensions",),
    ),
    Company(
        "Layers CUT, SCORE, DIMENSION, TITLE",
        {
            "outer": ("CUT", 1, SOLID),
            "crease": ("SCORE", 5, SOLID),
            "dimension": ("DIMENSION", 3, SOLID),
            "frame": ("TITLE", 7, SOLID),
        },
        ("dimensions", "frame"),
    ),
    Company(
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
    Company(
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
    Company(
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
    Company(
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
    Company(
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
    Company(
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
    Company(
        "templatemaker.nl",
        {
            "outer": ("", "#0000ff", SOLID),
            "crease": ("", "#ff0000", "DASHED"),
            "dimension": ("", "#00ff00", SOLID),
        },
        (),
        "svg",
    ),
    Company(
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
    Company(
        "Cricut",
        {
            "outer": ("", "#000000", SOLID),
            "crease": ("", "#9b9b9b", SOLID),
            "dimension": ("", "#000000", SOLID),
        },
        (),
        "svg",
    ),
    Company(
        "Unit left out, inches", _styles_by_layer("CUT", "CREASE"), header=None, scale=1 / 25.4
    ),
    Company("Header in inches, millimetres drawn", _styles_by_layer("CUT", "CREASE"), header=1),
    Company("Header in metres, millimetres drawn", _styles_by_layer("CUT", "CREASE"), header=6),
)
