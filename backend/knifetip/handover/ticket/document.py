"""document: lay a job ticket out on pages of A4 and write them as PDF."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Final

import numpy as np
from fpdf import FPDF
from fpdf.enums import XPos, YPos
from fpdf.fonts import FontFace

from knifetip.handover.pdf import Frame, draw_figure, draw_sample
from knifetip.handover.ticket.facts import TicketFacts
from knifetip.handover.ticket.fonts import FAMILY, TicketFonts
from knifetip.handover.ticket.qr import draw_qr
from knifetip.handover.ticket.sentences import Sentences, time_text
from knifetip.model.figure import Figure, FigureLayer

# Lengths in mm.
_MARGIN: Final = 12.0
_WIDTH: Final = 210.0 - 2.0 * _MARGIN
_QR: Final = 34.0
_TITLES: Final = 34.0
_PICTURE: Final = 88.0
_LINE: Final = 4.6
_SIZE: Final = 9.0  # of letters (pt)
_SMALL: Final = 7.5
#: Most lines and arcs of the picture; the shortest of further ones are left out.
_MOST_EDGES: Final = 20_000
_HEADINGS: Final = ("ticket.station", "ticket.tool", "ticket.length", "ticket.time")
#: Share of the width of each column of the table of stations.
_COLUMNS: Final = (40, 84, 38, 24)
#: Replaced by the number of pages when the file is written; no name contains it.
_PAGES: Final = "◊◊"
_GREY: Final = (110, 110, 110)


class _Page(FPDF):
    """The pages of a ticket, with a line at the foot of each."""

    def __init__(self, foot: Sequence[str]) -> None:
        super().__init__(unit="mm", format="A4")
        self.foot = foot  #: texts at the left and at the right

    def footer(self) -> None:
        """Write the foot of a page; fpdf calls it."""
        self.set_y(-_MARGIN)
        self.set_font(FAMILY, "", _SMALL)
        self.set_text_color(*_GREY)
        left, right = self.foot
        self.cell(_WIDTH / 2.0, 4.0, left)
        self.cell(
            _WIDTH / 2.0,
            4.0,
            right.replace("{page}", str(self.page_no())),
            align="R",
        )
        self.set_text_color(0, 0, 0)


def write_ticket(
    facts: TicketFacts, picture: Figure, language: str, fonts: Sequence[str] = ()
) -> bytes:
    """Return the job ticket of a job as PDF.

    Parameters
    ----------
    picture
        The drawing, in layers of line types.
    language
        Tag of the language.
    fonts
        Files of further fonts, see ``TicketFonts``.
    """
    return _Ticket(facts, language, fonts).write(picture)


class _Ticket:
    def __init__(self, facts: TicketFacts, language: str, fonts: Sequence[str]) -> None:
        self._facts = facts
        self._say = Sentences(facts, language)
        page = self._say.word(
            "ticket.page", at=time_text(facts.printed), page="{page}", pages=_PAGES
        )
        self._pdf = _Page((self._say.word("ticket.job", job=facts.job), page))
        self._fonts = TicketFonts(self._pdf, fonts)
        self._pdf.alias_nb_pages(_PAGES)
        self._pdf.set_margin(_MARGIN)
        self._pdf.c_margin = 0.0
        self._pdf.set_auto_page_break(True, _MARGIN + 6.0)
        self._pdf.set_title(
            self._clean(f"{self._say.word('ticket.title')} {facts.order or facts.job}")
        )
        self._pdf.set_lang(language)
        self._pdf.set_creation_date(datetime.fromtimestamp(max(facts.printed, 0.0), UTC))

    def write(self, picture: Figure) -> bytes:
        """Lay out all parts of the ticket and return the file."""
        self._pdf.add_page()
        self._head()
        self._picture(picture)
        self._stations()
        self._text(
            self._say.verdict(), title=self._say.word("ticket.verdict"), bold=not self._say.is_ready
        )
        accepted = self._say.accepted()
        if accepted:
            self._text("\n".join(accepted), title=self._say.word("ticket.accepted"))
        if self._facts.notes:
            self._text(self._facts.notes, title=self._say.word("ticket.notes"))
        if self._fonts.has_boxes:
            self._pdf.set_text_color(*_GREY)
            self._text(self._say.word("ticket.boxes"))
        return bytes(self._pdf.output())

    def _clean(self, text: str) -> str:
        return self._fonts.printable(text)

    def _head(self) -> None:
        """Write title and facts, with the QR code at their right."""
        pdf, facts = self._pdf, self._facts
        left = 210.0 - _MARGIN - _QR
        draw_qr(pdf, facts.address, Frame(left, _MARGIN, _QR, _QR))
        pdf.set_font(FAMILY, "", _SMALL)
        pdf.set_xy(left, _MARGIN + _QR - 2.0)
        pdf.cell(_QR, 4.0, self._say.word("ticket.scan"), align="C", link=facts.address)
        pdf.set_xy(_MARGIN, _MARGIN)
        pdf.set_font(FAMILY, "B", 16)
        pdf.cell(0, 8.0, self._say.word("ticket.title"), new_x=XPos.LMARGIN, new_y=YPos.NEXT)
        pdf.ln(1.0)
        beside = _WIDTH - _QR - 4.0 - _TITLES
        for number, (title, text) in enumerate(self._say.rows()):
            pdf.set_font(FAMILY, "", _SIZE)
            pdf.set_text_color(*_GREY)
            pdf.cell(_TITLES, _LINE, title)
            pdf.set_text_color(0, 0, 0)
            # The first rows are those by which a person finds the job.
            pdf.set_font(FAMILY, "B" if number < 3 else "", _SIZE + (1.0 if number < 3 else 0.0))
            self._lines(text, beside)
        pdf.set_y(max(pdf.get_y(), _MARGIN + _QR + 3.0))

    def _lines(self, text: str, width: float) -> None:
        """Write a text in lines of a width, and go to the left margin of the next line."""
        self._pdf.multi_cell(
            width, _LINE, self._clean(text), align="L", new_x=XPos.LMARGIN, new_y=YPos.NEXT
        )

    def _picture(self, picture: Figure) -> None:
        """Draw the drawing in its frame, and a sample of each kind of line below."""
        pdf = self._pdf
        pdf.ln(1.5)
        top = pdf.get_y()
        pdf.set_draw_color(200, 200, 200)
        pdf.set_line_width(0.2)
        pdf.rect(_MARGIN, top, _WIDTH, _PICTURE)
        inside = Frame(_MARGIN + 4.0, top + 4.0, _WIDTH - 8.0, _PICTURE - 8.0)
        if picture.edge_count:
            draw_figure(pdf, self._on_sheet(picture.longest(_MOST_EDGES)), inside)
        pdf.set_y(top + _PICTURE + 2.0)
        if self._facts.lengths:
            self._legend(picture)

    def _on_sheet(self, picture: Figure) -> Figure:
        """Return the drawing with the edges of its sheet, if the size of the sheet is given."""
        if self._facts.sheet is None:
            return picture
        x, y = (picture.box[0] - self._facts.margins).tolist()
        width, height = self._facts.sheet
        corners = np.array([(x, y), (x + width, y), (x + width, y + height), (x, y + height)])
        ends = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
        sheet = FigureLayer("SHEET", "#8a919c", 8, (), ends, np.zeros(4))
        return picture._replace(layers=(sheet, *picture.layers))

    def _legend(self, picture: Figure) -> None:
        """Write the length of each line type behind a sample of its line, in one or more rows."""
        pdf = self._pdf
        self._title(self._say.word("ticket.lengths"))
        pdf.set_font(FAMILY, "", _SIZE)
        looks = {layer.name: layer for layer in picture.layers}
        for name, text in self._say.line_types():
            width = pdf.get_string_width(text) + 6.0
            if pdf.get_x() + 14.0 + width > 210.0 - _MARGIN:
                pdf.ln(_LINE)
            x, y = pdf.get_x(), pdf.get_y() + _LINE / 2.0
            if name in looks:
                draw_sample(pdf, looks[name], Frame(x, y, 12.0, 0.0))
            pdf.set_x(x + 14.0)
            pdf.cell(width, _LINE, text)
        pdf.ln(_LINE)

    def _text(self, text: str, *, title: str = "", bold: bool = False) -> None:
        """Write a paragraph below a title."""
        pdf = self._pdf
        if title:
            self._title(title)
        pdf.set_font(FAMILY, "B" if bold else "", _SIZE)
        self._lines(text, _WIDTH)

    def _title(self, title: str) -> None:
        pdf = self._pdf
        pdf.ln(1.5)
        if pdf.will_page_break(3.0 * _LINE):
            pdf.add_page()
        pdf.set_font(FAMILY, "B", _SIZE)
        pdf.cell(0, _LINE + 0.4, title, new_x=XPos.LMARGIN, new_y=YPos.NEXT)

    def _stations(self) -> None:
        """Write the table of the stations whose tools must be loaded."""
        facts, pdf = self._facts, self._pdf
        if not facts.stations:
            return
        self._title(self._say.word("ticket.stations"))
        pdf.set_font(FAMILY, "", _SIZE)
        pdf.set_draw_color(200, 200, 200)
        titles = [self._say.word(code) for code in _HEADINGS]
        with pdf.table(
            col_widths=_COLUMNS,
            line_height=_LINE,
            text_align=("LEFT", "LEFT", "RIGHT", "RIGHT"),
            headings_style=FontFace(emphasis="BOLD"),
            borders_layout="HORIZONTAL_LINES",
            padding=0.4,
        ) as table:
            table.row(titles)
            for use in facts.stations:
                table.row([self._clean(one) for one in self._say.station(use)])
