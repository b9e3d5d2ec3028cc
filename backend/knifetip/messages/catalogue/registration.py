"""registration: messages about printed sheets, on which a drawing is laid by measured marks."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "registration.bound-to-machine": entry(
        "The printed sheet of job {job} was measured on machine {machine}.",
        "Forget the measured marks at that machine first, and measure the sheet again where it "
        "then lies.",
        job="text",
        machine="text",
    ),
    "registration.close": entry(
        "Marks {other} and {mark} were measured at nearly the same place: {distance:.2f} mm apart "
        "at X {x:.2f}, Y {y:.2f} mm.",
        "Move to each mark before its position is taken, and measure both again.",
        other="count",
        mark="count",
        distance="number",
        x="number",
        y="number",
    ),
    "registration.count": entry(
        "The request has {given} measured positions, and job {job} has {count} marks.",
        "Measure every mark, in the order of the job.",
        given="count",
        job="text",
        count="count",
    ),
    "registration.edge-elsewhere": entry(
        "edge {edge} is {distance:.4g} mm away from where the measured marks place it",
        edge="edge",
        distance="number",
    ),
    "registration.error": entry(
        "Mark {mark} was measured at X {x:.2f}, Y {y:.2f} mm, {distance:.2f} mm away from where "
        "all marks together place it; {limit:g} mm are permitted.",
        "Measure the marks again. If all are right, the print is distorted: permit a greater error "
        "in the order, or let the scale be fitted.",
        mark="count",
        x="number",
        y="number",
        distance="number",
        limit="number",
    ),
    "registration.forgotten": entry(
        "measured marks forgotten; the sheet lies at the stops",
    ),
    "registration.laid": entry(
        "Printed sheet with {count} marks: shift X {x:.2f}, Y {y:.2f} mm, turn {turn:.3f}°, scale "
        "{scale:.5f}, greatest error {error:.2f} mm.",
        count="count",
        x="number",
        y="number",
        turn="number",
        scale="number",
        error="number",
    ),
    "registration.measured": entry(
        "marks measured: {count}, turn {turn:.3f}°, scale {scale:.5f}, greatest error "
        "{error:.2f} mm",
        count="count",
        turn="number",
        scale="number",
        error="number",
    ),
    "registration.measured-in-order": entry(
        "The order contains measured positions of marks. Where a sheet lies is only known when it "
        "is on the table.",
        "Order the job with its marks only, and send the positions when the machine waits: POST "
        "/api/jobs/ID/registration.",
    ),
    "registration.mirrored": entry(
        "The measured marks are a mirror image of those in the drawing.",
        "Check the order in which the marks were measured, and that the printed side lies up as "
        "the drawing shows it.",
    ),
    "registration.no-marks": entry(
        "Job {job} has no marks.",
        "Order the job with the marks of the printed sheet.",
        job="text",
    ),
    "registration.no-station": entry(
        "{machine} has no station {station}.",
        "Choose the station with which the marks were measured.",
        machine="text",
        station="count",
    ),
    "registration.not-measured": entry(
        "{count} marks are not measured: the program is for a sheet at the stops of the machine.",
        count="count",
    ),
    "registration.not-waiting": entry(
        "Job {job} does not wait at its machine for the confirmation of the operator, so its marks "
        "cannot be measured.",
        "Measure the marks when the machine has taken the job and waits for the start.",
        job="text",
    ),
    "registration.off-table": entry(
        "By the measured marks, the drawing lies from X {x:.1f}, Y {y:.1f} to X {right:.1f}, Y "
        "{top:.1f} mm, but the table of {machine} reaches from 0 to {width:.0f} × {height:.0f} mm.",
        "Move the sheet and measure its marks again.",
        x="number",
        y="number",
        right="number",
        top="number",
        machine="text",
        width="number",
        height="number",
    ),
    "registration.one-copy": entry(
        "The order has marks and {copies} copies, and each printed sheet lies in another place.",
        "Order one job for each sheet.",
        copies="count",
    ),
    "registration.other-edges": entry(
        "the edges on the table are not those of the drawing",
    ),
    "registration.scale": entry(
        "By the measured marks, the print is {scale:.4f} times as large as the drawing; {least:g} "
        "to {most:g} is possible.",
        "Check which marks were measured, their order, and the unit of the drawing.",
        scale="number",
        least="number",
        most="number",
    ),
}
