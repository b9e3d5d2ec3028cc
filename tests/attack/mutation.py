"""Random changes of a program: of bytes, words, lines, tracks and stations.

    mutate(text, others, rng) -> (description, mutant)

The changes are those that editors, transfers and wrong posts make: digits, signs, lost and repeated
lines, foreign modes, cut ends, exchanged tracks.  A double mutant is the mutant of a mutant.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import Path
from random import Random

Lines = list[str]
#: A change of the lines of a program in place, at a row; it returns False if it does not apply.
Change = Callable[[Lines, int, Random], bool]

_WORD = re.compile(r"([A-Za-z])\s*([+-]?\d*\.?\d+)")
_SEGMENT = re.compile(r"(GO|LINE|CW|CCW|OUT|OSC|DWELL|PULSES)\b")
_HPGL = re.compile(r"^[A-Z]{2}[-\d,]*;$")

#: Differences that replace the number of a word, by letter.
_STEPS = {
    "X": (0.012, -0.012, 0.05, -0.05, 0.5, -5.0, 50.0, 0.1),
    "Z": (0.012, -0.012, 0.05, -0.05, 0.5, -0.5, 2.0, -2.0, 20.0, -20.0, 1.5, -1.5),
    "C": (180, -180, 360, -360, 90, -90, 1.2, -1.2, 5, 720, -720, 45),
    "F": (1, -1, 100, -100, 1000, 30000),
    "P": (1, -1, 2, -0.05, 0.05, 0.001, 5),
    "T": (1, -1, 2),
    "S": (1, -1, 100, 17000, -200),
    "G": (1, -1, 2, -2, 3, 0.1),
    "M": (1, -1, 2, -2, 60, -60),
    "Q": (0.01, -0.004, 1.0),
}
#: Lines that switch a station, an output or the spindle, or wait.
_SWITCHES = r"M6[45]|M[35]|T\d|G4|G49|SP|FS|OUT|OSC|DWELL"
#: Differences of whole numbers of units or pulses.
_WHOLE_STEPS = (1, -1, 2, -2, 10, -10, 400, -4000, 36000, -18000)
_FOREIGN = tomllib.loads(Path(__file__).with_name("foreign.toml").read_text())
_FOREIGN_WORDS = _FOREIGN["words"].split()
_FOREIGN_LINES = [line.strip() for line in re.split(r"[|\n]", _FOREIGN["lines"]) if line.strip()]
_FOREIGN_HPGL = _FOREIGN["hpgl"].split()
_FOREIGN_SEGMENTS = _FOREIGN["mcx314"].strip().split("\n")


def mutate(text: bytes, others: Sequence[bytes], rng: Random) -> tuple[str, bytes] | None:
    """Return a random change of a program: what it is, and the mutant; None if it has no effect.

    ``others`` are programs from which lines may be taken.
    """
    lines = text.decode("latin-1").split("\n")
    plots = any(_HPGL.match(line) for line in lines)
    driven = any(line.startswith("PULSES") for line in lines)
    rows = [row for row, line in enumerate(lines) if line and not line.startswith(("(", ";"))]
    if not rows:
        return None
    row = rng.choice(rows)
    name = rng.choice(_WEIGHTED)
    before = lines[row]
    if name == "foreign line":
        foreign = _FOREIGN_HPGL if plots else _FOREIGN_SEGMENTS if driven else _FOREIGN_LINES
        lines.insert(row, rng.choice(foreign))
    elif name == "line of another program":
        source = rng.choice(others).decode("latin-1").split("\n")
        at = rng.randrange(len(source))
        lines[row : row + rng.randrange(2)] = source[at : at + rng.choice((1, 1, 2, 5))]
    elif name == "cut off":
        at = rng.randrange(len(text))
        return f"cut off at byte {at}", text[:at]
    elif name == "byte":
        at = rng.randrange(len(text))
        new = bytes([rng.choice(b"0123456789XYZCGMFIJ-. ;()\n\r\t/%#,NPTS\x00\x80")])
        if text[at : at + 1] == new:
            return None
        kept = rng.choice((0, 1))
        return f"byte {at} {text[at : at + 1]!r} to {new!r}", text[:at] + new + text[at + kept :]
    elif not _CHANGES[name](lines, row, rng):
        return None
    mutant = "\n".join(lines).encode("latin-1")
    return (f"{name} at line {row + 1} ({before})", mutant) if mutant != text else None


def _digit(lines: Lines, row: int, rng: Random) -> bool:
    line = lines[row]
    places = [at for at, sign in enumerate(line) if sign.isdigit()]
    if not places:
        return False
    at, new = rng.choice(places), rng.choice("0123456789")
    lines[row] = line[:at] + rng.choice((new, new, new, "", line[at] + new)) + line[at + 1 :]
    return True


def _word_number(lines: Lines, row: int, rng: Random) -> bool:
    words = list(_WORD.finditer(lines[row]))
    if not words or _SEGMENT.match(lines[row]):
        return _whole_number(lines, row, rng)
    word = rng.choice(words)
    letter = word[1].upper()
    steps = _STEPS.get("X" if letter in "YIJ" else letter)
    if steps is None:
        return False
    value = float(word[2]) + rng.choice(steps)
    number = f"{value:g}" if letter in "FSTPQGM" else f"{value:.4f}"
    lines[row] = lines[row][: word.start(2)] + number + lines[row][word.end(2) :]
    return True


def _whole_number(lines: Lines, row: int, rng: Random) -> bool:
    numbers = list(re.finditer(r"-?\d+", lines[row]))
    if not numbers:
        return False
    number = rng.choice(numbers)
    new = str(int(number[0]) + rng.choice(_WHOLE_STEPS))
    lines[row] = lines[row][: number.start()] + new + lines[row][number.end() :]
    return True


def _scaled(lines: Lines, row: int, rng: Random) -> bool:
    words = [word for word in _WORD.finditer(lines[row]) if word[1] in "XYZIJCFV"]
    if not words:
        return False
    if _SEGMENT.match(lines[row]):
        word = rng.choice(words)
        pulses = int(float(word[2]))
        whole = rng.choice((-pulses, pulses * 2, pulses * 10, pulses // 10, 0))
        lines[row] = lines[row][: word.start(2)] + str(whole) + lines[row][word.end(2) :]
        return True
    word = rng.choice(words)
    value = float(word[2])
    scaled = [f"{value / 25.4:.4f}", f"{-value:.4f}", f"{value:.1f}", f"{value * 25.4:.4f}"]
    broken = [word[2].replace(".", ""), word[2].replace(".", ","), f"{word[2]}.5", "0", "1e1", "+1"]
    number = rng.choice(scaled + broken)
    lines[row] = lines[row][: word.start(2)] + number + lines[row][word.end(2) :]
    return True


def _word_dropped(lines: Lines, row: int, rng: Random) -> bool:
    words = list(_WORD.finditer(lines[row]))
    if not words:
        return False
    word = rng.choice([words[0], *words])
    lines[row] = (lines[row][: word.start()] + lines[row][word.end() :]).strip()
    return True


def _word_inserted(lines: Lines, row: int, rng: Random) -> bool:
    words = lines[row].split(" ")
    words.insert(rng.randrange(len(words) + 1), rng.choice(_FOREIGN_WORDS))
    lines[row] = " ".join(words)
    return True


def _word_replaced(lines: Lines, row: int, rng: Random) -> bool:
    words = lines[row].split(" ")
    at = rng.randrange(len(words))
    alike = [
        word for line in lines for word in line.split(" ") if word[:1] == words[at][:1] and word
    ]
    words[at] = rng.choice([*alike, rng.choice(_FOREIGN_WORDS)])
    lines[row] = " ".join(words)
    return True


def _words_shuffled(lines: Lines, row: int, rng: Random) -> bool:
    words = lines[row].split(" ")
    rng.shuffle(words)
    lines[row] = " ".join(words)
    return True


def _words_exchanged(lines: Lines, row: int, rng: Random) -> bool:
    """Exchange the letters of two words of a line, such as X and Y or I and J."""
    words = list(_WORD.finditer(lines[row]))
    if len(words) < 2:
        return False
    one, other = sorted(rng.sample(words, 2), key=lambda word: word.start())
    signs = list(lines[row])
    signs[one.start()], signs[other.start()] = signs[other.start()], signs[one.start()]
    lines[row] = "".join(signs)
    return True


def _dropped(lines: Lines, row: int, rng: Random) -> bool:
    del lines[row : row + rng.choice((1, 1, 1, 1, 2, 3, 8))]
    return True


def _doubled(lines: Lines, row: int, rng: Random) -> bool:
    block = lines[row : row + rng.choice((1, 1, 1, 2, 4, 10))]
    lines[row:row] = block
    return True


def _swapped(lines: Lines, row: int, rng: Random) -> bool:
    other = row + rng.choice((1, 1, 1, 2, 3))
    if other >= len(lines):
        return False
    lines[row], lines[other] = lines[other], lines[row]
    return True


def _moved(lines: Lines, row: int, rng: Random) -> bool:
    size = rng.choice((1, 1, 1, 2, 5))
    block = lines[row : row + size]
    del lines[row : row + size]
    near = min(len(lines), max(0, row + rng.randrange(-8, 9)))
    at = rng.choice((near, near, rng.randrange(len(lines) + 1)))
    lines[at:at] = block
    return True


def _reversed(lines: Lines, row: int, rng: Random) -> bool:
    last = row + rng.randrange(2, 8)
    lines[row:last] = lines[row:last][::-1]
    return True


def _joined(lines: Lines, row: int, rng: Random) -> bool:
    if row + 1 >= len(lines):
        return False
    lines[row : row + 2] = [lines[row] + rng.choice((" ", "")) + lines[row + 1]]
    return True


def _split(lines: Lines, row: int, rng: Random) -> bool:
    words = lines[row].split(" ")
    if len(words) < 2:
        return False
    at = rng.randrange(1, len(words))
    lead = rng.choice(("", words[0] + " "))
    lines[row : row + 1] = [" ".join(words[:at]), lead + " ".join(words[at:])]
    return True


def _commented(lines: Lines, row: int, rng: Random) -> bool:
    words = lines[row].split(" ")
    at = rng.randrange(len(words))
    words[at] = rng.choice((f"({words[at]})", f";{words[at]}", f"({words[at]}", f"{words[at]})"))
    lines[row] = " ".join(words)
    return True


def _comment_added(lines: Lines, row: int, rng: Random) -> bool:
    lines[row] += rng.choice(
        (" (note)", " ; note", ";note", "(a (b) c)", " (msg, hold)", " (PY, x = 1)", " //")
    )
    return True


def _numbered(lines: Lines, row: int, rng: Random) -> bool:
    lines[row] = rng.choice(("N10 ", "N10", "/", "N-1 ", "N1.5 ", "O1 ")) + lines[row]
    return True


def _respaced(lines: Lines, row: int, rng: Random) -> bool:
    line = lines[row]
    at = rng.randrange(len(line) + 1)
    lines[row] = rng.choice(
        (line.replace(" ", ""), line.lower(), line + "\r", f"  {line}", f"{line[:at]} {line[at:]}")
    )
    return True


def _motion(lines: Lines, row: int, rng: Random) -> bool:
    """Exchange the motion word of a line, or leave it out so that the last one holds."""
    if _SEGMENT.match(lines[row]):
        name, _, words = lines[row].partition(" ")
        if rng.random() < 0.4:
            end = " JOIN"
            words = words.removesuffix(end) if words.endswith(end) else words + end
        else:
            name = rng.choice(("GO", "LINE", "CW", "CCW"))
            words = re.sub(r" V\d+.*", "", words) if name == "GO" else words
        lines[row] = f"{name} {words}"
        return True
    if not re.search(r"\bG[0-3]\b", lines[row]):
        return False
    new = rng.choice(("G0", "G1", "G2", "G3", ""))
    lines[row] = re.sub(r"\bG[0-3]\b", new, lines[row], count=1).strip()
    if new in ("G0", "G1", "") and rng.random() < 0.5:
        lines[row] = re.sub(r" ?[IJ]-?[\d.]+", "", lines[row])
    return True


def _radius_arc(lines: Lines, row: int, rng: Random) -> bool:
    """Give an arc its radius instead of its centre."""
    found = re.search(r"I(-?\d+\.\d+) J(-?\d+\.\d+)(?![\d.])", lines[row])
    if not found:
        return False
    radius = (float(found[1]) ** 2 + float(found[2]) ** 2) ** 0.5
    new = f"R{rng.choice((radius, -radius)):.4f}"
    lines[row] = lines[row].replace(found[0], new)
    return True


def _tail_shifted(lines: Lines, row: int, rng: Random) -> bool:
    """Shift one axis in a line and all lines after it, or up to the next rapid."""
    letter = rng.choice("CCCXYZ")
    shift = rng.choice(
        (360.0, -360.0, 180.0, -180.0) if letter == "C" else (0.02, -0.02, 1.0, -5.0)
    )
    whole = rng.random() < 0.5

    def moved(word: re.Match[str]) -> str:
        return f"{letter}{float(word[1]) + shift:.4f}"

    def pulsed(word: re.Match[str]) -> str:
        return f"{letter}{int(word[1]) + round(shift * 200)}"

    for at in range(row, len(lines)):
        if not whole and at > row and lines[at].startswith("G0 X"):
            break
        if lines[at].startswith("GO"):
            # A whole number of pulses.
            lines[at] = re.sub(rf"{letter}(-?\d+)", pulsed, lines[at])
        elif lines[at][:2] in ("G0", "G1", "G2", "G3", "G9"):
            lines[at] = re.sub(rf"{letter}(-?\d+(?:\.\d*)?)(?![\d.])", moved, lines[at])
    return True


def _tracks(lines: Lines) -> list[int]:
    """Return the rows at which tracks begin, by rapids to their first points."""
    return [row for row, line in enumerate(lines) if re.match(r"G[0O] .*[XYC]|PU-?\d", line)]


def _tracks_exchanged(lines: Lines, row: int, rng: Random) -> bool:
    begins = _tracks(lines)
    if len(begins) < 3:
        return False
    first, second = sorted(rng.sample(range(len(begins) - 1), 2))
    a, b, c, d = begins[first], begins[first + 1], begins[second], begins[second + 1]
    lines[a:d] = lines[c:d] + lines[b:c] + lines[a:b]
    return True


def _track_moved(lines: Lines, row: int, rng: Random) -> bool:
    begins = _tracks(lines)
    if len(begins) < 3:
        return False
    which = rng.randrange(len(begins) - 1)
    block = lines[begins[which] : begins[which + 1]]
    if rng.random() < 0.6:
        del lines[begins[which] : begins[which + 1]]
    begins = _tracks(lines)
    at = rng.choice(begins)
    lines[at:at] = block
    return True


def _track_returned(lines: Lines, row: int, rng: Random) -> bool:
    """Cut a straight track again after it, or after the whole path, in the opposite direction."""
    begins = [*_tracks(lines), len(lines)]
    straight = []
    for a, b in pairwise(begins):
        cuts = [at for at in range(a + 1, b) if re.match(r"G[0123] .*[XY]", lines[at])]
        places = [dict(_WORD.findall(lines[at])) for at in (a, *cuts)]
        if len(cuts) == 1 and lines[cuts[0]].startswith("G1") and {"X", "Y"} <= places[0].keys():
            straight.append((a, b, cuts[0], places))
    if not straight:
        return False
    a, b, cut, (start, stop) = rng.choice(straight)
    stop = start | stop
    block = lines[a:b]
    for at, place in ((0, stop), (cut - a, start)):
        for letter in "XY":
            block[at] = re.sub(rf"{letter}-?[\d.]+", f"{letter}{place[letter]}", block[at])
        for letter in set("XY") - {word[0] for word in block[at].split()}:
            block[at] += f" {letter}{place[letter]}"
    heading = float(start.get("C", 0.0)) + rng.choice((180.0, -180.0, 0.0))
    block[0] = re.sub(r"C-?[\d.]+", f"C{heading:.4f}", block[0])
    at = rng.choice((b, rng.choice(begins[:-1])))
    lines[at:at] = block
    return True


def _stations_exchanged(lines: Lines, row: int, rng: Random) -> bool:
    """Exchange the sections of two stations, or move one."""
    begins = [
        at for at, line in enumerate(lines) if re.match(r"\(station|; station|M64|SP[1-9]", line)
    ]
    if len(begins) < 2:
        return False
    which = rng.randrange(len(begins) - 1)
    a, b = begins[which], begins[which + 1]
    c = begins[which + 2] if which + 2 < len(begins) else len(lines) - 1
    lines[a:c] = lines[b:c] + lines[a:b]
    return True


def _switch(lines: Lines, row: int, rng: Random) -> bool:
    """Change a line that switches a station, an output or the spindle."""
    rows = [at for at, line in enumerate(lines) if re.match(_SWITCHES, line)]
    if not rows:
        return False
    at = rng.choice(rows)
    line = lines.pop(at)
    action = rng.randrange(5)
    if action == 0:
        line = line.translate(str.maketrans("45", "54")) if line.startswith("M6") else line
        if line.startswith("O"):
            line = line.replace(" OFF", " O") if " OFF" in line else line.replace(" ON", " OFF")
            line = re.sub(r" O$", " ON", line)
    elif action == 1:
        line = re.sub(r"\d+(?=\D*$)", lambda word: str(int(word[0]) + rng.choice((1, -1))), line)
    elif action == 2:
        at = max(0, min(len(lines), at + rng.choice((-3, -2, -1, 1, 2, 3))))
    elif action == 3:
        return True
    else:
        lines.insert(at, line)
        at = rng.randrange(len(lines))
    lines.insert(at, line)
    return True


def _mode(lines: Lines, row: int, rng: Random) -> bool:
    """Drop, exchange or repeat a word of the line that states the modes."""
    head = next((at for at, line in enumerate(lines) if line.startswith("G21")), None)
    if head is None:
        return False
    words = lines[head].split(" ")
    at = rng.randrange(len(words))
    action = rng.randrange(3)
    if action == 0:
        del words[at]
    elif action == 1:
        words[at] = rng.choice(("G20", "G91", "G90.1", "G18", "G41", "G43", "G93", "G95", "G55"))
    else:
        lines.insert(row, words.pop(at))
    lines[head] = " ".join(words)
    return True


_CHANGES: dict[str, Change] = {
    "digit": _digit,
    "number": _word_number,
    "scale": _scaled,
    "word dropped": _word_dropped,
    "word inserted": _word_inserted,
    "word replaced": _word_replaced,
    "words shuffled": _words_shuffled,
    "words exchanged": _words_exchanged,
    "lines dropped": _dropped,
    "lines repeated": _doubled,
    "lines exchanged": _swapped,
    "lines moved": _moved,
    "lines reversed": _reversed,
    "lines joined": _joined,
    "line split": _split,
    "word commented": _commented,
    "comment added": _comment_added,
    "line numbered": _numbered,
    "spaces": _respaced,
    "motion": _motion,
    "radius for centre": _radius_arc,
    "tail shifted": _tail_shifted,
    "tracks exchanged": _tracks_exchanged,
    "track moved": _track_moved,
    "track returned": _track_returned,
    "stations exchanged": _stations_exchanged,
    "switch": _switch,
    "mode": _mode,
}
#: Kinds that find most get a greater share.
_WEIGHTED = (
    *_CHANGES,
    *("digit", "number", "number", "lines dropped", "lines moved", "switch", "switch"),
    *("foreign line", "foreign line", "foreign line", "word replaced", "word inserted"),
    *("line of another program", "cut off", "byte", "byte", "track moved", "track returned"),
)
KINDS = tuple(sorted(set(_WEIGHTED)))
