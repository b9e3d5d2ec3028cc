"""field: messages about fields of the TOML files of machines, boards, tools and profiles."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "field.above": entry(
        "{path} is {value}, but must be at most {limit:g}",
        path="text",
        value="text",
        limit="number",
    ),
    "field.below": entry(
        "{path} is {value}, but must be at least {limit:g}",
        path="text",
        value="text",
        limit="number",
    ),
    "field.above-clearance": entry(
        "{path} is {value:g} mm, but must not be more than clearance, {clearance:g} mm",
        path="text",
        value="number",
        clearance="number",
    ),
    "field.bad-arguments": entry(
        "{path} has arguments that do not fit the message code {name!r}",
        path="text",
        name="text",
    ),
    "field.blank": entry("{path} is empty", path="text"),
    "field.control-character": entry(
        "{path} contains the control character {character}, which cannot be seen or typed",
        "Remove it, or type the text again.",
        path="text",
        character="text",
    ),
    "field.inconsistent": entry(
        "{path} contradicts other fields: {fault}",
        path="text",
        fault="message",
    ),
    "field.missing": entry("{path} is missing", path="text"),
    "field.metadata-too-large": entry(
        "{path} is larger than {most} kB",
        path="text",
        most="count",
    ),
    "field.misspelt": entry(
        "{path} is not a known field; perhaps {near} is meant",
        path="text",
        near="text",
    ),
    "field.no-neighbour": entry(
        "{path} must contain previous, next or both",
        path="text",
    ),
    "field.no-spindle": entry(
        "{path}: `spindle` and `spindle_speed` are set, but the tool of station {station} has no "
        "oscillation and no spindle",
        path="text",
        station="count",
    ),
    "field.needs-heading": entry(
        "{path}: station {station} has a tool that an axis must turn, but [axes] has no c. Tools "
        "of such a machine are a free knife, a cutter or a laser",
        path="text",
        station="count",
    ),
    "field.gantry-not-square": entry(
        "{path}: programs of a machine with several carriages do not correct an angle of "
        "{angle:g}° between X and Y; squareness must be 90",
        path="text",
        angle="number",
    ),
    "field.gantry-without-heading": entry(
        "{path}: a machine with carriages needs an axis c in [axes]",
        path="text",
    ),
    "field.override-range": entry(
        "{path}: the feed override from {low} to {high} % must contain 100 %",
        path="text",
        low="count",
        high="count",
    ),
    "field.spindle-of-beam": entry(
        "{path}: `spindle` and `spindle_speed` are set, but station {station} has a laser, which "
        "is switched by M3 with its `power`",
        path="text",
        station="count",
    ),
    "field.no-such-carriage": entry(
        "{path}: station {station} is on carriage {carriage}, but the machine has "
        "{count:# carriage|# carriages}",
        path="text",
        station="count",
        carriage="count",
        count="count",
    ),
    "field.no-kind": entry(
        "{path} does not state its kind: the field {field} is missing",
        path="text",
        field="text",
    ),
    "field.not-a-colour": entry(
        '{path} is {value}, but must be a whole number from 1 to 255 or "#rrggbb"',
        path="text",
        value="text",
    ),
    "field.not-a-line-type": entry(
        "{path} is {value!r}, but must be a line type: {known:or}",
        path="text",
        value="text",
        known="texts",
    ),
    "field.not-a-list": entry("{path} is {value}, but must be a list", path="text", value="text"),
    "field.not-a-number": entry(
        "{path} is {value}, but must be a number",
        path="text",
        value="text",
    ),
    "field.not-a-profile": entry(
        "{path} is {value!r}, but must be a profile of the library: {known:or}",
        path="text",
        value="text",
        known="texts",
    ),
    "field.not-a-table": entry(
        "{path} is {value}, but must be a table of fields",
        path="text",
        value="text",
    ),
    "field.not-a-time": entry(
        "{path} is {value}, but must be a time in RFC 3339 with its offset, such as "
        "2030-01-02T03:04:05Z",
        path="text",
        value="text",
    ),
    "field.not-above": entry(
        "{path} is {value}, but must be greater than {limit:g}",
        path="text",
        value="text",
        limit="number",
    ),
    "field.not-above-low": entry(
        "{path} is {value:g}, but must be greater than the value of the field low, which is "
        "{low:g}",
        path="text",
        value="number",
        low="number",
    ),
    "field.not-below": entry(
        "{path} is {value}, but must be less than {limit:g}",
        path="text",
        value="text",
        limit="number",
    ),
    "field.not-boolean": entry(
        "{path} is {value}, but must be true or false",
        path="text",
        value="text",
    ),
    "field.bad-json": entry(
        "{path} is not valid JSON: the fault is in line {line}, column {column}",
        path="text",
        line="count",
        column="count",
    ),
    "field.nested-too-deep": entry("{path} is nested too deeply", path="text"),
    "field.not-json": entry("{path} is not valid JSON: {reason}", path="text", reason="text"),
    "field.not-less-than-caliper": entry(
        "{path} is {value:g} mm, but must be less than the caliper of {caliper:g} mm",
        path="text",
        value="number",
        caliper="number",
    ),
    "field.not-one-of": entry(
        "{path} is {value}, but must be {known:or}",
        path="text",
        value="text",
        known="texts",
    ),
    "field.not-text": entry("{path} is {value}, but must be text", path="text", value="text"),
    "field.no-year": entry(
        "{path} is {value}, but must be in the years 1 to 9999 of UTC", path="text", value="text"
    ),
    "field.wrong-order": entry(
        "{path}: {second} must not be before {first}", path="text", first="text", second="text"
    ),
    "field.not-empty": entry("{path} is {value}, but must be null", path="text", value="text"),
    "field.wrong-form": entry(
        "{path} is {value}, which does not have the required form",
        path="text",
        value="text",
    ),
    "field.not-whole": entry(
        "{path} is {value}, but must be a whole number",
        path="text",
        value="text",
    ),
    "field.other": entry(
        "{path} is {value}, which is not valid ({fault})",
        path="text",
        value="text",
        fault="text",
    ),
    "field.outside": entry(
        "{path} is {value}, but must be from {low:g} to {high:g}",
        path="text",
        value="text",
        low="number",
        high="number",
    ),
    "field.park-outside": entry(
        "{path} parks at {park:g} mm, outside the travel of its y axis from {low:g} to {high:g} mm",
        path="text",
        park="number",
        low="number",
        high="number",
    ),
    "field.parks-too-near": entry(
        "{path} has two carriages that park {distance:g} mm apart, but min_distance is {least:g} "
        "mm",
        path="text",
        distance="number",
        least="number",
    ),
    "field.repeated-letters": entry(
        "{path} has the letters {letters:, }; each letter may occur only once",
        path="text",
        letters="texts",
    ),
    "field.repeated-numbers": entry(
        "{path} has the numbers {numbers:, }; each number may occur only once",
        path="text",
        numbers="texts",
    ),
    "field.rest-choice": entry(
        "{path} must contain whole alone (copies are possible only with it), or a start "
        "(from_track or from_line), a station, or both",
        path="text",
    ),
    "field.edges-or-line-type": entry(
        "{path} must have either edges or line_type",
        path="text",
    ),
    "field.sheet-size": entry(
        "{path} must have both width and height, or none of width, height and margin",
        path="text",
    ),
    "field.spacing": entry(
        "{path} is {value:g} mm, but must be either 0 or at least {least:g} mm",
        path="text",
        value="number",
        least="number",
    ),
    "field.too-few": entry(
        "{path} has {count:# value|# values}, but needs at least {least}",
        path="text",
        count="count",
        least="count",
    ),
    "field.too-long": entry("{path} is longer than {most} characters", path="text", most="count"),
    "field.too-many": entry("{path} has more than {most} values", path="text", most="count"),
    "field.close-marks": entry(
        "{path}: the mark at X {x:g}, Y {y:g} mm is only {distance:.1f} mm away from another one; "
        "marks must be at least {least:g} mm apart",
        path="text",
        x="number",
        y="number",
        distance="number",
        least="number",
    ),
    "field.measured-marks": entry(
        "{path} has {marks} marks, and {measured} of them were measured; measure all or none",
        path="text",
        marks="count",
        measured="count",
    ),
    "field.too-many-copies": entry(
        "{path} contains {count} copies of drawings; a sheet may have {limit}",
        path="text",
        count="count",
        limit="count",
    ),
    "field.too-many-passes": entry(
        "{path} is {value:g} mm, which is too small: the V-groove would need more than {most} "
        "passes",
        path="text",
        value="number",
        most="count",
    ),
    "field.too-short": entry(
        "{path} has fewer than {least:# character|# characters}",
        path="text",
        least="count",
    ),
    "field.zone-above-travel": entry(
        "{path}: the top of the zone {zone} is {top:g} mm above the mat and the clearance is "
        "{clearance:g} mm, but tools travel at travel_z = {travel_z:g} mm; raise travel_z",
        path="text",
        zone="text",
        top="number",
        clearance="number",
        travel_z="number",
    ),
    "field.unknown": entry(
        "{path} is not a known field",
        path="text",
    ),
    "field.unknown-kind": entry(
        "{path} has the unknown kind {value!r}; known kinds are {known:, }",
        path="text",
        value="text",
        known="texts",
    ),
}
