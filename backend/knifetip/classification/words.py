"""words: what the name of a layer says in the languages of those who draw cartons.

    "Schnitt außen", "Línea de hendido", "no cut" -> Hint

A name is read word by word, never letter by letter: ``SCHNITTKANTEN`` is no ``Schnitt``, ``Cutout``
no ``cut``, ``Faltmarken`` no fold.  A word that denies takes the meaning away, two words that
contradict each other leave none.  Chinese, Japanese and Korean have no spaces, and are searched.

A hint decides nothing by itself: rules of profiles do.  It is one witness, the shape another.
"""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from functools import lru_cache

from knifetip.model.dieline import LineType

#: Parts of the names of dashed line styles, and of those that draw centre lines; folded.
DASHED = ("dash", "hidden", "dot", "strich", "pointill", "tratt", "trazo", "kesik", "штрих")
CENTRE_LINE = ("center", "centre", "phantom", "mitte", "axe", "eje", "asse")

#: Words by what they mean; folded, without accents.
_WORDS: dict[LineType, str] = {
    LineType.CUT: """
        cut cuts cutting cutline cutlines diecut diecutting trim trimming knife blade thrucut
        throughcut outline contour perimeter slit slits slot slots
        schnitt schnitte schneiden schneidlinie schneidlinien stanzkontur stanzung stanzen
        stanzlinie stanzlinien kontur aussenkontur innenkontur umriss messer messerlinie
        coupe coupes couper coupant decoupe decoupes decoupage contours filet
        taglio tagli tagliente tagliare contorno contorni fustella
        corte cortes cortar troquel troquelado cuchilla faca facas recorte
        snijlijn snijlijnen snij snijden stanslijn stans stansmes
        ciecie ciecia wykroj wykrojnik noz noze
        kesim kesme kesik bicak bicaklar
        рез резка резы вырубка высечка нож ножи рубка рубки контур
        rez rezy rezani vysek vyseky nuz noze orez
        skar skarlinje stanslinje skaering leikkaus taiere vagas stans
        stanzen stanzform durchschnitt aussenschnitt innenschnitt
        різ різання висічка ніж rezanje rezanie κοπη κοψιμο قص قطع duongcat netcat coupants
        outerprofile outerprofiles interiorprofile interiorprofiles
    """,
    LineType.CREASE: """
        crease creases creasing creaseline creaselines fold folds folding foldline foldlines score
        scores scoring scoreline scorelines bend bends bending valley mountain hinge hinges joints
        rill rille rillen rillung rillungen rilllinie rilllinien rillinie rillinien ritzrill falz
        falze falzlinie falzlinien faltlinie faltlinien biegelinie biegelinien biegung
        rainant rainage rainages rainure rainures pli plis pliage pliure refoulage refoulages
        cordonatura cordonature cordone cordoni cordonatore piega pieghe piegatura
        hendido hendidos hendedura plegado pliegue pliegues doblez dobleces
        vinco vincos vincagem dobra dobras
        ril rillen rillijn rillijnen vouw vouwen vouwlijn vouwlijnen
        big bigi bigowanie bigowka bigowe zagiecie zagiecia przegniatanie
        pilyaj piliaj rilye katlama katlanma kirim
        биг биги биговка биговки сгиб сгибы фальц фальцовка линиясгиба
        ohyb ohyby ryl ryly rylovani bigovani bigovany
        bigning bigg biglinje vik viklinje bukkelinje nuuttaus biegeles bigeles hajtas cre
        doblado raineur raineurs
        біг біговка біги згин згини фальцювання πικμανση διπλωμα τσακιση طي ثني تكسير
        duongcan netcan duonggap
    """,
    LineType.PERFORATION: """
        perf perfs perfo perforation perforations perforated perforating perforate zipper tearline
        tearstrip tear perfolinie perforationslinie perforierung perforiert aufreissfaden
        aufreisslinie abriss perforazione perforazioni strappo perforado perforacion perforacao
        picote picotage perforatie perforacja perforacje perforace perforasyon perforaj perfore
        перфорация перфорации perforering perforate perforieren perforalas перфорація
        διατρηση تخريم duongrang
    """,
    LineType.HALF_CUT: """
        half kiss partial halfcut halfcuts kisscut kisscuts partialcut michair halbschnitt anritzen
        anritzung anritz ritzlinie ritzlinien mezzotaglio mediocorte meiocorte nadciecie
        nadciecia yarimkesim надсечка надсечки просечка narez надсічка підсічка halfsnede halvstans
        felvagas catnua μισοκοπη anschnitt anstanzen micoupe pcut ritzen
    """,
    LineType.V_GROOVE: """
        groove grooves grooving vgroove vgrooves vcut vcuts vgrooving vnut vnuten
    """,
    LineType.COMBI: """
        combi kombi combination combinations cutcrease perfcrease perfocrease kombination
    """,
    LineType.IGNORED: """
        dim dims dimension dimensions dimensioning text texts note notes label labels info title
        titleblock frame border axis axes center centre centerline construction defpoints legend
        annotation annotations comment comments bleed glue gluearea artwork image images print
        printing graphic graphics registration crop cropmarks watermark viewport viewports hatch
        engrave engraving engraved etch etching grid guide guides reference regmark regmarks
        register regmarken safety safezone margin margins grain fluting corrugation
        arrow arrows habillage
        bemassung bemassungen masse masslinie masslinien beschriftung beschriftungen rahmen
        zeichnungsrahmen schriftfeld hilfslinie hilfslinien achse achsen mittellinie schraffur
        klebung kleber leim druck beschnitt passer
        cotation cotations cote cotes texte textes cadre cartouche axe collage impression repere
        quota quote quotatura quotature testo testi cornice cartiglio asse assi stampa colla
        cota cotas acotacion acotado texto textos marco cajetin eje ejes moldura legenda impresion
        maat maten maatvoering tekst teksten kader as lijm druk
        wymiar wymiary wymiarowanie opis opisy ramka os osie klej druk
        olcu olculer olculendirme yazi yazilar cerceve metin eksen eksenler tutkal baski
        размер размеры текст тексты рамка ось оси осевая клей печать надпись надписи
        kota koty kotovani popis popisy ramecek lepidlo tisk
        розміри размерные текст розмір kichthuoc matt mattsattning meret meretek szoveg
        διαστασεισ διασταση ابعاد نص acotado bendextent bendextents
    """,
}
#: Words that take the meaning away, and words of other trades that only look like ours.
_DENIALS = frozenset(
    word
    for line in """
    no not non none nicht kein keine ohne sans pas senza sin sem nao geen niet bez nie degil yok
    не нет без unused old alt hidden off
    section sections sectional wall walls elevation plan door doors window windows
    schnittkanten schnittkante schnittlinien schnittlinie schnittebene schnittansicht schnittflache
    faltmarken faltmarke cutout cutouts uncut shortcut cutaway cutplane
    """.splitlines()
    for word in line.split()
)
#: Words for the whole die: what is said beside them is meant, as in "Fustella Cordone".
_DIES = frozenset(
    ("die", "dieline", "fustella", "troquel", "stanzform", "stanze", "stanz", "faca", "forme")
)
#: Halves of two-word names: the first makes another thing of the second.
_BEFORE_CUT: dict[str, LineType] = {
    **dict.fromkeys(
        ("half", "kiss", "partial", "mezzo", "mezza", "medio", "meio", "halb", "yarim", "demi"),
        LineType.HALF_CUT,
    ),
    **dict.fromkeys(
        ("mi", "pol", "نصف"),
        LineType.HALF_CUT,
    ),
    "v": LineType.V_GROOVE,
    "perf": LineType.PERFORATION,
    "perfo": LineType.PERFORATION,
}
_SIGNS: tuple[tuple[str, LineType], ...] = (
    ("ハーフカット", LineType.HALF_CUT),
    ("半抜", LineType.HALF_CUT),
    ("半斷", LineType.HALF_CUT),
    ("반칼", LineType.HALF_CUT),
    ("半刀", LineType.HALF_CUT),
    ("半切", LineType.HALF_CUT),
    ("半断", LineType.HALF_CUT),
    ("v槽", LineType.V_GROOVE),
    ("齿刀", LineType.PERFORATION),
    ("齿线", LineType.PERFORATION),
    ("撕裂线", LineType.PERFORATION),
    ("齒線", LineType.PERFORATION),
    ("ミシン", LineType.PERFORATION),
    ("미싱", LineType.PERFORATION),
    ("压痕", LineType.CREASE),
    ("壓痕", LineType.CREASE),
    ("压线", LineType.CREASE),
    ("折线", LineType.CREASE),
    ("折痕", LineType.CREASE),
    ("罫線", LineType.CREASE),
    ("折り", LineType.CREASE),
    ("오시", LineType.CREASE),
    ("괘선", LineType.CREASE),
    ("접는선", LineType.CREASE),
    ("접음", LineType.CREASE),
    ("壓線", LineType.CREASE),
    ("刀线", LineType.CUT),
    ("模切", LineType.CUT),
    ("裁切", LineType.CUT),
    ("切割", LineType.CUT),
    ("切线", LineType.CUT),
    ("刀線", LineType.CUT),
    ("刀模", LineType.CUT),
    ("抜き", LineType.CUT),
    ("カット", LineType.CUT),
    ("切断", LineType.CUT),
    ("칼선", LineType.CUT),
    ("재단", LineType.CUT),
    ("尺寸", LineType.IGNORED),
    ("标注", LineType.IGNORED),
    ("文字", LineType.IGNORED),
    ("图框", LineType.IGNORED),
    ("标题", LineType.IGNORED),
    ("寸法", LineType.IGNORED),
    ("注記", LineType.IGNORED),
    ("標註", LineType.IGNORED),
    ("尺碼", LineType.IGNORED),
    ("치수", LineType.IGNORED),
)
_DENYING_SIGNS = ("不", "非", "无", "無")
_NOTHING = frozenset(
    word
    for line in """
    layer layers default standard design drafting drawing drawings sheet model group path shape
    shapes visible object objects entity entities geometry unnamed untitled none main lines line
    ebene ebenen zeichnung linie linien calque calques dessin ligne lignes livello livelli disegno
    linee capa capas dibujo linea lineas camada camadas desenho laag lagen tekening lijn lijnen
    warstwa warstwy rysunek linia linie katman katmanlar cizim cizgi слой слои чертеж линия линии
    vrstva vrstvy vykres cara cary svg dxf g svgfile a b c
    """.splitlines()
    for word in line.split()
)

