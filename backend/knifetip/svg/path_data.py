"""path_data: parse the path data of many paths into lines, cubic curves and elliptic arcs.

For example, "M0 0h10a5 5 0 0 1 5 5z" has three segments.  For each of the n segments, ``kind`` is
line, curve or arc, ``numbers`` (n, 8) contains its coordinates, and ``path`` is the index of its
path.

A kernel parses the bytes.  Relative coordinates become absolute; H, V, S, T and Z become explicit
lines and curves; quadratic curves become cubic ones.  A path is read up to the first error in its
data, as the SVG standard requires.

Source: Scalable Vector Graphics (SVG) 1.1, second edition, chapter 8.3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.drawing_builder.path_table import ARC, CUBIC, LINE, Table
from knifetip.geometry.columns import I64
from knifetip.kernels import F64_1, U8_1, OutF64_1, OutI64_1, inline_kernel, kernel

#: Count that ``_scan`` returns if the paths have too many segments.
_TOO_MANY: Final = -1


@dataclass(frozen=True, eq=False, slots=True)
class ScannedPaths(Table):
    """The segments of all paths, and the position of the first error in each path's data."""

    wrong: I64  #: (paths,) index of the first invalid character, -1 if none


def scan_paths(paths: Sequence[str], max_segments: int) -> ScannedPaths | None:
    """Return the segments of paths; None if there are more than ``max_segments`` segments.

    ``paths`` contains the path data of each path, such as "M0 0h10".
    """
    pieces = [path.encode("ascii", "replace") for path in paths]
    size = np.array([0, *(len(piece) for piece in pieces)], np.int64)
    data = np.frombuffer(b"".join(pieces), np.uint8)
    kind, numbers, path, wrong, count = _scan(data, np.cumsum(size), max_segments)
    if count == _TOO_MANY:
        return None
    return ScannedPaths(kind[:count], numbers[:count], path[:count], wrong)


@kernel
def _skip_separators(data: U8_1, position: int, last: int) -> int:
    """Return the index of the next byte that is neither white space nor a comma.

    The search starts at the index ``position`` of the path data ``data``.  ``last`` is the index
    after the last byte of the path; it is returned if only separators are left.
    """
    while position < last and (
        data[position] == 32
        or data[position] == 44
        or data[position] == 10
        or data[position] == 13
        or data[position] == 9
    ):
        position += 1
    return position


@kernel
def _parse_number(data: U8_1, position: int, last: int) -> tuple[float, int]:
    """Return the next number of a path, and the index of the byte after the number.

    If there is no number, the index is -1.

    ``position``: index at which parsing starts; separators before the number are skipped.
    """
    position = _skip_separators(data, position, last)
    negative = False
    if position < last and (data[position] == 45 or data[position] == 43):
        negative = data[position] == 45
        position += 1
    w: Any = np.int64(0)
    digits = 0
    power = 0
    has_digit = False
    while position < last and 48 <= data[position] <= 57:
        has_digit = True
        if digits < 18:
            w = w * 10 + np.int64(data[position] - 48)
            digits += w > 0
        else:
            power += 1
        position += 1
    if position < last and data[position] == 46:
        position += 1
        while position < last and 48 <= data[position] <= 57:
            has_digit = True
            if digits < 18:
                w = w * 10 + np.int64(data[position] - 48)
                digits += w > 0
                power -= 1
            position += 1
    if not has_digit:
        return 0.0, -1
    if position + 1 < last and (data[position] == 69 or data[position] == 101):
        ahead = position + 1
        has_minus = False
        if data[ahead] == 45 or data[ahead] == 43:
            has_minus = data[ahead] == 45
            ahead += 1
        # "1em" has no exponent; the caller refuses the letter.
        if ahead < last and 48 <= data[ahead] <= 57:
            raised = 0
            while ahead < last and 48 <= data[ahead] <= 57:
                raised = min(raised * 10 + int(data[ahead] - 48), 100_000)
                ahead += 1
            power += -raised if has_minus else raised
            position = ahead
    value = float(w)
    if w > 0 and power != 0:
        # Beyond 600 every number of 18 digits is 0 or infinite.
        power = min(max(power, -600), 600)
        # Two steps avoid an underflow or overflow of the intermediate result.
        half = power // 2
        if -22 <= power <= 22:
            value = value * 10.0**power if power > 0 else value / 10.0**-power
        else:
            value = value * 10.0**half * 10.0 ** (power - half)
    return -value if negative else value, position


