"""customer_agreement: find the line types on which the drawings of a customer agree."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Sequence
from typing import Final

from knifetip.model.customer_answers import LearnedAnswer, Look, TaughtDrawing
from knifetip.model.dieline import LineType

#: Number of drawings in which a look must have one line type if no question about it was answered.
_UNANSWERED: Final = 2


def learn_answers(
    drawings: Sequence[TaughtDrawing], sha256: str, refused: Collection[Look] = ()
) -> tuple[LearnedAnswer, ...]:
    """Return the answers that a customer's drawings agree on.

    An answer for a look applies to open edges for any reason if all edges of the look have one line
    type in all drawings.  Otherwise there is an answer for each reason on which they agree.

    Parameters
    ----------
    drawings
        Drawings of one customer, the newest first.
    sha256
        File for which the answers are meant; its own earlier answers suffice.
    refused
        Looks whose answers a user has taken back.
    """
    types: dict[tuple[Look, str], set[LineType]] = defaultdict(set)
    taught: dict[tuple[Look, str], list[TaughtDrawing]] = defaultdict(list)
    decided: dict[Look, set[LineType]] = defaultdict(set)
    answered: set[Look] = set()
    for one in drawings:
        for use in one.uses:
            decided[use.look].add(use.line_type)
            if use.reason:
                answered.add(use.look)
            for reason in {use.reason, ""}:
                types[use.look, reason].add(use.line_type)
                if one not in taught[use.look, reason]:
                    taught[use.look, reason].append(one)
    learned = []
    for (look, reason), kinds in types.items():
        whole = len(decided[look]) == 1
        if len(kinds) > 1 or whole != (reason == "") or look in refused:
            continue
        (kind,) = kinds
        files = taught[look, reason]
        hashes = {one.sha256 for one in files}
        same_file = sha256 in hashes and look in answered
        if reason and kind != LineType.IGNORED and not same_file:
            # Where cuts and folds look alike, their places do not distinguish them either.
            continue
        if look not in answered and len(hashes) < _UNANSWERED:
            continue
        sure = same_file or (len(hashes) > 1 and (look in answered or kind != LineType.IGNORED))
        names = tuple(dict.fromkeys(one.name for one in files))
        learned.append(LearnedAnswer(look, reason, kind, names, sure))
    return tuple(learned)
