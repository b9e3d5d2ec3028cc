/**
 * Texts and hints of all messages in the language "en", in ICU MessageFormat.
 * Written by frontend/catalogue.py: do not edit.
 */

import type { Catalogue, Names } from "./catalogue";

export const TEXTS = {
  "advice.compiling": {
    "text": "Wait until the job is compiled.",
    "hint": ""
  },
  "advice.ended": {
    "text": "Order the job again.",
    "hint": ""
  },
  "advice.interrupted": {
    "text": "Check the table, then mark the job finished, queue it again or scrap it.",
    "hint": ""
  },
  "advice.of-reason": {
    "text": "{reason__hint}",
    "hint": ""
  },
  "advice.queued": {
    "text": "Wait until the gateway of the machine has claimed the job.",
    "hint": ""
  },
  "advice.ready": {
    "text": "Release the job first.",
    "hint": ""
  },
  "advice.running": {
    "text": "Hold, resume or cancel the job.",
    "hint": ""
  },
  "backup.exists": {
    "text": "The file {file} already exists.",
    "hint": "Choose another file, or replace it with --replace."
  },
  "backup.foreign": {
    "text": "The database in the file {file} does not contain tables of knifetip.",
    "hint": "Choose a file that knifetip backup has written."
  },
  "backup.missing-row": {
    "text": "The file {file} is damaged: a row of the table {table} refers to a row that is missing.",
    "hint": "Choose another backup."
  },
  "backup.not-a-backup": {
    "text": "The file {file} is not a backup of a knifetip database: {reason}.",
    "hint": "Choose a file that knifetip backup has written."
  },
  "backup.postgresql": {
    "text": "The database {url} is on a PostgreSQL server, which has its own commands for backups.",
    "hint": "Back it up with: pg_dump --format=custom --file=FILE DATABASE. Restore it to an empty database with: pg_restore --exit-on-error --dbname=DATABASE FILE."
  },
  "backup.unwritable": {
    "text": "The database cannot be copied to {file}: {reason}.",
    "hint": "Free space on the disk or choose another folder. The database was not changed."
  },
  "board.above-travel": {
    "text": "The board is {caliper, number, ::@#####} mm thick, but the head of {machine} travels only {travel, number, ::@#####} mm above the table and must stay {clearance, number, ::@#####} mm above the board.",
    "hint": "Choose a thinner board, or a machine whose head travels higher."
  },
  "board.too-thick": {
    "text": "The board is {caliper, number, ::@#####} mm thick, but {machine} takes board up to {limit, number, ::@#####} mm.",
    "hint": "Choose a thinner board or another machine. The limit is max_caliper in the machine file."
  },
  "bridges.divided-blank": {
    "text": "The part at edge {edge} would be held by {count, plural, one {# bridge} other {# bridges}}, because cuts divide its blank. The board requires {fewest, plural, one {# bridge} other {# bridges}} (uncut gaps) on each part.",
    "hint": "Set the line type of the cuts between the parts to ignored and make them by hand, choose a smaller spacing of bridges in the board file, or choose a board without bridges."
  },
  "bridges.no-room": {
    "text": "The contour at edge {edge} is {length, number, ::.0} mm long, which is too short for {fewest, plural, one {# bridge} other {# bridges}} of {gap, number, ::.00} mm width. The board requires bridges (uncut gaps that hold a part) at most {spacing, number, ::.0} mm apart, and away from corners and narrow slots.",
    "hint": "Choose narrower bridges or a larger spacing of bridges in the board file, or choose a board without bridges."
  },
  "calibration.bad-points": {
    "text": "The {count, plural, one {# measured point} other {# measured points}} of the test cut cannot be used. At least one point is needed, and each value must be a finite number.",
    "hint": "Measure at least one point on a slanted part of the contour of the test cut."
  },
  "calibration.choose-cutter": {
    "text": "{machine} has {count, plural, one {# cutter} other {# cutters}}, so the cutter to calibrate must be named.",
    "hint": "Choose one of {cutters}."
  },
  "calibration.missing-column": {
    "text": "Line {line} of {file} has no value for {columns__or}.",
    "hint": "Write the heading azimuth,dx,dy on the first line. Write three numbers, in degrees, mm and mm, on each other line, for example 45,-0.05,0.06."
  },
  "calibration.not-a-number": {
    "text": "Line {line} of {file} has a value that is not a number: {values}.",
    "hint": "Write three numbers with decimal points, for example 45,-0.05,0.06."
  },
  "calibration.not-csv": {
    "text": "{file} is not a CSV file: {reason}.",
    "hint": "Save the file as CSV in UTF-8."
  },
  "calibration.undetermined": {
    "text": "At every measured point the contour runs nearly along {along}, so the deflection of the cutter in {along} ({other}) cannot be determined. The sum of sin² of the angles between the contour and the {along} axis is {weight, number, ::.0000}, but must be at least {least, number, ::@##############}.",
    "hint": "Measure one more point where the contour runs along {direction}, or at 45°."
  },
  "calibration.wrong-sign": {
    "text": "The measured points give a deflection of {x, number, ::.000} mm in X and {y, number, ::.000} mm in Y. A negative value means that the cutter moves towards the contour, although the board normally pushes it away from the contour, so a sign or the side is probably wrong.",
    "hint": "Check the signs of dx and dy, and check on which side of the contour the tool moves."
  },
  "cf2.cut-short": {
    "text": "The CF2 file is incomplete: it ends at line {line} inside {inside}. Objects of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again as CF2."
  },
  "cf2.decimal-commas": {
    "text": "Line {line} of the CF2 file has {fields} fields instead of {expected} for the record {record}. The file seems to use decimal commas, but in CF2 files commas separate the fields.",
    "hint": "Export the drawing again with decimal points."
  },
  "cf2.empty": {
    "text": "The CF2 file contains no drawing: it has neither a MAIN section nor a subroutine.",
    "hint": "Send the complete file, or export the drawing again as CF2."
  },
  "cf2.main": {
    "text": "the MAIN section",
    "hint": ""
  },
  "cf2.section": {
    "text": "the section {name}",
    "hint": ""
  },
  "cf2.subroutine": {
    "text": "the subroutine {name}",
    "hint": ""
  },
  "check.begun-sheet": {
    "text": "The begun sheet of job {job} lies in its place, unmoved.",
    "hint": ""
  },
  "check.board": {
    "text": "The board on the table is {board}{caliper}.",
    "hint": ""
  },
  "check.caliper": {
    "text": ", {caliper, number, ::@#####} mm thick",
    "hint": ""
  },
  "check.drawing-place": {
    "text": ": the lower left corner of the drawing lies at X {x, number, ::@#####}, Y {y, number, ::@#####} mm",
    "hint": ""
  },
  "check.fed-sheet": {
    "text": "a sheet of the stack lies in its place",
    "hint": ""
  },
  "check.fed-table": {
    "text": "the sheet before it was removed",
    "hint": ""
  },
  "check.hands": {
    "text": "Hands and people are clear of the machine.",
    "hint": ""
  },
  "check.named": {
    "text": "{id} ({text})",
    "hint": ""
  },
  "check.sheet-larger": {
    "text": "A sheet that is larger than the drawing lies in its place{place}.",
    "hint": ""
  },
  "check.sheet-outline": {
    "text": "The sheet, cut to the outline of the drawing, lies in its place{place}.",
    "hint": ""
  },
  "check.sheet-place": {
    "text": ", its lower left corner at X {x, number, ::@#####}, Y {y, number, ::@#####} mm",
    "hint": ""
  },
  "check.sheet-size": {
    "text": "A sheet of {width, number, ::@#####} × {height, number, ::@#####} mm lies in its place{place}.",
    "hint": ""
  },
  "check.station": {
    "text": "Station {station} holds {tool}, and the tool is not damaged.",
    "hint": ""
  },
  "check.table": {
    "text": "Nothing lies on the table except the sheet.",
    "hint": ""
  },
  "check.table-next": {
    "text": "The finished sheet is removed, and nothing lies on the table except the new one.",
    "hint": ""
  },
  "check.unfinished-sheet": {
    "text": "The unfinished sheet of job {job} is removed.",
    "hint": ""
  },
  "classification.across": {
    "text": "the edge meets other lines inside the blank, and one of them must be a slit if the blank folds into a box; the edge is perpendicular to the longest of these lines, so it may be a fold",
    "hint": ""
  },
  "classification.along": {
    "text": "the edge meets other lines inside the blank, and one of them must be a slit if the blank folds into a box; the edge is parallel to the longest of these lines, so it may be a fold",
    "hint": ""
  },
  "classification.around": {
    "text": "the edge encloses a complete carton",
    "hint": ""
  },
  "classification.arrow": {
    "text": "the edge has an arrowhead, or is connected to a line with an arrowhead",
    "hint": ""
  },
  "classification.as-its-style": {
    "text": "the edge is treated like all edges with the same layer, colour and line style",
    "hint": ""
  },
  "classification.beside-gap": {
    "text": "{reason}; this assumes that a straight line is missing in the outline beside the edge, because as drawn the blank falls apart there",
    "hint": ""
  },
  "classification.bleed": {
    "text": "the edge surrounds a blank at a constant distance, as a bleed line does",
    "hint": ""
  },
  "classification.board-ends": {
    "text": "such an edge should be cut",
    "hint": ""
  },
  "classification.closes-nothing": {
    "text": "the edge is part of no closed outline",
    "hint": ""
  },
  "classification.contradicted": {
    "text": "{rule}, but {reason}",
    "hint": ""
  },
  "classification.convention": {
    "text": "the colours fit the colour convention \"{name}\": with this convention the cut lines form a closed outline, and {folds} of {lines, plural, one {# line} other {# lines}} inside the outline are folds",
    "hint": ""
  },
  "classification.corners": {
    "text": "at both ends, the edge continues round a corner into one other line, as a fold does not",
    "hint": ""
  },
  "classification.cuts-panel-off": {
    "text": "a cut at the position of the edge would separate a panel from its blank",
    "hint": ""
  },
  "classification.dashed": {
    "text": "the edges with this layer, colour and line style are drawn dashed",
    "hint": ""
  },
  "classification.dimension": {
    "text": "the edge belongs to a dimension: a text beside the line states its length",
    "hint": ""
  },
  "classification.divider": {
    "text": "the edge divides two panels",
    "hint": ""
  },
  "classification.divides-panels": {
    "text": "an edge of type {type} should divide two panels",
    "hint": ""
  },
  "classification.fold-end": {
    "text": "the edge lies between the outline and a fold of the same two panels, as a slit that locks a flap does",
    "hint": ""
  },
  "classification.follows": {
    "text": "the answer for other edges decides this line type: they have the same colour and line style, or show whether the profile swaps cut and crease",
    "hint": ""
  },
  "classification.frame": {
    "text": "the edge frames the whole drawing",
    "hint": ""
  },
  "classification.free": {
    "text": "the edge lies inside a panel and touches no other edge",
    "hint": ""
  },
  "classification.hole": {
    "text": "the edge closes a hole in a panel",
    "hint": ""
  },
  "classification.inner": {
    "text": "the edge lies inside a hole or divides a hole into parts",
    "hint": ""
  },
  "classification.labelled": {
    "text": "the edge belongs to a closed shape with a text in or beside it, which may be a label or a small part",
    "hint": ""
  },
  "classification.layer-denies": {
    "text": "the name of the layer of the edge, \"{layer}\", suggests another line type",
    "hint": ""
  },
  "classification.layer-name": {
    "text": "the name of the layer of the edge contains \"{word}\"",
    "hint": ""
  },
  "classification.layer-name-against": {
    "text": "but the name of the layer of the edge contains \"{word}\"",
    "hint": ""
  },
  "classification.learned": {
    "text": "learned from drawings of the same customer: edges with this layer, colour and line style have this line type in {drawings}",
    "hint": ""
  },
  "classification.learned-guess": {
    "text": "edges with this layer, colour and line style have this line type in {drawings} of the same customer",
    "hint": ""
  },
  "classification.legend": {
    "text": "the edge lies outside all blanks, beside the name of a line type, so it belongs to a legend",
    "hint": ""
  },
  "classification.letter": {
    "text": "the edge lies in a row of small shapes, as the outlines of letters do",
    "hint": ""
  },
  "classification.like-outline": {
    "text": "the edge has the layer, colour and line style of the outline",
    "hint": ""
  },
  "classification.like-outline-not-folds": {
    "text": "the edge has the layer, colour and line style of the outline, which differ from those of the folds",
    "hint": ""
  },
  "classification.linetype-name": {
    "text": "the name of the line style of the edge contains \"{word}\"",
    "hint": ""
  },
  "classification.linetype-name-against": {
    "text": "but the name of the line style of the edge contains \"{word}\"",
    "hint": ""
  },
  "classification.mark": {
    "text": "the edge belongs to a closed shape that is much smaller than the blank",
    "hint": ""
  },
  "classification.measured": {
    "text": "a text beside the edge states its length, so the edge may be a dimension line",
    "hint": ""
  },
  "classification.mirror-cut": {
    "text": "the drawing contains a mirror image of the edge, and this mirror image is a cut",
    "hint": ""
  },
  "classification.mirror-folded": {
    "text": "the drawing contains a mirror image of the edge, and this mirror image is a fold",
    "hint": ""
  },
  "classification.mixed": {
    "text": "{reason} (this is true for most of the length of the edge)",
    "hint": ""
  },
  "classification.must-be-processed": {
    "text": "such an edge should not be ignored",
    "hint": ""
  },
  "classification.named": {
    "text": "the name of the layer marks the edge as not being part of the carton, and the outlines close without the edge",
    "hint": ""
  },
  "classification.no-rule": {
    "text": "no rule of the profile {profile} matches the edge",
    "hint": ""
  },
  "classification.no-rule-but-shape": {
    "text": "no rule of the profile {profile} matches the edge, but {shape}",
    "hint": ""
  },
  "classification.none-closes": {
    "text": "almost all edges with the same layer, colour and line style divide panels",
    "hint": ""
  },
  "classification.not-made": {
    "text": "such an edge should be ignored",
    "hint": ""
  },
  "classification.oblique": {
    "text": "the edge meets other lines inside the blank, and one of them must be a slit if the blank folds into a box; the edge is neither parallel nor perpendicular to the longest of these lines, so it may be a fold",
    "hint": ""
  },
  "classification.on-cut": {
    "text": "{rule}, and the edge lies on top of a cut",
    "hint": ""
  },
  "classification.only-fold-style": {
    "text": "this is the only colour and line style whose edges do nothing but divide panels",
    "hint": ""
  },
  "classification.open": {
    "text": "the edge belongs to an outline that does not close",
    "hint": ""
  },
  "classification.open-flap": {
    "text": "at each end of the edge begins a line whose other end meets nothing, and both lines are equally long, so they may be the sides of a flap that is not closed",
    "hint": ""
  },
  "classification.other-style-closes": {
    "text": "most of the outline of the blank consists of edges with another layer, colour or line style",
    "hint": ""
  },
  "classification.outline": {
    "text": "the edge closes the outline of a blank",
    "hint": ""
  },
  "classification.override": {
    "text": "the user set the line type of the edge",
    "hint": ""
  },
  "classification.own-width": {
    "text": "the line width of the edge distinguishes it from other edges with the same layer, colour and line style",
    "hint": ""
  },
  "classification.paired": {
    "text": "some edges with this layer, colour and line style form pairs of parallel lines",
    "hint": ""
  },
  "classification.panel-hangs": {
    "text": "only this edge connects a panel to the rest of the blank",
    "hint": ""
  },
  "classification.panels-hang": {
    "text": "most edges with this layer, colour and line style are each the only connection between a panel and the rest of the blank",
    "hint": ""
  },
  "classification.part-of-outline": {
    "text": "the name of the layer \"{layer}\" means the line type {type}, and most of the outline lies on layers whose names mean cuts",
    "hint": ""
  },
  "classification.part-of-side": {
    "text": "the side of one of the panels continues beyond the edge, as it does beside a slit",
    "hint": ""
  },
  "classification.ring-fold": {
    "text": "the edge meets lines inside the blank that are probably slits, so it is probably a fold between them",
    "hint": ""
  },
  "classification.ring-slit": {
    "text": "the edge ends inside the blank where three folds meet, or is parallel to such an edge; if it were a fold too, four folds would meet there, which does not make a box",
    "hint": ""
  },
  "classification.role-against": {
    "text": "{role}; {against}",
    "hint": ""
  },
  "classification.rule": {
    "text": "profile {profile}: {rule}",
    "hint": ""
  },
  "classification.shape": {
    "text": "{parts}",
    "hint": ""
  },
  "classification.shared": {
    "text": "the edge lies where equal parts of the drawing touch, so it may be a common cut of blanks",
    "hint": ""
  },
  "classification.slit": {
    "text": "the edge is a slit: it begins at another edge and ends inside a panel",
    "hint": ""
  },
  "classification.slot": {
    "text": "the edge closes a slot or a round hole in a panel",
    "hint": ""
  },
  "classification.slot-side": {
    "text": "the edge is a side of a slot at a fold",
    "hint": ""
  },
  "classification.speck": {
    "text": "the edge is short, lies outside all blanks and touches no other edge",
    "hint": ""
  },
  "classification.stray": {
    "text": "the edge lies outside all blanks of the drawing",
    "hint": ""
  },
  "classification.swapped": {
    "text": "this rule turns edges of the closed outline into creases, so cut and crease may be swapped; the answer also decides the edges that the profile cuts",
    "hint": ""
  },
  "classification.swapped-both": {
    "text": "this rule turns edges of the closed outline into creases and edges between panels into cuts, so cut and crease may be swapped; the answer also decides the edges that the profile cuts",
    "hint": ""
  },
  "classification.swapped-like": {
    "text": "{reason}; {convention}",
    "hint": ""
  },
  "classification.table": {
    "text": "the edge belongs to boxes with texts, as in a title block",
    "hint": ""
  },
  "classification.through": {
    "text": "the edge continues through points inside the blank where other lines end; a slit would end there, so the edge is probably a fold",
    "hint": ""
  },
  "classification.unknown": {
    "text": "the geometry of the drawing does not show which line type the edge has",
    "hint": ""
  },
  "classification.votes": {
    "text": "{votes__semicolon}",
    "hint": ""
  },
  "classification.with-text": {
    "text": "{reason}, and a text lies beside the edge",
    "hint": ""
  },
  "classification.without-tabs": {
    "text": "the walls of the box have no glue tabs, as in rigid boxes, which are folded at V-grooves",
    "hint": ""
  },
  "cleaning.as-drawn": {
    "text": "the edge is used as it was drawn",
    "hint": ""
  },
  "cleaning.dropped-off-panel": {
    "text": "the edge was dropped, because it belongs to a fold and lies outside all panels",
    "hint": ""
  },
  "cleaning.dropped-speck": {
    "text": "the edge was dropped, because it is only {length, number, ::@###} mm long and connects no other edges",
    "hint": ""
  },
  "cleaning.end-moved": {
    "text": "one end of the edge was moved by {distance, number, ::@#} mm to meet another edge",
    "hint": ""
  },
  "cleaning.fitted": {
    "text": "the edge was part of a curve made of short lines; one line or arc replaces this curve",
    "hint": ""
  },
  "cleaning.fitted-edge": {
    "text": "the edge and edge {edge} were parts of a curve made of short lines; one line or arc, which deviates by at most {distance, number, ::@#} mm from this curve, replaces them",
    "hint": ""
  },
  "cleaning.folds-on-cuts": {
    "text": "{count, plural, one {# edge} other {# edges}} of the line type {type} {count, plural, one {lies} other {lie}} on cuts and {count, plural, one {is} other {are}} not made along {length, number, ::.0} mm: the cuts are made instead.",
    "hint": "If the board should stay connected there, set the line type of the cuts to {type}. Otherwise nothing needs to be done."
  },
  "cleaning.folds-trimmed": {
    "text": "Creases or V-grooves in {count} edges were shortened: {length, number, ::.00} mm of them lie outside all panels and are not made.",
    "hint": "If a panel should be there, close its outline. Otherwise nothing needs to be done."
  },
  "cleaning.ignored": {
    "text": "the edge has the line type ignored, so it is displayed but not processed",
    "hint": ""
  },
  "cleaning.joined": {
    "text": "the edge and another edge on the same line were merged into one edge",
    "hint": ""
  },
  "cleaning.joined-edge": {
    "text": "the edge was merged into edge {edge}, which lies on the same line",
    "hint": ""
  },
  "cleaning.kept": {
    "text": "the edge is used as it was drawn, without a change",
    "hint": ""
  },
  "cleaning.kept-changed": {
    "text": "the edge was kept, with these changes: {changes__semicolon}",
    "hint": ""
  },
  "cleaning.length-on-others": {
    "text": "a part of the edge, {length, number, ::@###} mm long, lies on other edges, so it is made only once, with them",
    "hint": ""
  },
  "cleaning.longer": {
    "text": "other edges on the same line were merged into the edge, so it became longer",
    "hint": ""
  },
  "cleaning.loop": {
    "text": "the edge was dropped, because it belongs to a loop of at most 0.3 mm at a corner of an outline, which no tool can follow; the outline is complete without it",
    "hint": ""
  },
  "cleaning.moved": {
    "text": "one end of the edge was moved to meet another edge",
    "hint": ""
  },
  "cleaning.near": {
    "text": "the edge was drawn twice: it lies close beside another edge and was merged into it",
    "hint": ""
  },
  "cleaning.near-edge": {
    "text": "the edge was drawn twice: it lies {distance, number, ::@#} mm beside edge {edge} and was merged into it",
    "hint": ""
  },
  "cleaning.no-work": {
    "text": "the edge is unchanged, because no tool processes an edge of its line type",
    "hint": ""
  },
  "cleaning.off-panel": {
    "text": "a part of the fold lies outside all panels and was dropped",
    "hint": ""
  },
  "cleaning.on-edge": {
    "text": "the edge lies on edge {edge} and was merged into it",
    "hint": ""
  },
  "cleaning.part-dropped": {
    "text": "a part of the edge, {length, number, ::@#} mm long, was dropped because it is too short to process",
    "hint": ""
  },
  "cleaning.part-off-panel": {
    "text": "a part of the fold, {length, number, ::@###} mm long, was dropped because it lies outside all panels",
    "hint": ""
  },
  "cleaning.shortened": {
    "text": "a part of the edge lies on other edges, so it is made only once, with them",
    "hint": ""
  },
  "cleaning.speck": {
    "text": "the edge was dropped, because it is too short to process and connects no other edges",
    "hint": ""
  },
  "cleaning.twice": {
    "text": "the edge was removed, because it lies completely on other edges",
    "hint": ""
  },
  "cleaning.unclassified": {
    "text": "the edge has no line type yet, so it is displayed but not processed",
    "hint": ""
  },
  "command.bad-corner": {
    "text": "The option --corner-at ''{text}'' does not have the form X,Y=TYPE or X,Y=TYPE:K.",
    "hint": "Write for example --corner-at 300,100=C or --corner-at 300,100=D:0.3."
  },
  "command.bad-edge": {
    "text": "The option --edge ''{pair}'' does not have the form EDGE=TYPE or EDGE,EDGE=TYPE.",
    "hint": "Write for example --edge 12,13=ignored. The first edge has number 0."
  },
  "command.bad-layer": {
    "text": "The option --layer ''{pair}'' does not have the form NAME=TYPE.",
    "hint": "Write for example --layer FOLDS=crease."
  },
  "command.bad-line-type": {
    "text": "The line type in the option ''{pair}'' does not exist.",
    "hint": "Choose the line type {known__or}."
  },
  "command.bad-option": {
    "text": "The option {option} cannot be used: {faults__semicolon}.",
    "hint": "{faults__hint} knifetip program --help describes all options."
  },
  "command.file-too-large": {
    "text": "The file {path} is larger than {limit} MB.",
    "hint": "Export a single carton, without pictures."
  },
  "command.no-such-layer": {
    "text": "The file {file} has no layer ''{layer}''.",
    "hint": "Choose one of the layers of the file: {layers}."
  },
  "command.unreadable-file": {
    "text": "The file {path} cannot be read: {reason}.",
    "hint": "Check the name and the permissions of the file."
  },
  "command.unwritable-file": {
    "text": "The file {path} cannot be written: {reason}.",
    "hint": "Choose another path."
  },
  "content.altered": {
    "text": "The stored content {address} of {owner} is damaged: its SHA-256 does not match.",
    "hint": "Restore the content from a backup, or compile the job again. Nothing was sent to a machine."
  },
  "content.bad-url": {
    "text": "''{url}'' is not the URL of a folder or a bucket.",
    "hint": "Write the URL as file:///FOLDER or s3://BUCKET/PREFIX, with the keys of S3 in AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY."
  },
  "content.missing": {
    "text": "The stored content {address} of {owner} is missing.",
    "hint": "Check that --store names the folder or bucket of this database. If it does, restore the content from a backup, or compile the job again. Nothing was sent to a machine."
  },
  "content.no-obstore": {
    "text": "The package obstore is not installed, which --store {url} needs.",
    "hint": "Install it with: pip install 'knifetip[s3]'."
  },
  "content.outside": {
    "text": "The stored content {address} of {owner} is in a folder or bucket outside the database.",
    "hint": "Start the server and its workers with the same option --store as when the content was stored."
  },
  "content.unavailable": {
    "text": "The store {url} cannot be used: {reason}.",
    "hint": "Check the folder or the bucket, its keys and the network. Nothing was stored."
  },
  "controller.alarm": {
    "text": "{name} stopped with ALARM:{code}: {alarm}{due}.",
    "hint": "Check the table and home the machine ($H) before the next job."
  },
  "controller.alarm-code": {
    "text": "ALARM:{code} ({alarm})",
    "hint": ""
  },
  "controller.alarm-of-unknown-cause": {
    "text": "{name} is locked by an alarm whose code was not received.",
    "hint": "Check the table, then home the machine. If it has no limit switches, unlock it."
  },
  "controller.alarm-state": {
    "text": "{name} has stopped and reports an alarm{due}.",
    "hint": "Check the table, then home the machine ($H) or unlock it ($X)."
  },
  "controller.alarm-unknown": {
    "text": "an unknown alarm",
    "hint": ""
  },
  "controller.answer-lost": {
    "text": "{name} has been in the state {state} for {seconds, number, ::@#####} s{due}. This means that a response of the controller was lost.",
    "hint": "Check the cable to the controller, then check the board on the table."
  },
  "controller.answer-missing": {
    "text": "The receive buffer of {name} contains fewer bytes than were sent{due}. This means that a response of the controller was lost, or bytes on their way to it.",
    "hint": "Check the cable to the controller, then check the board on the table."
  },
  "controller.bad-address": {
    "text": "''{address}'' is not the address of a controller.",
    "hint": "Write the address as HOST:PORT, for example 127.0.0.1:2323, or as a URL. Known schemes: {schemes}."
  },
  "controller.bad-host": {
    "text": "The address ''{address}'' of the controller cannot be right: ''{host}'' is neither an IP address nor the name of a host.",
    "hint": "Write the address as HOST:PORT, for example 127.0.0.1:2323."
  },
  "controller.bad-serial-address": {
    "text": "''{address}'' is not the address of a serial port.",
    "hint": "Write it as serial:///dev/ttyUSB0 or serial://COM3; ?baud=250000 at its end sets another speed than 115200 bits per second, &flow=rtscts or &flow=xonxoff the flow control."
  },
  "controller.busy": {
    "text": "{name} is busy: it reports the state {state}. Nothing was sent.",
    "hint": "Wait until the controller is idle, or reset it at the table."
  },
  "controller.check-end-not-confirmed": {
    "text": "{name} did not confirm within {seconds, number, ::@#####} s that its check mode ($C), in which nothing moves, has ended.",
    "hint": "Check the table, then try again."
  },
  "controller.closed": {
    "text": "The connection to {name} was closed.",
    "hint": "Connect to the controller again."
  },
  "controller.connection-failed": {
    "text": "The connection to {address} is lost ({reason}).",
    "hint": "Check the table before you send anything again."
  },
  "controller.door-open": {
    "text": "{name} did not lift the tool and did not raise the stations, because its safety door is open.",
    "hint": "Close the safety door, press Release, then lift the tool."
  },
  "controller.due": {
    "text": "; no response to program line {line} ({text}) was received",
    "hint": ""
  },
  "controller.in-alarm": {
    "text": "{name} is locked by alarm {code}: {alarm}.",
    "hint": "{alarm__hint}"
  },
  "controller.left-program": {
    "text": "{name} no longer executes the program: its state is {state}.",
    "hint": "Check the table. Another program or a person may have operated the machine."
  },
  "controller.lift-not-finished": {
    "text": "{name} did not finish lifting the tool within {seconds, number, ::@#####} s.",
    "hint": "Lift the tool and raise the stations at the table."
  },
  "controller.line-changed": {
    "text": "{name} received ''{received}'' instead of program line {line} ({sent}).",
    "hint": "Check the cable to the controller. Check the board on the table, which may be spoiled."
  },
  "controller.locked": {
    "text": "{name} is locked by {cause}. The stations may still be lowered.",
    "hint": "Lift the tool and raise the stations at the table, then home the machine ($H) or unlock it ($X)."
  },
  "controller.locked-by-alarm": {
    "text": "{name} is locked by an alarm.",
    "hint": "Home the machine ($H) or unlock it ($X) at the table."
  },
  "controller.lost": {
    "text": "The connection to {name} is lost{due}.",
    "hint": "Check the cable to the controller, then check the board on the table."
  },
  "controller.lost-in-buffer": {
    "text": "The connection to {name} is lost. The controller may still execute the program lines in its buffer.",
    "hint": "Keep clear of the table until the machine has stopped, then check the table."
  },
  "controller.no-host-and-port": {
    "text": "The address ''{address}'' of the controller has no host or no port.",
    "hint": "Write the address as HOST:PORT, for example 127.0.0.1:2323."
  },
  "controller.not-ready": {
    "text": "{name} is not ready: it reports the state {state}. Nothing was sent.",
    "hint": "Wait until the controller is idle, or unlock it, then send the job again."
  },
  "controller.not-recovered": {
    "text": "{name} did not reach its safe state, with the tool lifted and the stations raised.",
    "hint": "Lift the tool and raise the stations at the table."
  },
  "controller.not-secured": {
    "text": "{name} cannot be brought into its safe state, with the tool lifted and the stations raised, because it reports the state {state}.",
    "hint": "Lift the tool and raise the stations at the table."
  },
  "controller.not-stopped": {
    "text": "{error} {progress} The machine is not in a safe state: {unsafe}",
    "hint": "{unsafe__hint}"
  },
  "controller.off-heading": {
    "text": "At X{x, number, ::.000} Y{y, number, ::.000} mm the tool was turned to C{c, number, ::.000}, which is {turn, number, ::.0} degrees away from the program near program line {line}. Either a program line was corrupted on its way to the controller, or a motor lost steps.",
    "hint": "Check the cable to the controller and home the machine. Check the board on the table, which may be spoiled."
  },
  "controller.off-path": {
    "text": "The machine was at X{x, number, ::.000} Y{y, number, ::.000} Z{z, number, ::.000} mm, which is {distance, number, ::.0} mm away from the path of the program near program line {line}. Either a program line was corrupted on its way to the controller, or a motor lost steps.",
    "hint": "Check the cable to the controller and home the machine. Check the board on the table, which may be spoiled."
  },
  "controller.one-carriage": {
    "text": "The machine {machine} has {count} carriages, and the gateway and the simulated table can only drive a machine with one.",
    "hint": "Download the program and open it in the controller of the machine."
  },
  "controller.port-busy": {
    "text": "Another program uses the serial port {port}.",
    "hint": "Close the other program, then start the gateway again."
  },
  "controller.port-missing": {
    "text": "There is no serial port {port}{found}.",
    "hint": "Plug in the controller and switch it on, or correct the name of the port."
  },
  "controller.port-not-permitted": {
    "text": "The user of this gateway may not open the serial port {port}.",
    "hint": "On Linux, add the user to the group of the port, usually dialout (sudo usermod -aG dialout USER), then log in again."
  },
  "controller.port-unusable": {
    "text": "The serial port {port} cannot be opened ({reason}).",
    "hint": "Correct the name of the port or its speed."
  },
  "controller.ports-found": {
    "text": "; this computer has {ports}",
    "hint": ""
  },
  "controller.refused-safe-state": {
    "text": "{refusals__space}",
    "hint": "Lift the tool and raise the stations at the table. Then compare the outputs in the machine file with the outputs of the controller."
  },
  "controller.rejected-command": {
    "text": "{name} rejected the command {command}: {error} (error:{code}).",
    "hint": "Check the table, then try again."
  },
  "controller.rejected-in-check": {
    "text": "{name} rejected program line {line} ({text}) in its check mode, before anything moved: {error} (error:{code}).",
    "hint": "Compile the job again for this controller."
  },
  "controller.rejected-line": {
    "text": "{name} rejected program line {line} ({text}): {error} (error:{code}).",
    "hint": "Check the board on the table, then compile the job again for this controller."
  },
  "controller.reports-alarm": {
    "text": "{name} reports an alarm.",
    "hint": "Check the table, then home the machine ($H) or unlock it ($X)."
  },
  "controller.reset": {
    "text": "{name} was reset{due}. The position of the machine may be lost, so the job does not continue automatically.",
    "hint": "Check the table and home the machine. Then queue the job again or scrap it."
  },
  "controller.reset-not-confirmed": {
    "text": "{name} did not confirm its reset within {seconds, number, ::@#####} s.",
    "hint": "Check the table, then try again."
  },
  "controller.settings-refused": {
    "text": "{name} has settings with which the programs of this machine would be dangerous: {differences__space} Nothing was sent.",
    "hint": "{differences__hint} The gateway then connects by itself."
  },
  "controller.silent": {
    "text": "{name} has not responded for {seconds, number, ::@#####} s{due}.",
    "hint": "Check the cable to the controller, then check the board on the table."
  },
  "controller.stopped": {
    "text": "{error} {progress} The machine was stopped, the head was lifted to Z {height, number, ::.0} mm, and the stations were raised.",
    "hint": "{error__hint}"
  },
  "controller.too-few-outputs": {
    "text": "{name} has {count, plural, one {# digital output} other {# digital outputs}}, but the machine file contains a station with output {output}. Nothing was sent.",
    "hint": "Use a controller with more outputs, for example grblHAL, or correct the machine file."
  },
  "controller.unable": {
    "text": "{name} cannot execute program line {line} ({text}): {obstacle}. Nothing has moved.",
    "hint": "Use a controller with the axes and outputs of the machine, for example grblHAL, or correct the machine file."
  },
  "controller.unexpected-answer": {
    "text": "{name} responded to a program line that this gateway did not send. Either a response was sent twice, or another program sends lines to the controller.",
    "hint": "Check the cable to the controller, and close any other program that is connected to the controller."
  },
  "controller.unreachable": {
    "text": "No controller responds at {address} ({reason}).",
    "hint": "Switch on the controller, or correct the address."
  },
  "controller.unsafe": {
    "text": "{error} {progress} The machine is not in a safe state: the stations may still be lowered.",
    "hint": "Lift the tool and raise the stations at the table. {error__hint}"
  },
  "controller.was-reset": {
    "text": "{name} was reset.",
    "hint": "Check the table and home the machine before the next job."
  },
  "controller.web-server": {
    "text": "A web server answers at {address}, not a controller.",
    "hint": "Correct the host or the port in the address of the controller."
  },
  "conversion.failed": {
    "text": "The file is {what}. {program}, which converts such files, stopped with the error ''{reason}''.",
    "hint": "{what__hint}"
  },
  "conversion.failed-at": {
    "text": "The file is {what}. {program}, which converts such files, stopped at byte {position, number} of the file with the error ''{reason}''.",
    "hint": "{what__hint}"
  },
  "conversion.no-program": {
    "text": "The file is {what}, which knifetip reads only if the program {program} is installed.",
    "hint": "{what__hint} Or ask the administrator of knifetip to install {program} (command {command}). Files that need no other program are {formats__or}."
  },
  "conversion.no-result": {
    "text": "The file is {what}. {program}, which converts such files, found no drawing in it.",
    "hint": "{what__hint}"
  },
  "conversion.result-unreadable": {
    "text": "The file is {what}. {program} has converted it, but the result cannot be read: {error}",
    "hint": "{what__hint}"
  },
  "conversion.too-large": {
    "text": "The file is {what}. Its conversion by {program} makes files of more than {limit, number, ::precision-integer} MB.",
    "hint": "Export a single carton, without pictures. {what__hint}"
  },
  "conversion.too-much-memory": {
    "text": "The file is {what}. Its conversion by {program} needs more than {limit, number, ::precision-integer} MB of memory.",
    "hint": "Export a single carton, without pictures. {what__hint}"
  },
  "conversion.too-slow": {
    "text": "The file is {what}. Its conversion by {program} takes longer than {seconds, number, ::@#####} s.",
    "hint": "Export a single carton, without pictures. {what__hint}"
  },
  "corner.bad-k": {
    "text": "The parameter k of the corner at the start of edge {edge} is {k}, but must be between 0 and 1.",
    "hint": "Choose a k from 0 (the path of corner type B) to 1 (the path of corner type C)."
  },
  "corner.bad-share": {
    "text": "Corner {corner} in the list of corners (the first corner has number 0) has type D with the parameter k = {k}, which must be between 0 and 1.",
    "hint": "Choose a k from 0 (the path of corner type B) to 1 (the path of corner type C)."
  },
  "corner.inside": {
    "text": "The corner at X {x, number, ::@#####} mm, Y {y, number, ::@#####} mm is an inside corner, but corner types apply only to outside corners.",
    "hint": "Remove the corner type of this corner from the request."
  },
  "corner.no-contour": {
    "text": "No corner type can be set at X {x, number, ::@#####} mm, Y {y, number, ::@#####} mm (searched within {within, number, ::@#####} mm), because the drawing has no contour whose outside corners are milled.",
    "hint": "Remove the corner types from the request for this drawing."
  },
  "corner.no-cutter": {
    "text": "Corner types were chosen, but {machine} has no rotating cutter.",
    "hint": "Remove the corner types from the request, or choose a machine with a rotating cutter."
  },
  "corner.not-found": {
    "text": "No corner of a milled contour lies within {within, number, ::@#####} mm of X {x, number, ::@#####} mm, Y {y, number, ::@#####} mm. The nearest corner is {distance, number, ::.00} mm away.",
    "hint": "Give X and Y of a corner in mm, in the coordinates of the drawing. The nearest corners are {known}."
  },
  "corner.replaced": {
    "text": "{count, plural, one {# corner has} other {# corners have}} type B instead of {type}, because the path of the cutter in type {type} would cross another path or come too near to another edge. X and Y on the sheet in mm ({count, plural, one {one corner} other {the first corners}}): {places__semicolon}.",
    "hint": "Choose corner type B for {count, plural, one {this corner} other {these corners}}, or a cutter with a smaller diameter."
  },
  "corner.unknown-number": {
    "text": "Corner {corner} in the list of corners (the first corner has number 0) has the corner type {type}, which does not exist.",
    "hint": "Choose corner type B, C or D."
  },
  "corner.unknown-type": {
    "text": "The corner type ''{type}'' does not exist.",
    "hint": "Choose corner type B, C, D or auto."
  },
  "crease.tight-bend": {
    "text": "The double crease at edge {edge} is bent with a radius of {radius, number, ::.00} mm, which is too small for a second crease line {offset, number, ::.00} mm inside the bend.",
    "hint": "Draw the crease with a larger radius, or set the double crease of the board to 0."
  },
  "curve.bad-ellipse": {
    "text": "An ellipse has an angle range that is not valid, or one of its values is not a number.",
    "hint": "Delete the ellipse and draw it again."
  },
  "curve.bad-spline": {
    "text": "A spline is damaged: degree {degree}, {points} control points and {knots} knots do not match.",
    "hint": "Draw the spline again, or export it as lines and arcs."
  },
  "curve.bad-tolerance": {
    "text": "The tolerance for converting curves is {tolerance, number, ::@##############} mm, which is not valid.",
    "hint": "Give a tolerance greater than 0."
  },
  "curve.not-finite": {
    "text": "A coordinate of a point of a curve is not a number.",
    "hint": "Draw the curve again, as lines and arcs."
  },
  "curve.not-fitted": {
    "text": "A curve cannot be converted to lines and arcs that deviate from it by at most {tolerance, number, ::@#####} mm.",
    "hint": "Draw the curve again, as lines and arcs."
  },
  "curve.too-many-pieces": {
    "text": "More than {limit, number} lines and arcs are needed to convert a curve with a deviation of at most {tolerance, number, ::@#####} mm.",
    "hint": "Allow a larger deviation, or simplify the curve."
  },
  "curve.too-many-spans": {
    "text": "A spline has {spans, number} spans (polynomial pieces), but the limit is {limit, number}.",
    "hint": "Simplify the spline in the CAD program before exporting."
  },
  "cut.too-many-crossings": {
    "text": "The drawing has more than {limit, number} pairs of cuts that cross each other or lie beside each other.",
    "hint": "Delete hatching and duplicate lines, or split the drawing into several drawings."
  },
  "cut.too-short": {
    "text": "The cut at edge {edge} is {length, number, ::.00} mm long and ends inside a panel or at a bridge. The slanted blade of the knife needs a cut of at least {lead, number, ::.00} mm.",
    "hint": "Set the line type of the cut to ignored, join the cut to another cut, or choose a knife with a less slanted blade."
  },
  "cutter.contour-touches-itself": {
    "text": "A contour touches itself at X{x, number, ::.000 group-off} Y{y, number, ::.000 group-off}, in the edges {edge} and {other}, so the path of a cutter of {diameter, number, ::@##} mm diameter beside it is not closed.",
    "hint": "Trim the two edges at their intersection, or move one of them."
  },
  "cutter.corner-loop": {
    "text": "The edges {edge} and {other} cross {size, number, ::@###} mm before the corner at X{x, number, ::.000 group-off} Y{y, number, ::.000 group-off}, where they meet, so the path of a cutter of {diameter, number, ::@##} mm diameter beside them is not closed.",
    "hint": "Trim the two edges at their crossing, so that the corner is there."
  },
  "cutter.interference": {
    "text": "The cutter of {diameter, number, ::.00} mm diameter does not fit beside edge {edge}: it would cut {depth, number, ::@##} mm into the part at edge {other}. The job allows no parts of contours that the cutter leaves uncut.",
    "hint": "Choose 'Leave this part uncut' (interference 'trim') and accept the shortfalls that the verdict then lists, or choose a thinner cutter."
  },
  "cutter.misses-bridge": {
    "text": "A bridge is needed on the contour at edge {edge}, {distance, number, ::.0} mm from the start of this edge in the direction of milling, but the cutter does not reach the contour there.",
    "hint": "Choose a thinner cutter, a board with another spacing of bridges, or a board without bridges."
  },
  "cutter.narrower-slits": {
    "text": "{count, plural, one {# slit} other {# slits}} become {width, number, ::@#####} mm wide. The thinnest cutter of the library, ''{title}', makes them {diameter, number, ::@#####} mm wide.",
    "hint": "Fit a cutter of {diameter, number, ::@#####} mm diameter, state it in the file of the machine and compile again, or accept the wide slits."
  },
  "cutter.short-lead": {
    "text": "The lead-in of the cutter is {lead, number, ::@#####} mm long, but must be longer than the radius of the cutter, {radius, number, ::@#####} mm.",
    "hint": "Correct the lead-in in the machine file."
  },
  "cutter.thinner-chosen": {
    "text": "The cutter of {diameter, number, ::@#####} mm diameter in station {station} makes the cuts: with the one of {thickest, number, ::@#####} mm, not all edges could be made as they are drawn.",
    "hint": ""
  },
  "cutter.thinner-needed": {
    "text": "The cutter of {own, number, ::@#####} mm diameter leaves {total, plural, one {# edge} other {# edges}} uncut. A cutter of {diameter, number, ::@#####} mm diameter, such as ''{title}' of the library, makes {count} of them.",
    "hint": "Fit a cutter of {diameter, number, ::@#####} mm diameter, state it in the file of the machine and compile again, or accept the uncut edges."
  },
  "database.bad-url": {
    "text": "''{url}'' is not the URL of a database.",
    "hint": "Write the URL as sqlite:///FILE or postgresql://USER@HOST/NAME."
  },
  "database.damaged": {
    "text": "The database {file} is damaged: {reason}.",
    "hint": "Stop the server and put a backup in its place: knifetip restore FILE --replace. Keep the older backups until then. Check the disk."
  },
  "database.folder-unusable": {
    "text": "The folder {folder} of the database cannot be used: {reason}.",
    "hint": "Choose another folder with --database sqlite:///FILE, or permit this user to write there."
  },
  "database.in-memory": {
    "text": "The server cannot use an in-memory database, because all jobs would be lost when the server stops.",
    "hint": "Use a database file: sqlite:///FILE."
  },
  "database.in-use": {
    "text": "The database {file} is in use.",
    "hint": "Stop the server and the workers that use it, then try again."
  },
  "database.missing": {
    "text": "The database {file} does not exist.",
    "hint": "Set the database with --database sqlite:///FILE."
  },
  "database.newer": {
    "text": "The database {url} was written by knifetip {writer} (revision {revision}). knifetip {version} supports revisions up to {newest} and would damage it.",
    "hint": "Use that version of knifetip or a newer one. To go back to version {version}, restore a backup from before the upgrade."
  },
  "database.newer-unrecorded": {
    "text": "The database {url} has revision {revision} of a newer or changed knifetip. knifetip {version} supports revisions up to {newest} and would damage it.",
    "hint": "Start the version of knifetip that wrote it. To go back to version {version}, restore a backup from before the upgrade."
  },
  "database.no-password": {
    "text": "The file {file} contains no password for the database.",
    "hint": "Write only the password to the file, in UTF-8."
  },
  "database.not-utf8": {
    "text": "The database {url} has the encoding {encoding}, which cannot store all names.",
    "hint": "Create it with UTF-8: CREATE DATABASE knifetip ENCODING 'UTF8' TEMPLATE template0 LC_COLLATE 'C.UTF-8' LC_CTYPE 'C.UTF-8'."
  },
  "database.older": {
    "text": "The database {url} has revision {revision}; knifetip {version} needs revision {newest}.",
    "hint": "Stop all servers and workers, make a backup, and run: knifetip db upgrade. Alternatively, start one server with --migrate."
  },
  "database.password-file": {
    "text": "The password of the database cannot be read from {file}: {reason}.",
    "hint": "Name a file that contains only the password and that this user can read."
  },
  "database.unreachable": {
    "text": "The database cannot be reached: {reason}",
    "hint": "Check the URL of the database, and that its server is running."
  },
  "database.unreleased": {
    "text": "The database {url} has revision {revision}, from before the first release. knifetip {version} migrates databases from revision {oldest} on.",
    "hint": "Start the version of knifetip that wrote it, and order unfinished jobs again with this version and a new database."
  },
  "database.unusable": {
    "text": "The database cannot be used: {reason}.",
    "hint": "Check that its file, its folder and its disk exist and can be written by this user, or choose another one with --database."
  },
  "deflection.exceeds-radius": {
    "text": "The deflection of {deflection, number, ::.000} mm cannot be corrected, because it is not smaller than the cutter's radius of {radius, number, ::.000} mm.",
    "hint": "Measure the deflection of the cutter again, or correct it in the board file."
  },
  "depth.not-set": {
    "text": "Passes or a depth were chosen for edge {edge}, but programs of {machine} do not set the depth of the knife.",
    "hint": "Remove the choice, and set the depth at the machine."
  },
  "depth.of-cutter": {
    "text": "A depth was chosen for edge {edge}, but the cutter or laser of station {station} always cuts through the whole board.",
    "hint": "Remove the depth; passes can be chosen for a cutter."
  },
  "depth.one-pass": {
    "text": "Passes were chosen for edge {edge}, but the tool of station {station} cuts in one pass.",
    "hint": "Remove the choice, or choose another machine."
  },
  "depth.other-type": {
    "text": "Passes or a depth were chosen for edge {edge}, which has the line type {type}, but they can be chosen for cuts and half-cuts only.",
    "hint": "Remove the choice."
  },
  "depth.several": {
    "text": "The contour of edge {edge} and edge {other} is milled as a whole, but different passes were chosen for its edges.",
    "hint": "Choose the same passes for all edges of the contour."
  },
  "depth.too-deep": {
    "text": "The depth chosen for edge {edge} is {depth, number, ::@#####} mm, but on this board and table the tool may cut {most, number, ::@#####} mm deep.",
    "hint": "Choose a smaller depth."
  },
  "depth.too-few-passes": {
    "text": "{passes, plural, one {# pass was} other {# passes were}} chosen for edge {edge}, but at {step, number, ::@#####} mm in one pass the tool needs {least} for a depth of {depth, number, ::@#####} mm.",
    "hint": "Choose more passes, or leave their number to the tool."
  },
  "drawing.all-ignored": {
    "text": "There is nothing to make: {count, plural, one {the only edge} other {all # edges}} of the drawing {count, plural, one {is} other {are}} ignored.",
    "hint": "Give the edges that shall be made the line type cut, crease or another one."
  },
  "drawing.answer-taken-back": {
    "text": "An answer that was learned from earlier drawings of {customer} is no longer used.",
    "hint": ""
  },
  "drawing.answer-used": {
    "text": "An answer that was learned from earlier drawings of {customer} is used again.",
    "hint": ""
  },
  "drawing.changing": {
    "text": "Another request is changing drawing {drawing} at the same time.",
    "hint": "Try again in a moment."
  },
  "drawing.deleted": {
    "text": "The drawing was deleted.",
    "hint": ""
  },
  "drawing.details-changed": {
    "text": "The details of the order were changed.",
    "hint": ""
  },
  "drawing.empty": {
    "text": "There is nothing to make: the file contains no objects.",
    "hint": "Export the drawing again, with the lines of the carton in model space."
  },
  "drawing.fits-turned": {
    "text": "The drawing measures {width, number, ::.0} × {height, number, ::.0} mm, but the table of {machine} measures only {room_x, number, ::precision-integer} × {room_y, number, ::precision-integer} mm. Turned by 90°, the drawing fits.",
    "hint": "Turn the drawing by 90° and import it again."
  },
  "drawing.in-use": {
    "text": "Drawing {drawing} cannot be deleted, because job {job} was made from it.",
    "hint": "Keep the drawing. Only drawings from which no job was made can be deleted."
  },
  "drawing.larger-than-table": {
    "text": "The drawing measures {width, number, ::.0} × {height, number, ::.0} mm, but the table of {machine} measures only {room_x, number, ::precision-integer} × {room_y, number, ::precision-integer} mm.",
    "hint": "Check the unit of the drawing, choose a larger machine, or divide the drawing."
  },
  "drawing.no-customer": {
    "text": "Drawing {drawing} has no customer, so answers from earlier drawings of a customer cannot be used for it.",
    "hint": "Set the customer of the drawing first."
  },
  "drawing.no-lines": {
    "text": "There is nothing to make: the file contains no lines that a tool can follow. {count, plural, one {The only object was} other {All # objects were}} left out: {reasons__semicolon}.",
    "hint": "Draw the carton with lines, arcs or curves in model space, parallel to the XY plane, and import it again."
  },
  "drawing.no-lines-reason": {
    "text": "{reason} ({count, plural, one {# object} other {# objects}})",
    "hint": ""
  },
  "drawing.of-another": {
    "text": "The drawing {drawing} was uploaded by somebody else and is not shared.",
    "hint": "Ask its owner or an operator to share it with all designers, or upload the file again."
  },
  "drawing.open-questions": {
    "text": "{count, plural, one {# question} other {# questions}} about the drawing must be answered first: {questions__space}",
    "hint": "Answer the questions on the page of the drawing. Edges without an answer are not cut."
  },
  "drawing.read": {
    "text": "The drawing was imported from the file {name}.",
    "hint": ""
  },
  "drawing.reinterpreted": {
    "text": "The drawing was imported again with the unit {unit__unit} and the profile {profile}.",
    "hint": ""
  },
  "drawing.stale": {
    "text": "Drawing {drawing} was changed after you loaded it. The request is for revision {named}, but the drawing is at revision {revision}.",
    "hint": "Load the drawing again, check it, and repeat the request."
  },
  "drawing.types-set": {
    "text": "{count, plural, one {# edge was} other {# edges were}} given a line type.",
    "hint": ""
  },
  "drawing.unit-for-cleaning": {
    "text": "The drawing has no unit, so the lengths of its short edges and gaps cannot be compared with the limits of cleaning, which are in mm.",
    "hint": "Set the unit of the drawing on the page, or with PATCH /api/drawings/ID."
  },
  "drawing.unit-unknown": {
    "text": "The unit of the drawing is not known ({evidence}).",
    "hint": "Set the unit of the drawing on the page, with --unit, or with PATCH /api/drawings/ID."
  },
  "drawing.unknown": {
    "text": "Drawing {drawing} does not exist. It may have been deleted.",
    "hint": "Go back to the list of drawings and open another drawing."
  },
  "drawing.upload-too-large": {
    "text": "The file {name} is larger than {limit} MB.",
    "hint": "Send a smaller file, for example without pictures."
  },
  "dry-run.in-progress": {
    "text": "The machine is making a dry run of job {job} above the board, so the job was not started.",
    "hint": "Wait until the dry run has ended, or stop it. Then start the job."
  },
  "dry-run.no-job": {
    "text": "No job waits for its start at this machine, so there is no program for a dry run above the board.",
    "hint": "Release a job for this machine, and request the dry run before the job is started."
  },
  "dry-run.no-lift": {
    "text": "Internal error: line {line} of the dry run must lift the tool straight up to Z {height, number, ::@#####}, but does something else. Nothing was sent.",
    "hint": "Report this to the maker of knifetip, with the program of the job."
  },
  "dry-run.no-work": {
    "text": "The program of the job does not touch the board, so there is no frame to trace above it.",
    "hint": "Open the job and check its program."
  },
  "dry-run.not-running": {
    "text": "The machine is not making a dry run, so there is nothing to hold or to resume.",
    "hint": ""
  },
  "dry-run.other-path": {
    "text": "Internal error: line {line} of the dry run leaves the path of the program. Nothing was sent.",
    "hint": "Report this to the maker of knifetip, with the program of the job."
  },
  "dry-run.switches": {
    "text": "Internal error: line {line} of the dry run switches an output or the spindle on. Nothing was sent.",
    "hint": "Report this to the maker of knifetip, with the program of the job."
  },
  "dry-run.too-low": {
    "text": "Internal error: line {line} of the dry run moves Z to {z, number, ::@#####}, but Z must stay at {height, number, ::@#####} or higher. Nothing was sent.",
    "hint": "Report this to the maker of knifetip, with the program of the job."
  },
  "dry-run.unknown-line": {
    "text": "Line {line} of the program cannot be used in a dry run above the board: ''{text}''. Nothing was sent.",
    "hint": "Compile the job again. A program that was edited by hand cannot be used in a dry run."
  },
  "dry-run.uses-machine": {
    "text": "The machine is making a dry run above the board.",
    "hint": "Wait until the dry run has ended, or stop it first."
  },
  "dxf.at-line": {
    "text": "at line {line} of the file",
    "hint": ""
  },
  "dxf.blocks-expand-too-far": {
    "text": "The blocks of the DXF file expand to {count} entities (drawn objects), but the limit is {limit, number}.",
    "hint": "Export a drawing with a single carton, or explode the blocks and delete the copies that are not needed."
  },
  "dxf.blocks-too-deep": {
    "text": "The blocks of the DXF file are nested {depth} levels deep, but the limit is {limit} levels.",
    "hint": "Explode the blocks in the CAD program and export again."
  },
  "dxf.coordinate-alone": {
    "text": "The DXF file is damaged at line {line}: the coordinate with group code {code} of an object of the type {kind} belongs to a point, of which the other coordinate is missing.",
    "hint": "Export the drawing again."
  },
  "dxf.cut-short": {
    "text": "The DXF file is incomplete: it ends {where} in the section {section}, after {count, plural, one {# entity (drawn object)} other {# entities (drawn objects)}}. Objects of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again."
  },
  "dxf.no-section": {
    "text": "The file is not a DXF file, because it has no section.",
    "hint": "Export the drawing as DXF (text or binary, any version)."
  },
  "dxf.not-a-group-code": {
    "text": "The file is not a DXF file, because line {line} is ''{text}'' instead of a group code (a whole number).",
    "hint": "Export the drawing as DXF (text or binary, any version)."
  },
  "dxf.not-a-number": {
    "text": "The DXF file is damaged at line {line}: the value ''{text}'' of group code {code} of an object of the type {kind} is not a number.",
    "hint": "Export the drawing again, with a point as the decimal separator of numbers."
  },
  "dxf.other-kind": {
    "text": "The file has the format {kind}, not DXF.",
    "hint": "Export the drawing as DXF (text or binary, any version)."
  },
  "dxf.too-large-unusual": {
    "text": "The DXF file has {size, number, ::.0} MB and uses features that take long to read. The limit for such files is {limit, number, ::.0} MB.",
    "hint": "Export a drawing with a single carton, or save it as DXF R2000."
  },
  "dxf.without-end-mark": {
    "text": "without the end marker EOF",
    "hint": ""
  },
  "edge-choice.bad-syntax": {
    "text": "''{text}'' is not a value of {option}.",
    "hint": "Write it as EDGES:NAME=VALUE,NAME=VALUE, with the numbers of the edges and what is chosen for them, for example 12,13:passes=2."
  },
  "edge-choice.joined": {
    "text": "Edge {edge} and edge {other} are made as one edge, but different options were chosen for them.",
    "hint": "Choose the same for both."
  },
  "edge-choice.no-edge": {
    "text": "An option was chosen for edge {row}, but the drawing has {count, plural, one {# edge} other {# edges}}, numbered from 0.",
    "hint": "Choose an edge of this drawing."
  },
  "edge.no-length": {
    "text": "These edges have a length of 0, so they have no direction: edge {edges}.",
    "hint": "Delete these edges from the drawing."
  },
  "edge.not-finite": {
    "text": "Edge {edge} has a coordinate that is not a number.",
    "hint": "Draw the edge again."
  },
  "edge.place": {
    "text": " at edge {edge}",
    "hint": ""
  },
  "edge.too-crowded": {
    "text": "More than {limit, number} pairs of end points of edges lie closer together than {distance, number, ::@##############} mm.",
    "hint": "Delete edges that are drawn many times on top of each other."
  },
  "edge.too-far": {
    "text": "Edge {edge} lies {distance, number, ::@##} mm away from the origin of the drawing, which is too far to be processed.",
    "hint": "Check the unit of the drawing, or delete the edge."
  },
  "edge.too-many-overlaps": {
    "text": "{edges, number} edges overlap each other at more than {limit, number} positions.",
    "hint": "Delete edges that are drawn many times on top of each other."
  },
  "error.at-edge": {
    "text": "{error} This concerns {count, plural, one {edge} other {# edges:}} {edges}{more}. Edge {edge} is part of the object with the handle {handle} on the layer \"{layer}\".",
    "hint": "{error__hint}"
  },
  "error.at-edges": {
    "text": "Edges {edges__and}: {error}",
    "hint": "{error__hint}"
  },
  "error.in-file": {
    "text": "File {name}: {error}",
    "hint": "{error__hint}"
  },
  "error.more-edges": {
    "text": " and {count} more",
    "hint": ""
  },
  "field.above": {
    "text": "{path} is {value}, but must be at most {limit, number, ::@#####}",
    "hint": ""
  },
  "field.above-clearance": {
    "text": "{path} is {value, number, ::@#####} mm, but must not be more than clearance, {clearance, number, ::@#####} mm",
    "hint": ""
  },
  "field.bad-arguments": {
    "text": "{path} has arguments that do not fit the message code ''{name}''",
    "hint": ""
  },
  "field.bad-json": {
    "text": "{path} is not valid JSON: the fault is in line {line}, column {column}",
    "hint": ""
  },
  "field.below": {
    "text": "{path} is {value}, but must be at least {limit, number, ::@#####}",
    "hint": ""
  },
  "field.blank": {
    "text": "{path} is empty",
    "hint": ""
  },
  "field.control-character": {
    "text": "{path} contains the control character {character}, which cannot be seen or typed",
    "hint": "Remove it, or type the text again."
  },
  "field.edges-or-line-type": {
    "text": "{path} must have either edges or line_type",
    "hint": ""
  },
  "field.gantry-without-heading": {
    "text": "{path}: a machine with carriages needs an axis c in [axes]",
    "hint": ""
  },
  "field.inconsistent": {
    "text": "{path} contradicts other fields: {fault}",
    "hint": ""
  },
  "field.metadata-too-large": {
    "text": "{path} is larger than {most} kB",
    "hint": ""
  },
  "field.missing": {
    "text": "{path} is missing",
    "hint": ""
  },
  "field.misspelt": {
    "text": "{path} is not a known field; perhaps {near} is meant",
    "hint": ""
  },
  "field.needs-heading": {
    "text": "{path}: station {station} has a tool that an axis must turn, but [axes] has no c. Tools of such a machine are a free knife, a cutter or a laser",
    "hint": ""
  },
  "field.nested-too-deep": {
    "text": "{path} is nested too deeply",
    "hint": ""
  },
  "field.no-kind": {
    "text": "{path} does not state its kind: the field {field} is missing",
    "hint": ""
  },
  "field.no-neighbour": {
    "text": "{path} must contain previous, next or both",
    "hint": ""
  },
  "field.no-spindle": {
    "text": "{path}: `spindle` and `spindle_speed` are set, but the tool of station {station} has no oscillation and no spindle",
    "hint": ""
  },
  "field.no-such-carriage": {
    "text": "{path}: station {station} is on carriage {carriage}, but the machine has {count, plural, one {# carriage} other {# carriages}}",
    "hint": ""
  },
  "field.no-year": {
    "text": "{path} is {value}, but must be in the years 1 to 9999 of UTC",
    "hint": ""
  },
  "field.not-a-colour": {
    "text": "{path} is {value}, but must be a whole number from 1 to 255 or \"#rrggbb\"",
    "hint": ""
  },
  "field.not-a-line-type": {
    "text": "{path} is ''{value}'', but must be a line type: {known__or}",
    "hint": ""
  },
  "field.not-a-list": {
    "text": "{path} is {value}, but must be a list",
    "hint": ""
  },
  "field.not-a-number": {
    "text": "{path} is {value}, but must be a number",
    "hint": ""
  },
  "field.not-a-profile": {
    "text": "{path} is ''{value}'', but must be a profile of the library: {known__or}",
    "hint": ""
  },
  "field.not-a-table": {
    "text": "{path} is {value}, but must be a table of fields",
    "hint": ""
  },
  "field.not-a-time": {
    "text": "{path} is {value}, but must be a time in RFC 3339 with its offset, such as 2030-01-02T03:04:05Z",
    "hint": ""
  },
  "field.not-above": {
    "text": "{path} is {value}, but must be greater than {limit, number, ::@#####}",
    "hint": ""
  },
  "field.not-above-low": {
    "text": "{path} is {value, number, ::@#####}, but must be greater than the value of the field low, which is {low, number, ::@#####}",
    "hint": ""
  },
  "field.not-below": {
    "text": "{path} is {value}, but must be less than {limit, number, ::@#####}",
    "hint": ""
  },
  "field.not-boolean": {
    "text": "{path} is {value}, but must be true or false",
    "hint": ""
  },
  "field.not-empty": {
    "text": "{path} is {value}, but must be null",
    "hint": ""
  },
  "field.not-json": {
    "text": "{path} is not valid JSON: {reason}",
    "hint": ""
  },
  "field.not-less-than-caliper": {
    "text": "{path} is {value, number, ::@#####} mm, but must be less than the caliper of {caliper, number, ::@#####} mm",
    "hint": ""
  },
  "field.not-one-of": {
    "text": "{path} is {value}, but must be {known__or}",
    "hint": ""
  },
  "field.not-text": {
    "text": "{path} is {value}, but must be text",
    "hint": ""
  },
  "field.not-whole": {
    "text": "{path} is {value}, but must be a whole number",
    "hint": ""
  },
  "field.other": {
    "text": "{path} is {value}, which is not valid ({fault})",
    "hint": ""
  },
  "field.outside": {
    "text": "{path} is {value}, but must be from {low, number, ::@#####} to {high, number, ::@#####}",
    "hint": ""
  },
  "field.override-range": {
    "text": "{path}: the feed override from {low} to {high} % must contain 100 %",
    "hint": ""
  },
  "field.park-outside": {
    "text": "{path} parks at {park, number, ::@#####} mm, outside the travel of its y axis from {low, number, ::@#####} to {high, number, ::@#####} mm",
    "hint": ""
  },
  "field.parks-too-near": {
    "text": "{path} has two carriages that park {distance, number, ::@#####} mm apart, but min_distance is {least, number, ::@#####} mm",
    "hint": ""
  },
  "field.repeated-letters": {
    "text": "{path} has the letters {letters}; each letter may occur only once",
    "hint": ""
  },
  "field.repeated-numbers": {
    "text": "{path} has the numbers {numbers}; each number may occur only once",
    "hint": ""
  },
  "field.rest-choice": {
    "text": "{path} must contain whole alone (copies are possible only with it), or a start (from_track or from_line), a station, or both",
    "hint": ""
  },
  "field.sheet-size": {
    "text": "{path} must have both width and height, or none of width, height and margin",
    "hint": ""
  },
  "field.spacing": {
    "text": "{path} is {value, number, ::@#####} mm, but must be either 0 or at least {least, number, ::@#####} mm",
    "hint": ""
  },
  "field.spindle-of-beam": {
    "text": "{path}: `spindle` and `spindle_speed` are set, but station {station} has a laser, which is switched by M3 with its `power`",
    "hint": ""
  },
  "field.too-few": {
    "text": "{path} has {count, plural, one {# value} other {# values}}, but needs at least {least}",
    "hint": ""
  },
  "field.too-long": {
    "text": "{path} is longer than {most} characters",
    "hint": ""
  },
  "field.too-many": {
    "text": "{path} has more than {most} values",
    "hint": ""
  },
  "field.too-many-passes": {
    "text": "{path} is {value, number, ::@#####} mm, which is too small: the V-groove would need more than {most} passes",
    "hint": ""
  },
  "field.too-short": {
    "text": "{path} has fewer than {least, plural, one {# character} other {# characters}}",
    "hint": ""
  },
  "field.unknown": {
    "text": "{path} is not a known field",
    "hint": ""
  },
  "field.unknown-kind": {
    "text": "{path} has the unknown kind ''{value}''; known kinds are {known}",
    "hint": ""
  },
  "field.wrong-form": {
    "text": "{path} is {value}, which does not have the required form",
    "hint": ""
  },
  "field.wrong-order": {
    "text": "{path}: {second} must not be before {first}",
    "hint": ""
  },
  "field.zone-above-travel": {
    "text": "{path}: the top of the zone {zone} is {top, number, ::@#####} mm above the mat and the clearance is {clearance, number, ::@#####} mm, but tools travel at travel_z = {travel_z, number, ::@#####} mm; raise travel_z",
    "hint": ""
  },
  "file.3mf": {
    "text": "a 3MF model",
    "hint": "In the CAD program, make a flat drawing of the carton, and export it as DXF."
  },
  "file.7z": {
    "text": "a 7z archive",
    "hint": ""
  },
  "file.affinity": {
    "text": "an Affinity document",
    "hint": "In Affinity, choose File > Export, and SVG or PDF as the type."
  },
  "file.ard": {
    "text": "an ArtiosCAD design (ARD)",
    "hint": "In ArtiosCAD, choose File > Outputs, and CFF2 or DXF as the type."
  },
  "file.binary": {
    "text": "a binary file of an unknown format",
    "hint": "In the program that drew it, export the drawing as DXF. In ArtiosCAD (.ard), choose File > Outputs, and DXF or CFF2 as the type."
  },
  "file.bmp": {
    "text": "a BMP picture",
    "hint": "A picture has no lines that can be cut. In the program that drew it, export the drawing as DXF, SVG or PDF."
  },
  "file.cdr": {
    "text": "a CorelDRAW drawing (CDR)",
    "hint": "In CorelDRAW, choose File > Export, and SVG or DXF as the type."
  },
  "file.compound-file": {
    "text": "an old Office file, or a CAD file in the same container format",
    "hint": "In the program that drew it, export the drawing as DXF."
  },
  "file.ddes": {
    "text": "a DDES file (DDES2 or DDES3, ANSI IT8.6)",
    "hint": "In ArtiosCAD, choose File > Outputs, and CFF2 or DXF as the type. In another CAD program, export the drawing as CF2 or DXF."
  },
  "file.dmpl": {
    "text": "a plotter file in the language DM/PL",
    "hint": "In the program that drew it, choose a plotter with HPGL, or export the drawing as DXF, PDF or SVG."
  },
  "file.dwf": {
    "text": "a DWF drawing, which is only for display",
    "hint": "In the CAD program that wrote it, save the drawing as DXF."
  },
  "file.dwg": {
    "text": "a DWG drawing",
    "hint": "In AutoCAD or another CAD program, choose File > Save As, and DXF (such as DXF 2013) as the type."
  },
  "file.eps": {
    "text": "an EPS file",
    "hint": "In Illustrator, open the file and choose File > Save As > PDF. In other programs, export the drawing as PDF, SVG or DXF."
  },
  "file.gcode": {
    "text": "a program for a machine (G-code)",
    "hint": "Send the drawing from which the program was made."
  },
  "file.gif": {
    "text": "a GIF picture",
    "hint": "A picture has no lines that can be cut. In the program that drew it, export the drawing as DXF, SVG or PDF."
  },
  "file.gzip": {
    "text": "a gzip archive",
    "hint": ""
  },
  "file.html": {
    "text": "an HTML page",
    "hint": ""
  },
  "file.iges": {
    "text": "an IGES file",
    "hint": "In the CAD program, make a flat drawing of the carton, and export it as DXF."
  },
  "file.illustrator": {
    "text": "an old Illustrator file without PDF content",
    "hint": "In Illustrator, choose File > Save As with the option 'Create PDF Compatible File', or export the drawing as PDF, SVG or DXF."
  },
  "file.indesign": {
    "text": "an InDesign document",
    "hint": "In InDesign, choose File > Export, and Adobe PDF (Print) as the type."
  },
  "file.jpeg": {
    "text": "a JPEG picture",
    "hint": "A picture has no lines that can be cut. In the program that drew it, export the drawing as DXF, SVG or PDF."
  },
  "file.json": {
    "text": "a JSON file",
    "hint": ""
  },
  "file.metafile": {
    "text": "a Windows metafile (EMF or WMF)",
    "hint": "In the program that drew it, export the drawing as SVG, PDF or DXF."
  },
  "file.office": {
    "text": "an Office document",
    "hint": "Send the drawing in it as a separate file. A drawing that was made in the Office program can be saved as PDF."
  },
  "file.old-dwg": {
    "text": "an old DWG drawing",
    "hint": "In AutoCAD or another CAD program, choose File > Save As, and DXF (such as DXF 2013) as the type."
  },
  "file.photoshop": {
    "text": "a Photoshop picture",
    "hint": "A picture has no lines that can be cut. In the program that drew it, export the drawing as DXF, SVG or PDF."
  },
  "file.png": {
    "text": "a PNG picture",
    "hint": "A picture has no lines that can be cut. In the program that drew it, export the drawing as DXF, SVG or PDF."
  },
  "file.postscript": {
    "text": "a PostScript file",
    "hint": "In Illustrator, open the file and choose File > Save As > PDF. In other programs, export the drawing as PDF, SVG or DXF."
  },
  "file.printer": {
    "text": "a file for a printer (PCL or PJL)",
    "hint": "In the program that drew it, export the drawing as DXF, PDF or SVG instead of printing it to a file."
  },
  "file.rar": {
    "text": "a RAR archive",
    "hint": ""
  },
  "file.rhino": {
    "text": "a Rhino model",
    "hint": "In Rhino, select the flat curves, and choose File > Export Selected, and DXF as the type."
  },
  "file.riff": {
    "text": "a picture or a video (RIFF)",
    "hint": "A picture has no lines that can be cut. In the program that drew it, export the drawing as DXF, SVG or PDF."
  },
  "file.silhouette": {
    "text": "a project of Silhouette Studio",
    "hint": "In Silhouette Studio Business Edition, choose File > Save As, and SVG or PDF as the type."
  },
  "file.sketchup": {
    "text": "a SketchUp model",
    "hint": "In SketchUp, choose File > Export > 2D Graphic, and DXF or PDF as the type."
  },
  "file.step": {
    "text": "a STEP file",
    "hint": "In the CAD program, make a flat drawing of the carton, and export it as DXF."
  },
  "file.stl": {
    "text": "an STL model",
    "hint": "In the CAD program, make a flat drawing of the carton, and export it as DXF."
  },
  "file.tiff": {
    "text": "a TIFF picture",
    "hint": "A picture has no lines that can be cut. In the program that drew it, export the drawing as DXF, SVG or PDF."
  },
  "file.xml": {
    "text": "an XML file of the type ''{element}''",
    "hint": ""
  },
  "file.xps": {
    "text": "an XPS document",
    "hint": "In the program that drew it, export the drawing as PDF, SVG or DXF, or print it to a PDF."
  },
  "file.zip": {
    "text": "a ZIP archive",
    "hint": "Unpack the archive, and send the drawing in it."
  },
  "finding.at-edge": {
    "text": "Edge {edge}: {fault}",
    "hint": "{fault__hint}"
  },
  "finding.at-edge-and-line": {
    "text": "Edge {edge}, program line {line}: {fault}",
    "hint": "{fault__hint}"
  },
  "finding.at-line": {
    "text": "Program line {line}: {fault}",
    "hint": "{fault__hint}"
  },
  "finding.more": {
    "text": " {count, plural, one {# more finding is} other {# more findings are}} not listed here.",
    "hint": ""
  },
  "folder.bad-address": {
    "text": "''{address}'' is not the address of a folder on this computer.",
    "hint": "Write it as file:///FOLDER with the full path of the folder, for example file:///srv/programs."
  },
  "folder.deleted": {
    "text": "The program file {file} was still in the folder and was deleted. The software of the machine may have read it before.",
    "hint": "Check at the machine that the program is not loaded. If it runs, stop it there."
  },
  "folder.not-deleted": {
    "text": "The program file {file} could not be deleted ({reason}).",
    "hint": "Delete the file. Check at the machine that the program is not loaded."
  },
  "folder.not-written": {
    "text": "The program was not written into the folder {folder}, so the machine did not get it.",
    "hint": "Check the folder, then queue the job again."
  },
  "folder.taken": {
    "text": "The software of the machine has taken the program file {file}, so the machine may execute it.",
    "hint": "Stop the program at the machine. Nothing can be stopped from here."
  },
  "folder.unusable": {
    "text": "Programs cannot be written into the folder {folder} ({reason}).",
    "hint": "Create the folder, or give the user of the gateway the permission to write into it."
  },
  "gateway.access-refused": {
    "text": "The server {server} refuses this gateway: {reason}",
    "hint": "Create a key with knifetip key create NAME --scope gateway, give it to the gateway with --key-file PATH, and start the gateway again."
  },
  "gateway.cancelled": {
    "text": "The operator cancelled the job at program line {line}.",
    "hint": ""
  },
  "gateway.controller-not-idle": {
    "text": "{name} is not idle: it reports the state {state}.",
    "hint": "Wait until the controller is idle, or reset the controller at the table."
  },
  "gateway.job-withdrawn": {
    "text": "The server withdrew the job from the gateway (the program that sends jobs to the machine), and the machine was stopped.",
    "hint": "Check the table and the board on it."
  },
  "gateway.job-withdrawn-before-start": {
    "text": "The server withdrew the job from the gateway before the job was started. Nothing was sent to the machine.",
    "hint": ""
  },
  "gateway.machine-changed": {
    "text": "Version {version} of the machine {machine} is no longer the newest.",
    "hint": "Load the definition of the machine again."
  },
  "gateway.no-reason": {
    "text": "The gateway (the program that sends jobs to the machine) ended the job without stating a reason.",
    "hint": "Look for the cause in the log of the gateway."
  },
  "gateway.not-claimed": {
    "text": "The job {job} was not claimed with this key, so its program is not given out.",
    "hint": "Claim the job first."
  },
  "gateway.outdated-machine": {
    "text": "The gateway {gateway} uses version {version} of the machine {machine}, whose newest version is {newest}.",
    "hint": "Load the definition of the machine again, or restart the gateway."
  },
  "gateway.server-silent-before-start": {
    "text": "The server did not answer before the program was to begin. Nothing was sent to the machine.",
    "hint": "Check the network connection of the gateway."
  },
  "gateway.started-in-dry-run": {
    "text": "The job was started while the machine was making a dry run above the board. Nothing of the job was sent to the machine.",
    "hint": "Queue the job again, and start it when the machine is at rest."
  },
  "gateway.switched-off": {
    "text": "The gateway (the program that sends jobs to the machine) was stopped.",
    "hint": ""
  },
  "gateway.switched-off-before-begin": {
    "text": "The gateway (the program that sends jobs to the machine) was switched off before the program was begun. No line of it was executed.",
    "hint": ""
  },
  "gateway.switched-off-before-report": {
    "text": "The machine finished the job, but the gateway (the program that sends jobs to the machine) was stopped before the result was reported.",
    "hint": ""
  },
  "gateway.switched-off-in-run": {
    "text": "The gateway (the program that sends jobs to the machine) was stopped while the machine executed the job. The gateway then sent the machine the command to stop.",
    "hint": "Check the table, then start the gateway again."
  },
  "gateway.system-error": {
    "text": "The operating system on the computer of the gateway reports an error: {reason}.",
    "hint": "Correct the cause of the error on this computer, then start the gateway again."
  },
  "grbl.alarm-1": {
    "text": "a limit switch was hit, so the position of the machine is lost",
    "hint": "Check what the head has hit. Home the machine, or unlock it and jog it away from the switch."
  },
  "grbl.alarm-10": {
    "text": "an emergency stop button is pressed",
    "hint": "Release the emergency stop button when the table is safe, then home the machine."
  },
  "grbl.alarm-11": {
    "text": "the machine must be homed first",
    "hint": "Clear the table, then home the machine."
  },
  "grbl.alarm-12": {
    "text": "a limit switch is triggered",
    "hint": "Unlock the machine, jog it away from the switch, then home it."
  },
  "grbl.alarm-14": {
    "text": "the spindle did not reach its speed",
    "hint": "Check the spindle and its cable, then unlock the machine."
  },
  "grbl.alarm-17": {
    "text": "a motor driver reports a fault",
    "hint": "Check the motor drivers and their supply, then home the machine."
  },
  "grbl.alarm-2": {
    "text": "a move would have gone beyond the travel range of the machine",
    "hint": "Check the work zero and the placement of the job, then unlock the machine."
  },
  "grbl.alarm-3": {
    "text": "the controller was reset during a move, so the position of the machine may be lost",
    "hint": "Check the table, then home the machine."
  },
  "grbl.alarm-4": {
    "text": "the probe was not in the expected state before probing",
    "hint": "Check the probe and its cable, then unlock the machine."
  },
  "grbl.alarm-5": {
    "text": "the probe did not touch the workpiece",
    "hint": "Check the probe and the board, then unlock the machine."
  },
  "grbl.alarm-6": {
    "text": "the controller was reset during homing",
    "hint": "Clear the table, then home the machine again."
  },
  "grbl.alarm-7": {
    "text": "the safety door was opened during homing",
    "hint": "Close the safety door, then home the machine again."
  },
  "grbl.alarm-8": {
    "text": "the limit switch stayed triggered when the machine moved away from it during homing",
    "hint": "Check the limit switches and their cables, then home the machine."
  },
  "grbl.alarm-9": {
    "text": "homing did not reach the limit switch",
    "hint": "Check the limit switches and their cables, then home the machine."
  },
  "grbl.axis-letter-used": {
    "text": "the controller names the rotary axis {letter}, and the line already contains this letter",
    "hint": ""
  },
  "grbl.error-1": {
    "text": "a number has no letter before it",
    "hint": ""
  },
  "grbl.error-10": {
    "text": "soft limits can be enabled only if homing is enabled",
    "hint": ""
  },
  "grbl.error-11": {
    "text": "the line is too long",
    "hint": ""
  },
  "grbl.error-12": {
    "text": "the setting exceeds the maximum step rate of the controller",
    "hint": ""
  },
  "grbl.error-13": {
    "text": "a safety door is open",
    "hint": ""
  },
  "grbl.error-14": {
    "text": "the start-up line or the build information is too long to be stored",
    "hint": ""
  },
  "grbl.error-15": {
    "text": "the jog target lies outside the travel of the machine",
    "hint": ""
  },
  "grbl.error-16": {
    "text": "the jog command has no feed, or contains a word that is not allowed in it",
    "hint": ""
  },
  "grbl.error-17": {
    "text": "laser mode needs a PWM output",
    "hint": ""
  },
  "grbl.error-18": {
    "text": "the controller was reset, so it did not execute the command",
    "hint": ""
  },
  "grbl.error-2": {
    "text": "a number is missing or cannot be read",
    "hint": ""
  },
  "grbl.error-20": {
    "text": "the controller does not support this command",
    "hint": ""
  },
  "grbl.error-21": {
    "text": "the line has two commands of one modal group, for example G0 and G1",
    "hint": ""
  },
  "grbl.error-22": {
    "text": "no feed has been set",
    "hint": ""
  },
  "grbl.error-23": {
    "text": "the number of the command must be an integer",
    "hint": ""
  },
  "grbl.error-24": {
    "text": "the line has two commands that both need axis words",
    "hint": ""
  },
  "grbl.error-25": {
    "text": "a word is repeated in the line",
    "hint": ""
  },
  "grbl.error-26": {
    "text": "the line lacks the axis words that its command needs",
    "hint": ""
  },
  "grbl.error-27": {
    "text": "the line number is out of range",
    "hint": ""
  },
  "grbl.error-28": {
    "text": "the command lacks its P or L word",
    "hint": ""
  },
  "grbl.error-29": {
    "text": "the controller does not support this work coordinate system",
    "hint": ""
  },
  "grbl.error-3": {
    "text": "the controller does not support this $ command",
    "hint": ""
  },
  "grbl.error-30": {
    "text": "G53 is used without G0 or G1",
    "hint": ""
  },
  "grbl.error-31": {
    "text": "the line has axis words (X, Y, Z), but no command that uses them",
    "hint": ""
  },
  "grbl.error-32": {
    "text": "the arc has no axis words in its plane",
    "hint": ""
  },
  "grbl.error-33": {
    "text": "the start and end of the arc do not lie on one circle",
    "hint": ""
  },
  "grbl.error-34": {
    "text": "the radius of the arc cannot be computed",
    "hint": ""
  },
  "grbl.error-35": {
    "text": "the arc has no centre, because both I and J are missing",
    "hint": ""
  },
  "grbl.error-36": {
    "text": "the line has words (a letter with a number) that no command uses",
    "hint": ""
  },
  "grbl.error-37": {
    "text": "the tool length offset is applied to the wrong axis",
    "hint": ""
  },
  "grbl.error-38": {
    "text": "the tool number is too high",
    "hint": ""
  },
  "grbl.error-39": {
    "text": "a value is out of range",
    "hint": ""
  },
  "grbl.error-4": {
    "text": "a value is negative, but must be positive",
    "hint": ""
  },
  "grbl.error-5": {
    "text": "homing is disabled in the settings of the controller",
    "hint": ""
  },
  "grbl.error-6": {
    "text": "the step pulse is too short",
    "hint": ""
  },
  "grbl.error-60": {
    "text": "the memory card of the controller could not be opened",
    "hint": ""
  },
  "grbl.error-7": {
    "text": "the settings of the controller could not be read, so the defaults were restored",
    "hint": ""
  },
  "grbl.error-79": {
    "text": "an emergency stop button is pressed",
    "hint": ""
  },
  "grbl.error-8": {
    "text": "the command is allowed only while the controller is idle",
    "hint": ""
  },
  "grbl.error-9": {
    "text": "the controller is locked by an alarm, or is jogging",
    "hint": ""
  },
  "grbl.no-output": {
    "text": "the controller has no digital output {output} (it has {count, plural, one {# output} other {# outputs}})",
    "hint": ""
  },
  "grbl.no-reverse": {
    "text": "this build of grbl turns the spindle in one direction only (option D), and has no M4",
    "hint": "Install a build without the option, or set `spindle = \"M3\"` for the station."
  },
  "grbl.no-rotary-axis": {
    "text": "the controller has no axis that rotates the tool (its axes are {axes})",
    "hint": ""
  },
  "grbl.unknown-alarm": {
    "text": "the alarm code is not documented by Grbl",
    "hint": "Read the manual of the controller and check the table, then home the machine."
  },
  "grbl.unknown-error": {
    "text": "the error code is not documented by Grbl",
    "hint": ""
  },
  "groove.along-edge": {
    "text": "The V-groove at edge {edge} meets the edge of the board at an angle of only {angle, number, ::.0}°, so it would run along the edge of the board instead of ending there.",
    "hint": "End the groove before the edge of the board, or let it meet the edge of the board at 5° or more."
  },
  "groove.curved": {
    "text": "{count, plural, one {# V-groove is an arc} other {# V-grooves are arcs}} (first: edge {edge}), which a straight blade cannot follow.",
    "hint": "Draw the V-grooves with straight lines, permit chords in the board file (groove_curve), or choose another line type for them."
  },
  "groove.overcut": {
    "text": "The V-cutter cuts {overrun, number, ::.00} mm too far at each end of a groove that ends inside the board, but the board allows an overcut of only {allowed, number, ::.00} mm.",
    "hint": "Choose a V-cutter with a narrower blade, or allow a longer overcut in the board file."
  },
  "groove.runs-out": {
    "text": "The V-groove at edge {edge} would continue {distance, number, ::.00} mm beyond the edge of the board and cut into the next part.",
    "hint": "End the groove before the edge of the board, let it meet the edge of the board at a larger angle, or move the parts apart."
  },
  "groove.through-cut": {
    "text": "The V-groove at edge {groove} is {width, number, ::.00} mm wide at the top face of the board. At {place, number, ::.0} mm from the start of the groove, its flank reaches {through, number, ::.00} mm sideways across the cut at edge {cut}. The cut lies only {distance, number, ::.00} mm from the centre line of the groove. The board allows a groove to be shifted away from cuts on one side by at most {limit, number, ::.00} mm.",
    "hint": "Move the groove and the cut {through, number, ::.00} mm further apart, or choose a board with a shallower groove."
  },
  "groove.through-cut-at-it": {
    "text": "The V-groove at edge {groove} is {width, number, ::.00} mm wide at the top face of the board. At {place, number, ::.0} mm from the start of the groove, its flank reaches {through, number, ::.00} mm sideways across the cut at edge {cut}. The cut lies only {distance, number, ::.00} mm from the centre line of the groove.",
    "hint": "End the groove at the cut, let the cut cross the groove at 45° or more, or move one of them."
  },
  "groove.tight-bend": {
    "text": "The V-groove at edge {edge} is bent with a radius of {radius, number, ::.0} mm. A straight blade of {blade, number, ::.00} mm width would deviate from this bend by more than {error, number, ::.000} mm.",
    "hint": "Draw the groove with a larger radius, choose a V-cutter with a narrower blade, or allow a larger deviation in the board file."
  },
  "groove.too-deep": {
    "text": "The V-groove at edge {edge} is {depth, number, ::.00} mm deep, but the board is only {caliper, number, ::.00} mm thick.",
    "hint": "Choose a shallower groove or a thicker board."
  },
  "groove.too-short": {
    "text": "The V-groove at edge {edge} is {length, number, ::.00} mm long, but the blade is {blade, number, ::.00} mm wide.",
    "hint": "Draw a longer groove, or choose a V-cutter with a narrower blade."
  },
  "hpgl.bad-address": {
    "text": "''{address}'' is not the address of a plotter.",
    "hint": "Write it as tcp://HOST, or as serial:///dev/ttyUSB0?baud=9600&flow=rtscts; a serial port needs flow=rtscts or flow=xonxoff, as it is set at the plotter. &buffer=1024 states how many bytes the connection and the plotter hold."
  },
  "hpgl.bad-area": {
    "text": "{path} is {value}, but must be [x0, y0, x1, y1] with x0 < x1 and y0 < y1",
    "hint": "Write the corners of the area in plotter units, the lower left corner first."
  },
  "hpgl.bad-byte": {
    "text": "The program line contains the byte {byte}, which is not allowed in an HPGL program.",
    "hint": "Remove the byte."
  },
  "hpgl.bad-feed": {
    "text": "{place} has a feed of {feed, number, ::@#####} mm/min, but {device} supports only multiples of {step, number, ::@#####} mm/min from {slowest, number} to {fastest, number} mm/min.",
    "hint": "Choose one of these feeds for the tool in the machine file."
  },
  "hpgl.bad-number": {
    "text": "The program line has a plus or minus sign that is not followed by a number, or a number with too many digits.",
    "hint": "Correct the number."
  },
  "hpgl.bad-range": {
    "text": "{path} is {value}, but must be [least, greatest] with 0 < least ≤ greatest",
    "hint": "Write the two values in this order."
  },
  "hpgl.datum": {
    "text": "{path} has an offset or an output, but an HPGL program cannot use these settings: the machine itself stores the tool offsets and lowers the tools",
    "hint": "Set all values of datum to 0 and remove output."
  },
  "hpgl.depth-change": {
    "text": "{place} changes the depth of the tool during a cut, which HPGL cannot express.",
    "hint": "Choose a board and a tool with which each cut needs only one pass."
  },
  "hpgl.ends-down": {
    "text": "The program ends while the tool is down.",
    "hint": "Lift the tool (PU) before the end of the program."
  },
  "hpgl.ends-with-pen": {
    "text": "The program ends while a pen is selected.",
    "hint": "Deselect the pen (SP0) before the end of the program."
  },
  "hpgl.feed-not-supported": {
    "text": "{path} is {value, number, ::@#####} mm/min, but {device} supports only multiples of {step, number, ::@#####} mm/min from {slowest, number, ::@#####} to {fastest, number, ::@#####}",
    "hint": "Choose one of these feeds."
  },
  "hpgl.force-out-of-range": {
    "text": "The force (FS) in the program line is not between {low} and {high}.",
    "hint": "Give a force in this range."
  },
  "hpgl.initialised-again": {
    "text": "The program line initialises the machine (IN) a second time.",
    "hint": "Delete the second IN."
  },
  "hpgl.lone-letter": {
    "text": "The program line has a single letter, but each HPGL instruction has two letters.",
    "hint": "Correct the instruction."
  },
  "hpgl.loose-number": {
    "text": "The program line has a number that belongs to no instruction.",
    "hint": "Delete the number, or add the instruction before the number."
  },
  "hpgl.moves-before-pa": {
    "text": "The program line moves the tool before the program has chosen absolute coordinates (PA).",
    "hint": "Write PA before the first move."
  },
  "hpgl.needs-no-number": {
    "text": "The instruction in this program line does not take a number.",
    "hint": "Delete the number."
  },
  "hpgl.needs-one-number": {
    "text": "The instruction in this program line needs exactly one number.",
    "hint": "Give one number."
  },
  "hpgl.never-down": {
    "text": "The toolpath never lowers a tool, so nothing would be cut.",
    "hint": "Give at least one edge a line type for which the machine has a tool."
  },
  "hpgl.no-approach": {
    "text": "Internal error: {place} starts a cut, but no rapid move to the start of the cut precedes it.",
    "hint": "Report the error with the drawing."
  },
  "hpgl.no-device": {
    "text": "The machine file of {machine} has no HPGL settings.",
    "hint": "Add the HPGL settings under [controller] in the machine file: see the page Connect a machine of the documentation."
  },
  "hpgl.no-force": {
    "text": "{path} is {value}, but {device} has no force setting (FS)",
    "hint": "Remove force."
  },
  "hpgl.no-force-setting": {
    "text": "The program line sets the force (FS), but the machine has no force setting.",
    "hint": "Remove FS."
  },
  "hpgl.no-instruction": {
    "text": "The program contains no instruction.",
    "hint": "Choose a file with an HPGL program."
  },
  "hpgl.no-pen": {
    "text": "The machine file of {machine} assigns no pen to the operation {work} with station {station}.",
    "hint": "Add a [[controller.pen]] with this station and this operation (field work) to the machine file."
  },
  "hpgl.no-pen-selected": {
    "text": "The program line lowers the tool, but no pen is selected.",
    "hint": "Select a pen (SP) before this program line."
  },
  "hpgl.no-speed": {
    "text": "The program line cuts, but no speed has been set.",
    "hint": "Set the speed (VS) before this program line."
  },
  "hpgl.no-speed-setting": {
    "text": "The program line sets the speed (VS), but the machine has no speed setting.",
    "hint": "Remove VS."
  },
  "hpgl.no-terminator": {
    "text": "The last instruction of the program has no semicolon.",
    "hint": "Add the semicolon, or send the complete program again."
  },
  "hpgl.not-initialised": {
    "text": "The first instruction of the program is not IN (initialise).",
    "hint": "Write IN at the beginning of the program."
  },
  "hpgl.not-raised": {
    "text": "{name} has accepted no data for {seconds, number, ::@#####} s, so the command to raise the tool could not be sent. The tool may still be lowered.",
    "hint": "Stop the program at the machine and raise the tool there."
  },
  "hpgl.not-reached": {
    "text": "{error} The machine still executes what is in its buffer, and the tool may remain lowered at the end.",
    "hint": "Stop the program at the machine and raise the tool there."
  },
  "hpgl.outside-area": {
    "text": "The program line moves the tool outside the working area of the machine.",
    "hint": "Move the drawing on the table, or choose a larger machine."
  },
  "hpgl.pen-cannot": {
    "text": "{path} is ''{work}'', but the tool of station {station} cannot do this operation",
    "hint": "Assign the pen to another station, or choose another operation in the field work."
  },
  "hpgl.plunge-without-move": {
    "text": "The program line lowers the tool, but no move follows, so the direction of the tool is not known.",
    "hint": "Add a move after the instruction PD."
  },
  "hpgl.press": {
    "text": "{place} presses a crease that is too short to be rolled: the tool is lowered at one point. Before that, the tool must be turned to the direction of the crease, which HPGL cannot express.",
    "hint": "Draw a longer crease, set the line type of the crease to ignored, or choose another machine."
  },
  "hpgl.repeated-pen": {
    "text": "{path} has the same station and the same operation (field work) as another pen",
    "hint": "Remove one of the two pens, or choose another operation for one of the two pens."
  },
  "hpgl.runs-on": {
    "text": "The rest of the program is not sent to {name}. The machine still executes what is in its buffer, and raises the tool after that.",
    "hint": "Stay away from the tool until the machine is at rest, or stop the program at the machine."
  },
  "hpgl.selects-while-down": {
    "text": "The program line selects a pen while the tool is down.",
    "hint": "Lift the tool (PU) before the pen is selected."
  },
  "hpgl.send-by-hand": {
    "text": "Download the program and send it with the software of the cutting machine. Stay beside the machine while it cuts, so that you can stop it.",
    "hint": ""
  },
  "hpgl.sets-while-down": {
    "text": "The program line sets the speed (VS) or the force (FS) while the tool is down.",
    "hint": "Lift the tool (PU) before the speed or the force is set."
  },
  "hpgl.slanted-plunge": {
    "text": "{place} lowers or lifts the tool along a slope, which HPGL cannot express.",
    "hint": "Choose a tool that enters the board vertically."
  },
  "hpgl.speed-out-of-range": {
    "text": "The speed (VS) in the program line is not between {low} and {high}.",
    "hint": "Give a speed in this range."
  },
  "hpgl.station-without-pen": {
    "text": "{path} has no pen",
    "hint": "Add a [[controller.pen]] with this station."
  },
  "hpgl.swivel": {
    "text": "{place} rotates the head about the tip of the knife, because the machine file sets a knife offset (trail). HPGL cannot express this rotation and does not need it: an HPGL machine itself compensates for the knife offset.",
    "hint": "Set the trail of the knife to 0 in the machine file."
  },
  "hpgl.swivel-depth": {
    "text": "{path} is {value, number, ::@#####} mm, but an HPGL program cannot change the depth of a lowered tool",
    "hint": "Set swivel_depth to 0."
  },
  "hpgl.tool-not-supported": {
    "text": "{path} is neither a knife nor a creasing tool, and HPGL cannot control other tools",
    "hint": "Remove the station, or choose another controller language."
  },
  "hpgl.trail": {
    "text": "{path} (knife offset) is {value, number, ::@#####} mm, but an HPGL machine itself compensates for the offset of its knife",
    "hint": "Set trail to 0, or set free if the device does not compensate."
  },
  "hpgl.travel": {
    "text": "{path} extends from {low, number, ::@#####} to {high, number, ::@#####} mm, but the working area in the HPGL settings extends from {least, number, ::@#####} to {greatest, number, ::@#####} mm",
    "hint": "Reduce the travel of the axis, or correct the working area in the HPGL settings."
  },
  "hpgl.turn-in-board": {
    "text": "The tool turns by {degrees, number, ::.00}° while it is in the board, but at most {most, number, ::.00}° is allowed.",
    "hint": "Lift the tool before it turns."
  },
  "hpgl.unknown-instruction": {
    "text": "The instruction {name} in the program line is not supported.",
    "hint": "Remove the instruction."
  },
  "hpgl.unknown-pen": {
    "text": "The program line selects a pen that the machine does not have.",
    "hint": "Select a pen that is defined in the machine file."
  },
  "hpgl.wrong-force": {
    "text": "The program line lowers pen {pen} with a force that differs from the force of this pen in the machine file (FS{force}).",
    "hint": "Write FS{force} before this program line."
  },
  "hpgl.x-without-y": {
    "text": "The program line has an X coordinate without a Y coordinate.",
    "hint": "Give both coordinates."
  },
  "import.all-outside-page": {
    "text": "the whole drawing lies outside the visible area of the page",
    "hint": "Move the drawing onto the page in the program that drew it, so that objects beside the page are left out."
  },
  "import.angles-not-numbers": {
    "text": "the start or end angle of the arc is not a number",
    "hint": ""
  },
  "import.annotations": {
    "text": "{count, plural, one {# note or form field} other {# notes and form fields}} on the PDF page {count, plural, one {is} other {are}} not cut",
    "hint": ""
  },
  "import.area-outline": {
    "text": "the object is the outline of a filled area, which was imported because the drawing has no lines",
    "hint": ""
  },
  "import.area-outline-on-page": {
    "text": "the object is the outline of a filled area, which was imported because the page has no lines",
    "hint": ""
  },
  "import.area-outline-round-lines": {
    "text": "the object is the outline of a filled area; it was imported, because the lines on this area have no closed outline of their own",
    "hint": ""
  },
  "import.array": {
    "text": "the object inserts the block as a grid of copies ({columns} columns × {rows} rows)",
    "hint": ""
  },
  "import.aspect-ratio": {
    "text": "The size of the page ({size__space}) does not have the proportions of its viewBox ({width, number, ::@#####} × {height, number, ::@#####}): the width gives the scale {across, number, ::@###}, the height {down, number, ::@###}. The drawing is read at the scale {used, number, ::@###}, as browsers display it.",
    "hint": "Check the size of the drawing. If it is wrong, correct the page size in the program that drew it, and export the drawing again."
  },
  "import.bad-operands": {
    "text": "the path uses the PDF operator ''{operator}'' with a wrong number or type of values",
    "hint": ""
  },
  "import.bad-path-data": {
    "text": "the path data of the object is invalid at character {character} (''{text}'')",
    "hint": "Correct the object in the program that drew it, and export the drawing again."
  },
  "import.bad-place": {
    "text": "the position of the object cannot be read: {reason}",
    "hint": ""
  },
  "import.bad-points": {
    "text": "the points of the object cannot be read: ''{points}''",
    "hint": ""
  },
  "import.bad-primitive": {
    "text": "the path of the object joins vertices that it does not have, or in an unknown way (''{kind}'' from {first} to {second})",
    "hint": "Correct the object in the program that drew it, and export the drawing again."
  },
  "import.bad-radius": {
    "text": "the radius of the object is {radius, number, ::@#####}, but must be greater than 0",
    "hint": ""
  },
  "import.bad-size": {
    "text": "the attribute {name} of the object cannot be read: {reason}",
    "hint": ""
  },
  "import.bad-transform": {
    "text": "the attribute transform of the object cannot be read: {reason}",
    "hint": ""
  },
  "import.bad-value": {
    "text": "the value ''{value}'' is not a length",
    "hint": ""
  },
  "import.bad-window": {
    "text": "the position or size of the nested drawing cannot be read: {reason}",
    "hint": ""
  },
  "import.block-external": {
    "text": "the object inserts the block ''{block}'', which is defined in another file",
    "hint": "Bind the external reference in the CAD program, and export the drawing again."
  },
  "import.block-in-itself": {
    "text": "the block ''{block}'' inserts itself",
    "hint": ""
  },
  "import.block-missing": {
    "text": "the object inserts the block ''{block}'', which is not defined in the file",
    "hint": "Add the definition of the block in the CAD program, and export the drawing again."
  },
  "import.bridge": {
    "text": "the steel rule of the cutting die has 1 bridge (gap), {width, number, ::@#####} file units wide; the edge is cut without the gap",
    "hint": ""
  },
  "import.bridges": {
    "text": "the steel rule of the cutting die has {bridges, number, ::@#####} bridges (gaps), each {width, number, ::@#####} file units wide; the edge is cut without the gaps",
    "hint": ""
  },
  "import.changed": {
    "text": "{objects, plural, one {# object is} other {# objects are}} imported with a change: {reason}.",
    "hint": "The import report lists {objects, plural, one {it} other {them}}. {reason__hint}"
  },
  "import.changed-on-layer": {
    "text": "{objects, plural, one {# object} other {# objects}} on layer ''{layer}'' {objects, plural, one {is} other {are}} imported with a change: {reason}.",
    "hint": "The import report lists {objects, plural, one {it} other {them}}. {reason__hint}"
  },
  "import.check-drawing": {
    "text": "Check the drawing: {reason}.",
    "hint": "{reason__hint}"
  },
  "import.clip-path": {
    "text": "the object only limits the visible area of other objects (clipping path)",
    "hint": ""
  },
  "import.clipped": {
    "text": "only the part of the object that is visible inside its clip path or mask was imported",
    "hint": "Remove the clip path or mask and export the drawing again if the whole object must be cut."
  },
  "import.clipped-away": {
    "text": "the object lies outside its clip path or mask, so it is not visible",
    "hint": "Remove the clip path or mask and export the drawing again if the object must be cut."
  },
  "import.contains-itself": {
    "text": "the object contains a reference to itself",
    "hint": ""
  },
  "import.conversion-doubtful": {
    "text": "{program}, which converted the file, reported {count, plural, one {# object or place} other {# objects or places}} that it could not convert ({losses}). Objects of the drawing may be missing or wrong.",
    "hint": "Compare the drawing with the original. {what__hint}"
  },
  "import.converted": {
    "text": "the file was converted by {program}",
    "hint": ""
  },
  "import.coordinate-not-a-number": {
    "text": "a coordinate of the object is not a number",
    "hint": ""
  },
  "import.curves-fitted": {
    "text": "the curves of the object were converted to {pieces, plural, one {# line or arc} other {# lines and arcs}}, which deviate by at most {tolerance, number, ::@#} file units from the curves",
    "hint": ""
  },
  "import.curves-fitted-relative": {
    "text": "the curves of the object were converted to {pieces, plural, one {# line or arc} other {# lines and arcs}}, which deviate by at most {tolerance, number, ::@#} file units from the curves (1/250,000 of the size of the drawing)",
    "hint": ""
  },
  "import.damaged": {
    "text": "the object is damaged: {reason}",
    "hint": ""
  },
  "import.damaged-or-frame": {
    "text": "the object is damaged, or is only the frame around a text",
    "hint": ""
  },
  "import.dimension": {
    "text": "the object is a dimension or a note, which is not cut",
    "hint": ""
  },
  "import.drawn-twice": {
    "text": "the object is drawn twice: it has the same shape and position as {same}",
    "hint": ""
  },
  "import.drawn-twice-often": {
    "text": "the object is drawn several times: it has the same shape and position as {same} and {more} more {more, plural, one {object} other {objects}}",
    "hint": ""
  },
  "import.empty-path": {
    "text": "the path of the object is empty",
    "hint": ""
  },
  "import.end-mark": {
    "text": "the object (SEQEND) only marks the end of a list of vertices or attributes",
    "hint": ""
  },
  "import.endless-line": {
    "text": "the object is a construction line of infinite length",
    "hint": ""
  },
  "import.extrusion-not-a-number": {
    "text": "the extrusion direction of the object is not a number",
    "hint": ""
  },
  "import.few-vertices": {
    "text": "the object is a polyline with {vertices, plural, one {# vertex} other {# vertices}}, but needs at least 2",
    "hint": ""
  },
  "import.filled-area": {
    "text": "the object is a filled area without an outline, so it is not cut",
    "hint": ""
  },
  "import.filled-area-beside-strokes": {
    "text": "the object is a filled area without an outline; the outline of a filled area is cut only if the drawing has no lines, or if the lines on the area have no closed outline of their own",
    "hint": ""
  },
  "import.filled-area-on-page": {
    "text": "the object is a filled area without an outline; the outlines of filled areas are cut only on pages that have no lines",
    "hint": ""
  },
  "import.fit-points": {
    "text": "the file states only the fit points of the curve, so the curve was drawn through these points",
    "hint": ""
  },
  "import.font-shape": {
    "text": "the object is a shape from a font file, which cannot be read",
    "hint": "Explode the object into lines in the CAD program, and export the drawing again."
  },
  "import.hatch": {
    "text": "the object is a hatch (filled area), whose boundary is not read",
    "hint": "Draw the boundary as lines in the CAD program, and export the drawing again if it must be cut."
  },
  "import.height-not-a-number": {
    "text": "the height (z) of the object is not a number",
    "hint": ""
  },
  "import.height-too-far": {
    "text": "the height (z) of the object is {height, number, ::@#####} file units, but the limit is {limit, number, ::@#####}",
    "hint": ""
  },
  "import.hidden": {
    "text": "the object is hidden",
    "hint": ""
  },
  "import.hidden-layer": {
    "text": "the object is hidden, because the layer {layer} is switched off",
    "hint": "Switch the layer on and export the drawing again if the object must be cut."
  },
  "import.image": {
    "text": "the object is an image, which is not cut",
    "hint": ""
  },
  "import.incomplete": {
    "text": "the object is incomplete, because its {part} is missing",
    "hint": ""
  },
  "import.interrupted-path": {
    "text": "the path has neither a stroke nor a fill, because another object begins before the path ends",
    "hint": ""
  },
  "import.invisible": {
    "text": "the object is marked as invisible",
    "hint": ""
  },
  "import.kept": {
    "text": "the object was imported unchanged",
    "hint": ""
  },
  "import.kept-changed": {
    "text": "the object was imported; note: {notes__semicolon}",
    "hint": ""
  },
  "import.laid-flat": {
    "text": "the object was moved from the height z = {height, number, ::@#####} file units to z = 0",
    "hint": ""
  },
  "import.layer-frozen": {
    "text": "the layer of the object is frozen",
    "hint": "Thaw the layer and export the drawing again if the object must be cut."
  },
  "import.layer-never-plotted": {
    "text": "CAD programs never plot the layer of the object",
    "hint": "Move the object to another layer and export the drawing again if the object must be cut."
  },
  "import.layer-not-plotted": {
    "text": "the layer of the object is set to be not plotted",
    "hint": "Set the layer to be plotted and export the drawing again if the object must be cut."
  },
  "import.layer-off": {
    "text": "the layer of the object is switched off",
    "hint": "Switch the layer on and export the drawing again if the object must be cut."
  },
  "import.left-out": {
    "text": "{objects, plural, one {# object is} other {# objects are}} not cut: {reason}.",
    "hint": "The import report lists {objects, plural, one {it} other {them}}. {reason__hint}"
  },
  "import.left-out-further": {
    "text": "{objects, plural, one {# further object is} other {# further objects are}} not cut.",
    "hint": "The import report gives the reason for each object."
  },
  "import.left-out-on-layer": {
    "text": "{objects, plural, one {# object} other {# objects}} on layer ''{layer}'' {objects, plural, one {is} other {are}} not cut: {reason}.",
    "hint": "The import report lists {objects, plural, one {it} other {them}}. {reason__hint}"
  },
  "import.light": {
    "text": "the object is a light, which is not cut",
    "hint": ""
  },
  "import.lightburn-shape": {
    "text": "the object is a LightBurn shape of the type {kind}, which cannot be read",
    "hint": "In LightBurn, select the object, choose Edit > Convert to Path, and save the project again."
  },
  "import.line-not-numbers": {
    "text": "the values in line {line} of the file are not all numbers: {values}",
    "hint": ""
  },
  "import.lone-vertex": {
    "text": "the object is a vertex that belongs to no polyline",
    "hint": ""
  },
  "import.mesh": {
    "text": "the object is a three-dimensional mesh, not a line in a plane",
    "hint": ""
  },
  "import.missing-id": {
    "text": "the object refers to another object by the id ''{id}'', which does not exist in the file",
    "hint": ""
  },
  "import.missing-subroutine": {
    "text": "the object inserts the subroutine {name}, which is not in the file",
    "hint": ""
  },
  "import.multiple-line": {
    "text": "the object is a multiline (MLINE), which is not read",
    "hint": "Explode the multiline into lines in the CAD program, and export the drawing again."
  },
  "import.no-end-mark": {
    "text": "the end mark {mark} of the file is missing, so objects may be missing",
    "hint": "Compare the drawing with the original, or export it again."
  },
  "import.no-length": {
    "text": "the length of the object is {length, number, ::@#####}, which is too short to be cut",
    "hint": ""
  },
  "import.no-major-axis": {
    "text": "the major axis of the ellipse has a length of 0",
    "hint": ""
  },
  "import.no-paint": {
    "text": "the object has neither a stroke nor a fill, so it is not visible",
    "hint": ""
  },
  "import.no-parameter-range": {
    "text": "the ellipse has no length, because its start parameter and its end parameter are both {parameter, number, ::@#####}",
    "hint": ""
  },
  "import.no-pen": {
    "text": "the object is drawn without a pen (pen 0), so it is not visible",
    "hint": ""
  },
  "import.no-points": {
    "text": "the object has no points",
    "hint": ""
  },
  "import.no-scale": {
    "text": "the object has no size, because it is scaled by {x, number, ::@#####} in X and {y, number, ::@#####} in Y",
    "hint": ""
  },
  "import.no-size": {
    "text": "the object has no size: its width is {width, number, ::@#####} and its height {height, number, ::@#####}",
    "hint": ""
  },
  "import.no-stroke-width": {
    "text": "the stroke of the object has a width of 0, so it is not visible",
    "hint": "Give the stroke a width and export the drawing again if the object must be cut."
  },
  "import.no-sweep": {
    "text": "the arc has no length, because it starts and ends at the same angle, {degrees, number, ::@#####}°",
    "hint": ""
  },
  "import.not-a-line": {
    "text": "the object is of the type {kind}, which cannot be read",
    "hint": ""
  },
  "import.not-clipped": {
    "text": "the file clips the object, but the complete object was imported",
    "hint": "Trim the object, or apply the clip path, in the program that drew the file. Then export the drawing again."
  },
  "import.not-flat": {
    "text": "the object is not parallel to the XY plane",
    "hint": ""
  },
  "import.not-numbers": {
    "text": "the coordinates of the object are not all numbers: {values}",
    "hint": ""
  },
  "import.not-svg": {
    "text": "the content of the object is not SVG",
    "hint": ""
  },
  "import.not-visible": {
    "text": "the object is completely transparent",
    "hint": ""
  },
  "import.nothing-named": {
    "text": "the PDF page uses a form or image with the name ''{name}'', which the PDF does not contain",
    "hint": ""
  },
  "import.odd-points": {
    "text": "the list of points of the object is incomplete: the last point has no y coordinate",
    "hint": "Correct the object in the program that drew it, and export the drawing again."
  },
  "import.on-layer": {
    "text": "the object also lies on the layer {layer}",
    "hint": ""
  },
  "import.other-file": {
    "text": "the object is in another file, ''{file}'', which is not loaded",
    "hint": "Embed the object in the file and export again."
  },
  "import.other-language": {
    "text": "the object is for readers of another language, so it is not visible",
    "hint": ""
  },
  "import.other-pages": {
    "text": "The file has {pages, plural, one {# page} other {# pages}}, but only page {page} is read.",
    "hint": "If the drawing is on another page, choose this page, or export it as a separate file."
  },
  "import.other-pages-lines": {
    "text": "The file has {others, plural, one {# other page} other {# other pages}} besides page {page}, and only page {page} is read. Page {most} has the most lines of the other pages ({lines, number}).",
    "hint": "If the drawing is on another page, choose this page, or export it as a separate file."
  },
  "import.other-sheet": {
    "text": "the object is on sheet {sheet} of the plot, but only the first sheet is read",
    "hint": "If the object must be cut, export its sheet as a separate file."
  },
  "import.outside-page": {
    "text": "the object lies outside the visible area of the page",
    "hint": ""
  },
  "import.page-ends-early": {
    "text": "the path has neither a stroke nor a fill, because the page ends before the path ends",
    "hint": ""
  },
  "import.paper-space": {
    "text": "the object is in a layout (paper space), not in the model",
    "hint": ""
  },
  "import.paper-space-annotation": {
    "text": "the object is an annotation or a viewport in a layout (paper space), not in the model",
    "hint": ""
  },
  "import.parameters-not-numbers": {
    "text": "the start or end parameter of the ellipse is not a number",
    "hint": ""
  },
  "import.partly-outside-page": {
    "text": "a part of the object lies outside the visible area of the page",
    "hint": ""
  },
  "import.picture": {
    "text": "the object is a picture, which is not cut",
    "hint": ""
  },
  "import.picture-block": {
    "text": "the block {block} with {entities, plural, one {# object} other {# objects}} is the graphic of a dimension or a hatch, which is not cut",
    "hint": ""
  },
  "import.pieces-drawn-twice": {
    "text": "{pieces} of the {all} segments of the object {pieces, plural, one {is} other {are}} drawn twice: {pieces, plural, one {it lies} other {they lie}} exactly on {same}",
    "hint": ""
  },
  "import.pieces-drawn-twice-often": {
    "text": "{pieces} of the {all} segments of the object {pieces, plural, one {is} other {are}} drawn several times: {pieces, plural, one {it lies} other {they lie}} exactly on {same} and {more} more {more, plural, one {object} other {objects}}",
    "hint": ""
  },
  "import.pieces-no-length": {
    "text": "{pieces} of the {all} segments of the object {pieces, plural, one {has} other {have}} no length",
    "hint": ""
  },
  "import.place-not-a-number": {
    "text": "the position of the object is not a number",
    "hint": ""
  },
  "import.placement-not-a-number": {
    "text": "the position, scale or rotation of the object is not a number",
    "hint": ""
  },
  "import.places-block": {
    "text": "the object inserts the block {block}",
    "hint": ""
  },
  "import.places-subroutine": {
    "text": "the object inserts the subroutine {name}",
    "hint": ""
  },
  "import.plotter-marks": {
    "text": "the instruction draws symbols, ticks or characters of its own, which are not cut",
    "hint": ""
  },
  "import.point": {
    "text": "the object is a point, which has no length",
    "hint": ""
  },
  "import.proxy": {
    "text": "the object can be read only by the program that made it",
    "hint": "Explode the object into lines in that program and export again."
  },
  "import.region": {
    "text": "the object is a region, which cannot be read",
    "hint": "Explode the region into lines in the CAD program, and export the drawing again."
  },
  "import.repeated": {
    "text": "the drawing contains the object {times} times",
    "hint": ""
  },
  "import.rules-not-read": {
    "text": "the style sheet of the drawing has rules that are not supported: {rules}",
    "hint": ""
  },
  "import.script": {
    "text": "the object is a script, which is not executed",
    "hint": ""
  },
  "import.shading": {
    "text": "the object is a shading (colour gradient), which is not cut",
    "hint": ""
  },
  "import.short-path-data": {
    "text": "the path data of the object is incomplete: it ends inside a command",
    "hint": "Correct the object in the program that drew it, and export the drawing again."
  },
  "import.solid": {
    "text": "the object is a solid or a face, not a line in a plane",
    "hint": ""
  },
  "import.spot-colour": {
    "text": "the object is drawn in the spot colour {colour}",
    "hint": ""
  },
  "import.subroutine-in-itself": {
    "text": "the subroutine {name} inserts itself",
    "hint": ""
  },
  "import.text": {
    "text": "the object is a text, which is not cut",
    "hint": ""
  },
  "import.text-unknown-letters": {
    "text": "the object is a text, which is not cut; its wording cannot be shown, because its font does not state which characters it has",
    "hint": ""
  },
  "import.tilted": {
    "text": "the object is not parallel to the XY plane: its plane is tilted by {degrees, number, ::@#####}°",
    "hint": ""
  },
  "import.tilted-axis": {
    "text": "the object is not parallel to the XY plane: its major axis rises by {rise, number, ::@#####} file units",
    "hint": ""
  },
  "import.too-far": {
    "text": "a coordinate of the object is {coordinate, number, ::@#####} file units, but the limit is {limit, number, ::@#####}",
    "hint": ""
  },
  "import.too-many-fit-points": {
    "text": "the curve has {points, number} fit points, but the limit is {limit, number}",
    "hint": ""
  },
  "import.turned-page": {
    "text": "the lines after this instruction are turned about the origin of the plotter, but some plotters turn the paper, so that these lines may be in another place",
    "hint": "Compare the drawing with the original, or export it as DXF, PDF or SVG."
  },
  "import.uncentred-arc": {
    "text": "the centre of the arc is {first, number, ::@#####} file units away from the start of the arc, but {second, number, ::@#####} file units away from the end of the arc",
    "hint": ""
  },
  "import.underlay": {
    "text": "the object is an underlay (an inserted picture or PDF page), which is not cut",
    "hint": ""
  },
  "import.uneven-height": {
    "text": "the object is not parallel to the XY plane: its height z varies from {low, number, ::@#####} to {high, number, ::@#####} file units",
    "hint": ""
  },
  "import.unknown-instruction": {
    "text": "the object is an instruction that HPGL does not define",
    "hint": "Compare the drawing with the original, or export it as DXF, PDF or SVG."
  },
  "import.unknown-operator": {
    "text": "the PDF page uses the operator ''{operator}'', which is not supported",
    "hint": ""
  },
  "import.unknown-position": {
    "text": "the object begins at a position that depends on the plotter, such as the end of a text",
    "hint": "Export the drawing as DXF, PDF or SVG if the object must be cut."
  },
  "import.unknown-record": {
    "text": "the object is a CF2 record of a type that is not supported",
    "hint": ""
  },
  "import.unsupported-element": {
    "text": "the object is an SVG element of the type {kind}, which is not supported",
    "hint": ""
  },
  "import.unused-block": {
    "text": "the file defines the block {block} with {entities, plural, one {# object} other {# objects}}, but the drawing does not use it",
    "hint": ""
  },
  "import.unused-subroutine": {
    "text": "the file defines the subroutine {name} with {records, plural, one {# record} other {# records}}, but the drawing does not use it",
    "hint": ""
  },
  "import.value-angle": {
    "text": "the angle {degrees, number, ::@#####}° is not finite",
    "hint": ""
  },
  "import.value-not-numbers": {
    "text": "the value ''{value}'' is not a number",
    "hint": ""
  },
  "import.value-not-transform": {
    "text": "the value ''{value}'' is not a valid transform",
    "hint": ""
  },
  "import.value-transform-numbers": {
    "text": "the transform {name} has {count} values, which is a wrong number of values",
    "hint": ""
  },
  "import.value-unit": {
    "text": "the value ''{value}'' has an unknown unit of length",
    "hint": ""
  },
  "import.viewport": {
    "text": "the object is a viewport, which only displays a part of the drawing",
    "hint": ""
  },
  "import.white-area": {
    "text": "the object is a white area without an outline, so it is not cut",
    "hint": ""
  },
  "import.white-line": {
    "text": "the object is drawn in white on a white page, so it is not visible",
    "hint": "Give the object another colour and export the drawing again if it must be cut."
  },
  "import.wrong-field-count": {
    "text": "line {line} of the file has {fields, plural, one {# field} other {# fields}}, which is the wrong number of fields for its record",
    "hint": ""
  },
  "input.not-finite": {
    "text": "{what} has a coordinate that is not a number.",
    "hint": "Draw the object again."
  },
  "job.action-requested": {
    "text": "The operator requested the action {action}.",
    "hint": ""
  },
  "job.answered": {
    "text": "The job uses the verified program of job {job}, which has the same drawing, machine and options.",
    "hint": ""
  },
  "job.at-line": {
    "text": "The machine is at program line {line}.",
    "hint": ""
  },
  "job.awaits-kernels": {
    "text": "The job waits until the server has compiled the software modules that the machine {machine} needs. The server does this once after an installation.",
    "hint": "Wait. The job continues automatically."
  },
  "job.being-cancelled": {
    "text": "Job {job} is already being cancelled.",
    "hint": "Wait until the machine has stopped."
  },
  "job.cancelled": {
    "text": "The job was cancelled.",
    "hint": ""
  },
  "job.cancelled-before-request": {
    "text": "Job {job} is being cancelled, so the request {request} is not possible.",
    "hint": "Wait until the machine has stopped."
  },
  "job.changed": {
    "text": "Job {job} was changed since you read it.",
    "hint": "Read the job again, and repeat the change if it is still necessary."
  },
  "job.check-refused": {
    "text": "The program was not begun, so the job was returned to the queue: {reason}",
    "hint": ""
  },
  "job.checked": {
    "text": "The operator checked at the machine: {checks__semicolon}.",
    "hint": ""
  },
  "job.claim-returned": {
    "text": "The gateway put the job back into the queue. {reason}",
    "hint": ""
  },
  "job.claimed": {
    "text": "The gateway of the machine took the job from the queue (claimed it).",
    "hint": ""
  },
  "job.claimed-to-confirm": {
    "text": "The gateway of the machine took the job from the queue. The job now waits for the confirmation of the operator.",
    "hint": ""
  },
  "job.compile-cancelled": {
    "text": "The compilation of the job was cancelled.",
    "hint": ""
  },
  "job.compile-crashed": {
    "text": "Internal error {incident} while compiling. Nothing was cut.",
    "hint": "Report the error with the log of the server, which contains its cause under this number."
  },
  "job.compile-started": {
    "text": "Attempt {attempt} to compile the job has started.",
    "hint": ""
  },
  "job.compiles-died": {
    "text": "The process that compiles the job ended unexpectedly {attempts} times, the last time in the stage {stage}.",
    "hint": "Send a smaller drawing, or report the error with the drawing."
  },
  "job.confirmed-sheet": {
    "text": "The operator confirmed that a new sheet of board {board} is on the table.",
    "hint": ""
  },
  "job.confirmed-table": {
    "text": "The operator confirmed that the table is clear and that the board on it is {board}.",
    "hint": ""
  },
  "job.copy-done": {
    "text": "Copy {copy} of {copies} of the job is finished.",
    "hint": ""
  },
  "job.copy-done-next-sheet": {
    "text": "Copy {copy} of {copies} of the job is finished. The next copy needs a new sheet of board.",
    "hint": "Put a new sheet of board on the table, then confirm the new sheet on the page of the job. The machine then starts the next copy."
  },
  "job.declared-finished": {
    "text": "The operator marked the job as finished, after the machine had stopped at program line {line} of {lines}.",
    "hint": ""
  },
  "job.details-changed": {
    "text": "The details of the order were changed.",
    "hint": ""
  },
  "job.exceptions-accepted": {
    "text": "{by} accepted {count, plural, one {# shortfall} other {# shortfalls}}: {reason}",
    "hint": ""
  },
  "job.executed": {
    "text": "The machine executed every line of the program.",
    "hint": ""
  },
  "job.fully-executed": {
    "text": "The machine executed job {job} to its last program line ({lines}), so the job cannot be queued again.",
    "hint": "Check the table. Mark the job finished if the sheet is complete, otherwise scrap the job."
  },
  "job.gateway-fell-silent": {
    "text": "The gateway {gateway} stopped responding.",
    "hint": "Check the computer of the gateway and its network connection."
  },
  "job.gateway-lost": {
    "text": "The gateway {gateway} stopped responding.",
    "hint": "Check the computer of the gateway and its network connection."
  },
  "job.gateway-silent": {
    "text": "The gateway {gateway}, which claimed job {job}, does not respond.",
    "hint": "Switch on the machine and start its gateway. Confirm the job when it waits for a confirmation again."
  },
  "job.held-before-start": {
    "text": "The operator paused the job before the machine executed the first program line. The machine starts when the operator confirms the job again.",
    "hint": ""
  },
  "job.interrupted": {
    "text": "The job was interrupted at program line {line} of {lines}{copy}. {cause}",
    "hint": "{cause__hint} Check the table. If the sheet has not moved, continue it: only the tracks that are left are made. Otherwise queue the job again (a new sheet is cut from the first program line), or mark the job finished if the sheet is complete, or scrap the job."
  },
  "job.interrupted-at-end": {
    "text": "The job was interrupted at program line {line} of {lines}{copy}. {cause}",
    "hint": "{cause__hint} Check the table. Mark the job finished if the sheet is complete, otherwise scrap the job."
  },
  "job.interrupted-between-copies": {
    "text": "The job was interrupted after copy {copy} of {copies}, before the first program line of the next copy. {cause}",
    "hint": "{cause__hint} Check the table. Then either queue the job again for the remaining copies, or mark the job finished, or scrap it."
  },
  "job.interrupted-in-first-line": {
    "text": "The job was interrupted before its first program line of {lines} was complete{copy}. It is not known whether the machine has moved. {cause}",
    "hint": "{cause__hint} Check the table. If the sheet is untouched and has not moved, continue it or queue the job again. Otherwise scrap the job."
  },
  "job.interrupted-unobserved": {
    "text": "The job was interrupted at program line {line} of {lines} or later{copy}: {most}. {cause}",
    "hint": "{cause__hint} Look at the sheet: it shows which tracks are made. To continue it, state for each track that is not known whether it is made."
  },
  "job.late-report": {
    "text": "A late report of the gateway arrived: {report}",
    "hint": ""
  },
  "job.machine-not-free": {
    "text": "Job {job} cannot start, because its machine takes no job now. {reason}",
    "hint": "{reason__hint}"
  },
  "job.may-have-ended": {
    "text": "nobody observed the machine then, so it may have executed the program to its end",
    "hint": ""
  },
  "job.may-have-gone-on": {
    "text": "nobody observed the machine then, so it may have executed lines up to line {line}",
    "hint": ""
  },
  "job.needs-end": {
    "text": "The whole program of job {job} was sent to the machine, which does not report when it has finished, so there is nothing to resume.",
    "hint": "When the machine has finished and is at rest, confirm this on the station page or with POST /api/jobs/{job}/end."
  },
  "job.needs-sheet": {
    "text": "Job {job} waits for a new sheet, so it cannot be resumed.",
    "hint": "Put a new sheet on the table, make the checks at the machine, then confirm the job."
  },
  "job.no-confirmation-awaited": {
    "text": "Job {job} is {state}, so it does not wait for a confirmation.",
    "hint": "{advice}"
  },
  "job.no-end-awaited": {
    "text": "Job {job} is {state}, and its machine does not wait for a person to confirm the end of a program.",
    "hint": "Look at what the job waits for."
  },
  "job.no-sheet-awaited": {
    "text": "Job {job} is on hold, but it does not wait for a new sheet.",
    "hint": "Resume the job."
  },
  "job.no-shortfalls": {
    "text": "The shortfalls of job {job} cannot be accepted, because the job is not refused, or was also refused for another reason.",
    "hint": "Check the fields state and reason of the job, and correct this other reason first."
  },
  "job.no-work": {
    "text": "The drawing contains nothing that the machine can make: every edge is too short for its tool, or in a place that the cutter does not enter.",
    "hint": "Check the unit of the drawing and the line types of its edges. Otherwise choose another machine or machine file: a smaller creasing wheel for short creases, a thinner cutter or a knife for narrow contours."
  },
  "job.not-checked": {
    "text": "The confirmation of job {job} leaves out what must be checked at the machine: {missing__semicolon}.",
    "hint": "Make these checks at the machine, then confirm the job with all of them in `checked`."
  },
  "job.not-confirmed": {
    "text": "Job {job} was started, although the operator has not confirmed that the table is ready.",
    "hint": "Check the table, then confirm the job or cancel it."
  },
  "job.not-running": {
    "text": "The report was not accepted, because job {job} is {state} and not running on a machine.",
    "hint": "Claim the job with the gateway first, and report on it only while it is running."
  },
  "job.not-taken": {
    "text": "Job {job} is queued, and the gateway of its machine {machine} has not claimed it yet.",
    "hint": "Confirm the job after the gateway has claimed it. The field reason of the job shows what the job waits for."
  },
  "job.nothing-refused": {
    "text": "Job {job} is {state}, and no machine has refused its program, so there is nothing to try again.",
    "hint": ""
  },
  "job.nothing-sent": {
    "text": "The gateway sent nothing to the machine.",
    "hint": ""
  },
  "job.nothing-to-confirm": {
    "text": "Job {job} is running, so there is nothing to confirm.",
    "hint": "Hold or cancel the job if the machine must stop."
  },
  "job.of-copy": {
    "text": ", in copy {copy} of {copies}",
    "hint": ""
  },
  "job.ordered": {
    "text": "The job was created.",
    "hint": ""
  },
  "job.other-phase": {
    "text": "Job {job} has continued since the request was prepared, so the request no longer applies.",
    "hint": "Check what the job waits for, then resume it if the machine may continue."
  },
  "job.outdated": {
    "text": "The program of job {job} is out of date: {changes__semicolon}.",
    "hint": "Compile the job again. Its program is then made and verified for the present machine and board."
  },
  "job.program-has-shortfalls": {
    "text": "The tools cannot make every line as it is drawn: {findings__space}{more}",
    "hint": "Accept these shortfalls for this job, or change the drawing, the line types of its edges, the tools or the board."
  },
  "job.program-refused": {
    "text": "The program does not match the drawing, so nothing was cut: {findings__space}{more}",
    "hint": "Choose another machine or board, change the drawing, or set the line types of these edges to ignored and make them by hand."
  },
  "job.rechecked": {
    "text": "The operator let the machine check the job again.",
    "hint": ""
  },
  "job.recompiled": {
    "text": "The operator had the job compiled again for the present machine and board.",
    "hint": ""
  },
  "job.released": {
    "text": "The operator released the job, so it is queued for its machine.",
    "hint": ""
  },
  "job.released-by-order": {
    "text": "The job was released automatically, as its order requested, so it is queued for its machine.",
    "hint": ""
  },
  "job.requeued": {
    "text": "The operator queued the job again.",
    "hint": ""
  },
  "job.scrapped": {
    "text": "The operator scrapped the job.",
    "hint": ""
  },
  "job.stale-epoch": {
    "text": "Job {job} was claimed again, so the claim of this gateway is no longer valid. The job is {state}. Its valid claim has the epoch (claim number) {current}, but the request names epoch {epoch}.",
    "hint": "Stop the machine and claim the job again."
  },
  "job.started": {
    "text": "The job was started.",
    "hint": ""
  },
  "job.started-unconfirmed": {
    "text": "The job was started without the confirmation of the operator.",
    "hint": ""
  },
  "job.stated-by-feed": {
    "text": "The automatic sheet feed confirmed: {checks__semicolon}.",
    "hint": ""
  },
  "job.tool-changed": {
    "text": "The operator put a new tool into station {station} ({name}). The old tool had worked along {used, number, ::precision-integer} m of lines.",
    "hint": ""
  },
  "job.unknown": {
    "text": "Job {job} does not exist.",
    "hint": "Choose one of the jobs that GET /api/jobs lists."
  },
  "job.unknown-checks": {
    "text": "Job {job} has no check {unknown}.",
    "hint": "Its checks are {known}."
  },
  "job.verdict-changed": {
    "text": "The verdict on job {job} has changed since it was read.",
    "hint": "Read the verdict again, then repeat the request."
  },
  "job.verified": {
    "text": "The job was compiled, and its program was verified.",
    "hint": ""
  },
  "job.worker-silent": {
    "text": "The process {worker}, which compiles the job, stopped responding in the stage {stage}.",
    "hint": "Report the error with the log of the server if it happens again."
  },
  "job.worn-tools": {
    "text": "Job {job} uses tools at the end of their lives: {tools__space}",
    "hint": "Put new tools into these stations and confirm the job with the numbers of the stations that were changed, or state why the tools stay in use."
  },
  "job.worn-tools-used": {
    "text": "The operator uses tools at the end of their lives: {tools__space} Reason: {reason}",
    "hint": ""
  },
  "job.wrong-state": {
    "text": "Job {job} is {state}, so its state cannot become {goal}.",
    "hint": "{advice}"
  },
  "job.wrong-state-for-request": {
    "text": "Job {job} is {state}, but the request {request} needs a job that is {states__each_or}.",
    "hint": "{advice}"
  },
  "key.expired-at-once": {
    "text": "The expiry of the key is in the past.",
    "hint": "Choose a time in the future, or leave the expiry out for a key that does not expire."
  },
  "key.incomplete": {
    "text": "An API key must have a title and at least one scope.",
    "hint": "Enter a title that names the program that uses the key, and choose its scopes."
  },
  "key.limited": {
    "text": "This API key is limited to the customer {customer}, but the answer to this request would contain the data of all customers.",
    "hint": "Use a key that is not limited to a customer."
  },
  "key.other-customer": {
    "text": "This API key is limited to the customer {customer} and cannot be used for ''{given}''.",
    "hint": "Leave the customer out, or use a key for that customer."
  },
  "key.other-machine": {
    "text": "This API key is limited to {machines__or} and cannot be used for the machine ''{machine}''.",
    "hint": "Choose another machine, or use a key for that machine."
  },
  "key.revoked": {
    "text": "The API key {id} was revoked.",
    "hint": "Create a new key."
  },
  "key.unknown": {
    "text": "There is no API key with the id {id}.",
    "hint": "List the keys with `knifetip key list`."
  },
  "key.unlimited-scope": {
    "text": "A key with the scope {scope} cannot be limited to a customer or to machines.",
    "hint": "Choose only scopes of {scopes}, or remove the limit."
  },
  "knife.park-heading": {
    "text": "The blade of station {station} turns freely: before the program starts, turn it to a heading of {degrees, number, ::@#####}°. The program leaves it in this direction.",
    "hint": ""
  },
  "language.bad-entry-point": {
    "text": "The Python entry point ''{name}'' of the group {group} must provide a controller language that is named ''{name}'', but does not provide one.",
    "hint": "Correct or remove the Python package that declares the entry point."
  },
  "language.default-outputs": {
    "text": "the machine does not state the number of digital outputs of its controller, and {language} has {count} by default, numbered from 0. It has no output {outputs}",
    "hint": "Use other outputs, or set `output_count` to the number that the controller is configured for."
  },
  "language.few-outputs": {
    "text": "the {language} controller has {count, plural, one {# digital output} other {# digital outputs}}, numbered from 0. It has no output {outputs}",
    "hint": "Use other outputs, or correct `output_count`."
  },
  "language.no-driver": {
    "text": "Programs in {language} cannot be sent to a machine, because the gateway has no driver for this language.",
    "hint": "{advice}"
  },
  "language.no-linear-axis": {
    "text": "carriage {carriage} has a linear axis {letter}, but {language} has no such axis. Its linear axes are {known}",
    "hint": "Change the letter of the axis, or the language (dialect) of the machine."
  },
  "language.no-rotary-axis": {
    "text": "carriage {carriage} has a rotary axis {letter}, but {language} has no such axis. Its rotary axes are {known}",
    "hint": "Change the letter of the axis, or the language (dialect) of the machine."
  },
  "language.no-settings": {
    "text": "{path} is not allowed, because {language} has no settings",
    "hint": "Remove the section [controller]."
  },
  "language.unknown": {
    "text": "The controller language ''{name}'' does not exist.",
    "hint": "Choose one of {known}."
  },
  "language.unusable": {
    "text": "{machine} cannot be controlled with programs in {language}: {faults__semicolon}.",
    "hint": "{faults__hint} Choose the language {own}, which the machine file names."
  },
  "layer.not-finite": {
    "text": "A coordinate on the layer {layer} is not a number.",
    "hint": "Draw the edges of this layer again."
  },
  "lead.no-corner": {
    "text": "{count, plural, one {# contour has} other {# contours have}} a lead-in perpendicular to the contour, because {count, plural, one {it has} other {they have}} no outer corner that turns by at least {angle, number, ::@#####}° and has room for the lead-in. X and Y on the sheet in mm ({count, plural, one {one contour} other {the first contours}}): {places__semicolon}.",
    "hint": "No action is needed. To begin at corners that turn less, set a negative angle nearer to 0° for the lead-in in the machine file."
  },
  "lead.no-room": {
    "text": "{count, plural, one {# contour has} other {# contours have}} no lead-in or no lead-out, because the tool would cut into another edge there. The tool plunges or lifts on the contour, which may leave a mark. X and Y on the sheet in mm ({count, plural, one {one contour} other {the first contours}}): {places__semicolon}.",
    "hint": "Choose a thinner tool or a shorter lead-in, or leave more room between the edges."
  },
  "library.acting-text": {
    "text": "The field {field} of the {shelf} {name} contains an invisible control character: ''{text}''.",
    "hint": "Type the text again without control characters and marks of the writing direction."
  },
  "library.bad-if-match": {
    "text": "The header If-Match is ''{match}'', which is not a version number.",
    "hint": "Send the ETag of the entry in If-Match, for example \"3\"."
  },
  "library.bad-name": {
    "text": "''{name}'' is not a valid name of a {shelf}.",
    "hint": "Use up to 64 lower-case letters, digits, hyphens and underscores. Write other characters into the title of the {shelf}."
  },
  "library.changed-since": {
    "text": "it was made for version {version} of the {shelf} {name}, whose newest version is {newest}",
    "hint": ""
  },
  "library.deleted": {
    "text": "The {shelf} {name} was deleted.",
    "hint": "Order a new job with another {shelf}, or create the {shelf} again."
  },
  "library.deleted-since": {
    "text": "it was made for version {version} of the {shelf} {name}, which was deleted",
    "hint": ""
  },
  "library.exists": {
    "text": "A {shelf} with the name {name} already exists, at version {version}.",
    "hint": "Send If-Match: \"{version}\" to replace this {shelf}, or choose another name."
  },
  "library.in-use": {
    "text": "The {shelf} {name} cannot be deleted: {count, plural, one {# job} other {# jobs}} that have not ended use it, for example {jobs}.",
    "hint": "Wait until these jobs have ended, or cancel them. Then delete the {shelf}."
  },
  "library.invalid": {
    "text": "The {shelf} ''{name}'' cannot be used: {faults__semicolon}.",
    "hint": "{faults__hint} Correct the TOML file of the {shelf}. The command knifetip schema {shelf} describes all fields."
  },
  "library.large-integer": {
    "text": "An integer in the document has more than 64 bits.",
    "hint": "Correct the number, or write it with a decimal point."
  },
  "library.long-text": {
    "text": "The field {field} of the {shelf} {name} is longer than {limit} characters: ''{text}''.",
    "hint": "Use at most {limit} characters."
  },
  "library.nested-too-deep": {
    "text": "The tables of the {shelf} ''{name}'' are nested too deeply.",
    "hint": "Write only the fields that knifetip schema {shelf} describes."
  },
  "library.no-settings": {
    "text": "The controller of {machine} has no settings that knifetip knows.",
    "hint": "Set up the controller as its maker describes."
  },
  "library.not-an-object": {
    "text": "The JSON document of the {shelf} ''{name}'' is not an object.",
    "hint": "Send an object with the fields that GET /api/schemas/{shelf}s describes."
  },
  "library.not-json": {
    "text": "The {shelf} ''{name}'' is not valid JSON: {reason}.",
    "hint": "Send an object with the fields that GET /api/schemas/{shelf}s describes."
  },
  "library.not-stored": {
    "text": "The server has no user-defined {shelf} with the name {name}.",
    "hint": "Choose an entry that GET /api/library lists with shipped: false."
  },
  "library.not-toml": {
    "text": "The {shelf} ''{name}'' is not valid TOML: {reason}.",
    "hint": "Correct the TOML syntax at this position."
  },
  "library.not-utf8": {
    "text": "The {shelf} ''{name}'' is not UTF-8 text: byte {byte} is invalid.",
    "hint": "Save the file as UTF-8."
  },
  "library.null-in-list": {
    "text": "A list in the {shelf} ''{name}'' contains null.",
    "hint": "Remove null from the list, or replace it by a value."
  },
  "library.shipped": {
    "text": "The {shelf} ''{name}'' is part of knifetip and cannot be changed.",
    "hint": "Save a copy of it under another name, and change the copy."
  },
  "library.stale": {
    "text": "Another user has changed the {shelf} {name}: it is now at version {version}, but your change is based on version {given}.",
    "hint": "Load the {shelf} again and check it. Then send your change with If-Match: \"{version}\"."
  },
  "library.too-long": {
    "text": "The {shelf} ''{name}'' has a size of {size} kB, but the limit is {limit} kB.",
    "hint": "Remove comments and fields that are not needed."
  },
  "library.too-many": {
    "text": "The server already has {limit} user-defined machines, boards and tools, which is the largest number allowed.",
    "hint": "Delete entries that are not used."
  },
  "library.unknown": {
    "text": "The {shelf} ''{name}'' does not exist.",
    "hint": "Choose one of {known}."
  },
  "library.unknown-file": {
    "text": "The {shelf} ''{name}'' does not exist: {reason}.",
    "hint": "Check the path of the file, or choose one of {known}."
  },
  "library.unknown-version": {
    "text": "The {shelf} {name} has no version {version}; its newest version is {newest}.",
    "hint": "Choose one of the versions that GET /api/{shelf}s/{name}/versions lists."
  },
  "library.unreadable": {
    "text": "The {shelf} ''{name}'' cannot be read: {detail}.",
    "hint": "Correct the TOML file of the {shelf}."
  },
  "lift.not-stated": {
    "text": "Tools cannot be lifted less than usual between cuts, because the machine file of {machine} does not state to which height (turn_clearance).",
    "hint": "Let tools be lifted to the clearance of the machine, or set turn_clearance in the machine file, for example to 0.5 mm for board that lies flat."
  },
  "lightburn.doctype": {
    "text": "The LightBurn project has a DOCTYPE, which LightBurn does not write.",
    "hint": "Save the project again in LightBurn."
  },
  "lightburn.empty": {
    "text": "The LightBurn project contains no shape.",
    "hint": "Send the complete file, or save the project again in LightBurn."
  },
  "limit.disk-full": {
    "text": "The disk of the server is full, so nothing was stored.",
    "hint": "Delete files on the server or enlarge its disk, then send the request again. /readyz shows how much is free."
  },
  "limit.disk-low": {
    "text": "The disk of the server has only {free} MB free, and {least} MB are reserved for running jobs, so nothing was stored.",
    "hint": "Delete files on the server or enlarge its disk, then send the request again."
  },
  "limit.too-many-connections": {
    "text": "Too many connections to the server are open.",
    "hint": "Close unused connections, or try again in a moment."
  },
  "limit.too-many-listeners": {
    "text": "Too many event streams of the server are open (limit: {limit}).",
    "hint": "Close browser pages of the server that are not needed, or start the server with a greater --max-listeners."
  },
  "limit.too-many-requests": {
    "text": "This client sends too many requests: more than {rate} per second on average.",
    "hint": "Send the request again in {seconds} s."
  },
  "limit.too-slow": {
    "text": "The request did not arrive within the time limit.",
    "hint": "Send the whole request without a pause, and check the network connection."
  },
  "linuxcnc.bad-address": {
    "text": "''{address}'' is not a valid address of LinuxCNC.",
    "hint": "Write HOST:PORT, or linuxcnc://HOST:PORT/?OPTION=VALUE&OPTION=VALUE with the options {options}; values have no blanks."
  },
  "linuxcnc.beyond-travel": {
    "text": "Program line {line} would move {axis} to {position, number, ::.000} {unit} in coordinates of the machine, beyond the limit {limit, number, ::.000} {unit} of LinuxCNC at {name}. Nothing has moved.",
    "hint": "Set X Y zero where the whole sheet is within the travel, or place the job elsewhere. If the machine can move farther, correct MIN_LIMIT and MAX_LIMIT of {axis} in the INI file of LinuxCNC."
  },
  "linuxcnc.cause": {
    "text": ": {texts__semicolon}",
    "hint": ""
  },
  "linuxcnc.estop": {
    "text": "LinuxCNC at {name} is in emergency stop.",
    "hint": "Check the table, release the emergency stop button, then press Unlock, or reset the emergency stop and switch the machine on in LinuxCNC."
  },
  "linuxcnc.folder-not-writable": {
    "text": "The program file for LinuxCNC cannot be written to the folder {folder} ({reason}).",
    "hint": "Create the folder, and permit the user of the gateway to write to it."
  },
  "linuxcnc.ini-unread": {
    "text": "The gateway cannot read the INI file {path} of LinuxCNC at {name}, so it does not compare limits, velocities and accelerations with the machine file.",
    "hint": "Copy the file to the computer of the gateway, and add ini=PATH to the address."
  },
  "linuxcnc.lost": {
    "text": "The connection to LinuxCNC at {name} is lost. LinuxCNC may still execute its program.",
    "hint": "Keep clear of the table until the machine has stopped, or press the emergency stop button. Then check that LinuxCNC and linuxcncrsh run."
  },
  "linuxcnc.machine-off": {
    "text": "The machine of LinuxCNC at {name} is switched off.",
    "hint": "Check the table, then press Unlock, or switch the machine on in LinuxCNC."
  },
  "linuxcnc.not-at-rest": {
    "text": "The machine of LinuxCNC at {name} has not come to rest within {seconds, number, ::@#####} s.",
    "hint": "Press the emergency stop button if the machine still moves, then check the table."
  },
  "linuxcnc.not-begun": {
    "text": "LinuxCNC at {name} has not begun the program within {seconds, number, ::@#####} s.",
    "hint": "Look for a message of LinuxCNC at the machine, then try again."
  },
  "linuxcnc.not-homed": {
    "text": "The machine of LinuxCNC at {name} is not homed (joints {joints}).",
    "hint": "Check that the table is clear, then press Home, or home all joints in LinuxCNC."
  },
  "linuxcnc.not-secured": {
    "text": "The tool was not lifted and the stations were not raised. {cause}",
    "hint": "{cause__hint}"
  },
  "linuxcnc.program-not-opened": {
    "text": "LinuxCNC at {name} cannot open the program file {path}{cause}.",
    "hint": "If LinuxCNC runs on another computer, share a folder with it and give its path on both computers: linuxcnc://HOST:PORT/?programs=FOLDER&remote=FOLDER_THERE. The user of LinuxCNC must be able to read it."
  },
  "linuxcnc.refused": {
    "text": "LinuxCNC at {name} refused the command ''{command}''{cause}.",
    "hint": "Check the table and LinuxCNC, then try again."
  },
  "linuxcnc.rejected-in-check": {
    "text": "LinuxCNC at {name} refused the program before anything moved{cause}.",
    "hint": "If a tool is missing, write the tool table of the machine (knifetip machine NAME --tool-table) to LinuxCNC. Otherwise compile the job again for this controller."
  },
  "linuxcnc.silent": {
    "text": "LinuxCNC at {name} has not responded for {seconds, number, ::@#####} s. It may still execute its program.",
    "hint": "Keep clear of the table until the machine has stopped, or press the emergency stop button. Then check that LinuxCNC and linuxcncrsh run."
  },
  "linuxcnc.stopped": {
    "text": "LinuxCNC at {name} reported an error near program line {line}{cause}.",
    "hint": "Check the table and the board before the next job."
  },
  "linuxcnc.unreadable": {
    "text": "LinuxCNC at {name} sent a reply that the gateway cannot read: {reply}.",
    "hint": "Close every other connection to linuxcncrsh: it mixes up the replies to two clients."
  },
  "linuxcnc.wrong-password": {
    "text": "linuxcncrsh at {name} refused the password of the option {option}.",
    "hint": "Give the passwords of linuxcncrsh in the address: linuxcnc://HOST:PORT/?password=CONNECTPW&enable=ENABLEPW."
  },
  "machine.busy": {
    "text": "Job {job} already occupies the table of {machine}.",
    "hint": "Wait until that job has ended. If that job is interrupted, choose what to do with it: mark as finished, queue again or scrap."
  },
  "machine.busy-with-another": {
    "text": "Another job already occupies the table of {machine}.",
    "hint": "Wait until that job has ended. If that job is interrupted, choose what to do with it: mark as finished, queue again or scrap."
  },
  "machine.no-cutter": {
    "text": "{machine} has no cutter with the name ''{cutter}'', because none of its tools is a rotating cutter or a laser.",
    "hint": "Choose a machine with a rotating cutter or a laser. Only these tools can be calibrated."
  },
  "machine.no-such-cutter": {
    "text": "{machine} has no cutter with the name ''{cutter}''.",
    "hint": "Choose one of the cutters {known}."
  },
  "mcx314.after-end": {
    "text": "The program continues after END.",
    "hint": "Remove the lines after END."
  },
  "mcx314.alarm-chip": {
    "text": "The motion chip of {name} received a segment too late, or refused a segment.",
    "hint": "Check the sheet on the table, then unlock and home the machine. Choose a slower feed or a longer refill in the machine file."
  },
  "mcx314.alarm-drive": {
    "text": "The drive of the axis {axis} of {name} reports a fault.",
    "hint": "Clear the fault at the drive, then unlock and home the machine."
  },
  "mcx314.alarm-emergency": {
    "text": "{name} is in emergency stop.",
    "hint": "Clear the cause, release the button, unlock and home the machine."
  },
  "mcx314.alarm-limit": {
    "text": "The axis {axis} of {name} is at its limit switch.",
    "hint": "Check the table, then unlock and home the machine."
  },
  "mcx314.alarm-other": {
    "text": "{name} reports the alarm {alarm}.",
    "hint": "Check the table, then unlock and home the machine."
  },
  "mcx314.alarm-unhomed": {
    "text": "The axes of {name} are not homed, so their positions are unknown.",
    "hint": "Check that the tool is out of the board, then home the machine."
  },
  "mcx314.axis-too-fast": {
    "text": "{path} needs {rate, number, ::precision-integer} pulses per second, but the chip MCX314 makes at most {limit, number}",
    "hint": "Choose a lower velocity, fewer pulses per millimetre or degree, or a greater multiple of the drive speed."
  },
  "mcx314.axis-too-long": {
    "text": "{path} is {pulses, number} pulses long, but the chip MCX314 counts at most {limit, number} in one segment",
    "hint": "Choose fewer pulses per millimetre or degree."
  },
  "mcx314.bad-arc": {
    "text": "The end of the arc is not on its circle, or the arc is a point or a whole circle.",
    "hint": "Correct the end or the centre."
  },
  "mcx314.bad-axes": {
    "text": "The line moves {count} axes at once, but the chip MCX314 moves one to three.",
    "hint": "Divide the move into moves of at most three axes."
  },
  "mcx314.bad-header": {
    "text": "The program does not begin with “MCX314 {version}”.",
    "hint": "Check that it is a program for an MCX314, in this version of the format."
  },
  "mcx314.bad-line": {
    "text": "The line ''{text}'' is not an instruction.",
    "hint": "Correct the line."
  },
  "mcx314.bad-rate": {
    "text": "{path} is {value}, but must be a multiple of {step} and at most {limit}",
    "hint": "Choose another value. The steps follow from the multiple of the drive speed that [controller] states."
  },
  "mcx314.bad-speed": {
    "text": "The drive speed must be {slowest, number} to {fastest, number} pulses per second.",
    "hint": "Correct the drive speed."
  },
  "mcx314.ends-lowered": {
    "text": "Output {output} is on at the end of the program.",
    "hint": "Switch it off before END."
  },
  "mcx314.ends-oscillating": {
    "text": "The oscillation is on at the end of the program.",
    "hint": "Switch it off before END."
  },
  "mcx314.feed-too-slow": {
    "text": "{path} gives {rate, number, ::precision-integer} pulses per second along a diagonal, but programs need at least {limit, number, ::precision-integer} for an exact feed",
    "hint": "Choose a greater feed, or more pulses per millimetre."
  },
  "mcx314.four-axes": {
    "text": "{place} moves four axes at once, but the chip MCX314 can move only three.",
    "hint": "Let the tool turn before or after its depth changes."
  },
  "mcx314.gave-up": {
    "text": "{name} has received nothing from this gateway for {seconds, number, ::@#####} s and stopped the program.",
    "hint": "Check the connection to the board, then check the sheet on the table."
  },
  "mcx314.joins-nothing": {
    "text": "The instruction JOIN continues the move in the line before, but that line is neither a line nor an arc.",
    "hint": "Remove JOIN."
  },
  "mcx314.joins-short": {
    "text": "The instruction JOIN follows a segment that takes only {milliseconds, number, ::@##} ms, but writing the next segment to the chip takes up to {refill, number, ::@##} ms.",
    "hint": "Remove JOIN, or make the segment before it longer."
  },
  "mcx314.lost": {
    "text": "The connection to {name} is lost.",
    "hint": "Check the cable to the board, then check the sheet on the table."
  },
  "mcx314.no-circle": {
    "text": "The line is an arc, but X and Y have different pulses per millimetre.",
    "hint": "Replace the arc by lines."
  },
  "mcx314.no-end": {
    "text": "The program does not end with END.",
    "hint": "The file may be incomplete: create the program again."
  },
  "mcx314.no-newline": {
    "text": "The last line does not end with a newline.",
    "hint": "The file may be incomplete: create the program again."
  },
  "mcx314.no-pulses": {
    "text": "The first instruction must be PULSES with the pulses of X, Y, Z and C.",
    "hint": "Create the program again."
  },
  "mcx314.no-wiring": {
    "text": "The machine file of {machine} does not state how the axes are connected to the motion chip MCX314.",
    "hint": "Add the table [controller] to the machine file, with the pulses and speeds of the axes."
  },
  "mcx314.not-at-rest": {
    "text": "{name} was not at rest after {seconds, number, ::@#####} s.",
    "hint": "Lift the tool and raise the stations at the table."
  },
  "mcx314.not-lifted": {
    "text": "The outputs are off, but the tool was not lifted. {cause}",
    "hint": "{cause__hint}"
  },
  "mcx314.not-settled": {
    "text": "A move begins already {seconds, number, ::@#####} s after an output or the oscillation was switched.",
    "hint": "Add a dwell before the move, as long as the station needs after it is switched."
  },
  "mcx314.other-pulses": {
    "text": "The program is made for other pulses per millimetre or degree than {machine} has.",
    "hint": "Create the program for this machine."
  },
  "mcx314.out-of-range": {
    "text": "A number in the line is greater than {limit, number}, the most that the chip MCX314 can count.",
    "hint": "Divide the move into shorter moves."
  },
  "mcx314.pulses-of-board": {
    "text": "The program states other pulses per millimetre or degree than {name} has.",
    "hint": "Compare [controller] in the machine file with the settings of the board, then compile the job again."
  },
  "mcx314.refused": {
    "text": "{name} refused {request}: {code}.",
    "hint": "Check the table, then try again."
  },
  "mcx314.reset": {
    "text": "{name} was switched off or reset. All outputs were released, and the position is unknown.",
    "hint": "Check that the tool is out of the board, then home the machine."
  },
  "mcx314.silent": {
    "text": "{name} has not answered for {seconds, number, ::@#####} s.",
    "hint": "Check that the board is switched on, then check the sheet on the table."
  },
  "mcx314.speed": {
    "text": "{place} needs {rate, number, ::precision-integer} pulses per second, but the chip MCX314 makes only {slowest, number} to {fastest, number}.",
    "hint": "Choose another feed for the tool, or another multiple of the drive speed."
  },
  "mcx314.spindle-not-supported": {
    "text": "{path} states a direction or a speed, but a program for an MCX314 can only switch the spindle on and off",
    "hint": "Remove spindle and spindle_speed, and set them at the drive."
  },
  "mcx314.stopped": {
    "text": "{name} has discarded the program at line {line}.",
    "hint": "Another program may be connected to the board. Check the sheet on the table."
  },
  "mcx314.too-far": {
    "text": "{place} needs {pulses, number} pulses, but the chip MCX314 counts at most {limit, number} in one segment.",
    "hint": "Divide the edge, or use fewer pulses per millimetre."
  },
  "mcx314.too-short": {
    "text": "{place} takes only {milliseconds, number, ::@##} ms, but writing the next segment to the chip MCX314 takes up to {refill, number, ::@##} ms.",
    "hint": "Choose a slower feed for the tool, or remove short edges from the drawing."
  },
  "mcx314.tool-not-supported": {
    "text": "{path} is a tool that must be switched on and off during a cut, which a program for an MCX314 cannot do",
    "hint": "Use a knife, a crease wheel, a V-cutter or a router in this station."
  },
  "mcx314.unknown-line": {
    "text": "Program line {line} ({text}) is not an instruction for an MCX314.",
    "hint": "Compile the job again for this machine."
  },
  "mcx314.unknown-output": {
    "text": "The machine has no output {output}.",
    "hint": "Correct the number."
  },
  "mcx314.unknown-position": {
    "text": "The line moves an axis by a number of pulses, but no line before it states where the axis is.",
    "hint": "Move the axis with GO first."
  },
  "mcx314.unreadable": {
    "text": "{name} sent an answer that does not come from a board with an MCX314: {answer}",
    "hint": "Check the address of the controller."
  },
  "mcx314.wrong-dwell": {
    "text": "The dwell must last {needed} ms, the time that the selected station needs after it is switched.",
    "hint": "Correct the duration of the dwell."
  },
  "milling.contours-cross": {
    "text": "Edge {edge} belongs to a contour that crosses another contour or itself at X{x, number, ::.000 group-off} Y{y, number, ::.000 group-off}, so it is not clear on which side the cutter must run.",
    "hint": "Trim the contours at their crossings, so that each part has one outline, or set the line type of the contour that is not to be cut to ignored."
  },
  "milling.drawn-twice": {
    "text": "{count, plural, one {# cut lies} other {# cuts lie}} at most {distance, number, ::.000} mm beside other cuts, as edge {edge} beside edge {other}: the board cannot hold so narrow a strip, and the cutter removes it.",
    "hint": "If the same line is drawn twice, set the line type of {count, plural, one {# cut} other {these # cuts}} to ignored. Otherwise choose a machine with a knife."
  },
  "milling.shared-edge": {
    "text": "Two parts share edge {edge}. On its line, a cutter of {diameter, number, ::@#####} mm diameter would cut into one of the parts at an end of the edge or at a line beside it.",
    "hint": "Move the parts at least {diameter, number, ::@#####} mm apart. If the edge divides one blank, set its line type to ignored and cut it by hand, or choose a machine with a knife."
  },
  "motion.feed": {
    "text": "cutting move",
    "hint": ""
  },
  "motion.lead-in": {
    "text": "lead-in",
    "hint": ""
  },
  "motion.lead-out": {
    "text": "lead-out",
    "hint": ""
  },
  "motion.lift": {
    "text": "lift",
    "hint": ""
  },
  "motion.plunge": {
    "text": "plunge",
    "hint": ""
  },
  "motion.rapid": {
    "text": "rapid move",
    "hint": ""
  },
  "motion.swivel": {
    "text": "turn of the tool",
    "hint": ""
  },
  "motion.unknown": {
    "text": "unknown motion type {number}",
    "hint": ""
  },
  "obstacle.asleep": {
    "text": "{name} is in sleep mode.",
    "hint": "Check the table, then press Release to wake the controller. Home the machine afterwards."
  },
  "obstacle.busy": {
    "text": "{name} executes something that does not belong to a job.",
    "hint": "Wait until it is at rest. If it stays so, press Release: the machine stops and moves no axis."
  },
  "obstacle.check-mode": {
    "text": "{name} is in check mode, in which nothing moves.",
    "hint": "Press Release to end the check mode."
  },
  "obstacle.door-closed": {
    "text": "{name} is on hold after its safety door was opened.",
    "hint": "Check the table, then press Release: the machine discards what it held and moves no axis. Lift the tool afterwards."
  },
  "obstacle.door-open": {
    "text": "The safety door of {name} is open.",
    "hint": "Close the safety door, then press Release."
  },
  "obstacle.held": {
    "text": "{name} is on hold, and no job runs on it.",
    "hint": "Check the table, then press Release: the machine discards what it held and moves no axis. Lift the tool afterwards."
  },
  "obstacle.job-door-closed": {
    "text": "The job on {name} is held, because the safety door was opened.",
    "hint": "Check the table, then press Resume to continue at this place, or Stop to end the job."
  },
  "obstacle.job-door-open": {
    "text": "The job on {name} is held, because the safety door is open.",
    "hint": "Close the safety door, then press Resume to continue at this place, or Stop to end the job."
  },
  "obstacle.limit-pressed": {
    "text": "A limit switch of {name} is still pressed ({axes}).",
    "hint": "Jog these axes away from their switches until this text disappears, or home the machine. If no axis is at a switch, check the switch and its cable."
  },
  "obstacle.limit-unused": {
    "text": "A limit switch of {name} is pressed ({axes}). It does not stop the machine, because hard limits are off.",
    "hint": "Jog these axes away from their switches. If no axis is at a switch, check the switch and its cable."
  },
  "obstacle.moves": {
    "text": "{name} moves, but not for a job.",
    "hint": "Wait until it is at rest, or press Release: the machine stops and discards the rest."
  },
  "obstacle.tool-change": {
    "text": "{name} waits until a tool is changed, and no job runs on it.",
    "hint": "Check that the tool is fixed, then press Release: the machine discards the rest and moves no axis."
  },
  "offset.bad-distance": {
    "text": "The offset distance of a path (the radius of the tool) is negative or not a number.",
    "hint": "Correct the radius of the tool."
  },
  "offset.bad-interference": {
    "text": "''{interference}'' is not a valid method for the parts of a contour that the tool cannot reach.",
    "hint": "Choose 'trim' (leave these parts uncut) or 'refuse' (write no program)."
  },
  "offset.bad-side": {
    "text": "The side of a path must be +1 (left) or -1 (right).",
    "hint": "Give +1 or -1 as the side."
  },
  "offset.cusp": {
    "text": "The offset curve at a distance of {radius, number, ::@#####} mm from path {path} is not closed, because segments {one} and {two} of the contour cross {size, number, ::@###} mm before the corner at ({x, number, ::.0000}, {y, number, ::.0000}) mm where they meet.",
    "hint": "Trim the two segments at their crossing, so that the corner is there."
  },
  "offset.dead-end": {
    "text": "The offset curve at a distance of {radius, number, ::@#####} mm from path {path} is not closed. A piece of the curve beside segment {segment} of the path is {depth, number, ::@###} mm long and does not connect to the rest of the curve.",
    "hint": "Draw the contour so that it does not overlap itself, or change the radius of the tool slightly."
  },
  "offset.interference": {
    "text": "A tool of {radius, number, ::@#####} mm radius that follows segment {segment} would cut {depth, number, ::@###} mm into segment {other}.",
    "hint": "Choose a tool with a smaller radius, or accept uncut areas where the tool does not fit."
  },
  "offset.mixed-group": {
    "text": "Path {path} has a different tool radius, or another side of the tool, than the other paths that are offset together with it.",
    "hint": "Reverse the path, or offset it separately."
  },
  "offset.self-contact": {
    "text": "The offset curve at a distance of {radius, number, ::@#####} mm from path {path} is not closed, because the contour touches itself at ({x, number, ::.0000}, {y, number, ::.0000}) mm in segments {one} and {two}.",
    "hint": "Trim the two segments at their intersection, or move one of the segments."
  },
  "oidc.bad-role": {
    "text": "The option --oidc-role {pair} is not valid.",
    "hint": "Write it as VALUE=ROLE, where ROLE is {roles__or}."
  },
  "oidc.bad-token": {
    "text": "The sign-in was refused, because the ID token of the provider is not valid: {reason}.",
    "hint": "Sign in again. If the error persists, ask an administrator to compare the issuer, the client id and the clocks of provider and server."
  },
  "oidc.bad-url": {
    "text": "{url} is not an https URL.",
    "hint": "Give a URL that begins with https://; http:// is permitted for this computer only."
  },
  "oidc.code-refused": {
    "text": "The provider refused the authorization code of the sign-in: {reason}.",
    "hint": "Sign in again. If the error persists, ask an administrator to check the client id, the secret and the redirect URL of this server at the provider."
  },
  "oidc.declined": {
    "text": "The provider did not sign you in: {reason}.",
    "hint": "Sign in again, or ask the administrator of the provider whether you may use this server."
  },
  "oidc.disabled": {
    "text": "The user {name} is disabled.",
    "hint": "An administrator can enable the user with `knifetip user enable`."
  },
  "oidc.no-client": {
    "text": "The client id of this server at the OpenID Connect provider is missing.",
    "hint": "Set it with --oidc-client-id."
  },
  "oidc.no-issuer": {
    "text": "Options for OpenID Connect are set, but the provider is missing.",
    "hint": "Set the URL of the provider with --oidc-issuer."
  },
  "oidc.no-role": {
    "text": "The user {name} has no role on this server.",
    "hint": "Ask the administrator of the provider for one of the roles or groups that the option --oidc-role of this server lists."
  },
  "oidc.no-roles": {
    "text": "No value of the provider is mapped to a role, so no user could sign in.",
    "hint": "Set at least one --oidc-role VALUE=ROLE, for example shop-admins=admin."
  },
  "oidc.not-begun": {
    "text": "This sign-in was not started in this browser, has expired, or is already finished.",
    "hint": "Sign in again. Cookies of this server must be permitted in the browser."
  },
  "oidc.not-installed": {
    "text": "Sign-in by OpenID Connect needs authlib, which is not installed.",
    "hint": "Install it with `pip install 'knifetip[oidc]'`."
  },
  "oidc.unreachable": {
    "text": "The provider {issuer} cannot be reached or sent an invalid answer.",
    "hint": "Try again in a minute. The log of the server contains the reason."
  },
  "oidc.used": {
    "text": "This sign-in at the provider was already used.",
    "hint": "Sign in again."
  },
  "operation.bad-feed": {
    "text": "A feed of {feed, number, ::@#####} per minute is not possible on this axis.",
    "hint": "Give a feed greater than 0 and not greater than {fastest, number, ::@#####} per minute."
  },
  "operation.bad-override": {
    "text": "A feed override of {percent} % is not possible on this machine.",
    "hint": "Choose {low} to {high} %."
  },
  "operation.beyond-travel": {
    "text": "The move would end at {axis} {target, number, ::.000}, beyond the travel of the axis from {low, number, ::@#####} to {high, number, ::@#####}. Nothing has moved.",
    "hint": "Jog a shorter distance, or in the other direction."
  },
  "operation.door-open": {
    "text": "The safety door of {name} is open. Nothing was sent.",
    "hint": "Close the safety door, then press Release."
  },
  "operation.expired": {
    "text": "The operation was not executed within {seconds, number, ::@#####} s and was dropped. Nothing was sent to the machine.",
    "hint": "Check the connection of the gateway to the server and to the machine, then try again."
  },
  "operation.gateway-absent": {
    "text": "No gateway of {machine} is connected, so nothing can be sent to the machine.",
    "hint": "Switch on the machine and start its gateway."
  },
  "operation.hands-not-clear": {
    "text": "The request {request} moves {machine}, but within the last {seconds, number, ::@#####} s nobody has confirmed that all hands are clear of it.",
    "hint": "Make sure that nobody reaches into the machine, press Hands clear on the station page, then repeat the request."
  },
  "operation.job-on-machine": {
    "text": "The machine executes a job, so it does nothing else.",
    "hint": "Wait until the job has ended, or cancel it."
  },
  "operation.job-running": {
    "text": "Job {job} is {state} on {machine}, so the machine does nothing else.",
    "hint": "Wait until the job has ended, or cancel it."
  },
  "operation.jog-ended": {
    "text": "The jog {id} has ended: its button was not reported as held within {seconds, number, ::@#####} s, or the machine has refused it.",
    "hint": "Release the button, and press it again."
  },
  "operation.missing-argument": {
    "text": "The operation {request} needs the field {name}.",
    "hint": "Add the field to the request."
  },
  "operation.no-controller": {
    "text": "The gateway of {machine} is not connected to the controller of the machine.",
    "hint": "Switch on the controller and check its cable."
  },
  "operation.no-result": {
    "text": "The gateway received the operation, but has not reported its result.",
    "hint": "Look at the machine before you ask for anything else."
  },
  "operation.no-spindle": {
    "text": "Station {station, number, ::@##############} of {machine} has no spindle or oscillation that is switched by hand.",
    "hint": "Choose a station with a knife that oscillates or with a cutter."
  },
  "operation.no-station": {
    "text": "{machine} has no station {station, number, ::@##############}, or no point was given for it.",
    "hint": "Choose a station of the machine, and a point on its table."
  },
  "operation.not-at-rest": {
    "text": "{name} is not at rest: it reports the state {state}. Nothing was sent.",
    "hint": "Wait until the machine has stopped. If it is in alarm, unlock or home it."
  },
  "operation.not-lifted": {
    "text": "The tool is not lifted: Z is below {height, number, ::@#####}. Nothing was sent.",
    "hint": "Park the machine, or jog Z up first."
  },
  "operation.not-locked": {
    "text": "{name} is not locked by an alarm, so there is nothing to unlock.",
    "hint": ""
  },
  "operation.nothing-held": {
    "text": "{name} is not on hold, so there is nothing to release.",
    "hint": "If an alarm locks the machine, unlock or home it."
  },
  "operation.override-not-confirmed": {
    "text": "{name} reports a feed override of {found} % instead of {percent} %.",
    "hint": "Press the button again; if the override does not change, look at the controller."
  },
  "operation.stopped": {
    "text": "A person has stopped {name} before the operation was complete.",
    "hint": ""
  },
  "operation.unknown": {
    "text": "There is no operation {id} of {machine}.",
    "hint": "Ask for the operation again: operations are kept for a short time only."
  },
  "operation.unknown-axis": {
    "text": "The machine has no axis ''{axis}''.",
    "hint": "Use letters of {axes}."
  },
  "operation.unknown-output": {
    "text": "The machine has no output {output, number, ::@##############}.",
    "hint": "Use one of its outputs: {outputs}."
  },
  "operation.unreported": {
    "text": "The controller of {machine} takes whole programs and reports nothing, so it cannot carry out the operation {request}.",
    "hint": "Use the controls of the machine itself. To see the path without work, raise or remove the tool, or draw the program with a pen."
  },
  "operation.unsupported": {
    "text": "{name} cannot execute the operation {request}.",
    "hint": "Carry it out at the machine."
  },
  "output.accepted-by": {
    "text": "accepted by {by}: {reason}",
    "hint": ""
  },
  "output.actions": {
    "text": "actions: {actions}",
    "hint": ""
  },
  "output.add-lines": {
    "text": "add these lines to the board file",
    "hint": ""
  },
  "output.calibrated": {
    "text": "{count} points, largest residual {residual, number, ::.0000} mm; {where}.",
    "hint": ""
  },
  "output.cancel-effect": {
    "text": "The machine holds, lifts the tool and releases its stations. The board on the table is probably lost.",
    "hint": ""
  },
  "output.cancel-question": {
    "text": "{effect} Cancel job {job}?",
    "hint": ""
  },
  "output.carriage": {
    "text": "carriage {number}: axes {axes__space}, parks at {letter}{park, number, ::@##### group-off}, stations {stations}",
    "hint": ""
  },
  "output.carriage-without-station": {
    "text": "carriage {number}: axes {axes__space}, parks at {letter}{park, number, ::@##### group-off}, no stations",
    "hint": ""
  },
  "output.carriages": {
    "text": "carriages at least {distance, number, ::@#####} mm apart",
    "hint": ""
  },
  "output.check-first": {
    "text": "Check at the machine before job {job} starts:",
    "hint": ""
  },
  "output.check-question": {
    "text": "{number} of {count}: {text} Is this true?",
    "hint": ""
  },
  "output.cleaned-edge": {
    "text": "{handle} edge {edge}: {outcome}",
    "hint": ""
  },
  "output.customer": {
    "text": "customer {customer}",
    "hint": ""
  },
  "output.disabled": {
    "text": " (disabled)",
    "hint": ""
  },
  "output.drawn": {
    "text": "drawn {drawn, number, ::.000} mm = kept {kept, number, ::.000} + merged {merged, number, ::.000} + dropped {dropped, number, ::.000}",
    "hint": ""
  },
  "output.expires": {
    "text": "expires {date}",
    "hint": ""
  },
  "output.folder-unreadable": {
    "text": "the folder cannot be read: {reason}",
    "hint": ""
  },
  "output.former-database": {
    "text": "The former database is kept as {file}.",
    "hint": ""
  },
  "output.gateway": {
    "text": "{title}: controller {controller}, server {server}",
    "hint": ""
  },
  "output.hands-clear": {
    "text": "Are all hands clear of the machine?",
    "hint": ""
  },
  "output.if-so": {
    "text": "If all of this is true, enter:",
    "hint": ""
  },
  "output.job-board": {
    "text": "{machine}, board {board}",
    "hint": ""
  },
  "output.job-progress": {
    "text": "line {line} of {lines}, copies {done} of {copies}",
    "hint": ""
  },
  "output.job-state": {
    "text": "The job is {state}.",
    "hint": ""
  },
  "output.job-tools": {
    "text": "tools: {tools}",
    "hint": ""
  },
  "output.kernels": {
    "text": "Compiled {compiled} of {total} software modules.",
    "hint": ""
  },
  "output.key": {
    "text": "key {id} for {title}: {scopes}",
    "hint": ""
  },
  "output.key-row": {
    "text": "{id} {title} {scopes} {notes}",
    "hint": ""
  },
  "output.key-valid": {
    "text": "{file}: key {id} for {title} is valid",
    "hint": ""
  },
  "output.leave-out": {
    "text": "To leave out these edges and make them by hand: --edge {edges}=ignored",
    "hint": ""
  },
  "output.line-type": {
    "text": "{type} {count} edges {length} mm",
    "hint": ""
  },
  "output.listening": {
    "text": "listening on {address}",
    "hint": ""
  },
  "output.machine": {
    "text": "{title} ({name}), language {language}, {feed} feed",
    "hint": ""
  },
  "output.machines": {
    "text": "machines {names__space}",
    "hint": ""
  },
  "output.migrated": {
    "text": "The tables were migrated from revision {before} to revision {after}.{copy}",
    "hint": ""
  },
  "output.migrated-new": {
    "text": "The tables were migrated to revision {after}.{copy}",
    "hint": ""
  },
  "output.migration-copy": {
    "text": " A copy from before the migration is {file}.",
    "hint": ""
  },
  "output.more": {
    "text": "and {count} more",
    "hint": ""
  },
  "output.more-lines": {
    "text": "… and {count} more: --json lists them all",
    "hint": ""
  },
  "output.no-tables": {
    "text": "no tables; knifetip needs revision {newest}",
    "hint": ""
  },
  "output.not-cleaned": {
    "text": "The drawing was not cleaned: {reason}",
    "hint": ""
  },
  "output.not-confirmed": {
    "text": "Job {job} was not confirmed. The machine does not start.",
    "hint": ""
  },
  "output.password": {
    "text": "Password",
    "hint": ""
  },
  "output.profile": {
    "text": "{name}: {title}, {count} rules",
    "hint": ""
  },
  "output.profile-not-stored": {
    "text": "No database: the profile was not stored. Name one with --database.",
    "hint": ""
  },
  "output.profile-stored": {
    "text": "stored as version {version}",
    "hint": ""
  },
  "output.read": {
    "text": "{file}: {size}, {count} segments; {evidence}",
    "hint": ""
  },
  "output.revision-current": {
    "text": "revision {revision}{writer}, up to date",
    "hint": ""
  },
  "output.revision-newer": {
    "text": "revision {revision}{writer}, newer than revision {newest} of this version",
    "hint": ""
  },
  "output.revision-older": {
    "text": "revision {revision}{writer}, older than revision {newest} of this version",
    "hint": ""
  },
  "output.revoked": {
    "text": "revoked {date}",
    "hint": ""
  },
  "output.scrap-question": {
    "text": "The table is freed. Order missing copies with knifetip job rest. Scrap job {job}?",
    "hint": ""
  },
  "output.server-silent": {
    "text": "the server does not answer: {reason}",
    "hint": ""
  },
  "output.size-and-edges": {
    "text": "{file}: {size}, {count} edges",
    "hint": ""
  },
  "output.station": {
    "text": "{number}  {name}: {tool}, datum {datum}",
    "hint": ""
  },
  "output.tables-current": {
    "text": "The tables are up to date.",
    "hint": ""
  },
  "output.time-saved": {
    "text": "{seconds, number, ::.0} s on the machine, {percent, number, ::precision-integer} % less than the {retracted, number, ::.0} s with a full lift of the tool between cuts",
    "hint": ""
  },
  "output.to-accept": {
    "text": "To accept: --accept {edges}:{code} --reason \"...\"",
    "hint": ""
  },
  "output.track": {
    "text": "{number}  {state} station {station}  lines {first}-{last}  from X{x, number, ::.0 group-off} Y{y, number, ::.0 group-off}  edges {edges}",
    "hint": ""
  },
  "output.unreached-areas": {
    "text": "the cutter does not reach {area, number, ::.00} mm² in {count, plural, one {# place} other {# places}}, which remain uncut",
    "hint": ""
  },
  "output.unreached-edges": {
    "text": "the cutter does not reach {length, number, ::.00} mm of the edges; they are up to {distance, number, ::.00} mm from the cut",
    "hint": ""
  },
  "output.used": {
    "text": "used {date}",
    "hint": ""
  },
  "output.used-version": {
    "text": "Version {version} of the machine is used, which was loaded before.",
    "hint": ""
  },
  "output.user-row": {
    "text": "{name} {role} last sign-in {date}{state}",
    "hint": ""
  },
  "output.verdict": {
    "text": "{word}: deviation {deviation, number, ::.0000} mm (tolerance {tolerance, number, ::@#####} mm; of the path {path, number, ::.0000}, by rounding in the controller {blending, number, ::.0000}, of the curve fit {fit, number, ::.0000}), overcut {overcut, number, ::.000} mm, uncut {uncut, number, ::.000} mm, setback {setback, number, ::.000} mm, {seconds, number, ::.0} s at the programmed feeds",
    "hint": ""
  },
  "output.waits-for": {
    "text": "waits for {event}",
    "hint": ""
  },
  "output.watching": {
    "text": "watching {folder}, server {server}",
    "hint": ""
  },
  "output.wide-slits": {
    "text": "{length, number, ::.00} mm of {count, plural, one {# slit} other {# slits}} are milled as wide as the cutter",
    "hint": ""
  },
  "output.word-accepted": {
    "text": "accepted",
    "hint": ""
  },
  "output.word-refused": {
    "text": "refused",
    "hint": ""
  },
  "output.worked": {
    "text": "processed {worked, number, ::.000} mm = kept {kept, number, ::.000} + added by closing gaps {added, number, ::.000}",
    "hint": ""
  },
  "output.worker": {
    "text": "compile worker for {database}",
    "hint": ""
  },
  "output.worker-stuck": {
    "text": "ERROR: this worker is stuck: it has not looked for jobs for {seconds, number, ::precision-integer} s. It exits with an error, so that systemd or the container engine starts it again.",
    "hint": ""
  },
  "output.writer": {
    "text": ", made by knifetip {version}",
    "hint": ""
  },
  "output.written-to": {
    "text": "written to {file}",
    "hint": ""
  },
  "output.zone": {
    "text": "keep-out zone {name}: X {left, number, ::@#####} to {right, number, ::@#####}, Y {bottom, number, ::@#####} to {back, number, ::@#####}, {top, number, ::@#####} mm high",
    "hint": ""
  },
  "override.ambiguous": {
    "text": "The request changes the line type of edges, but does not select these edges in exactly one way.",
    "hint": "Give edges (edge numbers), or handles, or a layer and/or a colour."
  },
  "override.no-edges-there": {
    "text": "The drawing has no edge {place__and}.",
    "hint": "Choose a layer and colour that GET /api/drawings/ID/edges lists."
  },
  "override.no-such-edge": {
    "text": "Edge {edge} does not exist. The drawing has {count, plural, one {# edge} other {# edges}}.",
    "hint": "Choose an edge number that exists. The first edge has number 0."
  },
  "override.no-such-handle": {
    "text": "No edge of the drawing has the handle ''{handle}''.",
    "hint": "Choose a handle that GET /api/drawings/ID/edges lists."
  },
  "override.of-colour": {
    "text": "with colour {colour}",
    "hint": ""
  },
  "override.on-layer": {
    "text": "on layer ''{layer}''",
    "hint": ""
  },
  "pdf.blank": {
    "text": "The page of the PDF contains no drawing.",
    "hint": "Export the drawing again, as the first page of the PDF."
  },
  "pdf.content-damaged": {
    "text": "The content of {where} of the PDF is damaged: {reason}. Objects of the drawing may be missing.",
    "hint": "Export the drawing again, or send it as DXF."
  },
  "pdf.cut-short": {
    "text": "The PDF file is incomplete: its {bytes, number} bytes do not end with %%EOF. Objects of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again."
  },
  "pdf.encrypted": {
    "text": "The PDF is encrypted, so it cannot be read.",
    "hint": "Save the PDF without a password and without restrictions, then send it again."
  },
  "pdf.expands-too-far": {
    "text": "The page of the PDF and its repeated forms expand to more than {limit, number, ::.0} MB.",
    "hint": "Export a drawing with a single carton, without symbols that the carton does not need."
  },
  "pdf.form": {
    "text": "The PDF is a dynamic form (XFA), whose page contains no drawing.",
    "hint": "Print the drawing to a PDF, or send it as DXF."
  },
  "pdf.form-named": {
    "text": "the form {name}",
    "hint": ""
  },
  "pdf.illustrator-only": {
    "text": "The Illustrator file was saved without PDF content, so its page contains no drawing.",
    "hint": "Save the file with the option 'Create PDF Compatible File', or as PDF."
  },
  "pdf.layers-too-deep": {
    "text": "The layers of the PDF are nested more than {limit, number} levels deep.",
    "hint": "Export the drawing again with fewer nested layers."
  },
  "pdf.nested-arrays": {
    "text": "arrays are nested too deeply",
    "hint": ""
  },
  "pdf.no-header": {
    "text": "The file is not a PDF: it does not begin with %PDF.",
    "hint": "Export the drawing again, or send it as DXF."
  },
  "pdf.no-page": {
    "text": "The PDF has no page.",
    "hint": "Export the drawing again, or send it as DXF."
  },
  "pdf.no-such-page": {
    "text": "The PDF has {pages, plural, one {# page} other {# pages}}, but no page {page}.",
    "hint": "Choose one of its pages."
  },
  "pdf.open-array": {
    "text": "an array has no closing bracket",
    "hint": ""
  },
  "pdf.open-image": {
    "text": "an embedded image is incomplete",
    "hint": ""
  },
  "pdf.open-text": {
    "text": "a text string has no closing parenthesis",
    "hint": ""
  },
  "pdf.page": {
    "text": "the page",
    "hint": ""
  },
  "pdf.page-too-large": {
    "text": "A side of the PDF page is {size, number, ::@#####} mm away from the origin of the page coordinates, but the limit is {limit, number, ::@#####} mm.",
    "hint": "Export the drawing in its true size."
  },
  "pdf.part-missing": {
    "text": "A part of the content of the PDF page is missing in the file. Objects of the drawing may be missing.",
    "hint": "Export the drawing again, or send it as DXF."
  },
  "pdf.stream-cut-short": {
    "text": "A data stream of the PDF is incomplete. Objects of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again."
  },
  "pdf.stream-damaged": {
    "text": "A data stream of the PDF is damaged ({reason}). Objects of the drawing may be missing.",
    "hint": "Export the drawing again, or send it as DXF."
  },
  "pdf.stream-too-large": {
    "text": "A data stream of the PDF is larger than {limit, number, ::.0} MB when unpacked.",
    "hint": "Export a single carton, without pictures."
  },
  "pdf.too-many-states": {
    "text": "The PDF saves more than {limit, number} graphics states (operator q) without restoring them.",
    "hint": "Export the drawing again from the program that drew it."
  },
  "plt.bad-number": {
    "text": "The plotter file (HPGL) is damaged at byte {position, number}: the values of the instruction {name} are not all numbers (''{text}'').",
    "hint": "Export the drawing again as HPGL, with a point as the decimal separator of numbers."
  },
  "plt.bad-polyline": {
    "text": "The plotter file (HPGL) is damaged at byte {position, number}: the encoded polyline (PE) cannot be decoded.",
    "hint": "Export the drawing again as HPGL. If the file was sent as text, send it as binary data."
  },
  "plt.bad-scale": {
    "text": "The plotter file (HPGL) is damaged at byte {position, number}: the instruction {name} states a scale of 0, or a type of scale that HPGL does not define.",
    "hint": "Export the drawing again as HPGL."
  },
  "plt.cut-short": {
    "text": "The plotter file (HPGL) is incomplete: the instruction {name} at byte {position, number} has no end. Objects of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again as HPGL."
  },
  "plt.damaged": {
    "text": "The plotter file (HPGL) is damaged at byte {position, number}: ''{text}'' is not an instruction.",
    "hint": "Export the drawing again as HPGL. If the file was sent as text, send it as binary data."
  },
  "plt.empty": {
    "text": "The plotter file (HPGL) contains no drawing: none of its instructions draws a line.",
    "hint": "Send the complete file, or export the drawing again as HPGL."
  },
  "plt.several-scales": {
    "text": "The plotter file (HPGL) draws lines at several scales, and at least one of them depends on the plotter and its paper (SC without IP).",
    "hint": "Export the drawing again as HPGL in plotter units of 1/40 mm, or send it as DXF."
  },
  "plt.wrong-count": {
    "text": "The plotter file (HPGL) is damaged at byte {position, number}: the instruction {name} has {count, plural, one {# value} other {# values}} instead of {expected__or}.",
    "hint": "Export the drawing again as HPGL."
  },
  "plt.x-without-y": {
    "text": "The plotter file (HPGL) is damaged at byte {position, number}: the instruction {name} has {count, plural, one {# value} other {# values}}, so the last point has no y coordinate.",
    "hint": "Export the drawing again as HPGL."
  },
  "process.name-taken": {
    "text": "Another process with the name {name} already uses this database.",
    "hint": "Give each process a different name with --name, or stop the other process."
  },
  "profile.bad-name": {
    "text": "''{name}'' is not a valid profile name.",
    "hint": "Use up to 64 lower-case letters, digits, hyphens and underscores. Write other characters into the title of the profile."
  },
  "profile.exists": {
    "text": "A profile with the name {name} already exists, at version {version}.",
    "hint": "Send If-Match: \"{version}\" to replace this profile, or choose another name."
  },
  "profile.invalid-field": {
    "text": "The profile cannot be read: {fault}.",
    "hint": "See ProfileIn in /api/openapi.json for the expected fields."
  },
  "profile.nested-too-deep": {
    "text": "The tables of the profile ''{name}'' are nested too deeply.",
    "hint": "Write only a title and a list of [[rule]] tables."
  },
  "profile.not-an-extension": {
    "text": "The profile ''{name}'' cannot be saved as an extension of ''{extends}'', because it lacks some rules of ''{extends}''.",
    "hint": "Save the profile without the field extends."
  },
  "profile.not-kept": {
    "text": "The server has no user-defined profile with the name {name}.",
    "hint": "Choose one of the profiles that GET /api/profiles lists."
  },
  "profile.not-toml": {
    "text": "The profile ''{name}'' is not valid TOML: {reason}.",
    "hint": "Correct the TOML syntax at this position."
  },
  "profile.not-utf8": {
    "text": "The file {name} is not UTF-8 text.",
    "hint": "Save the file as UTF-8."
  },
  "profile.not-utf8-byte": {
    "text": "The profile ''{name}'' is not UTF-8 text: byte {byte} is invalid.",
    "hint": "Save the file as UTF-8."
  },
  "profile.shipped": {
    "text": "The profile ''{name}'' is part of knifetip and cannot be changed.",
    "hint": "Save your profile under another name. It can extend ''{name}''."
  },
  "profile.shipped-command": {
    "text": "The profile ''{name}'' is part of knifetip and cannot be changed.",
    "hint": "Choose another name with --name."
  },
  "profile.stale": {
    "text": "Another user has changed the profile {name}: it is now at version {version}, but your change is based on version {given}.",
    "hint": "Load the profile again and check it. Then send your change with If-Match: \"{version}\"."
  },
  "profile.too-long": {
    "text": "The profile ''{name}'' has a size of {size} kB, but the limit is {limit} kB.",
    "hint": "Combine rules of the profile: one rule can list many layers, and * matches any characters."
  },
  "profile.too-many": {
    "text": "The server already has {limit} profiles, which is the largest number allowed.",
    "hint": "Delete a profile that is not used."
  },
  "program.bad-tolerance": {
    "text": "A tolerance of {tolerance, number, ::@##############} mm is too small for the path blending (rounding of corners) of the controller.",
    "hint": "Choose a tolerance of 0.001 mm or more."
  },
  "program.control-byte": {
    "text": "Line {line} of the program contains the byte 0x{byte}, which is a control command that the controller would execute at once.",
    "hint": "Remove the byte, or compile the job again."
  },
  "program.line-too-long": {
    "text": "A program line for row {row} of the toolpath has {length} characters ({line} …), but {dialect} accepts only {limit} characters.",
    "hint": "Check the coordinates of the drawing. They are too large for any table."
  },
  "program.line-too-long-to-send": {
    "text": "Line {line} of the program has {length} bytes, but {name} accepts only {limit} bytes.",
    "hint": "Report the error with the program file."
  },
  "program.no-placement": {
    "text": "{program} does not contain the position of the drawing on the sheet.",
    "hint": "Give the position with --placement X,Y. The report that knifetip program --report writes contains the position."
  },
  "program.not-bytes": {
    "text": "The program is of type {type}, but must be bytes.",
    "hint": "Pass the content of the file as bytes."
  },
  "program.not-fetched": {
    "text": "The program of job {job} could not be loaded from the server ({reason}). Nothing was sent to the machine.",
    "hint": "Queue the job again."
  },
  "program.too-large": {
    "text": "The program has {bytes, number} bytes; the limit is {limit, number}.",
    "hint": "Split the job into several sheets."
  },
  "program.too-many-lines": {
    "text": "The program has {lines, number} lines; the limit is {limit, number}.",
    "hint": "Split the job into several sheets."
  },
  "program.too-many-moves": {
    "text": "The program has {moves, number} moves; the limit is {limit, number}.",
    "hint": "Split the job into several sheets."
  },
  "program.wrong-checksum": {
    "text": "The program of job {job} was damaged during its transfer from the server (SHA-256 {arrived}… instead of {expected}…). Nothing was sent to the machine.",
    "hint": "Queue the job again. If this happens again, compile the job again."
  },
  "question.default-width": {
    "text": "lines of the default width",
    "hint": ""
  },
  "question.follows": {
    "text": "The answer also decides {edges, plural, one {# edge} other {# edges}} on layer \"{layer}\" (colour {colour}, line style {linetype}): {type} if {questions, plural, one {the answer is} other {all # answers about this rule are}} {answer}, and {other_type} if {questions, plural, one {it is} other {they are}} {other_answer}.",
    "hint": ""
  },
  "question.guess": {
    "text": " The most likely line type is {type} ({percent} %): {reason}.",
    "hint": ""
  },
  "question.line-type": {
    "text": "{edges, plural, one {# edge} other {# edges}} on layer \"{layer}\" (colour {colour}, line style {linetype}) {edges, plural, one {has} other {have}} no line type: total length {length, number, ::.0} {unit__unit}, extent {width, number, ::.0} × {height, number, ::.0} {unit__unit}, lower left corner at X {x, number, ::.0}, Y {y, number, ::.0}. Which line type should {edges, plural, one {this edge} other {these edges}} get?{guess}",
    "hint": ""
  },
  "question.line-type-by-width": {
    "text": "{edges, plural, one {# edge} other {# edges}} on layer \"{layer}\" (colour {colour}, line style {linetype}, {lines}) {edges, plural, one {has} other {have}} no line type: total length {length, number, ::.0} {unit__unit}, extent {width, number, ::.0} × {height, number, ::.0} {unit__unit}, lower left corner at X {x, number, ::.0}, Y {y, number, ::.0}. Which line type should {edges, plural, one {this edge} other {these edges}} get?{guess}",
    "hint": ""
  },
  "question.line-width": {
    "text": "lines {width, number, ::@#####} mm wide",
    "hint": ""
  },
  "question.line-width-without-unit": {
    "text": "lines {width, number, ::@#####} wide",
    "hint": ""
  },
  "question.shape": {
    "text": " The drawing shows: {reason}.",
    "hint": ""
  },
  "question.thinnest-lines": {
    "text": "thinnest lines",
    "hint": ""
  },
  "question.tool": {
    "text": "{machine} has no tool for {edges, plural, one {# edge} other {# edges}} of the line type {type}. Which other line type should {edges, plural, one {this edge} other {these edges}} get?",
    "hint": ""
  },
  "question.unit": {
    "text": "{reason} In which unit is the drawing? Its possible sizes are: {sizes}.{evidence}",
    "hint": ""
  },
  "question.unit-contradicted": {
    "text": "The file states the unit {stated__unit}, but the size of the drawing does not match this unit.",
    "hint": ""
  },
  "question.unit-doubtful": {
    "text": "The file states the unit {stated__unit}, but the drawing could also be in {other__unit}.",
    "hint": ""
  },
  "question.unit-evidence": {
    "text": " The strongest evidence for {unit__unit} is: {evidence__semicolon}.",
    "hint": ""
  },
  "question.unit-not-stated": {
    "text": "The file does not state the unit of the drawing.",
    "hint": ""
  },
  "question.unit-size": {
    "text": "{width__mm} × {height__mm} mm if the unit is {unit__unit}",
    "hint": ""
  },
  "question.unit-unreadable": {
    "text": "The unit of the drawing is not known: {evidence}.",
    "hint": "Choose the unit of the drawing."
  },
  "queue.after": {
    "text": " after job {job}",
    "hint": ""
  },
  "queue.before": {
    "text": " before job {job}",
    "hint": ""
  },
  "queue.changed": {
    "text": "The queue of {machine} has changed since it was displayed, so the job was not moved.",
    "hint": "Check the new order of the queue, and move the job again if necessary."
  },
  "queue.claimed": {
    "text": "The machine {machine} has taken job {job} from the queue, so its place and its copies cannot be changed.",
    "hint": "If the job is not confirmed yet, put it on hold: it then returns to the queue."
  },
  "queue.copies-changed": {
    "text": "The operator changed the number of copies from {former} to {copies}.",
    "hint": ""
  },
  "queue.copies-done": {
    "text": "{done, plural, one {# copy} other {# copies}} of job {job} are complete, so the number of copies must be greater.",
    "hint": "Enter a number greater than {done}, or cancel the job."
  },
  "queue.does-not-fit": {
    "text": "Job {job} was not moved to {machine}. {reason}",
    "hint": "{reason__hint}"
  },
  "queue.let-go": {
    "text": "The operator ended the hold of the job in the queue.",
    "hint": ""
  },
  "queue.moved": {
    "text": "The operator moved the job in the queue:{after}{before}.",
    "hint": ""
  },
  "queue.no-neighbour": {
    "text": "Job {job} cannot be moved next to job {neighbour}, which does not wait for {machine}.",
    "hint": "Look at the present queue. Name jobs that wait for the machine and are not claimed."
  },
  "queue.not-waiting": {
    "text": "Job {job} is {state} and does not wait, so it cannot be changed in the queue.",
    "hint": "{advice}"
  },
  "queue.priority-changed": {
    "text": "The priority of the job changed from {former} to {priority}.",
    "hint": ""
  },
  "queue.put-on-hold": {
    "text": "The operator put the job on hold in the queue.",
    "hint": ""
  },
  "queue.transferred": {
    "text": "The operator moved the job from {former} to {machine}. Its program was compiled again.",
    "hint": ""
  },
  "reading.crashed": {
    "text": "The file {name} cannot be read, probably because it is damaged (error {incident}).",
    "hint": "Export the drawing again as DXF, CF2, SVG or PDF, if necessary from another program. The log of the server contains the cause under this number."
  },
  "reading.cut-short": {
    "text": "The {format} file is incomplete: it ends at line {line}, after {count, plural, one {# element} other {# elements}}. Objects of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again."
  },
  "reading.damaged": {
    "text": "The {format} file cannot be read, because it is damaged ({reason}).",
    "hint": "Export the drawing again, if necessary from another program."
  },
  "reading.damaged-at": {
    "text": "The {format} file is damaged at line {line}, column {column}: {reason}.",
    "hint": "Export the drawing again, if necessary from another program."
  },
  "reading.empty": {
    "text": "The file is empty.",
    "hint": "Export the drawing again and send it as {formats__or}. A DXF file may be text or binary, of any version."
  },
  "reading.expands-too-far": {
    "text": "The repeated parts of the {format} file expand to more than {limit, number} elements.",
    "hint": "Export a drawing with a single carton, without repeated parts that the carton does not need."
  },
  "reading.nested-too-deep": {
    "text": "Blocks, symbols or groups of the {format} file are nested more than {limit} levels deep.",
    "hint": "Explode the blocks, symbols or groups in the program that drew the file, and export again."
  },
  "reading.no-pages": {
    "text": "A {format} file has no pages.",
    "hint": "Only a PDF or a PostScript file has pages to choose from."
  },
  "reading.too-large": {
    "text": "The file is {size, number, ::.0} MB large, but the limit is {limit, number, ::.0} MB.",
    "hint": "Export a single carton, without pictures."
  },
  "reading.too-many-elements": {
    "text": "The {format} file has more than {limit, number} elements.",
    "hint": "Export a drawing with a single carton."
  },
  "reading.too-many-entities": {
    "text": "The file has {count, number} entities (drawn objects), but the limit is {limit, number}.",
    "hint": "Export a drawing with a single carton."
  },
  "reading.too-many-segments": {
    "text": "The {format} file has more than {limit, number} lines and curves.",
    "hint": "Export a single carton, without pictures made of lines."
  },
  "reading.too-slow": {
    "text": "Reading the {format} file takes longer than {seconds, number, ::@#####} s.",
    "hint": "Export a single carton without pictures, and convert curves to lines and arcs."
  },
  "reading.truncated": {
    "text": "The {format} file is incomplete, so it cannot be read.",
    "hint": "Send the complete file, or export the drawing again."
  },
  "reading.unexpected": {
    "text": "The {format} file cannot be read, probably because it is damaged. The reader stopped with the error {reason}.",
    "hint": "Export the drawing again, if necessary from another program. If this happens again, report the error with the file."
  },
  "reading.unknown-kind": {
    "text": "The file is {what}, not a drawing of a supported type.",
    "hint": "Send the drawing as {formats__or}. A DXF file may be text or binary, of any version. {what__hint}"
  },
  "request.body-too-large": {
    "text": "The request is larger than {limit} MB, which is the limit for this URL.",
    "hint": "Divide the data into several requests."
  },
  "request.body-unreadable": {
    "text": "The body of the request cannot be read.",
    "hint": "Send JSON or multipart/form-data as /api/openapi.json describes, with the matching Content-Type."
  },
  "request.foreign-origin": {
    "text": "The request was rejected, because a page of another website sent it.",
    "hint": "Send the request from the page of this server, or from a program that is not a browser."
  },
  "request.foreign-page": {
    "text": "The request was rejected, because a page of another website ({origin}) sent it.",
    "hint": "Send the request from the page of this server, or from a program that is not a browser."
  },
  "request.html-form": {
    "text": "The API does not accept data of type {media}.",
    "hint": "Send JSON with Content-Type: application/json."
  },
  "request.invalid": {
    "text": "The request is invalid: {faults__semicolon}.",
    "hint": "{faults__hint} Correct these fields of the request. /api/openapi.json describes all fields."
  },
  "request.key-needed": {
    "text": "This request needs the access key of the server.",
    "hint": "Send the access key in the header Authorization: Bearer KEY, or sign in on the page of the server."
  },
  "request.key-reused": {
    "text": "The Idempotency-Key {key} was already used for a different request.",
    "hint": "Use a new key for each new request."
  },
  "request.local-only": {
    "text": "This server has no access key, so it accepts only requests from its own computer.",
    "hint": "Start the server with --key-file PATH or --key KEY, or open the page of the server at http://localhost on the same computer."
  },
  "request.no-host": {
    "text": "The request does not have exactly one Host header.",
    "hint": "Send one Host header, as HTTP/1.1 requires."
  },
  "request.no-media": {
    "text": "The request has a body but no Content-Type.",
    "hint": "Send the body as {supported__or}, and name it in the header Content-Type."
  },
  "request.not-base64": {
    "text": "The content of the file {name} is not base64.",
    "hint": "Encode the bytes of the file in base64, without line breaks."
  },
  "request.not-marked": {
    "text": "The request lacks the header X-Knifetip, which protects the server against requests from other websites.",
    "hint": "Send the header X-Knifetip with any value."
  },
  "request.not-storable": {
    "text": "The request contains characters or numbers that the database cannot store.",
    "hint": "Remove control characters, and use finite numbers."
  },
  "request.nothing-there": {
    "text": "The URL {path} does not exist on this server.",
    "hint": "Choose a URL that /api/openapi.json describes."
  },
  "request.one-drawing": {
    "text": "An order needs either a file or the id of a stored drawing.",
    "hint": "Send either the file (form part or JSON field file) or the field drawing, not both."
  },
  "request.order-not-tried": {
    "text": "This order was not processed, because an order before it failed. {reason}",
    "hint": "Send the request again with the same Idempotency-Key: orders that are already stored are not created twice."
  },
  "request.outcome-unknown": {
    "text": "An earlier request with this Idempotency-Key was begun, but it is not known whether it was executed.",
    "hint": "Check whether it was executed. If it was not, send the request again with a new key."
  },
  "request.refused": {
    "text": "The request was rejected with the HTTP status {status}.",
    "hint": "Correct the request as /api/openapi.json describes."
  },
  "request.scope-missing": {
    "text": "{principal} lacks the scope {scope}, which this request requires (present: {scopes}).",
    "hint": "Sign in as a user with the role {scope}, or use an API key with this scope."
  },
  "request.secret-not-kept": {
    "text": "A request with this Idempotency-Key was already executed. Its answer contained a secret, which the server does not store, so the answer cannot be repeated: see {path}.",
    "hint": "Get a new secret with POST {path}/rotate-secret."
  },
  "request.unknown-zone": {
    "text": "''{zone}'' is not the name of a time zone.",
    "hint": "Use a name of the IANA time zone database, such as Europe/Berlin or UTC."
  },
  "request.upload-too-large": {
    "text": "The file is larger than {limit} MB, which is the limit of this server.",
    "hint": "Send a smaller file, for example without pictures."
  },
  "request.wrong-host": {
    "text": "This server does not accept requests for the host ''{host}''.",
    "hint": "Use the IP address of the server, or start the server with --allow-host {host}."
  },
  "request.wrong-key": {
    "text": "The access key of the request is wrong.",
    "hint": "Send the key of this server in the header Authorization: Bearer KEY."
  },
  "request.wrong-media": {
    "text": "The content type {media} is not supported here.",
    "hint": "Send the body as {supported__or}, and name it in the header Content-Type."
  },
  "request.wrong-method": {
    "text": "The method {method} is not supported at {path}.",
    "hint": "Choose a method that /api/openapi.json describes for this URL."
  },
  "rest.bound-to-sheet": {
    "text": "Job {job} completes the sheet that lies on the machine {machine}, so its machine and its number of copies cannot be changed.",
    "hint": "Order one more copy of the whole job. It can have another machine and number of copies."
  },
  "rest.continue-first": {
    "text": "{interruption}",
    "hint": "Continue this sheet, {tracks} left. {interruption__hint}"
  },
  "rest.continued-already": {
    "text": "Job {other} already continues the sheet of job {job}.",
    "hint": "Continue that job instead, or cancel it before it begins."
  },
  "rest.continued-by": {
    "text": "Job {job} continues the work of this job.",
    "hint": ""
  },
  "rest.continues": {
    "text": "The job was created to make the rest of the sheet of job {job}.",
    "hint": ""
  },
  "rest.copy-of": {
    "text": "The job was created to make the whole program of job {job} again.",
    "hint": ""
  },
  "rest.line-changed": {
    "text": "The machine has meanwhile reported that it executed {line} program lines of job {job}.",
    "hint": "Look at the tracks again and choose where to continue."
  },
  "rest.no-copies": {
    "text": "No copy of job {job} remains to be ordered. It was ordered with {copies} copies.",
    "hint": "Make one more copy of the whole job if you need more."
  },
  "rest.no-such-station": {
    "text": "The program has no tracks of station {station}.",
    "hint": "Choose one of the stations that the list of tracks contains."
  },
  "rest.no-such-track": {
    "text": "The program has no track (uninterrupted run of a tool) with the number {track}. It has {count} tracks.",
    "hint": "Choose a track from the list of tracks."
  },
  "rest.no-tracks": {
    "text": "No track remains to be made after the chosen place.",
    "hint": "Choose an earlier place, or mark the job finished if the sheet is complete."
  },
  "rest.not-again": {
    "text": "Job {job} makes the rest of a sheet, so it cannot be queued again from its first line.",
    "hint": "Continue it from a track, or make one more copy of the whole program."
  },
  "rest.not-executed": {
    "text": "{count} tracks would be left out, although the machine reported only {executed} executed program lines. The first of them is track {track}, of station {station}.",
    "hint": "Continue from an earlier track. If these tracks are complete on the sheet, confirm that the skipped tracks are made."
  },
  "rest.old-program": {
    "text": "The program was made by an older version of knifetip, which did not store the tracks of a program.",
    "hint": "Make one more copy of the whole job."
  },
  "rest.ordered": {
    "text": "Job {job} was created to make the rest of the sheet.",
    "hint": ""
  },
  "rest.sheet-first": {
    "text": "Job {job} is interrupted, and its sheet occupies the table.",
    "hint": "Make the rest of the sheet first, or scrap the job. Then order the remaining copies."
  },
  "rest.statement-needed": {
    "text": "The machine executed {executed} program lines of job {job} for certain, and possibly more, up to line {most}. It is not known how much of {tracks, plural, one {# track} other {# tracks}} is made; the first of them is track {track}.",
    "hint": "Look at the sheet, and state the numbers of all tracks that are completely made (made). The new job makes all others."
  },
  "rest.tracks": {
    "text": "{count, plural, one {# track} other {# tracks}}",
    "hint": ""
  },
  "rest.tracks-between": {
    "text": "{least} to {most, plural, one {# track} other {# tracks}}",
    "hint": ""
  },
  "rest.whole-ordered": {
    "text": "Job {job} was created to make the whole program again.",
    "hint": ""
  },
  "rest.wrong-state": {
    "text": "Job {job} is {state}, so no other job can continue its work.",
    "hint": "{advice}"
  },
  "rs274.active-comment": {
    "text": "LinuxCNC executes the comment in the program line.",
    "hint": "Remove the comma from the comment, or delete the comment."
  },
  "rs274.after-end": {
    "text": "The program line comes after the end of the program (M2 or M30).",
    "hint": "Delete the program line."
  },
  "rs274.arc-of-other-carriage": {
    "text": "The program line has an arc (G2 or G3) while a station of a further carriage is selected. Controllers make arcs only with X and Y, which move the first carriage.",
    "hint": "Replace the arc by short lines (G1) with the letters of the axes of the carriage."
  },
  "rs274.arc-on-chord-machine": {
    "text": "The program line is an arc (G2, G3), and the controller of {machine} cannot follow arcs.",
    "hint": "Create the program again, or set arcs to 'arcs' in the machine file if the controller has them and turns the tool in them."
  },
  "rs274.axis-without-motion": {
    "text": "The program line has coordinates, but no motion word (G0, G1, G2 or G3).",
    "hint": "Add G0, G1, G2 or G3."
  },
  "rs274.bad-arc": {
    "text": "In the program line, the distance from the centre of the arc to the start of the arc differs by more than {limit, number, ::@#####} mm from the distance from the centre to the end of the arc.",
    "hint": "Correct the centre (I, J) or the end (X, Y) of the arc."
  },
  "rs274.bad-character": {
    "text": "The character ''{character}'' is not allowed at this position of the program line.",
    "hint": "Remove the character."
  },
  "rs274.bad-feed": {
    "text": "The feed (F) in the program line is 0 or negative.",
    "hint": "Give a feed greater than 0."
  },
  "rs274.bad-line-number": {
    "text": "The program line number (N) in the program line is negative, not an integer, or not at the start of the line.",
    "hint": "Correct or delete the line number."
  },
  "rs274.centre-without-arc": {
    "text": "The program line has the centre of an arc (I, J), but no arc motion (G2 or G3).",
    "hint": "Add G2 or G3, or delete I and J."
  },
  "rs274.change-without-station": {
    "text": "The program line changes the tool (M6), but no station (T) was selected before.",
    "hint": "Write the T word of the station before M6."
  },
  "rs274.control-byte": {
    "text": "The program line contains the byte {byte}, a control command that the controller would execute at once, even in a comment.",
    "hint": "Remove the byte."
  },
  "rs274.ends-lowered": {
    "text": "The program ends while a station is lowered.",
    "hint": "Raise the station (M65) and lift the head before the end of the program."
  },
  "rs274.ends-oscillating": {
    "text": "The program ends while a tool oscillates or rotates.",
    "hint": "Switch the tool off (M5) before the end of the program."
  },
  "rs274.ends-output-on": {
    "text": "The program ends while an output is on.",
    "hint": "Switch the output off (M65) before the end of the program."
  },
  "rs274.ends-with-offset": {
    "text": "The program ends while the offset of a station is active.",
    "hint": "Cancel the offset (G49) before the end of the program."
  },
  "rs274.g64-unsupported": {
    "text": "The program line contains G64, which the controller of this machine does not support.",
    "hint": "Remove G64."
  },
  "rs274.incomplete-arc": {
    "text": "The arc in the program line lacks X, Y, I or J.",
    "hint": "Give X, Y, I and J."
  },
  "rs274.letter-without-number": {
    "text": "The letter {letter} in the program line is not followed by a number.",
    "hint": "Add the number or delete the letter."
  },
  "rs274.line-too-long": {
    "text": "The program line is longer than {limit} characters, the limit of the controller.",
    "hint": "Shorten the line."
  },
  "rs274.missing-p": {
    "text": "A command in the program line needs a P word, but the line has none.",
    "hint": "Add the P word."
  },
  "rs274.mode-g17": {
    "text": "the XY plane (G17)",
    "hint": ""
  },
  "rs274.mode-g21": {
    "text": "the unit millimetre (G21)",
    "hint": ""
  },
  "rs274.mode-g40": {
    "text": "radius compensation off (G40)",
    "hint": ""
  },
  "rs274.mode-g49": {
    "text": "tool length compensation off (G49)",
    "hint": ""
  },
  "rs274.mode-g54": {
    "text": "the work coordinate system (G54)",
    "hint": ""
  },
  "rs274.mode-g90": {
    "text": "absolute coordinates (G90)",
    "hint": ""
  },
  "rs274.mode-g91-1": {
    "text": "arc centres relative to the start of the arc (G91.1)",
    "hint": ""
  },
  "rs274.mode-g92-1": {
    "text": "no shift of the coordinates (G92.1)",
    "hint": ""
  },
  "rs274.mode-g94": {
    "text": "the feed in mm/min (G94)",
    "hint": ""
  },
  "rs274.motion-without-axis": {
    "text": "The program line has a motion word (G0 to G3), but no coordinates.",
    "hint": "Add the coordinates or delete the motion word."
  },
  "rs274.moves-and-switches": {
    "text": "The program line moves the head and switches an output or the spindle at the same time.",
    "hint": "Write the move and the switching command in separate program lines."
  },
  "rs274.moves-other-carriage": {
    "text": "The feed line moves an axis of another carriage than that of the selected station.",
    "hint": "Move other carriages only in rapids (G0), or select a station of the other carriage."
  },
  "rs274.moves-unstated": {
    "text": "The program line moves the head before the program has set {mode}.",
    "hint": "Set this mode at the beginning of the program."
  },
  "rs274.nested-comment": {
    "text": "In the program line, a comment begins inside another comment.",
    "hint": "Close the first comment before the second comment begins."
  },
  "rs274.no-end": {
    "text": "The program has no end (M2 or M30).",
    "hint": "Add M2 as the last line of the program."
  },
  "rs274.no-feed": {
    "text": "The program line cuts, but no feed (F) has been set since the feed mode (G93 or G94) was chosen.",
    "hint": "Add an F word."
  },
  "rs274.not-settled": {
    "text": "The program line moves the head too soon after an output or the spindle was switched.",
    "hint": "Add a dwell (G4) before this program line."
  },
  "rs274.number-too-large": {
    "text": "A number in the program line is larger than 1,000,000.",
    "hint": "Correct the number."
  },
  "rs274.offset-without-station": {
    "text": "The program line applies the offset of a station (G43), but no station (T) was selected before.",
    "hint": "Write the T word of the station before G43."
  },
  "rs274.open-comment": {
    "text": "A comment in the program line is not closed.",
    "hint": "Close the comment with a closing parenthesis in the same program line."
  },
  "rs274.repeated-word": {
    "text": "The program line has two words that set the same value.",
    "hint": "Delete one of the two words."
  },
  "rs274.speed-without-m3": {
    "text": "The program line has a spindle speed (S), but neither M3 nor M4.",
    "hint": "Add M3 or M4, or delete the speed."
  },
  "rs274.spindle-of-other-station": {
    "text": "The station moves while the spindle or oscillation of another station is on.",
    "hint": "Switch it off (M5) before the station is changed."
  },
  "rs274.stray-p": {
    "text": "The P word belongs to no command of the program line, or to more than one command.",
    "hint": "Delete the P word, or write the commands into separate program lines."
  },
  "rs274.stray-q": {
    "text": "The Q word belongs to no command of the program line.",
    "hint": "Delete the Q word."
  },
  "rs274.switches-while-moving": {
    "text": "The program line switches an output while the head may still be moving: the controller switches outputs (M64, M65) as soon as it reads them.",
    "hint": "Add a dwell (G4 P0) after the last move and before this program line."
  },
  "rs274.timed-without-f": {
    "text": "The program line moves in inverse time mode (G93), but has no F word.",
    "hint": "Add the F word."
  },
  "rs274.too-many-digits": {
    "text": "A number in the program line has more than 15 digits.",
    "hint": "Round the number."
  },
  "rs274.unbounded-rounding": {
    "text": "The program line cuts, but the program does not limit by how much the controller may round corners.",
    "hint": "Set the limit with G64 P before this program line."
  },
  "rs274.unknown-letter": {
    "text": "The letter {letter} in the program line is not supported.",
    "hint": "Remove the letter and its number."
  },
  "rs274.unknown-output": {
    "text": "The program line switches an output that {machine} does not have.",
    "hint": "Choose an output that is defined in the machine file."
  },
  "rs274.unknown-station": {
    "text": "The program line selects a station (T) that {machine} does not have.",
    "hint": "Choose a station that is defined in the machine file."
  },
  "rs274.unknown-word": {
    "text": "The word {word} in the program line is not supported.",
    "hint": "Remove the word."
  },
  "rs274.wrong-direction": {
    "text": "The program line switches the spindle on in the wrong direction for the station.",
    "hint": "Use the word that the machine states for the station: M3 or M4."
  },
  "rs274.wrong-dwell": {
    "text": "The dwell (G4) in the program line is shorter than the {settle, number, ::@#####} s that the machine needs after switching.",
    "hint": "Make the dwell {settle, number, ::@#####} s or longer."
  },
  "rs274.wrong-speed": {
    "text": "The spindle speed (S) at M3 or M4 differs from the speed of the station in the machine file.",
    "hint": "Correct the speed, or compile the job again."
  },
  "rule.block": {
    "text": "inside the block {patterns__or}",
    "hint": ""
  },
  "rule.colour": {
    "text": "colour {colours__or}",
    "hint": ""
  },
  "rule.conditions": {
    "text": "{conditions}",
    "hint": ""
  },
  "rule.entity": {
    "text": "object type {kinds__or}",
    "hint": ""
  },
  "rule.everything": {
    "text": "every edge of the drawing",
    "hint": ""
  },
  "rule.layer": {
    "text": "layer {patterns__or}",
    "hint": ""
  },
  "rule.linetype": {
    "text": "line style {patterns__or}",
    "hint": ""
  },
  "run.executed": {
    "text": "{executed} of {lines} program lines were executed.",
    "hint": ""
  },
  "run.in-buffer": {
    "text": "{executed} of {lines} program lines were executed. Up to {rest} more program lines, which were in the buffer of the controller, may also have been executed.",
    "hint": ""
  },
  "run.nothing-sent": {
    "text": "No program line was executed.",
    "hint": ""
  },
  "segment.not-finite": {
    "text": "Segment {segment} of the path has a coordinate, or a bulge (curvature of an arc), that is not a number.",
    "hint": "Draw this segment of the path again."
  },
  "server.address-in-use": {
    "text": "The server cannot use the address {host}:{port}: {reason}.",
    "hint": "Stop the program that uses the port, or choose another port with --port."
  },
  "server.answered": {
    "text": "The request to {url} failed with the HTTP status {status}.",
    "hint": "Check the address. The log of the server contains the cause."
  },
  "server.bad-metrics-address": {
    "text": "''{address}'' is not a valid value of --metrics-address.",
    "hint": "Write it as HOST:PORT, such as 127.0.0.1:9464 or [::1]:9464."
  },
  "server.busy": {
    "text": "The server is busy: {waiting, plural, one {# request is} other {# requests are}} already waiting, so this request was not started.",
    "hint": "Send the request again in {seconds} s."
  },
  "server.database-damaged": {
    "text": "The database of the server is damaged.",
    "hint": "Stop the server and put a backup in its place: knifetip restore FILE --replace. Check the disk. Trying again does not help."
  },
  "server.database-silent": {
    "text": "The database of the server does not respond.",
    "hint": "Try again in a moment. If this happens again, check the database."
  },
  "server.internal-error": {
    "text": "Internal error of the server. Nothing was cut.",
    "hint": "Report the error with the log of the server."
  },
  "server.machine-taken": {
    "text": "Another server ({holder}) already runs the simulated machine {machine} of this database.",
    "hint": "Stop that server, use another --database, or start this server with --no-simulator."
  },
  "server.not-started": {
    "text": "The server could not start with the database {database}.",
    "hint": "Correct the cause, which the lines above this message state."
  },
  "server.stopping": {
    "text": "The server is shutting down and accepts no new requests.",
    "hint": "Try again in a moment."
  },
  "server.unreachable": {
    "text": "The server {server} cannot be reached: {reason}.",
    "hint": "Check the address in --server and the network connection."
  },
  "setting.difference": {
    "text": "{setting} is {found}, expected {expected}: {reason}.",
    "hint": "Set {assignment} at the controller, or correct the machine file."
  },
  "setting.faster": {
    "text": "the controller moves the axis faster than the machine file permits",
    "hint": ""
  },
  "setting.homes-at-other-end": {
    "text": "the controller sets its zero at the homing switch, but in the machine file the zero is at the other end of the axis",
    "hint": ""
  },
  "setting.inches": {
    "text": "positions are reported in inches and would be taken as millimetres",
    "hint": ""
  },
  "setting.laser-mode": {
    "text": "laser mode is on, but the machine file has no laser",
    "hint": ""
  },
  "setting.laser-mode-stops-spindle": {
    "text": "in laser mode the controller switches the spindle off in rapid moves, so tools would enter the board at rest",
    "hint": ""
  },
  "setting.no-buffer-state": {
    "text": "status reports do not contain the state of the buffers, so lost responses are noticed late",
    "hint": ""
  },
  "setting.no-hard-limits": {
    "text": "limit switches do not stop the machine",
    "hint": ""
  },
  "setting.no-homing": {
    "text": "the controller does not home, so it does not know its position after it was switched on",
    "hint": ""
  },
  "setting.no-laser-mode": {
    "text": "the controller is not in laser mode, so the laser beam would stay on during a feed hold",
    "hint": ""
  },
  "setting.no-rate": {
    "text": "the highest speed of the axis is 0, so the axis cannot move",
    "hint": ""
  },
  "setting.no-soft-limits": {
    "text": "the controller does not refuse moves beyond its travel",
    "hint": ""
  },
  "setting.no-steps": {
    "text": "the number of steps per millimetre or degree of the axis is 0, so the axis cannot move",
    "hint": ""
  },
  "setting.no-work-offset": {
    "text": "positions are reported without the offset of the work zero, so the gateway does not know where the tool is",
    "hint": ""
  },
  "setting.rotary-axes": {
    "text": "the controller takes the angle of a rotary axis as a length, or a length as an angle",
    "hint": ""
  },
  "setting.short-travel": {
    "text": "the travel is shorter than in the machine file, so the controller refuses jobs near the ends",
    "hint": ""
  },
  "setting.slower": {
    "text": "the controller moves the axis more slowly than the machine file states, so jobs take longer than stated",
    "hint": ""
  },
  "setting.spindle-limit": {
    "text": "the highest speed or power of the controller is lower than a station needs, so its tool would run more slowly or with less power",
    "hint": ""
  },
  "setting.unit-of-angle": {
    "text": "the unit of angles of the controller is not the degree",
    "hint": ""
  },
  "setting.unit-of-length": {
    "text": "the unit of length of the controller is not the millimetre, so positions would be taken wrongly",
    "hint": ""
  },
  "setting.z-homes-down": {
    "text": "homing would drive the tool down into the board",
    "hint": ""
  },
  "settings.bad-file": {
    "text": "The settings file {file} cannot be used: {reason}.",
    "hint": "Correct the file, or start the server without it."
  },
  "settings.bad-host": {
    "text": "''{host}'' is not a host name.",
    "hint": "Write the host as NAME or NAME:PORT."
  },
  "settings.bad-key": {
    "text": "{what} has {length} characters, but must have {shortest} to 200 ASCII characters without spaces.",
    "hint": "Choose another key, or let --key-file PATH generate one."
  },
  "settings.invalid": {
    "text": "The settings cannot be used: {faults__semicolon}.",
    "hint": "{faults__hint} The page Settings of the documentation lists all settings."
  },
  "settings.key-file": {
    "text": "The key file {file} cannot be used: {reason}.",
    "hint": "Choose a file that the server can read and write."
  },
  "settings.two-keys": {
    "text": "The server was started with both --key and --key-file.",
    "hint": "Give only one of the two options."
  },
  "sheet.bad-size": {
    "text": "''{text}'' is not a size of a sheet.",
    "hint": "Give the width and the height in mm as WIDTHxHEIGHT, with the distance of the drawing from the left and lower edge as WIDTHxHEIGHT:MARGIN, or outline for a sheet that was cut to the outline of the drawing."
  },
  "sheet.off-table": {
    "text": "The sheet would lie from X {x, number, ::.0}, Y {y, number, ::.0} to X {right, number, ::.0}, Y {top, number, ::.0} mm, but the table of {machine} reaches from 0 to {width, number, ::precision-integer} × {height, number, ::precision-integer} mm.",
    "hint": "Choose a smaller margin or sheet, or correct the origin in the machine file."
  },
  "sheet.smaller-than-drawing": {
    "text": "The sheet of {width, number, ::.0} × {height, number, ::.0} mm is too small: with its margin of {margin, number, ::.0} mm the drawing needs {needed_x, number, ::.0} × {needed_y, number, ::.0} mm.",
    "hint": "Enter the size and the margin of the sheet on the table, or check the unit of the drawing."
  },
  "sheet.without-outline": {
    "text": "The cuts of the drawing form no closed outline around all of its other lines, so the outline of the sheet is not known.",
    "hint": "Enter the width and the height of the sheet, or close the outline of the drawing."
  },
  "sign-in.slow-down": {
    "text": "Too many attempts to sign in failed.",
    "hint": "Wait {seconds} s, then try again."
  },
  "sign-in.wrong": {
    "text": "The name or the password is wrong.",
    "hint": "Check both. An administrator can set a new password."
  },
  "sign-in.wrong-code": {
    "text": "This pairing code is wrong, has expired or was already used.",
    "hint": "Ask an administrator for a new code. Each code is for one device and expires after ten minutes."
  },
  "start.at-corner": {
    "text": "The start chosen on edge {edge} is {distance, number, ::.00} mm from an end of the edge, but the cutter needs {least, number, ::.00} mm to enter beside it.",
    "hint": "Choose a point farther from both ends of the edge, or another edge of the contour."
  },
  "start.bridged": {
    "text": "A start or a direction was chosen for edge {edge}, but its contour has bridges, which divide it into several cuts.",
    "hint": "Remove the choice, or choose a board without bridges."
  },
  "start.conflict": {
    "text": "Two starts or two directions were chosen for the contour of edge {edge} and edge {other}.",
    "hint": "Remove one of the two choices."
  },
  "start.fixed-direction": {
    "text": "Edge {edge} cannot be cut in the chosen direction: the tool of station {station} must have the waste on its left.",
    "hint": "Choose the other direction, or leave the direction free."
  },
  "start.not-last": {
    "text": "The cut cannot begin on edge {edge}, because it also ends there, and an edge that is cut later must release the part.",
    "hint": "Choose an edge of the contour at which the part touches only waste."
  },
  "start.open": {
    "text": "A start or a direction was chosen for edge {edge}, but this edge belongs to no closed cut or half-cut.",
    "hint": "Remove the choice, or choose an edge of a closed contour."
  },
  "store.no-column": {
    "text": "The {kind} {id} has no {column} yet.",
    "hint": "Wait until the {kind} is compiled. If the compilation failed, the fields state and reason of the {kind} show why."
  },
  "store.unknown": {
    "text": "The {kind} {id} does not exist.",
    "hint": "Choose an id that GET /api/{kind}s lists."
  },
  "stored.text": {
    "text": "{text}",
    "hint": "{hint}"
  },
  "svg.empty": {
    "text": "The SVG file contains no element.",
    "hint": "Export the drawing again as plain SVG."
  },
  "svg.external-entity": {
    "text": "The DOCTYPE of the SVG has an entity ''{name}'' that refers to another file, which is not loaded.",
    "hint": "Save the drawing as plain SVG, without a DOCTYPE."
  },
  "svg.long-entity": {
    "text": "The DOCTYPE of the SVG has an entity ''{name}'' of {length, number} characters, which is too long.",
    "hint": "Save the drawing as plain SVG, without a DOCTYPE."
  },
  "svg.markup-entity": {
    "text": "The DOCTYPE of the SVG has an entity ''{name}'' that contains markup, which is not supported.",
    "hint": "Save the drawing as plain SVG, without a DOCTYPE."
  },
  "svg.other-xml": {
    "text": "The file is an XML file, but not SVG: its outermost element is {element} instead of svg.",
    "hint": "Save the drawing as plain SVG."
  },
  "svg.packed-cut-short": {
    "text": "The compressed SVG file (.svgz) is incomplete.",
    "hint": "Send the complete file, or export the drawing again as plain SVG."
  },
  "svg.packed-damaged": {
    "text": "The compressed SVG file (.svgz) is damaged: {reason}.",
    "hint": "Export the drawing again as plain SVG."
  },
  "svg.too-many-rules": {
    "text": "The style sheet of the SVG file has {count, number} rules, but the limit is {limit, number}.",
    "hint": "Export the drawing with style attributes in each element instead of a style sheet."
  },
  "svg.unpacks-too-far": {
    "text": "The compressed SVG file (.svgz) is larger than {limit, number, ::.0} MB when unpacked.",
    "hint": "Export a drawing with a single carton, without pictures."
  },
  "tool-check.in-zone": {
    "text": "The point lies in the keep-out zone {zone}, or so near that the tool would touch it. Nothing has moved.",
    "hint": "Choose another point."
  },
  "tool-check.large-shift": {
    "text": "In a tool check, a station can be corrected by at most {largest, number, ::@#####} mm or degrees.",
    "hint": "Measure the datum of the station again, and change it in the machine file."
  },
  "tool-check.not-lowered": {
    "text": "The tool is above the point, but was not lowered: Z would have to move to {target, number, ::.0}, and its travel ends at {lowest, number, ::@#####}.",
    "hint": "Check the tool from above. If the tool must go lower, correct the Z of the station in the machine file."
  },
  "tool-check.not-lowered-beam": {
    "text": "The laser is above the point, but was not lowered or switched on.",
    "hint": "Check its position with the pointer of the laser, if it has one."
  },
  "tool-check.not-reached": {
    "text": "Z did not come to rest at {target, number, ::.0} in time, so the tool was lifted again.",
    "hint": "Check the machine, then try again."
  },
  "tool-life.near": {
    "text": "The tool {name} in station {station} has worked along {used, number, ::precision-integer} m of lines, {percent, number, ::precision-integer} % of its life of {life, number, ::precision-integer} m.",
    "hint": "Have a new tool ready. Record the change of the tool on the page of the machine."
  },
  "tool-life.no-station": {
    "text": "The machine {machine} has no station {station}.",
    "hint": "Use the number of a station from the list of the tools of the machine."
  },
  "tool-life.over": {
    "text": "The tool {name} in station {station} has worked along {used, number, ::precision-integer} m of lines, {percent, number, ::precision-integer} % of its life of {life, number, ::precision-integer} m.",
    "hint": "Change the tool and record the change, or check the tool and state why it stays in use when you confirm the job."
  },
  "tool.bad-radius": {
    "text": "The tool radius for a corner of a contour is negative or not a number.",
    "hint": "Correct the radius of the tool in the machine file."
  },
  "tool.cannot-work": {
    "text": "Station {station} ({name}) of {machine} cannot be used: {reason}",
    "hint": "Correct the settings of the tool in the machine file."
  },
  "tool.free-without-trail": {
    "text": "the knife is set to turn freely (free), but its tip lies on its axis (trail is 0), so moves would not turn it",
    "hint": ""
  },
  "tool.missing": {
    "text": "{machine} has no tool for {count, plural, one {# edge} other {# edges}} of type {type}.",
    "hint": "Choose another line type for the edges, or another machine."
  },
  "tool.shallow-lead": {
    "text": "the lead-in of {lead, number, ::@#####} mm at an angle of {angle, number, ::@#####}° begins nearer to the contour than the tool radius of {radius, number, ::@#####} mm; the angle must be between {least, number, ::.0}° and 90°, or negative for a lead-in round a corner",
    "hint": ""
  },
  "tool.short-lead": {
    "text": "the lead-in of {lead, number, ::@#####} mm must be 0 or greater than the tool radius of {radius, number, ::@#####} mm",
    "hint": ""
  },
  "tool.swivel-of-driven-knife": {
    "text": "`swivel_depth` or `park_heading` is set, but these are only for knives that turn freely (free), and an axis of the machine turns this knife",
    "hint": ""
  },
  "tool.tilted": {
    "text": "The tool is tilted by {tilt, number, ::.00}°, but only tools tilted by up to {limit, number, ::@#####}° can be lifted along their axis.",
    "hint": "Choose a tool that is tilted by at most {limit, number, ::@#####}°."
  },
  "tool.without-power": {
    "text": "The power of the laser is 0.",
    "hint": "Set the power of the laser in the machine file."
  },
  "tool.without-speed": {
    "text": "The spindle speed of the cutter is 0.",
    "hint": "Set the spindle speed of the cutter in the machine file."
  },
  "toolpath.arc-too-long": {
    "text": "Internal error: {place} is an arc of more than 180°: {move}.",
    "hint": "Report the error with the drawing."
  },
  "toolpath.empty": {
    "text": "The toolpath has no moves, so nothing would be cut.",
    "hint": "Give at least one edge a line type for which the machine has a tool."
  },
  "toolpath.feed-too-fast": {
    "text": "{place} has a feed that is too fast for any machine: {move}.",
    "hint": "Correct the feed of the tool in the machine file."
  },
  "toolpath.move": {
    "text": "from ({start}) to ({end}), bulge {bulge}, feed {feed}",
    "hint": ""
  },
  "toolpath.no-approach": {
    "text": "Internal error: {place} starts a cut with station {station}, but no rapid move to the start of the cut precedes it.",
    "hint": "Report the error with the drawing."
  },
  "toolpath.no-feed": {
    "text": "{place} has no feed: {move}.",
    "hint": "Set the feed of the tool in the machine file."
  },
  "toolpath.not-finite": {
    "text": "Internal error: {place} has a value that is not a number: {move}.",
    "hint": "Report the error with the drawing."
  },
  "toolpath.rapid-arc": {
    "text": "Internal error: {place} is a rapid move along an arc: {move}.",
    "hint": "Report the error with the drawing."
  },
  "toolpath.row": {
    "text": "Row {row} of the toolpath ({motion})",
    "hint": ""
  },
  "toolpath.row-of-edge": {
    "text": "Row {row} of the toolpath ({motion}, edge {edge})",
    "hint": ""
  },
  "toolpath.swivel-without-turn": {
    "text": "Internal error: row {row} of the toolpath moves the head about the tip of the tool without rotating the tool, so the feed in degrees per minute is not defined.",
    "hint": "Report the error with the drawing."
  },
  "toolpath.too-far": {
    "text": "{place} is more than {limit, number, ::@#####} mm away from the origin: {move}.",
    "hint": "Check the unit of the drawing."
  },
  "toolpath.unknown-motion": {
    "text": "Internal error: {place} has an unknown motion type: {move}.",
    "hint": "Report the error with the drawing."
  },
  "toolpath.unknown-station": {
    "text": "{place} uses station {station}, which {machine} does not have.",
    "hint": "Choose one of the stations {known}."
  },
  "track.too-flat": {
    "text": "At the edge of the board, the direction of path {track} of the tool deviates by {angle, number, ::.00}° from the perpendicular to this edge, but a deviation of at most {limit, number, ::@#####}° is allowed.",
    "hint": "End the line inside the board, or let the line cross the edge of the board closer to a right angle."
  },
  "travel.above": {
    "text": "{tool} (station {station}) would move {excess, number, ::.00}{unit} beyond the upper end of the travel of axis {axis}{place}. The travel is {low, number, ::@#####} to {high, number, ::@#####}{unit}.",
    "hint": "For axis X, Y or C, move or rotate the drawing on the table, or choose a larger machine. For axis Z, check the heights in the machine file."
  },
  "travel.below": {
    "text": "{tool} (station {station}) would move {excess, number, ::.00}{unit} beyond the lower end of the travel of axis {axis}{place}. The travel is {low, number, ::@#####} to {high, number, ::@#####}{unit}.",
    "hint": "For axis X, Y or C, move or rotate the drawing on the table, or choose a larger machine. For axis Z, check the heights in the machine file."
  },
  "travel.heads-too-near": {
    "text": "{tool} (station {station}) would come as near as {distance, number, ::.00} mm to the parked carriage {other}{place}. Carriages must stay at least {least, number, ::@#####} mm apart.",
    "hint": "Move the drawing along Y, away from the parked carriage, or give the line type to a tool on the other carriage."
  },
  "unit.cf2-inches": {
    "text": "the CF2 file states inches (record UI)",
    "hint": ""
  },
  "unit.cf2-millimetres": {
    "text": "the CF2 file states millimetres (record UM)",
    "hint": ""
  },
  "unit.cf2-none": {
    "text": "the CF2 file states no unit: it has neither a UM nor a UI record",
    "hint": ""
  },
  "unit.cf2-scale-applied": {
    "text": "the coordinates in the CF2 file were multiplied by the factors in the record SCALE,{x, number, ::@#####},{y, number, ::@#####}, so that the drawing has the size in the records LL and UR",
    "hint": ""
  },
  "unit.cf2-scale-invalid": {
    "text": "the factors in the record SCALE,{x, number, ::@#####},{y, number, ::@#####} of the CF2 file are invalid, so the record was ignored",
    "hint": ""
  },
  "unit.cf2-scale-not-applied": {
    "text": "the record SCALE,{x, number, ::@#####},{y, number, ::@#####} of the CF2 file was ignored, because the coordinates already have the size in the records LL and UR",
    "hint": ""
  },
  "unit.cf2-scale-undecided": {
    "text": "the record SCALE,{x, number, ::@#####},{y, number, ::@#####} of the CF2 file was ignored, because the records LL and UR do not show whether the coordinates are already scaled",
    "hint": ""
  },
  "unit.cf2-scaled": {
    "text": "{unit}; {scale}",
    "hint": ""
  },
  "unit.corner-loops": {
    "text": "if the unit is {unit__unit}, the outlines have small loops of {length__mm} mm at {count} corners, as programs for laser cutters draw them",
    "hint": ""
  },
  "unit.dimensions-larger": {
    "text": "Dimensions in the drawing have different scales: {count, plural, one {# dimension is} other {# dimensions are}} drawn {factor, number, ::@##} times larger than the other {others, plural, one {dimension} other {# dimensions}}.",
    "hint": "Check which dimensions belong to the carton, and delete details that are drawn at another scale."
  },
  "unit.dimensions-smaller": {
    "text": "Dimensions in the drawing have different scales: {count, plural, one {# dimension is} other {# dimensions are}} drawn {factor, number, ::@##} times smaller than the other {others, plural, one {dimension} other {# dimensions}}.",
    "hint": "Check which dimensions belong to the carton, and delete details that are drawn at another scale."
  },
  "unit.drawn-in-imperial": {
    "text": "inches (stored as numbers in {unit__unit})",
    "hint": ""
  },
  "unit.drawn-in-inches": {
    "text": "inches",
    "hint": ""
  },
  "unit.drawn-in-metric": {
    "text": "millimetres (stored as numbers in {unit__unit})",
    "hint": ""
  },
  "unit.drawn-in-millimetres": {
    "text": "millimetres",
    "hint": ""
  },
  "unit.given": {
    "text": "the user set the unit of the drawing",
    "hint": ""
  },
  "unit.header": {
    "text": "the header of the DXF file states the unit of the drawing ($INSUNITS = {value})",
    "hint": ""
  },
  "unit.header-decimal-inches": {
    "text": "the header of the DXF file displays lengths in feet and decimal inches ($LUNITS = 3)",
    "hint": ""
  },
  "unit.header-factor": {
    "text": "the header of the DXF file multiplies the displayed dimensions by {factor, number, ::@#####} ({variable})",
    "hint": ""
  },
  "unit.header-fractions": {
    "text": "the header of the DXF file displays lengths in feet and fractions of inches ($LUNITS = 4)",
    "hint": ""
  },
  "unit.header-imperial": {
    "text": "the header of the DXF file sets imperial units ($MEASUREMENT = 0)",
    "hint": ""
  },
  "unit.header-metric": {
    "text": "the header of the DXF file sets metric units ($MEASUREMENT = 1)",
    "hint": ""
  },
  "unit.header-missing": {
    "text": "the DXF file states no unit ($INSUNITS is missing)",
    "hint": ""
  },
  "unit.header-not-a-number": {
    "text": "the header of the DXF file states no valid unit: $INSUNITS = ''{value}'' is not a number",
    "hint": ""
  },
  "unit.header-undefined": {
    "text": "the header of the DXF file states no valid unit: $INSUNITS = {value} is not defined",
    "hint": ""
  },
  "unit.header-unitless": {
    "text": "the header of the DXF file states that the drawing has no unit ($INSUNITS = 0)",
    "hint": ""
  },
  "unit.header-unsupported": {
    "text": "the header of the DXF file states a unit that is not supported: {name__unit} ($INSUNITS = {value})",
    "hint": ""
  },
  "unit.imprecise": {
    "text": "if the unit is {unit__unit}, the lengths of the edges are too imprecise to show whether they are multiples of a round number",
    "hint": ""
  },
  "unit.inconclusive": {
    "text": "{stated}, and the geometry of the drawing does not give enough evidence for {unit__unit}",
    "hint": ""
  },
  "unit.lightburn": {
    "text": "LightBurn projects state all lengths in millimetres",
    "hint": ""
  },
  "unit.multiples": {
    "text": "if the unit is {unit__unit}, {count} of {all} different edge lengths ({percent, number, ::precision-integer} % of the total length) {count, plural, one {is a multiple} other {are multiples}} of {grid}",
    "hint": ""
  },
  "unit.no-number-matches": {
    "text": "if the unit is {unit__unit}, no edge has a length that matches {all, plural, one {the number} other {one of the # numbers}} in the texts of the drawing",
    "hint": ""
  },
  "unit.not-given": {
    "text": "the unit of the drawing is not known",
    "hint": ""
  },
  "unit.number": {
    "text": "{text}",
    "hint": ""
  },
  "unit.number-in": {
    "text": "{text} ({unit__unit})",
    "hint": ""
  },
  "unit.numbers-match": {
    "text": "if the unit is {unit__unit}, {count} of {all} numbers in the texts of the drawing {count, plural, one {equals} other {equal}} the length of an edge: {numbers}",
    "hint": ""
  },
  "unit.numbers-match-often": {
    "text": "if the unit is {unit__unit}, {count} of {all} numbers in the texts of the drawing equal the length of an edge, for example {numbers}",
    "hint": ""
  },
  "unit.overruled": {
    "text": "{stated}, but the unit of the drawing is more likely {unit__unit}, because {reason}",
    "hint": ""
  },
  "unit.page-in-pixels": {
    "text": "the file states the size of its page without a unit, as files in pixels or points do",
    "hint": ""
  },
  "unit.paper-size": {
    "text": "if the unit is {unit__unit}, the drawing has exactly the size of a sheet of paper ({sheet})",
    "hint": ""
  },
  "unit.part-drawn-twice": {
    "text": "The drawing contains the same part at two sizes, one of them {factor, number, ::@##} times larger than the other. One of the two parts is a detail, or was inserted with a wrong unit.",
    "hint": "Delete the part with the wrong size, or set the line type of its edges to ignored."
  },
  "unit.parts-differ": {
    "text": "Parts of the drawing have different units: one part is drawn in {one}, another part in {other}.",
    "hint": "Scale one of the parts in the CAD program and export the drawing again."
  },
  "unit.pdf": {
    "text": "the PDF states its coordinates in points (1/72 inch)",
    "hint": ""
  },
  "unit.pdf-scaled": {
    "text": "the PDF states its coordinates in units of {scale, number, ::@#####} points (UserUnit); one point is 1/72 inch",
    "hint": ""
  },
  "unit.plotter": {
    "text": "the plotter file (HPGL) states its coordinates in units of 1/40 mm, or states their scale",
    "hint": ""
  },
  "unit.plotter-page": {
    "text": "the plotter file (HPGL) states the scale of its coordinates relative to the paper of the plotter (SC without IP), and the size of the paper is not known",
    "hint": ""
  },
  "unit.read-against-evidence": {
    "text": "The unit of the drawing is most likely {best__unit} ({best_width__mm} × {best_height__mm} mm), but the drawing was imported with the unit {unit__unit} ({width__mm} × {height__mm} mm).",
    "hint": "Check the size of the drawing, and choose another unit if the size is wrong."
  },
  "unit.read-against-header": {
    "text": "The file states the unit {stated__unit} ({stated_width__mm} × {stated_height__mm} mm), but the drawing was imported with the unit {unit__unit} ({width__mm} × {height__mm} mm).",
    "hint": "Check the size of the drawing, and choose another unit if the size is wrong."
  },
  "unit.scale-mentioned": {
    "text": "A text in the drawing mentions the scale {scales}, so the drawing may not have its true size.",
    "hint": "Check the size of the drawing."
  },
  "unit.share-stated": {
    "text": "the file states the unit {stated__unit}, and knifetip assumes that {percent, number, ::@##} % of the files that state this unit are drawn in {unit__unit}",
    "hint": ""
  },
  "unit.share-unstated": {
    "text": "the file states no unit, and knifetip assumes that {percent, number, ::@##} % of the files without a stated unit are drawn in {unit__unit}",
    "hint": ""
  },
  "unit.shortest-edges": {
    "text": "if the unit is {unit__unit}, the shortest edges of the drawing are {length__mm} mm long",
    "hint": ""
  },
  "unit.size-unusual": {
    "text": "if the unit is {unit__unit}, the drawing measures {width__mm} × {height__mm} mm, which is an unusual size for a carton",
    "hint": ""
  },
  "unit.size-usual": {
    "text": "if the unit is {unit__unit}, the drawing measures {width__mm} × {height__mm} mm, which is a usual size for a carton",
    "hint": ""
  },
  "unit.svg-no-size": {
    "text": "the SVG file has no width and no height, and {pixel}",
    "hint": ""
  },
  "unit.svg-no-unit": {
    "text": "the SVG file states its size without a unit of length ({size__space}), and {pixel}",
    "hint": ""
  },
  "unit.svg-pixel": {
    "text": "one coordinate unit is 1/96 inch (0.2646 mm) in a browser, but 1/72 inch (0.3528 mm) in Illustrator, and 1/90 inch (0.2822 mm) in old versions of Inkscape",
    "hint": ""
  },
  "unit.svg-size": {
    "text": "the SVG file states its size ({size__space}) for a viewBox of {width, number, ::@#####} × {height, number, ::@#####} coordinate units",
    "hint": ""
  },
  "unit.svg-size-in-pixels": {
    "text": "the SVG file states its size ({size__space}) and has no viewBox, so coordinates are in {pixel__unit}",
    "hint": ""
  },
  "unit.svg-writer": {
    "text": "the program that wrote the SVG file uses {pixel__unit} as the unit",
    "hint": ""
  },
  "unit.text-states": {
    "text": "a text in the drawing states the unit: “{text}”",
    "hint": ""
  },
  "unit.unsupported": {
    "text": "''{unit}'' is not a supported unit of length.",
    "hint": "Choose one of {known__or}."
  },
  "unit.writer": {
    "text": "the file was written by {writer}, which writes lengths in mm",
    "hint": ""
  },
  "user.at-provider": {
    "text": "The user {name} signs in at a provider and has no password on this server.",
    "hint": "Change the password at the provider."
  },
  "user.bad-name": {
    "text": "{name} is not a valid name of a user.",
    "hint": "Use 1 to 64 letters, digits and . _ @ + -, and begin with a letter or a digit."
  },
  "user.bad-password": {
    "text": "The password has {length} characters, but must have {shortest} to {longest}.",
    "hint": "Choose a longer password, for example four words."
  },
  "user.bad-role": {
    "text": "A user cannot have the role {role}.",
    "hint": "Choose {roles__or}. Gateways use API keys instead of users."
  },
  "user.exists": {
    "text": "A user with the name {name} already exists.",
    "hint": "Choose another name, or change that user."
  },
  "user.last-admin": {
    "text": "{name} is the last active administrator.",
    "hint": "Make another user an administrator first."
  },
  "user.not-signed-in": {
    "text": "Only a user who has signed in with a password can change it.",
    "hint": "Sign in with name and password."
  },
  "user.password-blank": {
    "text": "the password consists only of blanks",
    "hint": ""
  },
  "user.password-common": {
    "text": "the password consists of words that many people use",
    "hint": ""
  },
  "user.password-name": {
    "text": "the password consists of the name of the user or of the program",
    "hint": ""
  },
  "user.password-repeated": {
    "text": "the password repeats a few characters",
    "hint": ""
  },
  "user.password-sequence": {
    "text": "the characters of the password follow each other on the keyboard",
    "hint": ""
  },
  "user.unknown": {
    "text": "There is no user with the name {name}.",
    "hint": "List the users with `knifetip user list`."
  },
  "user.weak-password": {
    "text": "The password is too easy to guess: {why}.",
    "hint": "Choose another one, for example four words that have nothing to do with each other."
  },
  "user.wrong-password": {
    "text": "The current password is wrong.",
    "hint": "Enter the password with which you sign in."
  },
  "verify.bad-tolerance": {
    "text": "The tolerance of the verification is {tolerance} mm, which is not a valid length.",
    "hint": "Give a number greater than 0, usually 0.01 mm."
  },
  "verify.beam-on-rapid": {
    "text": "The laser beam is on during a rapid move of {length, number, ::.000} mm.",
    "hint": "Switch the beam off (M5) before the rapid move."
  },
  "verify.beam-refocused": {
    "text": "The laser beam is on while the head moves up or down by {height, number, ::.000} mm.",
    "hint": "Switch the beam off (M5) before the height changes."
  },
  "verify.beside-line": {
    "text": "The path of the {tool__tool} is {distance, number, ::.000} mm away from the edge that it should follow.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.beyond-rotation": {
    "text": "Axis {joint} turns to {position, number, ::.000}°, but its travel is {low, number, ::@#####}° to {high, number, ::@#####}°.",
    "hint": "Turn the drawing on the table, or choose a machine whose axis has a larger range of rotation."
  },
  "verify.beyond-travel": {
    "text": "Axis {joint} moves to {position, number, ::.000} mm, but its travel is {low, number, ::@#####} to {high, number, ::@#####} mm.",
    "hint": "For axis X or Y, move the drawing on the table, or choose a larger machine. For axis Z, check the heights in the machine file."
  },
  "verify.blade-bend": {
    "text": "The knife turns by {turn, number, ::precision-integer}° in the board within the width of its blade, {width, number, ::@#####} mm, on a bend of {radius, number, ::.00} mm radius. It cuts the top face up to {top, number, ::.000} mm beside the line, and the rear edge of the blade runs up to {rear, number, ::.00} mm beside it.",
    "hint": ""
  },
  "verify.blade-bend-too-tight": {
    "text": "The bend is too tight for the knife: on a radius of {radius, number, ::.00} mm it turns by {turn, number, ::precision-integer}° in the board within the width of its blade, {width, number, ::@#####} mm. It cuts the top face up to {top, number, ::.00} mm beside the line (permitted: {tolerance, number, ::@#####} mm), and the rear edge of the blade runs up to {rear, number, ::.00} mm beside it.",
    "hint": "Draw a bend with a radius of at least {least, number, ::.0} mm or a sharp corner, use a knife with a steeper or narrower blade, or accept the shortfall."
  },
  "verify.blade-not-parked": {
    "text": "At the end of the program, the freely turning blade of station {station} has a heading of {heading, number, ::.0}°, but the next program expects {park, number, ::@#####}°.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.blade-pushed": {
    "text": "A move of {length, number, ::.00} mm pushes the tip of the freely turning blade away from the axis of the blade instead of pulling it. The blade may then turn to either side or tear the board.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.bridge-near-corner": {
    "text": "The bridge at {place, number, ::.000} mm from the start of the contour is {distance, number, ::.000} mm too close to a sharp corner.",
    "hint": "Compile the job again, or choose a smaller spacing of bridges in the board file."
  },
  "verify.bridge-spacing": {
    "text": "The bridge at {place, number, ::.000} mm from the start of the contour is {distance, number, ::.000} mm away from the next bridge, but the board allows at most {most, number, ::@#####} mm.",
    "hint": "Compile the job again, or allow a larger spacing of bridges in the board file."
  },
  "verify.bridge-spare": {
    "text": "The bridge at {place, number, ::.000} mm from the start of the contour is not needed, because the bridges before and after it are only {distance, number, ::.000} mm apart.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.bridge-width": {
    "text": "The bridge at {place, number, ::.000} mm from the start of the contour is {width, number, ::.000} mm wide in the top face of the board, but the board needs bridges of {planned, number, ::@#####} mm width.",
    "hint": "Compile the job again for this board."
  },
  "verify.centre-off-path": {
    "text": "The centre of the cutter is {distance, number, ::.0000} mm away from its planned path, and the controller may round corners by another {rounding, number, ::.0000} mm. The tolerance is {tolerance, number, ::@#####} mm.",
    "hint": "Increase the tolerance, or report an internal error with the program file."
  },
  "verify.cleaning-beyond": {
    "text": "Internal error in cleaning: the cleaned edge extends beyond all edges of the drawing.",
    "hint": "Report this error with the drawing."
  },
  "verify.cleaning-dropped": {
    "text": "Internal error in cleaning: {length, number, ::.000} mm of the edge were lost.",
    "hint": "Report this error with the drawing."
  },
  "verify.cleaning-fit": {
    "text": "Internal error in cleaning: the edge is {distance, number, ::.0000} mm away from the arc that replaces it, and only {stated, number, ::.0000} mm are stated.",
    "hint": "Report this error with the drawing."
  },
  "verify.cleaning-incomplete": {
    "text": "Internal error in cleaning: the lengths of the kept, merged and dropped parts of the edge do not add up to the length of the edge.",
    "hint": "Report this error with the drawing."
  },
  "verify.cleaning-invented": {
    "text": "Internal error in cleaning: the cleaned edge corresponds to no edge of the drawing.",
    "hint": "Report this error with the drawing."
  },
  "verify.cleaning-moved": {
    "text": "Internal error in cleaning: the edge was moved by {distance, number, ::.0000} mm.",
    "hint": "Report this error with the drawing."
  },
  "verify.cleaning-type": {
    "text": "Internal error in cleaning: the edge has the line type {drawn} before cleaning and {worked} after it.",
    "hint": "Report this error with the drawing."
  },
  "verify.comes-out-anywhere": {
    "text": "The knife leaves the board at a point that is neither the end of an edge nor the point where it entered.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.comes-out-past": {
    "text": "The knife leaves the board {distance, number, ::.000} mm beyond the end of the edge.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.comes-out-short": {
    "text": "The knife leaves the board {distance, number, ::.000} mm before the end of the edge.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.contour-unreached": {
    "text": "The cutter of {width, number, ::.00} mm diameter does not fit into or beside the contour of this edge, so nothing of the contour is cut ({length, number, ::.000} mm on this edge).",
    "hint": "Choose a thinner cutter, enlarge the opening, or accept that the contour is not cut."
  },
  "verify.crease-meets-cuts": {
    "text": "Cuts end on {count} creases from one side. These creases are made without interruption, because all creases are made before the cuts.",
    "hint": ""
  },
  "verify.crease-stops-at-cut": {
    "text": "Cuts cross {count} creases. The wheel stops before these cuts, and up to {distance, number, ::.00} mm on each side of a cut are not creased.",
    "hint": "If the fold needs this length, choose a smaller creasing wheel, or move the cut."
  },
  "verify.crease-too-bent": {
    "text": "The crease bends too tightly for the creasing wheel: a wheel of {wheel, number, ::@#####} mm radius touches the board along a straight line of {contact, number, ::.0} mm, whose ends press up to {distance, number, ::.00} mm beside the crease (permitted: {tolerance, number, ::@#####} mm). {length, number, ::.0} mm of the crease are not pressed.",
    "hint": "Mount a creasing wheel of at most {smaller, number, ::.0} mm radius, draw a bend with a radius of at least {radius, number, ::precision-integer} mm, change the line type to perforation or half-cut, or accept the shortfall."
  },
  "verify.crease-too-short": {
    "text": "The crease is too short for the creasing wheel and is not made: it is {length, number, ::.00} mm long, the wheel has a radius of {radius, number, ::.0} mm, and it must stop {clearance, number, ::.00} mm before each free end.",
    "hint": "Join the crease to a crease on the same straight line, set its line type to ignored, or choose a board on which short creases are pressed or a smaller creasing wheel."
  },
  "verify.cut-both-ways": {
    "text": "{length, number, ::.000} mm of this edge are cut in both directions. A slanted blade then cuts the top face past both ends.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.cut-too-short": {
    "text": "The cut is {length, number, ::.00} mm long and ends inside a panel. The slanted blade of the knife needs a cut longer than {lead, number, ::.00} mm, so the cut is not made.",
    "hint": "Draw a longer cut, join the cut to another cut, set its line type to ignored, or choose a knife with a less slanted blade."
  },
  "verify.cuts-part": {
    "text": "The cutter cuts sideways into a part, up to {depth, number, ::.000} mm from the edge of the part.",
    "hint": "Move the parts further apart, or choose a thinner cutter."
  },
  "verify.cutter-at-rest": {
    "text": "The cutter moves through the board while its spindle is off.",
    "hint": "Start the spindle (M3) before the cutter enters the board."
  },
  "verify.deep-swivel": {
    "text": "The freely turning blade is turned about its tip at a depth of {depth, number, ::.00} mm instead of {planned, number, ::@#####} mm.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.drawn-twice": {
    "text": "Two lines of the type {type} lie {distance, number, ::.00} mm apart for {length, number, ::.0} mm, nearer than the board is thick. Is the same line drawn twice?",
    "hint": "Set the line type of one of the two to ignored, move them apart, or accept that both are made."
  },
  "verify.feed-of-other-axis": {
    "text": "Station {station} is on a further carriage, and its move has a feed in mm/min (G94). A controller may apply this feed only to the travel of the gantry.",
    "hint": "State the duration of the move in inverse time mode (G93)."
  },
  "verify.fixed-blade": {
    "text": "The board is best cut by an oscillating blade, and the knife of station {station} is fixed: it pushes thick or soft board together.",
    "hint": "Choose a machine with an oscillating knife, or cut a sample first."
  },
  "verify.flank-inside": {
    "text": "The flank of the V-groove meets the top face of the board {distance, number, ::.0000} mm too close to the centre line of the groove. The tolerance is {tolerance, number, ::@#####} mm.",
    "hint": "Check the tilt and the offsets of the V-cutter in the machine file, then compile the job again."
  },
  "verify.flank-outside": {
    "text": "The flank of the V-groove meets the top face of the board {distance, number, ::.0000} mm too far from the centre line of the groove. The tolerance is {tolerance, number, ::@#####} mm.",
    "hint": "Check the tilt and the offsets of the V-cutter in the machine file, then compile the job again."
  },
  "verify.flank-through-cut": {
    "text": "A flank of the V-groove reaches {depth, number, ::.000} mm sideways past the cut at edge {edge}. The cut lies {distance, number, ::.000} mm from the centre line of the groove, {place, number, ::.0} mm from the start of the groove.",
    "hint": "Move the groove and the cut further apart, or choose a shallower groove."
  },
  "verify.fold-angle": {
    "text": "The V-groove lets the board fold by {angle, number, ::.0}°, but the board must fold by {required, number, ::.0}° here.",
    "hint": "Choose a V-cutter with a larger tilt, or state the fold angle of the carton in the board file (fold_angle)."
  },
  "verify.goes-in-anywhere": {
    "text": "The knife enters the board at a point where no edge begins.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.groove-arc": {
    "text": "The V-groove is an arc, which a tilted blade cannot follow.",
    "hint": "Draw the V-groove with straight lines, or choose another line type."
  },
  "verify.groove-past-ends": {
    "text": "The V-cutter cuts {length, number, ::.00} mm beyond the ends of the groove, but the board allows an overcut of only {most, number, ::.00} mm.",
    "hint": "Choose a V-cutter with a narrower blade, or allow a longer overcut in the board file."
  },
  "verify.groove-shallower": {
    "text": "The V-cutter cuts {depth, number, ::.000} mm deep, although an earlier pass of the same groove was already {before, number, ::.000} mm deep.",
    "hint": "Order the passes by increasing depth."
  },
  "verify.groove-shifted": {
    "text": "The V-groove was shifted by {distance, number, ::.00} mm, so that its flank does not reach the cut beside it.",
    "hint": "If the fold must not move, move the cut, or set groove_shift in the board file to 0."
  },
  "verify.groove-too-short": {
    "text": "The V-groove is {length, number, ::.00} mm long, but the blade is {blade, number, ::.00} mm wide, so the groove is not made.",
    "hint": "Draw a longer groove, set its line type to crease or ignored, or choose a V-cutter with a narrower blade."
  },
  "verify.grooves-meet": {
    "text": "Two V-grooves lie {distance, number, ::.00} mm apart, but each is {width, number, ::.00} mm wide in the top face. Along {length, number, ::.0} mm their flanks meet, and no ridge remains between them.",
    "hint": "Move the grooves apart, choose a smaller depth of grooves in the board file, or accept the shortfall."
  },
  "verify.hanging-piece": {
    "text": "The edge at X{x, number, ::.000} Y{y, number, ::.000} (coordinates of the sheet) lies on a part of the board that, from line {line} of the program on, hangs only on bridges or narrow necks and may therefore move.",
    "hint": "Process this edge before the cut that leaves only the bridges or necks."
  },
  "verify.head-not-located": {
    "text": "A carriage moves along the gantry while the position of {other} is unknown.",
    "hint": "Park all carriages at the start of the program."
  },
  "verify.heads-too-near": {
    "text": "Only {distance, number, ::.00} mm remain between {first} and {second}. Their least distance is {least, number, ::@#####} mm.",
    "hint": "Park the carriage that is not in use before the move."
  },
  "verify.idle-head-low": {
    "text": "The carriage with axis {letter} is not in use, but {letter} is at {height, number, ::.00} mm. Its tools are above the board only at {needed, number, ::.00} mm or higher.",
    "hint": "Lift the carriage before another one is used."
  },
  "verify.in-zone": {
    "text": "Station {station} touches the keep-out zone {zone}: its tip is {depth, number, ::.0} mm below the top of the zone, and its tool or holder reaches into the zone.",
    "hint": "Lead the move around the zone, or lift the tool above it."
  },
  "verify.inside-part": {
    "text": "The cutter cuts into a finished part at X{x, number, ::.000} Y{y, number, ::.000} (coordinates of the sheet).",
    "hint": "Move the parts further apart, or choose a thinner cutter."
  },
  "verify.knife-at-rest": {
    "text": "The oscillating knife cuts while its oscillation is off.",
    "hint": "Start the oscillation (M3) before the knife enters the board."
  },
  "verify.laser-off": {
    "text": "The laser moves along an edge while its beam is off, so the edge is not cut.",
    "hint": "Switch the beam on (M3) before the edge."
  },
  "verify.loose-piece": {
    "text": "The edge at X{x, number, ::.000} Y{y, number, ::.000} (coordinates of the sheet) lies on a part of the board that line {line} of the program has already cut out, so this part of the board may move.",
    "hint": "Process this edge before the contour that cuts out this part of the board. Where contours cross, divide them at their crossings in the drawing."
  },
  "verify.low-without-station": {
    "text": "The head goes down to {height, number, ::.00} mm while no station is selected. All tools clear the board only at {needed, number, ::.00} mm or higher.",
    "hint": "Select a station before the head goes down, and lift it before the station is released."
  },
  "verify.lowers-second": {
    "text": "The program line lowers station {station} while station {other} may still be lowered.",
    "hint": "Raise station {other} (M65 P{output}) before this program line."
  },
  "verify.made-before": {
    "text": "Station {station} processes {length, number, ::.000} mm at X{x, number, ::.000} Y{y, number, ::.000} (coordinates of the sheet), although an earlier program has already made this line on the sheet.",
    "hint": "Continue from a later contour, or start a new sheet."
  },
  "verify.moves-before-stated": {
    "text": "The program moves the head before it switches off {thing}.",
    "hint": "Switch off {thing} before the first move. Only a lift straight up, to Z {height, number, ::.000} mm or higher, may come earlier."
  },
  "verify.moves-overlap": {
    "text": "The controller starts this move before the move in front of it has ended. Axis C turns differently in the two moves, so the tip leaves the path by up to {distance, number, ::.000} mm (tolerance {tolerance, number, ::.000} mm).",
    "hint": "Add an exact stop (G4 P0) before this program line."
  },
  "verify.moves-with-beam": {
    "text": "The program moves the head before it switches off the spindle (M5), so a laser beam may still be on.",
    "hint": "Write M5 before the first move."
  },
  "verify.narrow-cuts": {
    "text": "Two cuts lie {distance, number, ::.00} mm apart for {length, number, ::.0} mm. The strip or slot between them is narrower than the board is thick ({caliper, number, ::@#####} mm) and may tear or stay stuck.",
    "hint": ""
  },
  "verify.narrow-lines": {
    "text": "A line of the type {type} and one of the type {other} lie {distance, number, ::.00} mm apart for {length, number, ::.0} mm, which is too near for a board {caliper, number, ::@#####} mm thick: the narrow strip between them is crushed or tears off.",
    "hint": ""
  },
  "verify.narrow-rim": {
    "text": "The creasing wheel has a rim of {width, number, ::@#####} mm, which is narrow for a board {caliper, number, ::@#####} mm thick: it may cut into the upper face instead of creasing it.",
    "hint": "Mount a creasing wheel with a rim of at least {least, number, ::@#####} mm."
  },
  "verify.narrow-slits": {
    "text": "{count} slits and cuts between two parts ({length, number, ::.0} mm) become {width, number, ::@#####} mm wide: the board on each side loses half of this strip.",
    "hint": ""
  },
  "verify.never-stated": {
    "text": "The program never switches off {thing}, although an earlier program may have left it on.",
    "hint": "Switch off {thing} at the beginning of the program."
  },
  "verify.no-closed-cut": {
    "text": "A direction was chosen for the closed cut with edge {edge}, but the program does not cut this contour in one run.",
    "hint": "Compile the job again."
  },
  "verify.no-station": {
    "text": "The program line cuts, but no station (T and M6) has been selected before.",
    "hint": "Select the station before the first cut."
  },
  "verify.no-such-shortfall": {
    "text": "The verdict has no finding {code} at edge {edge}.",
    "hint": "Read the findings again: the drawing or the program may have changed since."
  },
  "verify.not-acceptable": {
    "text": "The finding {code} at edge {edge} is no shortfall, so it cannot be accepted. A shortfall is a line that the tool cannot make exactly as drawn.",
    "hint": "Change the drawing, the tool or the board, and compile the job again."
  },
  "verify.not-worked": {
    "text": "{length, number, ::.000} mm along the edge are not {work}{where}.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.off-curve": {
    "text": "The edge approximates a curve of the drawing file and is {fit, number, ::.0000} mm away from it. The path of the tool is {distance, number, ::.0000} mm away from the edge, and the controller may round corners by another {rounding, number, ::.0000} mm. The sum exceeds the tolerance of {tolerance, number, ::@#####} mm.",
    "hint": "Draw the curve with lines and circular arcs, or verify with a greater tolerance."
  },
  "verify.off-line": {
    "text": "The path of the {tool__tool} is {distance, number, ::.0000} mm away from the edge that it should follow, and the controller may round corners by another {rounding, number, ::.0000} mm. The tolerance is {tolerance, number, ::@#####} mm.",
    "hint": "Increase the tolerance, or report an internal error with the program file."
  },
  "verify.one-pass": {
    "text": "The board should be cut in passes of at most {step, number, ::@#####} mm, but programs for this controller do not set the depth: the knife cuts {depth, number, ::@#####} mm in one pass.",
    "hint": "Run the program several times, with less pressure on the knife at first."
  },
  "verify.oscillation-on": {
    "text": "Station {station} processes the board while the oscillation is on, although its tool must not oscillate.",
    "hint": "Switch the oscillation off (M5) before this station is used."
  },
  "verify.other-direction": {
    "text": "The program cuts edge {edge} against the chosen direction.",
    "hint": "Compile the job again."
  },
  "verify.other-passes": {
    "text": "Edge {edge} must be cut in {passes, plural, one {# pass} other {# passes}} down to {depth, number, ::@#####} mm below the top face, but the program cuts it at these depths (mm): {found}.",
    "hint": "Compile the job again."
  },
  "verify.other-placement": {
    "text": "The program places the drawing at X{x, number, ::.0000} Y{y, number, ::.0000} on the sheet, but the job places it at X{job_x, number, ::.0000} Y{job_y, number, ::.0000}.",
    "hint": "Compile the job again, or verify the program with the position X{x, number, ::.0000} Y{y, number, ::.0000} of the drawing."
  },
  "verify.other-start": {
    "text": "The closed cut with edge {edge} must begin at X {x, number, ::.000 group-off} mm, Y {y, number, ::.000 group-off} mm on this edge, but the program begins it elsewhere.",
    "hint": "Choose a start with more room for the tool, or compile the job again."
  },
  "verify.outline-begun": {
    "text": "The edge at X{x, number, ::.000} Y{y, number, ::.000} (coordinates of the sheet) lies on a part of the board whose outline the program begins to cut in line {line}, before this edge is made.",
    "hint": "Make creases, grooves, half-cuts and perforations before the outline of their part."
  },
  "verify.output": {
    "text": "output {output} (M65 P{output})",
    "hint": ""
  },
  "verify.output-off": {
    "text": "Station {station} processes the board while its output {output} is off, so its tool is not lowered.",
    "hint": "Switch output {output} on (M64) before the station is used."
  },
  "verify.pass-alone": {
    "text": "The cutter mills {length, number, ::.000} mm only {depth, number, ::.000} mm deep, and no other pass goes through the board there.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.pass-too-deep": {
    "text": "The {tool__tool} cuts {depth, number, ::.000} mm deep in a single pass along {length, number, ::.000} mm, but at most {step, number, ::@#####} mm per pass are allowed.",
    "hint": "Add a shallower pass, or allow deeper passes in the board file."
  },
  "verify.past-end": {
    "text": "The {tool__tool} continues {length, number, ::.000} mm beyond the end of the edge.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.past-open-cut": {
    "text": "The cutter continues {length, number, ::.000} mm beyond the end of an open cut.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.past-stop": {
    "text": "The {tool__tool} cuts {length, number, ::.000} mm beyond the point where it must stop.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.perforation-bridge": {
    "text": "A gap of the perforation, which begins {place, number, ::.000} mm from the start of the edge, is only {length, number, ::.000} mm long in the top face of the board, but it must be at least {least, number, ::.000} mm long to hold the board.",
    "hint": "Compile the job again for this board."
  },
  "verify.perforation-cut": {
    "text": "A cut of the perforation is {length, number, ::.000} mm long instead of {planned, number, ::.000} mm.",
    "hint": "Compile the job again for this board."
  },
  "verify.perforation-gap": {
    "text": "A gap of the perforation, which begins {place, number, ::.000} mm from the start of the edge, is {length, number, ::.000} mm long, but the board needs gaps of {planned, number, ::@#####} mm.",
    "hint": "Compile the job again for this board."
  },
  "verify.perforation-uneven": {
    "text": "A cut of the perforation is not where it is planned: the gap that begins {place, number, ::.000} mm from the start of the edge is {first, number, ::.000} mm long, and the gap after the cut {second, number, ::.000} mm.",
    "hint": "Compile the job again for this board."
  },
  "verify.plunge-without-move": {
    "text": "The {tool__tool} enters the board at X{x, number, ::.000} Y{y, number, ::.000} (coordinates of the sheet) and leaves it without a move.",
    "hint": "Delete the plunge, or compile the job again."
  },
  "verify.rapid-in-board": {
    "text": "A rapid move of station {station} is {depth, number, ::.000} mm below the top face of the board.",
    "hint": "Lift the tool above the board before the rapid move."
  },
  "verify.rapid-near-sheet": {
    "text": "A rapid move of station {station} is {depth, number, ::.000} mm below the top face of the board, and it is over the sheet, too close to the sheet, or in the mat.",
    "hint": "Lift the tool above the board before the rapid move, or keep the tool beside the sheet by the clearance of the machine."
  },
  "verify.rapid-too-low": {
    "text": "A rapid move of station {station} is only {height, number, ::.000} mm above the board; the turn_clearance of the machine is {needed, number, ::@#####} mm.",
    "hint": "Lift the tool higher before the rapid move."
  },
  "verify.released-before": {
    "text": "The edge at X{x, number, ::.000} Y{y, number, ::.000} (coordinates of the sheet) lies on a part of the board that an earlier program has already cut out or begun to cut out on this sheet.",
    "hint": "Continue from the first contour that is not made, or start a new sheet. If the tool did not cut through the board, state this when you continue the job."
  },
  "verify.replaced": {
    "text": "{length, number, ::.00} mm of this line of the type {type} are not made, because a line of the type {other} lies on it and is made instead.",
    "hint": "If the {type} is meant, set the line type of the other line to ignored."
  },
  "verify.slanted": {
    "text": "Station {station} moves {distance, number, ::.000} mm sideways (away from the axis of its tool) while the tool enters or leaves the board.",
    "hint": "Move the tool along its axis while it enters or leaves the board."
  },
  "verify.spindle": {
    "text": "the spindle (M5)",
    "hint": ""
  },
  "verify.stray": {
    "text": "The {tool__tool} processes {length, number, ::.000} mm of the board at X{x, number, ::.000} Y{y, number, ::.000} (coordinates of the sheet), where the drawing has no edge.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.stray-along": {
    "text": "The {tool__tool} processes {length, number, ::.000} mm along edge {edge}, whose line type ({type}) must not be processed with this tool.",
    "hint": "Check the line type of the edge, then compile the job again."
  },
  "verify.stray-plunge": {
    "text": "The {tool__tool} enters the board at X{x, number, ::.000} Y{y, number, ::.000} (coordinates of the sheet), where the drawing has no edge.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.stray-plunge-along": {
    "text": "The {tool__tool} enters the board on edge {edge}, whose line type ({type}) must not be processed with this tool.",
    "hint": "Check the line type of the edge, then compile the job again."
  },
  "verify.switches-at-unknown-height": {
    "text": "The program line switches an output or the spindle before the program has set the height of the head.",
    "hint": "Lift the head to Z {needed, number, ::.000} mm before this program line."
  },
  "verify.switches-low": {
    "text": "The program line switches an output or the spindle while axis Z is at {height, number, ::.000} mm, which is too low.",
    "hint": "Lift the head to Z {needed, number, ::.000} mm before this program line."
  },
  "verify.swivel-mark": {
    "text": "The freely turning blade turns by {turn, number, ::precision-integer}° about its tip, and its slanted edge cuts the top face up to {mark, number, ::.00} mm beside the line (permitted: {tolerance, number, ::@#####} mm).",
    "hint": "Let the blade turn at a smaller depth (`swivel_depth` of the knife), use a blade with a steeper edge, or accept the mark."
  },
  "verify.too-few-bridges": {
    "text": "Only {bridges, plural, one {# bridge holds} other {# bridges hold}} the part, but the board needs at least {fewest, plural, one {# bridge} other {# bridges}}.",
    "hint": "Compile the job again, or require fewer bridges in the board file. Where contours cross, divide them at their crossings in the drawing."
  },
  "verify.turn-at-feed": {
    "text": "Axis C turns by {degrees, number, ::.0000}° in a program line whose feed is in mm/min, so the duration of the rotation is not defined.",
    "hint": "Give the duration of the move in inverse time mode (G93)."
  },
  "verify.turn-in-board": {
    "text": "Axis C turns by {degrees, number, ::.000}° while the tool is in the board, but at most {most, number, ::.00}° is allowed.",
    "hint": "Lift the tool before it turns."
  },
  "verify.turn-off-path": {
    "text": "Axis C turns by {degrees, number, ::.000}° in the board, although the path of the tool turns by {path, number, ::.000}°.",
    "hint": "Turn the tool by the same angle as the path."
  },
  "verify.turn-overlaps": {
    "text": "The controller does not wait between the turn of axis C by {degrees, number, ::.00}° in the board and the move next to it, so the tool turns while it moves.",
    "hint": "Add an exact stop (G4 P0) before this program line."
  },
  "verify.two-lowered": {
    "text": "Station {station} processes the board while station {other} is also lowered (output {output} is on).",
    "hint": "Raise station {other} (M65 P{output}) before this station is used."
  },
  "verify.unclassified": {
    "text": "The edge has no line type (such as cut or crease), so the required tool is not known.",
    "hint": "Give the edge a line type."
  },
  "verify.unknown-beside-zone": {
    "text": "The head moves from an unknown position, and its tip is below {top, number, ::@#####} mm, the top of the keep-out zone {zone}, or at an unknown height. The move may lead through the zone.",
    "hint": "Lift Z above the zone before the first move of X or Y."
  },
  "verify.unknown-position": {
    "text": "The program line moves the head from or to a position that the program has not set.",
    "hint": "Give X, Y, Z and C before this program line."
  },
  "verify.unreached": {
    "text": "The cutter cannot reach {length, number, ::.000} mm of the edge, in {places, plural, one {# place} other {# places}}, without cutting into a part. The edge lies up to {distance, number, ::.000} mm from the board that the cutter removes.",
    "hint": "Choose a thinner cutter, widen the slot, or round the inner corners with at least the radius of the cutter."
  },
  "verify.where-from-start": {
    "text": ", beginning {place, number, ::.000} mm from the start of the edge",
    "hint": ""
  },
  "verify.where-past-end": {
    "text": "; the tool must also process the board beyond the end of the edge",
    "hint": ""
  },
  "verify.where-past-start": {
    "text": "; the tool must also process the board before the start of the edge",
    "hint": ""
  },
  "verify.wide-slit": {
    "text": "The cutter mills {length, number, ::.000} mm of the slit {width, number, ::.00} mm wide, because it follows the line of the slit with its centre.",
    "hint": "Cut the slit with a knife, choose a thinner cutter, or draw the slit as an outline of the width that it should have."
  },
  "verify.work-creased": {
    "text": "creased",
    "hint": ""
  },
  "verify.work-cut": {
    "text": "cut",
    "hint": ""
  },
  "verify.work-grooved": {
    "text": "grooved",
    "hint": ""
  },
  "verify.work-grooved-from-end": {
    "text": "grooved in the direction from the end to the start of the edge",
    "hint": ""
  },
  "verify.work-grooved-from-start": {
    "text": "grooved in the direction from the start to the end of the edge",
    "hint": ""
  },
  "verify.wrong-depth": {
    "text": "The {tool__tool} is {depth, number, ::.0000} mm below the top face of the board instead of {planned, number, ::.0000} mm.",
    "hint": "Compile the job again for this board."
  },
  "verify.wrong-feed": {
    "text": "Station {station} has a feed of {feed, number, ::@#####} mm/min instead of {planned, number, ::@#####} mm/min.",
    "hint": "Compile the job again with the current machine file."
  },
  "verify.wrong-heading": {
    "text": "The {tool__tool} is turned {degrees, number, ::.000}° away from the direction of the edge, which moves its cutting edge {swing, number, ::.000} mm sideways.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.wrong-time": {
    "text": "The move of station {station} takes {seconds, number, ::.0000} s instead of {planned, number, ::.0000} s.",
    "hint": "Compile the job again with the current machine file."
  },
  "waiting.check-refused": {
    "text": "{machine} has not begun the program: no line of it was executed. {reason}",
    "hint": "{reason__hint} Then try it again, or compile the job again, or cancel it. Other jobs of the queue go on."
  },
  "waiting.confirmed": {
    "text": "The operator confirmed the job, and {machine} is starting.",
    "hint": ""
  },
  "waiting.controller-not-connected": {
    "text": "The job waits, because the gateway of {machine} is not connected to the controller of the machine. {reason}",
    "hint": "{reason__hint}"
  },
  "waiting.for-controller": {
    "text": "The job waits, because the gateway of {machine} (the program that sends jobs to the machine) is not connected to the controller of the machine.",
    "hint": "Switch on the controller and check its cable."
  },
  "waiting.for-end": {
    "text": "The whole program was sent to {machine}, which does not report when it has finished.",
    "hint": "When the machine has finished and is at rest, confirm this on the station page or with knifetip job end: the copy is then finished. If the machine has not finished the program, cancel the job."
  },
  "waiting.for-gateway": {
    "text": "The job waits, because the gateway of {machine} (the program that sends jobs to the machine) is not connected to the server.",
    "hint": "Switch on the machine and start its gateway."
  },
  "waiting.for-machine": {
    "text": "The job waits until the gateway of {machine} (the program that sends jobs to the machine) takes the job from the queue.",
    "hint": ""
  },
  "waiting.for-person": {
    "text": "The job waits, because the gateway of {machine} (the program that sends jobs to the machine) is not connected to the server.",
    "hint": "{advice}"
  },
  "waiting.for-rest": {
    "text": "The job waits until the operator of {machine} confirms that the sheet of job {job}, of which it makes the rest, still lies in its place. Required: board ''{board}''{sheet}{tools}.",
    "hint": "Check that the sheet has not moved and that all tools are whole, then confirm the job to start it. If the sheet has moved or is gone, cancel the job."
  },
  "waiting.for-sheet": {
    "text": "Copy {copy} of {copies} of the job is finished. The next copy needs a new sheet.",
    "hint": "Put a new sheet of {board}{sheet} on the table, then confirm the new sheet. The machine then starts the next copy."
  },
  "waiting.for-start": {
    "text": "The job waits until the operator of {machine} confirms that the table is clear.{unfinished} Required: board ''{board}''{sheet}{tools}.",
    "hint": "Check the table, then confirm the job to start it."
  },
  "waiting.for-turn": {
    "text": "The job waits until {machine} has finished the jobs that come before it in the queue.",
    "hint": ""
  },
  "waiting.obstacle": {
    "text": "The job waits, because {machine} takes no job now. {reason}",
    "hint": "{reason__hint}"
  },
  "waiting.on-hold": {
    "text": "The job is on hold in the queue of {machine}. Other jobs are taken before it.",
    "hint": "End the hold to let the machine take the job."
  },
  "waiting.outdated": {
    "text": "The program of the job is out of date: {changes__semicolon}.",
    "hint": "Compile the job again. Its program is then made and verified for the present machine and board."
  },
  "waiting.sheet-outline": {
    "text": ", cut to the outline of the drawing",
    "hint": ""
  },
  "waiting.sheet-size": {
    "text": ", cut to {width, number, ::@#####} × {height, number, ::@#####} mm",
    "hint": ""
  },
  "waiting.taken": {
    "text": "The job waits, because {machine} is occupied by job {job}, which is {state}.",
    "hint": ""
  },
  "waiting.taken-interrupted": {
    "text": "The job waits, because {machine} is occupied by job {job}, which is interrupted.",
    "hint": "Mark that job finished, queue it again or scrap it first."
  },
  "waiting.taken-unconfirmed": {
    "text": "The job waits, because {machine} is occupied by job {job}, which waits for its confirmation.",
    "hint": "Confirm or cancel that job."
  },
  "waiting.tool": {
    "text": "{name} (station {station})",
    "hint": ""
  },
  "waiting.tools": {
    "text": ", tools: {tools}",
    "hint": ""
  },
  "waiting.unconfirmed-run": {
    "text": "{machine} was started, but the operator has not confirmed that the table is clear. Required: board ''{board}''{sheet}{tools}.",
    "hint": "Check the table. Confirm the job to let it continue, or cancel it."
  },
  "waiting.unfinished-sheet": {
    "text": " The unfinished sheet of job {job} may still lie on it.",
    "hint": ""
  },
  "watch.bad-sidecar": {
    "text": "The file with the fields of the order cannot be read: {reason}.",
    "hint": "Write a JSON object with the fields of an order, such as board and copies."
  },
  "watch.folder": {
    "text": "The folder {folder} cannot be used: {reason}.",
    "hint": "Choose an existing folder with read and write permission."
  },
  "watch.large-sidecar": {
    "text": "The file with the fields of the order is larger than {limit} MB.",
    "hint": "Write only the fields of the order into it."
  },
  "watch.no-drawing": {
    "text": "The drawing {name} of the order did not arrive in the folder.",
    "hint": "Put the drawing into the folder, then the order again. Or put both into a package *.xjdf.zip."
  },
  "watch.no-object": {
    "text": "The file with the fields of the order is not a JSON object.",
    "hint": "Write a JSON object with the fields of an order, such as board and copies."
  },
  "watch.other-drawing": {
    "text": "The file with the fields of the order contains the field drawing, but the order is for the drawing beside it.",
    "hint": "Remove the field drawing."
  },
  "watch.taken": {
    "text": "Another process already watches the folder {folder}.",
    "hint": "End the other process, or watch another folder."
  },
  "watch.xjdf-fields": {
    "text": "The JSON file of the XJDF order contains {names}. The XJDF document defines these fields.",
    "hint": "Remove these fields. Only {permitted__or} may be in the file."
  },
  "webhook.bad-url": {
    "text": "The URL of the webhook is not valid: {reason}.",
    "hint": "Use an http or https URL without a user name, such as https://erp.example/hooks."
  },
  "webhook.forbidden-address": {
    "text": "The address {address}, to which the URL of the webhook leads, is not permitted.",
    "hint": "Use the URL of another system. Link-local addresses and addresses of metadata services are never permitted. Private addresses are not permitted if the server runs with --no-webhook-private."
  },
  "webhook.inactive": {
    "text": "The webhook {webhook} is switched off.",
    "hint": "Switch the webhook on, then try again."
  },
  "webhook.too-many": {
    "text": "The server already has {count} webhooks, which is the largest number allowed.",
    "hint": "Delete a webhook that is no longer needed."
  },
  "webhook.unknown": {
    "text": "The webhook {webhook} does not exist.",
    "hint": "Choose an id that GET /api/webhooks lists."
  },
  "webhook.unknown-delivery": {
    "text": "The delivery {delivery} of this webhook does not exist.",
    "hint": "Choose one of the deliveries of the last 30 days, which GET /api/webhooks/ID/deliveries lists."
  },
  "worker.died": {
    "text": "The process that computed the drawing ended unexpectedly (exit code {code}), probably because it used too much memory.",
    "hint": "Send a smaller drawing, or split the drawing into several drawings."
  },
  "worker.memory": {
    "text": "The drawing needs more than the {limit} GB of memory that are allowed for one drawing.",
    "hint": "Send a smaller drawing, or split the drawing into several drawings."
  },
  "worker.timeout": {
    "text": "Processing the drawing took longer than {seconds, number, ::precision-integer} s in the stage {stage}.",
    "hint": "Send a smaller drawing, or split the drawing into several drawings."
  },
  "xjdf.bad-name": {
    "text": "The package contains a file with the unsafe name ''{name}''.",
    "hint": "Use relative names without .., backslashes, colons and control characters."
  },
  "xjdf.bad-package": {
    "text": "The package cannot be read: {reason}.",
    "hint": "Send an unencrypted ZIP file or multipart/related body with one XJDF document and the drawing."
  },
  "xjdf.bad-value": {
    "text": "{place} has the value ''{value}'', which is not supported.",
    "hint": "Use one of the values that the how-to page order-with-xjdf describes."
  },
  "xjdf.foreign-drawing": {
    "text": "The drawing {url} is on another server than {host}, and is not fetched from there.",
    "hint": "Send the drawing in the package, or upload it to this server and name its path."
  },
  "xjdf.many-files": {
    "text": "The package has more than {limit} files.",
    "hint": "Send only the documents of one order and its drawing."
  },
  "xjdf.missing": {
    "text": "The XJDF order lacks {place}.",
    "hint": "Add {place} to the document. Machine and board can also be query parameters of the request."
  },
  "xjdf.nested-parts": {
    "text": "A part of the package contains further parts.",
    "hint": "Send all documents and the drawing as parts of one multipart/related."
  },
  "xjdf.no-file": {
    "text": "The file ''{url}'' is not in the package.",
    "hint": "Send a package that contains it under this name, or upload the drawing and name it as /api/v1/drawings/ID. Files of other servers are not fetched."
  },
  "xjdf.no-parts": {
    "text": "The multipart message has no parts.",
    "hint": "Separate the parts with the boundary that the header Content-Type states."
  },
  "xjdf.not-xjdf": {
    "text": "The root element of the document is {element}.",
    "hint": "Send an element {wanted} of the namespace {namespace}."
  },
  "xjdf.same-names": {
    "text": "Two files of the package have the same name.",
    "hint": "Give each file a different name."
  },
  "xjdf.too-large": {
    "text": "{name} is larger than {limit} MB.",
    "hint": "Send a smaller file."
  },
  "xjdf.twice": {
    "text": "The XJDF order contains several values of {place}.",
    "hint": "Send a separate order for each value."
  },
  "xjdf.unreadable": {
    "text": "The document is not readable as XML: {reason}.",
    "hint": "Send an XJDF or XJMF document without a document type declaration."
  },
  "xjdf.wrong-count": {
    "text": "The package must contain exactly one file {names}, but contains {count}.",
    "hint": "Send a ZIP file or multipart/related body with one XJDF or XJMF document and the drawing."
  },
  "xjmf.many-messages": {
    "text": "The document has more than {limit} messages.",
    "hint": "Send several documents."
  },
  "zone.work": {
    "text": "{tool} (station {station}) would touch the keep-out zone {zone} at X {x, number, ::.0}, Y {y, number, ::.0} mm{place}: the tool with its holder needs {reach, number, ::.0} mm around its axis.",
    "hint": "Move the clamp or stop away from the drawing and correct its zone in the machine file, or move the origin in the machine file so that the drawing lies beside the zone."
  }
} as const satisfies Catalogue;

export const NAMES: Names = {
  "unit": {
    "": "units of the file",
    "mm": "mm",
    "cm": "cm",
    "m": "metres",
    "in": "inches",
    "ft": "feet",
    "pt": "points",
    "px": "pixels",
    "px-90": "pixels of 1/90 inch",
    "mi": "miles",
    "km": "kilometres",
    "uin": "microinches",
    "mil": "mils",
    "yd": "yards",
    "angstrom": "ångströms",
    "nm": "nanometres",
    "um": "micrometres",
    "dm": "decimetres",
    "dam": "decametres",
    "hm": "hectometres",
    "Gm": "gigametres",
    "au": "astronomical units",
    "ly": "light years",
    "pc": "parsecs",
    "survey-ft": "US survey feet",
    "survey-in": "US survey inches",
    "survey-yd": "US survey yards",
    "survey-mi": "US survey miles"
  },
  "tool": {
    "cutter": "cutter",
    "knife": "knife",
    "v-cutter": "V-cutter",
    "wheel": "creasing wheel"
  }
};

export const AND = "and";

export const OR = "or";