@kernel
def _parse_flag(data: U8_1, position: int, last: int) -> tuple[int, int]:
    """Return the next flag of an arc (0 or 1), and the index of the byte after the flag.

    If there is no flag, the index is -1.

    ``position``: index at which parsing starts; separators before the flag are skipped.
    """
    position = _skip_separators(data, position, last)
    if position < last and (data[position] == 48 or data[position] == 49):
        return int(data[position] - 48), position + 1
    return 0, -1


@kernel
def _argument_count(command: int) -> int:
    """Return the number of arguments of a path command, -1 if there is no such command.

    ``command`` is the ASCII code of the lower-case command letter.
    """
    if command == 109 or command == 108 or command == 116:  # m l t
        return 2
    if command == 104 or command == 118:  # h v
        return 1
    if command == 99:  # c
        return 6
    if command == 115 or command == 113:  # s q
        return 4
    if command == 97:  # a
        return 7
    if command == 122:  # z
        return 0
    return -1


@inline_kernel
def _place_cubic(
    row: OutF64_1,
    command: int,
    previous_command: int,
    arguments: F64_1,
    base_x: float,
    base_y: float,
    handle_x: float,
    handle_y: float,
) -> tuple[float, float, float, float]:
    """Write into ``row`` the two control points of the curve of a path command C, S, Q or T.

    The curve is cubic; a quadratic curve (Q, T) is converted.

    ``row`` (8,): numbers of the curve's segment.  Columns 0 and 1 contain x and y of its start; the
    control points are written into columns 4 to 7, and the other columns are not changed.
    ``command``, ``previous_command``: ASCII codes of the lower-case letters of the command and of
    the preceding command.
    ``arguments``: arguments of the command.
    ``base_x``, ``base_y``: added to the arguments: the start of the curve for a relative command,
    else 0.
    ``handle_x``, ``handle_y``: last control point of the preceding curve, which S and T mirror at
    the start of the curve.
    Returns x, y: end of the curve; handle_x, handle_y: last control point of the curve; the control
    point of the quadratic curve for Q and T.
    """
    x, y = row[0], row[1]
    if command == 99 or command == 115:
        if command == 99:
            row[4], row[5] = base_x + arguments[0], base_y + arguments[1]
        elif previous_command == 99 or previous_command == 115:
            row[4], row[5] = 2.0 * x - handle_x, 2.0 * y - handle_y
        else:
            row[4], row[5] = x, y
        rest = 2 if command == 99 else 0
        row[6], row[7] = base_x + arguments[rest], base_y + arguments[rest + 1]
        to_x, to_y = base_x + arguments[rest + 2], base_y + arguments[rest + 3]
        handle_x, handle_y = row[6], row[7]
    else:
        if command == 113:
            handle_x, handle_y = base_x + arguments[0], base_y + arguments[1]
            to_x, to_y = base_x + arguments[2], base_y + arguments[3]
        else:
            if previous_command == 113 or previous_command == 116:
                handle_x, handle_y = 2.0 * x - handle_x, 2.0 * y - handle_y
            else:
                handle_x, handle_y = x, y
            to_x, to_y = base_x + arguments[0], base_y + arguments[1]
        row[4], row[5] = x + (handle_x - x) * 2.0 / 3.0, y + (handle_y - y) * 2.0 / 3.0
        row[6] = to_x + (handle_x - to_x) * 2.0 / 3.0
        row[7] = to_y + (handle_y - to_y) * 2.0 / 3.0
    return to_x, to_y, handle_x, handle_y


