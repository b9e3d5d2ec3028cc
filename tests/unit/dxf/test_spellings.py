"""One small drawing in various spellings of programs: both readers return the same."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from knifetip.model.drawing import Drawing
from tests.support.truth.readers import difference, fast_reader_accepts, read_by_both
from tests.support.writers.dxf_text import dxf, entity

MARKED = "AC1015"


def line(*extra: tuple[int, object], x: object = 0, handle: object = "A1") -> str:
    own = [(100, "AcDbLine"), (10, x), (20, 0), (30, 0), (11, 10), (21, 5), (31, 0)]
    return entity("LINE", (5, handle), (100, "AcDbEntity"), (8, "CUT"), *extra, *own)


OTHER = line(x=1.5, handle="A2")
PLAIN = dxf(line(), OTHER, version=MARKED).decode()


def with_codes(change: Callable[[str], str]) -> str:
    lines = PLAIN.split("\n")
    lines[0:-1:2] = map(change, lines[0:-1:2])
    return "\n".join(lines)


SPELLINGS = {
    "lines end in CR LF": PLAIN.replace("\n", "\r\n"),
    "lines end in CR": PLAIN.replace("\n", "\r"),
    "lines end in both": PLAIN.replace("\n", "\r\n", 31),
    "three columns": with_codes(lambda code: code.rjust(3)),
    "blanks behind": with_codes(lambda code: code + "  "),
    "leading zeros": with_codes(lambda code: code.zfill(3)),
    "tabs before": with_codes(lambda code: "\t" + code),
    "tabs behind": with_codes(lambda code: code + "\t"),
    "plus signs": with_codes(lambda code: "+" + code),
    "NULs at the end": PLAIN + "\0\0",
    "Ctrl-Z at the end": PLAIN + "\x1a",
    "no last line end": PLAIN.rstrip("\n"),
    "something behind the end": PLAIN + "hello\nworld\n",
    "empty lines before": "\n \n" + PLAIN,
    "a comment before": "999\nmade by hand\n" + PLAIN,
    "comments within": PLAIN.replace("\n20\n", "\n999\nx\n20\n"),
    "byte order mark": "\ufeff" + PLAIN,
    "a section twice": PLAIN.replace(
        "0\nEOF", "0\nSECTION\n2\nENTITIES\n" + line(handle="A3") + "0\nENDSEC\n0\nEOF"
    ),
    "an unknown section": PLAIN.replace(
        "0\nEOF", "0\nSECTION\n2\nTHUMBNAILIMAGE\n90\n2\n310\nABcd\n0\nENDSEC\n0\nEOF"
    ),
    "bytes that are none": PLAIN.replace(
        "0\nEOF", "0\nSECTION\n2\nTHUMBNAILIMAGE\n90\n2\n310\nABC\n0\nENDSEC\n0\nEOF"
    ),
}


@pytest.mark.parametrize("spelling", SPELLINGS)
def test_both_readers_agree_on_any_spelling_of_lines(spelling: str) -> None:
    data = SPELLINGS[spelling].encode()
    assert difference(*read_by_both(data)) == ""


@pytest.mark.parametrize(
    "spelling", ["lines end in CR LF", "three columns", "leading zeros", "comments within"]
)
def test_usual_spellings_are_read_by_the_fast_reader(spelling: str) -> None:
    assert fast_reader_accepts(SPELLINGS[spelling].encode())


@pytest.mark.parametrize(
    "number",
    [
        *("+5.0", ".5", "5.", "-.5", "1.5E+02", "1.e3", "1e-400", "-0.0", "5 ", "\t5", "1e400"),
        *("1.5D+02", "1,5", "1 5", "", "5.0.0", "nan", "inf", "0x10", "1_000", "1e", "--5"),
        *(
            "1.#INF",
            "-1.#IND",
            "１",
            "5;",
            "1234567890" * 3,
            "0.1000000000000000055511151231257827",
        ),
    ],
)
def test_both_readers_agree_on_any_spelling_of_numbers(number: str) -> None:
    assert difference(*read_by_both(dxf(line(x=number), OTHER, version=MARKED))) == ""


@pytest.mark.parametrize(
    "tags",
    [
        [(62, " 3")], [(62, "+3")], [(62, "1.0")], [(62, -3)], [(62, 257)], [(62, "red")],
        [(62, "")], [(370, 25)], [(370, "x")], [(48, 0.5)], [(48, "x")], [(60, 1)], [(60, 2)],
        [(67, 1)], [(67, 2)], [(410, "Model")], [(410, "Layout1")], [(420, 0xFF0000)],
        [(420, -1)], [(6, "ByLayer")], [(6, "BYBLOCK")], [(8, "OTHER")], [(39, 5)], [(5, "A9")],
        [(102, "{X"), (330, "A"), (102, "}")], [(102, "{X")], [(92, 2), (310, "ABCD")],
        [(999, "")], [(430, "A$B")], [(1001, "X")], [(330, "1F"), (330, "1E")],
    ],
)  # fmt: skip
def test_both_readers_agree_on_additional_groups(tags: list[tuple[int, object]]) -> None:
    assert difference(*read_by_both(dxf(line(*tags), OTHER, version=MARKED))) == ""


@pytest.mark.parametrize("handle", ["ab1", "0", "A2", "XYZ", "", " A1 ", "1234567890ABCDEF0"])
def test_both_readers_agree_on_any_handle(handle: str) -> None:
    assert difference(*read_by_both(dxf(line(handle=handle), OTHER, version=MARKED))) == ""


@pytest.mark.parametrize(
    ("page", "encoding", "layer"),
    [
        ("ANSI_1252", "cp1252", "Größe"),
        ("ANSI_1252", "utf-8", "Größe刀"),
        ("", "cp1252", "Größe"),
        ("ANSI_932", "cp932", "切断表"),
        ("ANSI_936", "gbk", "刀线"),
        ("GB2312", "gbk", "刀线"),
        ("ANSI_950", "big5", "刀線"),
        ("ANSI_1251", "cp1251", "Резка"),
        ("dos850", "cp850", "Größe"),
        ("ANSI_1252", "ascii", "\\U+5200\\U+7EBF"),
    ],
)
def test_both_readers_agree_on_any_code_page(page: str, encoding: str, layer: str) -> None:
    header = f"9\n$DWGCODEPAGE\n3\n{page}\n0\nENDSEC\n"
    text = PLAIN.replace("0\nENDSEC\n", header, 1).replace("\nCUT\n", f"\n{layer}\n", 1)
    ours, reference = read_by_both(text.encode(encoding))
    assert difference(ours, reference) == ""
    assert isinstance(ours, Drawing)
    if page not in ("GB2312", "dos850"):
        assert ours.layers[0] == ("刀线" if encoding == "ascii" else layer)
