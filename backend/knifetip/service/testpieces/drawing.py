"""Draw test pieces for requests: as a file that is stored like an upload, and as a picture."""

from __future__ import annotations

import numpy as np

from knifetip.errors import PieceRefused
from knifetip.library.definition import Shelf, parse_toml
from knifetip.presentation.picture import svg_edges
from knifetip.service.components import Service
from knifetip.service.processes import testpiece_tasks
from knifetip.service.testpieces.arrows import with_arrows
from knifetip.service.testpieces.models import BenchQuery, FiguresIn, PieceIn
from knifetip.testpieces.piece import Piece
from knifetip.testpieces.registry import wizard_of
from knifetip.testpieces.squareness import with_pulses
from knifetip.testpieces.wizard import Bench, Figure


def bench_of(service: Service, asked: BenchQuery | PieceIn | FiguresIn) -> Bench:
    """Return the machine, the board and the station of a request.

    Raises
    ------
    LibraryError
        There is no such machine or board.
    PieceRefused
        The machine has no such station.
    """
    machine = service.store.library.machine(asked.machine)
    board = service.store.library.board(asked.board)
    for station in machine.stations:
        if station.number == asked.station:
            return Bench(machine, board, station)
    raise PieceRefused(
        "testpiece.unknown-station",
        machine=machine.title,
        station=asked.station,
        source=("station",),
    )


def draw_piece(service: Service, order: PieceIn) -> tuple[Piece, bytes]:
    """Return a test piece and its DXF file, drawn in a worker process.

    Raises
    ------
    LibraryError
        There is no such machine, board or test piece.
    PieceRefused
        The station cannot make the piece in the board.
    """
    piece = wizard_of(order.code).draw(bench_of(service, order))
    content: bytes = service.run(testpiece_tasks.write_piece, piece)
    return piece, content


def piece_name(order: PieceIn) -> str:
    """Return the file name of a test piece: its code, machine, station and board."""
    return f"{order.code} {order.machine} T{order.station} {order.board}.dxf"


def piece_picture(service: Service, code: str, query: BenchQuery) -> str:
    """Return a picture of a test piece as SVG, with the dimensions that are measured.

    For the errors see ``draw_piece``.
    """
    piece = wizard_of(code).draw(bench_of(service, query))
    bulge = np.zeros(len(piece.lines))
    return with_arrows(svg_edges(piece.ends, bulge, piece.line_type), piece)


def piece_figures(service: Service, order: FiguresIn) -> list[Figure]:
    """Return the settings that follow from the measures of a test piece.

    Raises
    ------
    LibraryError
        There is no such machine or board.
    PieceRefused
        The station cannot make the piece in the board, or a measure is not plausible.
    """
    bench = bench_of(service, order)
    wizard = wizard_of(order.measures.code)
    wizard.draw(bench)  # raises an error if the piece does not belong to the station
    figures = list(wizard.figures(bench, order.measures))
    definition = service.store.library.definition(Shelf.MACHINES, order.machine)
    fields = parse_toml(definition.shelf, definition.name, definition.toml)
    pulses = fields.get("controller", {}).get("pulses")
    return with_pulses(figures, pulses) if isinstance(pulses, dict) else figures