@kernel
def _scan(data: U8_1, bounds: OutI64_1, max_segments: int) -> Any:
    paths = len(bounds) - 1
    capacity = 64
    kind = np.empty(capacity, np.uint8)
    numbers = np.empty((capacity, 8))
    path_of = np.empty(capacity, np.int64)
    wrong = np.full(paths, -1, np.int64)
    arguments = np.empty(7)
    count = 0
    for path in range(paths):
        first, last = bounds[path], bounds[path + 1]
        x = y = start_x = start_y = handle_x = handle_y = 0.0
        # S and T mirror the last handle only after a curve of the same kind.
        previous_command = 0
        command = 0
        relative = False
        position = _skip_separators(data, first, last)
        while position < last:
            letter = data[position] | 32
            if 97 <= letter <= 122:
                if _argument_count(letter) < 0 or (command == 0 and letter != 109):
                    wrong[path] = position - first
                    break
                command = letter
                relative = data[position] >= 97
                position += 1
            elif command == 0 or command == 122:
                wrong[path] = position - first
                break
            before_arguments = position
            argument_count = _argument_count(command)
            for k in range(argument_count):
                if command == 97 and 3 <= k <= 4:
                    flag, position = _parse_flag(data, position, last)
                    arguments[k] = float(flag)
                else:
                    arguments[k], position = _parse_number(data, position, last)
                if position < 0:
                    break
            if position < 0:
                wrong[path] = _skip_separators(data, before_arguments, last) - first
                break
            if command == 109:
                x = arguments[0] + (x if relative else 0.0)
                y = arguments[1] + (y if relative else 0.0)
                start_x, start_y = x, y
                previous_command = command
                command = 108  # further coordinates without a letter are lines
                position = _skip_separators(data, position, last)
                continue
            if count == capacity:
                if count > max_segments:
                    return kind, numbers, path_of, wrong, _TOO_MANY
                capacity *= 2
                more_kind = np.empty(capacity, np.uint8)
                more_numbers = np.empty((capacity, 8))
                more_path_of = np.empty(capacity, np.int64)
                more_kind[:count] = kind
                more_numbers[:count] = numbers
                more_path_of[:count] = path_of
                kind, numbers, path_of = more_kind, more_numbers, more_path_of
            base_x = x if relative else 0.0
            base_y = y if relative else 0.0
            row = numbers[count]
            row[0], row[1] = x, y
            row[4:] = 0.0
            kind[count] = LINE
            path_of[count] = path
            to_x, to_y = x, y
            if command == 108:
                to_x, to_y = base_x + arguments[0], base_y + arguments[1]
            elif command == 104:
                to_x = base_x + arguments[0]
            elif command == 118:
                to_y = base_y + arguments[0]
            elif command == 122:
                to_x, to_y = start_x, start_y
            elif command == 97:
                to_x, to_y = base_x + arguments[5], base_y + arguments[6]
                if arguments[0] != 0.0 and arguments[1] != 0.0:
                    kind[count] = ARC
                    row[4], row[5], row[6] = abs(arguments[0]), abs(arguments[1]), arguments[2]
                    row[7] = arguments[3] + 2.0 * arguments[4]
            else:
                kind[count] = CUBIC
                to_x, to_y, handle_x, handle_y = _place_cubic(
                    row, command, previous_command, arguments, base_x, base_y, handle_x, handle_y
                )
            row[2], row[3] = to_x, to_y
            previous_command = command
            x, y = to_x, to_y
            # A closing line of zero length is omitted; other segments of zero length are debris.
            if command != 122 or row[0] != row[2] or row[1] != row[3]:
                count += 1
            position = _skip_separators(data, position, last)
    if count > max_segments:
        count = _TOO_MANY
    return kind, numbers, path_of, wrong, count
