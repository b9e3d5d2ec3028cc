"""classification: the reasons for line types."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "classification.around": entry("surrounds a whole carton"),
    "classification.arrow": entry("has an arrowhead, or belongs to a line that has one"),
    "classification.as-its-style": entry("as all of its style do"),
    "classification.bleed": entry(
        "surrounds a blank at the same distance everywhere, as a bleed does",
    ),
    "classification.board-ends": entry(": the board ends there, unless the outline is open"),
    "classification.closes-nothing": entry(" and closes nothing"),
    "classification.contradicted": entry("{rule}; but {reason}", rule="message", reason="message"),
    "classification.convention": entry(
        'colour convention "{name}" fits: the outline closes, {folds} of {lines:# dividing line '
        "is a fold|# dividing lines are folds}",
        name="text",
        folds="count",
        lines="count",
    ),
    "classification.cuts-panel-off": entry("it would cut a panel off its blank"),
    "classification.dashed": entry("in dashes"),
    "classification.divider": entry("divides two panels"),
    "classification.divides-panels": entry(", and a {type} divides panels", type="text"),
    "classification.frame": entry("frames the whole drawing"),
    "classification.free": entry("lies free inside a panel"),
    "classification.hole": entry("closes a hole in a panel"),
    "classification.inner": entry("lies inside a hole, or divides one"),
    "classification.layer-denies": entry('but its layer is called "{layer}"', layer="text"),
    "classification.layer-name": entry('its layer name contains "{word}"', word="text"),
    "classification.legend": entry(
        "lies outside every blank, beside the name of a line type: a legend",
    ),
    "classification.letter": entry("lies in a row of small shapes, as letters do"),
    "classification.like-outline": entry("in the style of the outline"),
    "classification.like-outline-not-folds": entry(
        "in the style of the outline; another style has the folds",
    ),
    "classification.linetype-name": entry('its linetype name contains "{word}"', word="text"),
    "classification.mark": entry("closes a shape much smaller than the blank"),
    "classification.mirror-cut": entry("its mirror image is cut"),
    "classification.mirror-folded": entry("its mirror image is folded"),
    "classification.mixed": entry(
        "{reason}, with the greater part of its length",
        reason="message",
    ),
    "classification.named": entry(
        "is not part of the carton by its name, and the outlines close without it",
    ),
    "classification.no-rule": entry("no rule of profile {profile}", profile="text"),
    "classification.no-rule-but-shape": entry(
        "no rule of profile {profile}; {shape}",
        profile="text",
        shape="message",
    ),
    "classification.none-closes": entry(", as all of its style do, and none closes an outline"),
    "classification.not-made": entry(", and is not to be made"),
    "classification.on-cut": entry("{rule}; it lies on a cut", rule="message"),
    "classification.open": entry("belongs to an outline that does not close"),
    "classification.other-style-closes": entry("but another style closes most of it"),
    "classification.outline": entry("closes the outline of a blank"),
    "classification.override": entry("override"),
    "classification.paired": entry("some of them in pairs"),
    "classification.panel-hangs": entry("and a panel hangs on it"),
    "classification.panels-hang": entry("and panels hang on most of them"),
    "classification.role-against": entry("it {role}{against}", role="message", against="message?"),
    "classification.rule": entry("profile {profile}: {rule}", profile="text", rule="text"),
    "classification.shape": entry("shape: it {parts:, }", parts="messages"),
    "classification.slit": entry("begins at another line and ends inside a panel"),
    "classification.slot": entry("closes a slot or a round hole in a panel"),
    "classification.speck": entry("lies outside every blank, by itself, and is small"),
    "classification.stray": entry("lies outside every blank"),
    "classification.swapped": entry("the lines that it calls crease close the outline"),
    "classification.swapped-both": entry(
        "the lines that it calls crease close the outline, and those that it calls cut divide the "
        "panels",
    ),
    "classification.swapped-like": entry(
        "{reason}; {convention}",
        reason="message",
        convention="message",
    ),
    "classification.table": entry("lies beside a text: a title block, a dimension or a label"),
    "classification.unknown": entry("gives no information by its shape"),
    "classification.votes": entry("{votes:; }", votes="messages"),
    "classification.with-text": entry("{reason}, with a text beside it", reason="message"),
}