_MEANING: dict[str, set[LineType]] = {}
for _kind, _listed in _WORDS.items():
    for _word in _listed.split():
        _MEANING.setdefault(_word, set()).add(_kind)

_CAMEL = re.compile(r"(?<=[a-zà-ÿ])(?=[A-ZÀ-Þ])")
_SPLIT = re.compile(r"[^\w]+|_+|\d+")
_LETTERS = str.maketrans({"ł": "l", "ı": "i", "ø": "o", "æ": "ae", "đ": "d", "œ": "oe"})


@dataclass(frozen=True, slots=True)
class Hint:
    """What a name says."""

    kind: LineType | None  #: None where it says nothing, or two things
    word: str  #: the part of the name that says it
    denied: bool  #: it holds a word that takes meaning away


@lru_cache(maxsize=4096)
def hint(name: str) -> Hint:
    """Return what the name of a layer says."""
    flat = name.casefold()
    for sign, kind in _SIGNS:
        if sign in flat:
            return Hint(kind, sign, any(sign in flat for sign in _DENYING_SIGNS))
    words = _read(name)
    found: dict[LineType, str] = {}
    skip = -1
    for place, word in enumerate(words):
        if place == skip:
            continue
        onward = words[place + 1] if place + 1 < len(words) else ""
        if word in _BEFORE_CUT and LineType.CUT in _MEANING.get(onward, ()):
            found[_BEFORE_CUT[word]] = f"{word} {onward}"
            skip = place + 1
            continue
        if word == "v" and onward in ("groove", "grooves", "nut", "nuten"):
            found[LineType.V_GROOVE] = f"{word} {onward}"
            skip = place + 1
            continue
        if onward and word + onward in _MEANING:
            found.update(dict.fromkeys(_MEANING[word + onward], f"{word} {onward}"))
            skip = place + 1
            continue
        for kind in _MEANING.get(word, ()):
            found.setdefault(kind, word)
    denied = any(word in _DENIALS for word in words)
    if len(found) > 1 and found.get(LineType.CUT) in _DIES:
        del found[LineType.CUT]
    kinds = set(found)
    if kinds == {LineType.CUT, LineType.CREASE} or kinds == {LineType.PERFORATION, LineType.CREASE}:
        return Hint(LineType.COMBI, " ".join(found.values()), denied)
    if len(kinds) == 2 and LineType.CUT in kinds:
        # What is cut in part is first of all in part.
        closer = kinds & {LineType.HALF_CUT, LineType.PERFORATION, LineType.V_GROOVE}
        kinds = closer or kinds
        found = {kind: found[kind] for kind in kinds}
    if len(kinds) != 1:
        return Hint(None, " ".join(found.values()), denied)
    ((kind, word),) = found.items()
    return Hint(kind, word, denied)


def meaningless(name: str) -> bool:
    """Return whether the name of a layer says nothing at all: ``0``, ``Layer 3``, ``Design``."""
    return all(word in _NOTHING for word in _read(name))


def _read(name: str) -> list[str]:
    """Return the words of a name, folded and without accents."""
    apart = _CAMEL.sub(" ", name)
    plain = unicodedata.normalize("NFKD", apart.casefold().translate(_LETTERS))
    bare = "".join(sign for sign in plain if not unicodedata.combining(sign))
    return [word for word in _SPLIT.split(bare.translate(_LETTERS)) if word]
