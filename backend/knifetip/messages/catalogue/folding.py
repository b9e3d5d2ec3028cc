"""folding: messages about blanks that are folded in space."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "folding.angle-invalid": entry(
        "{value} is not an angle of a fold",
        "Write the number of the fold, a colon and the angle in degrees from -180 to 180, such as "
        "3:45.",
        value="text",
    ),
    "folding.collision": entry(
        "panels {panel} and {other} cross by {distance:.4g} mm",
        "Change the angles of their folds, or the size of one panel.",
        panel="count",
        other="count",
        distance="number",
    ),
    "folding.flap-too-long": entry(
        "panel {panel} reaches {distance:.4g} mm beyond panel {other}",
        "Shorten the flap.",
        panel="count",
        other="count",
        distance="number",
    ),
    "folding.flaps-overlap": entry(
        "panels {panel} and {other} point to each other and overlap by {distance:.4g} mm",
        "Shorten them if they are to meet without an overlap.",
        panel="count",
        other="count",
        distance="number",
    ),
    "folding.gap": entry(
        "the fold between panels {panel} and {other} stays open by {distance:.4g} mm",
        "Change the angles of the folds around it.",
        panel="count",
        other="count",
        distance="number",
    ),
    "folding.groove-narrow": entry(
        "the groove between panels {panel} and {other} closes at {angle:.4g}°, and the panels fold "
        "by {required:.4g}°",
        "Cut the groove with a V-cutter of a larger angle, or fold it by less.",
        panel="count",
        other="count",
        angle="number",
        required="number",
    ),
    "folding.no-such-fold": entry(
        "fold {fold} does not exist; number of folds in the drawing: {count}",
        fold="count",
        count="count",
    ),
    "folding.not-straight": entry(
        "the fold between panels {panel} and {other} is not straight, so that it is shown flat",
        panel="count",
        other="count",
    ),
    "folding.solids-collide": entry(
        "panels {panel} and {other} lie in each other by {distance:.4g} mm, more than the board of "
        "{caliper:.4g} mm gives way",
        "Shorten one panel by the difference, or move its fold.",
        panel="count",
        other="count",
        distance="number",
        caliper="number",
    ),
    "folding.too-many-edges": entry(
        "the drawing has more than {limit} edges of cuts and folds, too many to fold it",
        "Fold a drawing of one blank.",
        limit="count",
    ),
    "folding.too-many-panels": entry(
        "the drawing has more than {limit} panels, too many to fold it",
        "Fold a drawing of one blank.",
        limit="count",
    ),
}
