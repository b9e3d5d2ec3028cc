/** English texts and hints of all messages. Written by frontend/catalogue.py: do not edit. */

import type { Catalogue } from "./catalogue";

export const TEXTS = {
  "advice.compiling": {
    "text": "Wait until it is ready.",
    "hint": ""
  },
  "advice.ended": {
    "text": "Order it again.",
    "hint": ""
  },
  "advice.interrupted": {
    "text": "Check the table, then mark the job finished, queue it again or scrap it.",
    "hint": ""
  },
  "advice.of-reason": {
    "text": "{reason:hint}",
    "hint": ""
  },
  "advice.queued": {
    "text": "Wait until its machine has taken it.",
    "hint": ""
  },
  "advice.ready": {
    "text": "Release it first.",
    "hint": ""
  },
  "advice.running": {
    "text": "Hold, resume or cancel it.",
    "hint": ""
  },
  "bridges.no-room": {
    "text": "The contour at edge {edge} is {length:.1f} mm long and has no room for {fewest:# bridge|# bridges} of {gap:.2f} mm that are at most {spacing:.1f} mm apart and away from corners and narrow slots.",
    "hint": "Choose narrower bridges or a larger spacing, or cut this board without bridges."
  },
  "calibration.bad-points": {
    "text": "The {count:# measured point|# measured points} cannot be used: at least one point is needed, and all values must be numbers.",
    "hint": "Measure at least one point on a slanted part of the contour."
  },
  "calibration.choose-cutter": {
    "text": "{machine} has {count:# cutter|# cutters}, so the cutter to calibrate must be named.",
    "hint": "Choose one: {cutters:, }."
  },
  "calibration.missing-column": {
    "text": "Line {line} of {file} has no value for {columns}.",
    "hint": "Write azimuth,dx,dy on the first line and degrees, mm, mm on the others, for example 45,-0.05,0.06."
  },
  "calibration.not-a-number": {
    "text": "Line {line} of {file} has a value that is not a number: {values:, }.",
    "hint": "Write three numbers with decimal points, for example 45,-0.05,0.06."
  },
  "calibration.not-csv": {
    "text": "{file} is not a CSV file: {reason}.",
    "hint": "Save it as CSV in UTF-8."
  },
  "calibration.undetermined": {
    "text": "The contour runs along {along} at every measured point, so the deflection along {other} cannot be determined (the sum of squares is {weight:.4f}, but {least} is needed).",
    "hint": "Measure one more point where the contour runs along {direction}, or at 45°."
  },
  "calibration.wrong-sign": {
    "text": "The measured points mean that the tool is pulled into the board (δx {x:.3f}, δy {y:.3f} mm), which is not possible.",
    "hint": "Check the signs of ΔX and ΔY, and on which side of the contour the tool moves."
  },
  "cf2.cut-short": {
    "text": "The CF2 is cut short: it ends at line {line} inside {inside}, so lines of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again as CF2."
  },
  "cf2.decimal-commas": {
    "text": "Line {line} of the CF2 has {fields} fields instead of {expected} for record {record}. It seems to use decimal commas, but commas separate the fields.",
    "hint": "Export the drawing with decimal points."
  },
  "cf2.empty": {
    "text": "The CF2 contains no drawing: it has neither a MAIN section nor a subroutine.",
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
  "classification.around": {
    "text": "the edge encloses a complete carton",
    "hint": ""
  },
  "classification.arrow": {
    "text": "the edge has an arrowhead, or is connected to a line with an arrowhead",
    "hint": ""
  },
  "classification.as-its-style": {
    "text": "like all edges of this style",
    "hint": ""
  },
  "classification.bleed": {
    "text": "the edge surrounds a blank at a constant distance, as a bleed line does",
    "hint": ""
  },
  "classification.board-ends": {
    "text": ", where the board ends unless the outline is open",
    "hint": ""
  },
  "classification.closes-nothing": {
    "text": " and does not close an outline",
    "hint": ""
  },
  "classification.contradicted": {
    "text": "{rule}; but {reason}",
    "hint": ""
  },
  "classification.convention": {
    "text": "the colours fit the convention \"{name}\": the outline closes, and {folds} of {lines:# dividing line is a fold|# dividing lines are folds}",
    "hint": ""
  },
  "classification.cuts-panel-off": {
    "text": "a cut there would separate a panel from its blank",
    "hint": ""
  },
  "classification.dashed": {
    "text": "they are dashed",
    "hint": ""
  },
  "classification.divider": {
    "text": "the edge divides two panels",
    "hint": ""
  },
  "classification.divides-panels": {
    "text": ", but edges of type {type} divide panels",
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
    "text": "the edge lies inside a hole or divides one",
    "hint": ""
  },
  "classification.layer-denies": {
    "text": "but the name of its layer, \"{layer}\", suggests another line type",
    "hint": ""
  },
  "classification.layer-name": {
    "text": "the name of its layer contains \"{word}\"",
    "hint": ""
  },
  "classification.legend": {
    "text": "the edge lies outside all blanks, beside the name of a line type, so it belongs to a legend",
    "hint": ""
  },
  "classification.letter": {
    "text": "the edge lies in a row of small shapes, as letters do",
    "hint": ""
  },
  "classification.like-outline": {
    "text": "it has the style of the outline",
    "hint": ""
  },
  "classification.like-outline-not-folds": {
    "text": "it has the style of the outline, and the folds have another style",
    "hint": ""
  },
  "classification.linetype-name": {
    "text": "the name of its linetype contains \"{word}\"",
    "hint": ""
  },
  "classification.mark": {
    "text": "the edge closes a shape that is much smaller than the blank",
    "hint": ""
  },
  "classification.mirror-cut": {
    "text": "its mirror image in the drawing is cut",
    "hint": ""
  },
  "classification.mirror-folded": {
    "text": "its mirror image in the drawing is folded",
    "hint": ""
  },
  "classification.mixed": {
    "text": "{reason} (true for most of its length)",
    "hint": ""
  },
  "classification.named": {
    "text": "the name of its layer shows that the edge is not part of the carton, and the outlines close without it",
    "hint": ""
  },
  "classification.no-rule": {
    "text": "no rule of the profile {profile} matches",
    "hint": ""
  },
  "classification.no-rule-but-shape": {
    "text": "no rule of the profile {profile} matches, but {shape}",
    "hint": ""
  },
  "classification.none-closes": {
    "text": ", as all edges of this style do, and none of them closes an outline",
    "hint": ""
  },
  "classification.not-made": {
    "text": ", so no tool must process it",
    "hint": ""
  },
  "classification.on-cut": {
    "text": "{rule}; the edge lies on a cut",
    "hint": ""
  },
  "classification.open": {
    "text": "the edge belongs to an outline that does not close",
    "hint": ""
  },
  "classification.other-style-closes": {
    "text": "edges of another style close most of this outline",
    "hint": ""
  },
  "classification.outline": {
    "text": "the edge closes the outline of a blank",
    "hint": ""
  },
  "classification.override": {
    "text": "set by the user",
    "hint": ""
  },
  "classification.paired": {
    "text": "some of them are parallel pairs",
    "hint": ""
  },
  "classification.panel-hangs": {
    "text": "a panel is connected only by it",
    "hint": ""
  },
  "classification.panels-hang": {
    "text": "most of them connect a panel to the rest of the blank",
    "hint": ""
  },
  "classification.role-against": {
    "text": "{role}{against}",
    "hint": ""
  },
  "classification.rule": {
    "text": "profile {profile}: {rule}",
    "hint": ""
  },
  "classification.shape": {
    "text": "{parts:, }",
    "hint": ""
  },
  "classification.slit": {
    "text": "the edge begins at another edge and ends inside a panel",
    "hint": ""
  },
  "classification.slot": {
    "text": "the edge closes a slot or a round hole in a panel",
    "hint": ""
  },
  "classification.speck": {
    "text": "the edge is short, lies outside all blanks and touches no other edge",
    "hint": ""
  },
  "classification.stray": {
    "text": "the edge lies outside all blanks",
    "hint": ""
  },
  "classification.swapped": {
    "text": "the edges that this rule makes creases close the outline",
    "hint": ""
  },
  "classification.swapped-both": {
    "text": "the edges that this rule makes creases close the outline, and the edges that it makes cuts divide the panels",
    "hint": ""
  },
  "classification.swapped-like": {
    "text": "{reason}; {convention}",
    "hint": ""
  },
  "classification.table": {
    "text": "the edge lies beside a text, as in a title block, a dimension or a label",
    "hint": ""
  },
  "classification.unknown": {
    "text": "the shape of the drawing does not show what the edge is",
    "hint": ""
  },
  "classification.votes": {
    "text": "{votes:; }",
    "hint": ""
  },
  "classification.with-text": {
    "text": "{reason}; a text lies beside it",
    "hint": ""
  },
  "cleaning.as-drawn": {
    "text": "unchanged",
    "hint": ""
  },
  "cleaning.dropped-speck": {
    "text": "dropped: the edge is only {length:.4g} mm long and connects no other edges",
    "hint": ""
  },
  "cleaning.end-moved": {
    "text": "one end was moved by {distance:.2g} mm to meet another edge",
    "hint": ""
  },
  "cleaning.fitted": {
    "text": "the edge was merged: it was part of a curve made of short lines, which became one line or arc",
    "hint": ""
  },
  "cleaning.fitted-edge": {
    "text": "merged: the edge was part of a curve made of short lines, which became one line or arc with edge {edge} (deviation up to {distance:.2g} mm)",
    "hint": ""
  },
  "cleaning.ignored": {
    "text": "the edge has the line type ignored: it is displayed but not processed",
    "hint": ""
  },
  "cleaning.joined": {
    "text": "the edge was merged into another edge on the same line",
    "hint": ""
  },
  "cleaning.joined-edge": {
    "text": "merged into edge {edge}, which lies on the same line",
    "hint": ""
  },
  "cleaning.kept": {
    "text": "kept",
    "hint": ""
  },
  "cleaning.kept-changed": {
    "text": "kept: {changes:; }",
    "hint": ""
  },
  "cleaning.length-on-others": {
    "text": "{length:.4g} mm of its length lie on other edges and were merged",
    "hint": ""
  },
  "cleaning.longer": {
    "text": "other edges on the same line were merged into this edge",
    "hint": ""
  },
  "cleaning.moved": {
    "text": "one end of the edge was moved to meet another edge",
    "hint": ""
  },
  "cleaning.no-work": {
    "text": "unchanged: no tool processes this edge",
    "hint": ""
  },
  "cleaning.on-edge": {
    "text": "merged: the edge lies on edge {edge}",
    "hint": ""
  },
  "cleaning.part-dropped": {
    "text": "a part of {length:.2g} mm was dropped because it is too short to process",
    "hint": ""
  },
  "cleaning.shortened": {
    "text": "a part of the edge lies on other edges and was merged with them",
    "hint": ""
  },
  "cleaning.speck": {
    "text": "the edge is too short to process and connects no other edges",
    "hint": ""
  },
  "cleaning.twice": {
    "text": "the edge lies completely on other edges",
    "hint": ""
  },
  "cleaning.unclassified": {
    "text": "the edge has no line type yet",
    "hint": ""
  },
  "command.bad-corner": {
    "text": "The option --corner-at {text!r} does not have the form X,Y=TYPE or X,Y=TYPE:K.",
    "hint": "Write for example --corner-at 300,100=C or --corner-at 300,100=D:0.3."
  },
  "command.bad-layer": {
    "text": "The option --layer {pair!r} does not have the form NAME=TYPE.",
    "hint": "Write for example --layer FOLDS=crease."
  },
  "command.bad-line-type": {
    "text": "The line type in the option --layer {pair!r} does not exist.",
    "hint": "Choose {known:or}."
  },
  "command.file-too-large": {
    "text": "The file {path} is larger than {limit} MB.",
    "hint": "Export a single carton, without pictures."
  },
  "command.no-such-layer": {
    "text": "The file {file} has no layer {layer!r}.",
    "hint": "Choose one of its layers: {layers:, }."
  },
  "command.unreadable-file": {
    "text": "The file {path} cannot be read: {reason}.",
    "hint": "Check its name and permissions."
  },
  "command.unwritable-file": {
    "text": "The file {path} cannot be written: {reason}.",
    "hint": "Choose another path."
  },
  "controller.alarm": {
    "text": "{name} stopped with ALARM:{code}: {alarm}{due}.",
    "hint": "Check the table and home the machine ($H) before the next job."
  },
  "controller.alarm-code": {
    "text": "ALARM:{code} ({alarm})",
    "hint": ""
  },
  "controller.alarm-state": {
    "text": "{name} reports alarm{due}.",
    "hint": "Check the table, then home it ($H) or unlock it ($X)."
  },
  "controller.alarm-unknown": {
    "text": "an alarm",
    "hint": ""
  },
  "controller.answer-lost": {
    "text": "{name} has reported {state} for {seconds:g} s{due}: an answer was lost on the way.",
    "hint": "Check the cable, then the board."
  },
  "controller.bad-address": {
    "text": "{address!r} is not the address of a controller.",
    "hint": "Write host:port, for example 127.0.0.1:2323."
  },
  "controller.busy": {
    "text": "{name} is busy: it reports {state}.",
    "hint": "Wait until it is idle, or reset it at the table; nothing was sent."
  },
  "controller.check-end-not-confirmed": {
    "text": "{name} did not confirm the end of its check mode within {seconds:g} s.",
    "hint": "Check the table, then try again."
  },
  "controller.closed": {
    "text": "The connection to {name} was closed.",
    "hint": ""
  },
  "controller.connection-failed": {
    "text": "The connection to {address} is lost ({reason}).",
    "hint": "Check the table before anything is sent again."
  },
  "controller.due": {
    "text": "; the answer to line {line} ({text}) is due",
    "hint": ""
  },
  "controller.lift-not-finished": {
    "text": "{name} did not finish its lift within {seconds:g} s.",
    "hint": "Lift the tool and raise the stations at the table."
  },
  "controller.locked": {
    "text": "{name} is locked by {cause}: the stations may still be lowered.",
    "hint": "Lift the tool and raise the stations at the table, then home ($H) or unlock ($X) it."
  },
  "controller.locked-by-alarm": {
    "text": "{name} is locked by an alarm.",
    "hint": "Home it ($H) or unlock it ($X) at the table."
  },
  "controller.lost": {
    "text": "The connection to {name} is lost{due}.",
    "hint": "Check the cable, then the board."
  },
  "controller.lost-in-buffer": {
    "text": "The connection to {name} is lost.",
    "hint": "Check the table: the controller may still execute what is in its buffer."
  },
  "controller.not-in-laser-mode": {
    "text": "{name} is not in laser mode, so a hold would leave the beam on.",
    "hint": "Set $32=1 at the controller and connect again; nothing was sent."
  },
  "controller.not-ready": {
    "text": "{name} is not ready: it reports {state}.",
    "hint": "Wait until it is idle, or unlock it, then send the job again; nothing was sent."
  },
  "controller.not-recovered": {
    "text": "{name} was not brought into its safe state.",
    "hint": ""
  },
  "controller.not-secured": {
    "text": "{name} cannot be brought into its safe state: it reports {state}.",
    "hint": "Lift the tool and raise the stations at the table."
  },
  "controller.not-stopped": {
    "text": "{error} {progress} The machine is not safe: {unsafe}",
    "hint": "{unsafe:hint}"
  },
  "controller.off-path": {
    "text": "The machine was at X{x:.3f} Y{y:.3f} Z{z:.3f}, {distance:.1f} mm off the program's path near line {line}: a line was changed on its way to the controller, or steps were lost.",
    "hint": "Check the cable and home the machine; the board may be spoiled."
  },
  "controller.refused-safe-state": {
    "text": "{refusals: }",
    "hint": "Lift the tool and raise the stations at the table; compare the machine's file with the controller's outputs."
  },
  "controller.rejected-command": {
    "text": "{name} refused {command}: {error} (error:{code}).",
    "hint": "Check the table, then try again."
  },
  "controller.rejected-in-check": {
    "text": "{name} refused line {line} ({text}): {error} (error:{code}).",
    "hint": "Nothing has moved: compile the job again for this controller."
  },
  "controller.rejected-line": {
    "text": "{name} refused line {line} ({text}): {error} (error:{code}).",
    "hint": "Check the board, then compile the job again for this controller."
  },
  "controller.reports-alarm": {
    "text": "{name} reports an alarm.",
    "hint": "Check the table, then home or unlock it."
  },
  "controller.reset": {
    "text": "{name} was reset{due}.",
    "hint": "Check the table and home the machine: its position may be lost. Nothing continues by itself."
  },
  "controller.reset-not-confirmed": {
    "text": "{name} did not confirm its reset within {seconds:g} s.",
    "hint": "Check the table, then try again."
  },
  "controller.silent": {
    "text": "{name} has not answered for {seconds:g} s{due}.",
    "hint": "Check the cable, then the board."
  },
  "controller.stopped": {
    "text": "{error} {progress} The machine was stopped and lifted to Z {height:.1f}, its stations were released.",
    "hint": "{error:hint}"
  },
  "controller.unexpected-answer": {
    "text": "{name} answered a line that was not sent from here: an answer was doubled on the way, or another program sends to the controller.",
    "hint": "Check the cable, and close any other program that sends to it."
  },
  "controller.unreachable": {
    "text": "No controller answers at {address} ({reason}).",
    "hint": "Switch it on, or correct the address."
  },
  "controller.was-reset": {
    "text": "{name} was reset.",
    "hint": ""
  },
  "corner.at": {
    "text": " at ({x:g}, {y:g})",
    "hint": ""
  },
  "corner.bad-interference": {
    "text": "{interference!r} is not a method for places where the cutter does not fit.",
    "hint": "Choose trim or refuse."
  },
  "corner.bad-k": {
    "text": "The parameter k of the corner at the start of edge {edge} is {k}, but must be between 0 and 1.",
    "hint": "Give a k from 0 (as type B) to 1 (as type C)."
  },
  "corner.bad-k-at": {
    "text": "The parameter k of the D corner{where} is {k}, but must be greater than 0 and less than 1.",
    "hint": "Choose type B instead of 0, and type C instead of 1."
  },
  "corner.bad-place": {
    "text": "The position ({x}, {y}) of a corner is not valid.",
    "hint": "Give X and Y in mm of the drawing."
  },
  "corner.bad-share": {
    "text": "Corner {corner} has type D with the parameter k = {k}, which must be between 0 and 1.",
    "hint": "Give a k from 0 (as type B) to 1 (as type C)."
  },
  "corner.inside": {
    "text": "The corner at ({x:g}, {y:g}) is an inside corner, for which no corner type can be chosen.",
    "hint": "Choose corner types only for outside corners."
  },
  "corner.no-contour": {
    "text": "No corner of a milled contour lies within {within:g} mm of ({x:g}, {y:g}), because the drawing has no contour that is milled around outside corners.",
    "hint": "Leave the corner types out for this drawing."
  },
  "corner.no-cutter": {
    "text": "Corner types were chosen, but {machine} has no rotating cutter.",
    "hint": "Leave the corner types out, or choose a machine with a rotating cutter."
  },
  "corner.not-found": {
    "text": "No corner of a milled contour lies within {within:g} mm of ({x:g}, {y:g}); the nearest corner is {distance:.2f} mm away.",
    "hint": "Give X and Y of a corner in mm of the drawing; the nearest are {known:, }."
  },
  "corner.unknown-number": {
    "text": "Corner {corner} has the type {type}, which does not exist.",
    "hint": "Choose type B, C or D."
  },
  "corner.unknown-type": {
    "text": "The corner type {type!r} does not exist.",
    "hint": "Choose B, C, D or auto."
  },
  "corner.unknown-type-at": {
    "text": "The corner type {type!r}{where} does not exist.",
    "hint": "Choose B, C, D or auto."
  },
  "crease.tight-bend": {
    "text": "The double crease at edge {edge} is bent with a radius of {radius:.2f} mm, which is too small for a second line {offset:.2f} mm inside it.",
    "hint": "Draw a wider bend, or set the double crease of the board to 0."
  },
  "crease.too-short": {
    "text": "The crease at edge {edge} is {length:.2f} mm long, which is too short for a wheel of {radius:.1f} mm radius that ends {clearance:.2f} mm before both ends.",
    "hint": "Join it to a collinear crease, set it to ignored, or choose a board on which short creases are pressed."
  },
  "curve.bad-ellipse": {
    "text": "An ellipse has no size, or its start or end angle is not a number.",
    "hint": "Draw the ellipse again."
  },
  "curve.bad-spline": {
    "text": "A spline of degree {degree} with {points} control points and {knots} knots is damaged.",
    "hint": "Draw the spline again, or export it as lines and arcs."
  },
  "curve.bad-tolerance": {
    "text": "Curves cannot be converted with a tolerance of {tolerance} mm.",
    "hint": "Give a tolerance greater than 0."
  },
  "curve.not-finite": {
    "text": "A point of a curve is not a number.",
    "hint": "Draw the curve again, as lines and arcs."
  },
  "curve.not-fitted": {
    "text": "A curve cannot be converted to lines and arcs within {tolerance:g} mm.",
    "hint": "Draw the curve again, as lines and arcs."
  },
  "curve.parameters": {
    "text": "The parameters of a curve do not increase.",
    "hint": "Draw the curve again, as lines and arcs."
  },
  "curve.too-many-pieces": {
    "text": "A curve needs more than {limit:,} lines and arcs to stay within {tolerance:g} mm.",
    "hint": "Increase the tolerance, or simplify the curve."
  },
  "curve.too-many-spans": {
    "text": "A spline has {spans:,} spans; the limit is {limit:,}.",
    "hint": "Simplify the curve before exporting."
  },
  "cut.too-many-crossings": {
    "text": "More than {limit:,} pairs of cuts cross or lie beside each other.",
    "hint": "Delete hatching and duplicate lines, or split the drawing."
  },
  "cut.too-short": {
    "text": "The cut at edge {edge} is {length:.2f} mm long and ends inside a panel or at a bridge, but the slanted blade needs {lead:.2f} mm.",
    "hint": "Set it to ignored, join it to another cut, or choose a steeper blade."
  },
  "cutter.does-not-fit": {
    "text": "The cutter of {diameter:.2f} mm diameter does not fit into the contour at edge {edge}, nor into {others:# other contour|# other contours}.",
    "hint": "Choose a thinner cutter, or set the contours to ignored."
  },
  "cutter.misses-bridge": {
    "text": "The cutter does not reach the contour at edge {edge}, {distance:.1f} mm along it, where a bridge is needed.",
    "hint": "Choose a thinner cutter, another spacing of bridges, or a board without bridges."
  },
  "cutter.short-lead": {
    "text": "The lead-in of the cutter is {lead:g} mm long, but must be longer than its radius of {radius:g} mm.",
    "hint": "Correct the lead in the machine file."
  },
  "database.bad-url": {
    "text": "{url!r} is not the URL of a database.",
    "hint": "Write sqlite:///FILE or postgresql://USER@HOST/NAME."
  },
  "database.in-memory": {
    "text": "A database in memory cannot be used, because its jobs would be lost when the server stops.",
    "hint": "Name a file: sqlite:///FILE."
  },
  "deflection.arc-too-small": {
    "text": "Near ({x:.2f}, {y:.2f}) the centre of the cutter moves on an arc of {radius:.3f} mm radius, which is too small to correct a deflection of {deflection:.3f} mm.",
    "hint": "Choose a smaller k or corner type B, or measure the deflection again."
  },
  "deflection.path-too-short": {
    "text": "Near ({x:.2f}, {y:.2f}) the path of the centre of the cutter is too short or turns too sharply to correct the deflection.",
    "hint": "Join short edges there, or measure the deflection again."
  },
  "drawing.changing": {
    "text": "Another request is changing drawing {drawing} at the same time.",
    "hint": "Try again in a moment."
  },
  "drawing.deleted": {
    "text": "Deleted.",
    "hint": ""
  },
  "drawing.in-use": {
    "text": "Drawing {drawing} cannot be deleted, because job {job} was made from it.",
    "hint": "Delete only drawings without jobs."
  },
  "drawing.larger-than-table": {
    "text": "The drawing measures {width:.1f} × {height:.1f} mm, but the table of {machine} has only {room_x:.0f} × {room_y:.0f} mm.",
    "hint": "Check the unit of the drawing, turn it, or choose a larger machine."
  },
  "drawing.open-questions": {
    "text": "{count:# question|# questions} about the drawing must be answered first: {questions: }",
    "hint": "Answer them on the page of the drawing; edges without an answer are not cut."
  },
  "drawing.read": {
    "text": "Read from {name}.",
    "hint": ""
  },
  "drawing.reinterpreted": {
    "text": "Unit: {unit:unit}, profile: {profile}.",
    "hint": ""
  },
  "drawing.stale": {
    "text": "Drawing {drawing} was changed since it was read: it is at revision {revision}, but the request names revision {named}.",
    "hint": "Read the drawing again, check it, and repeat the request."
  },
  "drawing.types-set": {
    "text": "{count:# line type was|# line types were} set.",
    "hint": ""
  },
  "drawing.unit-for-cleaning": {
    "text": "The drawing has no unit, so the lengths of short edges and gaps cannot be compared with the limits in mm.",
    "hint": "Set the unit on the page, or with PATCH /api/drawings/ID."
  },
  "drawing.unit-unknown": {
    "text": "The unit of the drawing is not known ({evidence}).",
    "hint": "Set the unit on the page, with --unit, or with PATCH /api/drawings/ID."
  },
  "drawing.unknown": {
    "text": "Drawing {drawing} does not exist.",
    "hint": "Go back to the list of drawings and open one of them; it may have been deleted."
  },
  "drawing.upload-too-large": {
    "text": "{name} is larger than {limit} MB.",
    "hint": "Send a smaller file."
  },
  "dxf.at-line": {
    "text": "at line {line}",
    "hint": ""
  },
  "dxf.blocks-expand-too-far": {
    "text": "The blocks of the DXF expand to {count} entities; the limit is {limit:,}.",
    "hint": "Export a single carton, or explode the blocks and delete the copies."
  },
  "dxf.blocks-too-deep": {
    "text": "The blocks of the DXF are nested {depth} levels deep; the limit is {limit}.",
    "hint": "Explode the blocks in the CAD program and export again."
  },
  "dxf.cut-short": {
    "text": "The DXF is cut short: it ends {where} in section {section}, after {count:# entity|# entities}, so lines of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again."
  },
  "dxf.no-section": {
    "text": "The file is not a DXF: it has no section.",
    "hint": "Export the drawing as DXF (text or binary, any version)."
  },
  "dxf.not-a-group-code": {
    "text": "The file is not a DXF: line {line} is {text!r} instead of a group code.",
    "hint": "Export the drawing as DXF (text or binary, any version)."
  },
  "dxf.other-kind": {
    "text": "The file is {kind}, not a DXF.",
    "hint": "Export the drawing as DXF (text or binary, any version)."
  },
  "dxf.too-large-unusual": {
    "text": "The DXF has {size:.1f} MB and uses features that take long to read; the limit for such files is {limit:.1f} MB.",
    "hint": "Export a single carton, or save it as DXF R2000."
  },
  "dxf.without-end-mark": {
    "text": "without its end mark (EOF)",
    "hint": ""
  },
  "edge.no-length": {
    "text": "Edge {edges:, } has no length, so its direction is not defined.",
    "hint": "Delete the edge from the drawing."
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
    "text": "More than {limit:,} pairs of line ends lie closer together than {distance} mm.",
    "hint": "Delete edges that are drawn many times on top of each other."
  },
  "edge.too-far": {
    "text": "Edge {edge} lies {distance:.3g} mm from the origin of the drawing.",
    "hint": "Check the unit of the drawing, or delete the edge."
  },
  "edge.too-many-overlaps": {
    "text": "{edges:,} edges overlap each other in more than {limit:,} places.",
    "hint": "Delete edges that are drawn many times on top of each other."
  },
  "error.at-edge": {
    "text": "{error} Object: handle {handle}, layer \"{layer}\".",
    "hint": "{error:hint}"
  },
  "error.at-edges": {
    "text": "Edges {edges: and }: {error}",
    "hint": "{error:hint}"
  },
  "error.in-file": {
    "text": "{name}: {error}",
    "hint": "{error:hint}"
  },
  "field.above": {
    "text": "{path} is {value}, but must be at most {limit:g}",
    "hint": ""
  },
  "field.below": {
    "text": "{path} is {value}, but must be at least {limit:g}",
    "hint": ""
  },
  "field.blank": {
    "text": "{path} is empty",
    "hint": ""
  },
  "field.inconsistent": {
    "text": "{path} is inconsistent: {fault}",
    "hint": ""
  },
  "field.missing": {
    "text": "{path} is missing",
    "hint": ""
  },
  "field.misspelt": {
    "text": "{path} is not a field; did you mean {near}?",
    "hint": ""
  },
  "field.no-kind": {
    "text": "{path} has no field {field}",
    "hint": ""
  },
  "field.not-a-colour": {
    "text": "{path} is {value}, but must be a whole number from 1 to 255 or \"#rrggbb\"",
    "hint": ""
  },
  "field.not-a-line-type": {
    "text": "{path} is {value!r}, but must be a line type: {known:or}",
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
    "text": "{path} is {value!r}, but must be a profile of the library: {known:or}",
    "hint": ""
  },
  "field.not-a-table": {
    "text": "{path} is {value}, but must be a table",
    "hint": ""
  },
  "field.not-above": {
    "text": "{path} is {value}, but must be greater than {limit:g}",
    "hint": ""
  },
  "field.not-above-low": {
    "text": "{path} is {value:g}, but must be greater than low, which is {low:g}",
    "hint": ""
  },
  "field.not-allowed": {
    "text": "{path} is {value}, but must be {allowed}",
    "hint": ""
  },
  "field.not-below": {
    "text": "{path} is {value}, but must be less than {limit:g}",
    "hint": ""
  },
  "field.not-boolean": {
    "text": "{path} is {value}, but must be true or false",
    "hint": ""
  },
  "field.not-less-than-caliper": {
    "text": "{path} is {value:g} mm, but must be less than the caliper of {caliper:g} mm",
    "hint": ""
  },
  "field.not-one-of": {
    "text": "{path} is {value}, but must be {known:or}",
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
    "text": "{path} is invalid: {reason}",
    "hint": ""
  },
  "field.repeated-numbers": {
    "text": "{path} contains the numbers {numbers:, }, but no number may occur twice",
    "hint": ""
  },
  "field.spacing": {
    "text": "{path} is {value:g} mm, but must be 0 or at least {least:g} mm",
    "hint": ""
  },
  "field.too-few": {
    "text": "{path} has {count:# value|# values}, but needs at least {least}",
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
    "text": "{path} is {value:g} mm, which needs more than {most} passes",
    "hint": ""
  },
  "field.unknown": {
    "text": "{path} is not a field",
    "hint": ""
  },
  "field.unknown-kind": {
    "text": "{path} has the unknown kind {value!r}; known kinds are {known}",
    "hint": ""
  },
  "finding.at-edge": {
    "text": "Edge {edge}: {fault}",
    "hint": "{fault:hint}"
  },
  "finding.at-edge-and-line": {
    "text": "Edge {edge}, line {line}: {fault}",
    "hint": "{fault:hint}"
  },
  "finding.at-line": {
    "text": "Line {line}: {fault}",
    "hint": "{fault:hint}"
  },
  "finding.more": {
    "text": " {count:# more finding is|# more findings are} not listed.",
    "hint": ""
  },
  "gateway.cancelled": {
    "text": "Cancelled by the operator at line {line}.",
    "hint": ""
  },
  "gateway.controller-not-idle": {
    "text": "{name} is not idle: it reports {state}.",
    "hint": "Wait until it is idle, or reset it at the table."
  },
  "gateway.job-withdrawn": {
    "text": "The server took the job back; the machine was stopped.",
    "hint": ""
  },
  "gateway.job-withdrawn-before-start": {
    "text": "The server took the job back before its start; nothing was sent to the machine.",
    "hint": ""
  },
  "gateway.no-reason": {
    "text": "The gateway ended the job and stated no reason.",
    "hint": ""
  },
  "gateway.switched-off": {
    "text": "The gateway was switched off.",
    "hint": ""
  },
  "gateway.switched-off-before-report": {
    "text": "The gateway was switched off before it could report.",
    "hint": ""
  },
  "gateway.switched-off-in-run": {
    "text": "The gateway was switched off; the machine was stopped.",
    "hint": ""
  },
  "gateway.system-error": {
    "text": "The operating system of the gateway reports: {reason}.",
    "hint": ""
  },
  "grbl.alarm-1": {
    "text": "a limit switch was hit; its position is lost",
    "hint": ""
  },
  "grbl.alarm-10": {
    "text": "an emergency stop is pressed",
    "hint": ""
  },
  "grbl.alarm-11": {
    "text": "it must be homed first",
    "hint": ""
  },
  "grbl.alarm-12": {
    "text": "a limit switch is closed",
    "hint": ""
  },
  "grbl.alarm-14": {
    "text": "the spindle did not reach its speed",
    "hint": ""
  },
  "grbl.alarm-17": {
    "text": "a motor driver reports a fault",
    "hint": ""
  },
  "grbl.alarm-2": {
    "text": "a move would have left the travel of the machine",
    "hint": ""
  },
  "grbl.alarm-3": {
    "text": "it was reset while moving; its position may be lost",
    "hint": ""
  },
  "grbl.alarm-4": {
    "text": "the probe was not in the expected state",
    "hint": ""
  },
  "grbl.alarm-5": {
    "text": "the probe did not touch",
    "hint": ""
  },
  "grbl.alarm-6": {
    "text": "homing was reset",
    "hint": ""
  },
  "grbl.alarm-7": {
    "text": "the door was opened during homing",
    "hint": ""
  },
  "grbl.alarm-8": {
    "text": "homing could not leave the limit switch",
    "hint": ""
  },
  "grbl.alarm-9": {
    "text": "homing did not find the limit switch",
    "hint": ""
  },
  "grbl.error-1": {
    "text": "a word without its letter",
    "hint": ""
  },
  "grbl.error-10": {
    "text": "soft limits need homing",
    "hint": ""
  },
  "grbl.error-11": {
    "text": "the line is too long",
    "hint": ""
  },
  "grbl.error-12": {
    "text": "a setting beyond its step rate",
    "hint": ""
  },
  "grbl.error-13": {
    "text": "a safety door is open",
    "hint": ""
  },
  "grbl.error-14": {
    "text": "its stored build line is too long",
    "hint": ""
  },
  "grbl.error-15": {
    "text": "a jog beyond the travel",
    "hint": ""
  },
  "grbl.error-16": {
    "text": "a jog without a feed, or with a word that has no place in it",
    "hint": ""
  },
  "grbl.error-17": {
    "text": "laser mode without a variable output",
    "hint": ""
  },
  "grbl.error-18": {
    "text": "it was reset and waits",
    "hint": ""
  },
  "grbl.error-2": {
    "text": "a number that cannot be read",
    "hint": ""
  },
  "grbl.error-20": {
    "text": "a command that it does not know",
    "hint": ""
  },
  "grbl.error-21": {
    "text": "two commands of one modal group in a line",
    "hint": ""
  },
  "grbl.error-22": {
    "text": "no feed has been set",
    "hint": ""
  },
  "grbl.error-23": {
    "text": "a command that must be a whole number is not",
    "hint": ""
  },
  "grbl.error-24": {
    "text": "two commands in a line want the axis words",
    "hint": ""
  },
  "grbl.error-25": {
    "text": "a word twice in a line",
    "hint": ""
  },
  "grbl.error-26": {
    "text": "a command without the axis words that it needs",
    "hint": ""
  },
  "grbl.error-27": {
    "text": "a line number out of range",
    "hint": ""
  },
  "grbl.error-28": {
    "text": "a command without its P or L word",
    "hint": ""
  },
  "grbl.error-29": {
    "text": "a work offset that it does not have",
    "hint": ""
  },
  "grbl.error-3": {
    "text": "a $ command that it does not know",
    "hint": ""
  },
  "grbl.error-30": {
    "text": "G53 without G0 or G1",
    "hint": ""
  },
  "grbl.error-31": {
    "text": "axis words that no command uses",
    "hint": ""
  },
  "grbl.error-32": {
    "text": "an arc without axis words in its plane",
    "hint": ""
  },
  "grbl.error-33": {
    "text": "an arc whose ends do not lie on one circle",
    "hint": ""
  },
  "grbl.error-34": {
    "text": "an arc whose radius cannot be worked out",
    "hint": ""
  },
  "grbl.error-35": {
    "text": "an arc without I and J",
    "hint": ""
  },
  "grbl.error-36": {
    "text": "words that no command uses",
    "hint": ""
  },
  "grbl.error-37": {
    "text": "a tool length offset on the wrong axis",
    "hint": ""
  },
  "grbl.error-38": {
    "text": "a tool number that is too high",
    "hint": ""
  },
  "grbl.error-39": {
    "text": "a value out of range",
    "hint": ""
  },
  "grbl.error-4": {
    "text": "a negative value where none may be",
    "hint": ""
  },
  "grbl.error-5": {
    "text": "homing is switched off in its settings",
    "hint": ""
  },
  "grbl.error-6": {
    "text": "a step pulse that is too short",
    "hint": ""
  },
  "grbl.error-60": {
    "text": "its memory card could not be opened",
    "hint": ""
  },
  "grbl.error-7": {
    "text": "its settings could not be read and were set to defaults",
    "hint": ""
  },
  "grbl.error-79": {
    "text": "an emergency stop is pressed",
    "hint": ""
  },
  "grbl.error-8": {
    "text": "this is possible only while it is idle",
    "hint": ""
  },
  "grbl.error-9": {
    "text": "it is locked by an alarm or jogs",
    "hint": ""
  },
  "grbl.unknown-alarm": {
    "text": "an alarm without a published meaning",
    "hint": ""
  },
  "grbl.unknown-error": {
    "text": "an error without a published meaning",
    "hint": ""
  },
  "groove.along-edge": {
    "text": "The V-groove at edge {edge} meets the edge of the board at only {angle:.1f}°, so its flanks would not leave the board.",
    "hint": "End the groove before the edge of the board, or let it meet the edge at 5° or more."
  },
  "groove.curved": {
    "text": "{count:# V-groove is an arc|# V-grooves are arcs} (first: edge {edge}), which a straight blade cannot follow.",
    "hint": "Draw straight lines, or choose another line type."
  },
  "groove.overcut": {
    "text": "The V-cutter cuts {overrun:.2f} mm beyond each end of a groove inside the board, but the board allows {allowed:.2f} mm.",
    "hint": "Choose a narrower blade, or allow a longer overcut for this board."
  },
  "groove.runs-out": {
    "text": "The V-groove at edge {edge} would continue {distance:.2f} mm beyond the edge of the board and cut into the next part.",
    "hint": "End the groove before the edge, let it meet the edge at a larger angle, or move the parts apart."
  },
  "groove.through-cut": {
    "text": "The V-groove at edge {groove} is {width:.2f} mm wide at the top face. {place:.1f} mm from its start, its flank extends {through:.2f} mm beyond the cut at edge {cut}, which lies {distance:.2f} mm beside it.",
    "hint": "Move the groove and the cut {through:.2f} mm further apart, or make the groove less deep."
  },
  "groove.through-cut-at-it": {
    "text": "The V-groove at edge {groove} is {width:.2f} mm wide at the top face. {place:.1f} mm from its start, its flank extends {through:.2f} mm beyond the cut at edge {cut}, which lies {distance:.2f} mm beside it.",
    "hint": "End the groove at the cut, or move one of them."
  },
  "groove.tight-bend": {
    "text": "The V-groove at edge {edge} is bent with a radius of {radius:.1f} mm, from which a blade of {blade:.2f} mm deviates by more than {error:.3f} mm.",
    "hint": "Draw a wider bend, choose a narrower blade, or allow a larger deviation for this board."
  },
  "groove.too-deep": {
    "text": "The V-groove at edge {edge} is {depth:.2f} mm deep, but the board is only {caliper:.2f} mm thick.",
    "hint": "Choose a shallower groove or a thicker board."
  },
  "groove.too-short": {
    "text": "The V-groove at edge {edge} is {length:.2f} mm long, but the blade is {blade:.2f} mm wide.",
    "hint": "Draw a longer groove, or choose a narrower blade."
  },
  "hpgl.bad-byte": {
    "text": "The byte {byte} is not allowed here.",
    "hint": "Remove it."
  },
  "hpgl.bad-feed": {
    "text": "{place} has a feed of {feed:g} mm/min, but {device} supports only whole cm/s from {slowest} to {fastest}.",
    "hint": "Give the tool a feed that is a multiple of {step:g} mm/min."
  },
  "hpgl.bad-number": {
    "text": "A sign is not followed by a number, or a number has too many digits.",
    "hint": "Correct the number."
  },
  "hpgl.depth-change": {
    "text": "{place} changes its depth while it cuts, which HPGL cannot express.",
    "hint": "Choose a board and a tool that need only one pass."
  },
  "hpgl.ends-down": {
    "text": "The program ends while the tool is down.",
    "hint": "Lift the tool (PU) before the end."
  },
  "hpgl.ends-with-pen": {
    "text": "The program ends without putting the tool away.",
    "hint": "Add SP0 before the end."
  },
  "hpgl.force-out-of-range": {
    "text": "The force (FS) is not between {low} and {high}.",
    "hint": "Give a force in this range."
  },
  "hpgl.initialised-again": {
    "text": "The device is initialised (IN) a second time.",
    "hint": "Delete the second IN."
  },
  "hpgl.lone-letter": {
    "text": "A single letter is not an instruction; instructions have two letters.",
    "hint": "Correct the instruction."
  },
  "hpgl.loose-number": {
    "text": "A number does not follow an instruction.",
    "hint": "Delete the number, or add the instruction before it."
  },
  "hpgl.moves-before-pa": {
    "text": "The line moves before the program has chosen absolute coordinates.",
    "hint": "Write PA before the first move."
  },
  "hpgl.needs-no-number": {
    "text": "The instruction does not take a number.",
    "hint": "Delete the number."
  },
  "hpgl.needs-one-number": {
    "text": "The instruction needs exactly one number.",
    "hint": "Give one number."
  },
  "hpgl.never-down": {
    "text": "The toolpath never lowers a tool, so nothing would be cut.",
    "hint": "Give at least one edge a line type for which the machine has a tool."
  },
  "hpgl.no-approach": {
    "text": "{place} starts a cut before a rapid move has reached its start.",
    "hint": "Report it as an internal error with the drawing."
  },
  "hpgl.no-device": {
    "text": "The file of {machine} does not describe an HPGL device.",
    "hint": "Describe it under [controller] in the machine file."
  },
  "hpgl.no-force-setting": {
    "text": "The device has no force setting, so it does not understand FS.",
    "hint": "Remove FS."
  },
  "hpgl.no-instruction": {
    "text": "The program has no instruction.",
    "hint": "Choose an HPGL program."
  },
  "hpgl.no-pen": {
    "text": "The file of {machine} assigns no pen to {work} with station {station}.",
    "hint": "Add a [[controller.pen]] to the machine file."
  },
  "hpgl.no-pen-selected": {
    "text": "The line lowers the tool, but no pen is selected.",
    "hint": "Select a pen (SP) before it."
  },
  "hpgl.no-speed": {
    "text": "The line cuts, but no speed has been set.",
    "hint": "Set the speed (VS) before it."
  },
  "hpgl.no-speed-setting": {
    "text": "The device has no speed setting, so it does not understand VS.",
    "hint": "Remove VS."
  },
  "hpgl.no-terminator": {
    "text": "The last instruction of the program has no semicolon.",
    "hint": "Add the semicolon, or send the complete program."
  },
  "hpgl.not-initialised": {
    "text": "The first instruction of the program is not IN.",
    "hint": "Begin the program with IN."
  },
  "hpgl.outside-area": {
    "text": "The line moves outside the area of the device.",
    "hint": "Move the drawing on the table."
  },
  "hpgl.plunge-without-move": {
    "text": "The line lowers the tool without a move, so the direction of the tool is not known.",
    "hint": "Add a move after PD."
  },
  "hpgl.press": {
    "text": "{place} presses the tool into the board at one point, but HPGL cannot turn the tool there.",
    "hint": "Choose a board with short_crease = \"refuse\", or another machine."
  },
  "hpgl.selects-while-down": {
    "text": "The line selects a pen while the tool is down.",
    "hint": "Lift the tool first (PU)."
  },
  "hpgl.slanted-plunge": {
    "text": "{place} lowers or lifts the tool along a slope, which HPGL cannot express.",
    "hint": "Choose a tool that moves straight down."
  },
  "hpgl.speed-out-of-range": {
    "text": "The speed (VS) is not between {low} and {high}.",
    "hint": "Give a speed in this range."
  },
  "hpgl.swivel": {
    "text": "{place} turns the head about the tip of the knife, which HPGL cannot express.",
    "hint": "Set the trail of the knife to 0 in the machine file; the device compensates for it."
  },
  "hpgl.turn-in-board": {
    "text": "The tool turns by {degrees:.2f}° while it is in the board; at most {most:.2f}° is allowed.",
    "hint": "Lift the tool before the corner."
  },
  "hpgl.unknown-instruction": {
    "text": "The instruction {name} is not supported.",
    "hint": "Remove it."
  },
  "hpgl.unknown-pen": {
    "text": "The device does not have this pen.",
    "hint": "Select a pen of the machine file."
  },
  "hpgl.wrong-force": {
    "text": "The line lowers pen {pen} with a force that is not the force of this pen (FS{force}).",
    "hint": "Set FS{force} before it."
  },
  "hpgl.x-without-y": {
    "text": "A coordinate X is not followed by Y.",
    "hint": "Give both coordinates."
  },
  "import.angles-not-numbers": {
    "text": "the angles of the arc are not numbers",
    "hint": ""
  },
  "import.annotations": {
    "text": "{count:# note or form field|# notes and form fields} on the page: not cut",
    "hint": ""
  },
  "import.area-outline": {
    "text": "outline of a filled area, because the drawing has no lines",
    "hint": ""
  },
  "import.area-outline-on-page": {
    "text": "outline of a filled area, because the page has no lines",
    "hint": ""
  },
  "import.array": {
    "text": "a grid of copies ({columns} columns × {rows} rows)",
    "hint": ""
  },
  "import.bad-operands": {
    "text": "the PDF operator {operator!r} has invalid operands",
    "hint": ""
  },
  "import.bad-path-data": {
    "text": "the path data of the object is invalid at character {character} ({text!r}); the path was read up to there, as browsers do",
    "hint": ""
  },
  "import.bad-place": {
    "text": "the position of the object cannot be read: {reason}",
    "hint": ""
  },
  "import.bad-points": {
    "text": "the points of the object cannot be read: {points!r}",
    "hint": ""
  },
  "import.bad-radius": {
    "text": "the radius is {radius:g}, but must be greater than 0",
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
    "text": "{value!r} is not a length",
    "hint": ""
  },
  "import.bad-window": {
    "text": "the position or size of the nested drawing cannot be read: {reason}",
    "hint": ""
  },
  "import.block-external": {
    "text": "the block {block!r} is in another file",
    "hint": "Bind the external reference in the CAD program and export again."
  },
  "import.block-in-itself": {
    "text": "the block {block!r} contains itself",
    "hint": ""
  },
  "import.block-missing": {
    "text": "the block {block!r} is not in the file",
    "hint": ""
  },
  "import.bridge": {
    "text": "the rule in the die has 1 bridge of {width:g} (file units)",
    "hint": ""
  },
  "import.bridges": {
    "text": "the rule in the die has {bridges:g} bridges of {width:g} (file units)",
    "hint": ""
  },
  "import.clip-path": {
    "text": "the object is only a clipping path",
    "hint": ""
  },
  "import.contains-itself": {
    "text": "the object contains itself",
    "hint": ""
  },
  "import.coordinate-not-a-number": {
    "text": "a coordinate of the object is not a number",
    "hint": ""
  },
  "import.curves-fitted": {
    "text": "its curves became {pieces:# line or arc|# lines and arcs}, which deviate by at most {tolerance:.2g} file units",
    "hint": ""
  },
  "import.curves-fitted-relative": {
    "text": "its curves became {pieces:# line or arc|# lines and arcs}, which deviate by at most {tolerance:.2g} file units (1/250,000 of the size of the drawing)",
    "hint": ""
  },
  "import.damaged": {
    "text": "the object is damaged: {reason}",
    "hint": ""
  },
  "import.damaged-or-frame": {
    "text": "the object is damaged, or is only the frame of a text",
    "hint": ""
  },
  "import.dimension": {
    "text": "dimensions and notes are not cut",
    "hint": ""
  },
  "import.drawn-twice": {
    "text": "the object is drawn twice: it lies exactly on {same:, }",
    "hint": ""
  },
  "import.drawn-twice-often": {
    "text": "the object is drawn several times: it lies exactly on {same:, } and {more} more",
    "hint": ""
  },
  "import.empty-path": {
    "text": "the path of the object is empty",
    "hint": ""
  },
  "import.end-mark": {
    "text": "the object only marks the end of a list",
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
    "text": "the polyline has {vertices:# vertex|# vertices}, but needs at least 2",
    "hint": ""
  },
  "import.filled-area": {
    "text": "the object is a filled area without a line",
    "hint": ""
  },
  "import.filled-area-beside-strokes": {
    "text": "the object is a filled area without a line, and the drawing has lines",
    "hint": ""
  },
  "import.filled-area-on-page": {
    "text": "the object is a filled area without a line, and the page has lines",
    "hint": ""
  },
  "import.fit-points": {
    "text": "the curve was drawn through its fit points",
    "hint": ""
  },
  "import.font-shape": {
    "text": "the object is a shape from a font file, which cannot be read",
    "hint": "Explode it into lines in the CAD program and export again."
  },
  "import.height-not-a-number": {
    "text": "the height (z) of the object is not a number",
    "hint": ""
  },
  "import.height-too-far": {
    "text": "the height (z) of the object is {height:g}; the limit is {limit:g}",
    "hint": ""
  },
  "import.hidden": {
    "text": "the object is hidden",
    "hint": ""
  },
  "import.hidden-layer": {
    "text": "the object is hidden, because the layer {layer} is switched off",
    "hint": "Switch the layer on and export again if the object must be cut."
  },
  "import.image": {
    "text": "images are not cut",
    "hint": ""
  },
  "import.incomplete": {
    "text": "the object is incomplete: its {part} is missing",
    "hint": ""
  },
  "import.interrupted-path": {
    "text": "the path is never painted, because another object starts before",
    "hint": ""
  },
  "import.invisible": {
    "text": "the object is marked as invisible",
    "hint": ""
  },
  "import.kept": {
    "text": "kept",
    "hint": ""
  },
  "import.kept-changed": {
    "text": "kept: {notes:; }",
    "hint": ""
  },
  "import.laid-flat": {
    "text": "moved from the height z = {height:g} to z = 0",
    "hint": ""
  },
  "import.layer-frozen": {
    "text": "the layer of the object is frozen",
    "hint": "Thaw the layer and export again if the object must be cut."
  },
  "import.layer-not-plotted": {
    "text": "the layer of the object is not plotted",
    "hint": "Set the layer to be plotted and export again if the object must be cut."
  },
  "import.layer-off": {
    "text": "the layer of the object is switched off",
    "hint": "Switch the layer on and export again if the object must be cut."
  },
  "import.light": {
    "text": "lights are not cut",
    "hint": ""
  },
  "import.line-not-numbers": {
    "text": "the values of line {line} are not all numbers: {values:, }",
    "hint": ""
  },
  "import.lone-vertex": {
    "text": "the vertex does not belong to a polyline",
    "hint": ""
  },
  "import.mesh": {
    "text": "the object is a three-dimensional mesh, not a flat line",
    "hint": ""
  },
  "import.missing-id": {
    "text": "no object has the id {id!r}, to which this object refers",
    "hint": ""
  },
  "import.missing-subroutine": {
    "text": "the subroutine {name} does not exist",
    "hint": ""
  },
  "import.multiple-line": {
    "text": "multilines cannot be read",
    "hint": "Explode it into lines in the CAD program and export again."
  },
  "import.no-length": {
    "text": "the object has no length ({length:g})",
    "hint": ""
  },
  "import.no-major-axis": {
    "text": "the major axis of the ellipse has a length of 0",
    "hint": ""
  },
  "import.no-paint": {
    "text": "the object has neither a line nor a fill",
    "hint": ""
  },
  "import.no-parameter-range": {
    "text": "the object has no length: it starts and ends at parameter {parameter:g}",
    "hint": ""
  },
  "import.no-points": {
    "text": "the object has no points",
    "hint": ""
  },
  "import.no-scale": {
    "text": "the object is scaled by {x:g} × {y:g}, so it has no size",
    "hint": ""
  },
  "import.no-size": {
    "text": "the object has no size: its width is {width:g} and its height {height:g}",
    "hint": ""
  },
  "import.no-sweep": {
    "text": "the arc has no length: it starts and ends at {degrees:g}°",
    "hint": ""
  },
  "import.not-a-line": {
    "text": "objects of type {kind} cannot be read",
    "hint": ""
  },
  "import.not-clipped": {
    "text": "the object is imported completely, although the file shows only a part of it",
    "hint": ""
  },
  "import.not-flat": {
    "text": "the object is not flat",
    "hint": ""
  },
  "import.not-numbers": {
    "text": "its coordinates are not all numbers: {values:, }",
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
    "text": "the PDF has no form or image with the name {name!r}",
    "hint": ""
  },
  "import.on-layer": {
    "text": "on the layer {layer}",
    "hint": ""
  },
  "import.other-file": {
    "text": "the object is in another file, {file!r}, which is not loaded",
    "hint": "Embed the object in the file and export again."
  },
  "import.other-pages": {
    "text": "only the first of {pages:# page|# pages} is read",
    "hint": "Export the other pages as separate files."
  },
  "import.outside-page": {
    "text": "the object lies outside the visible area of the page",
    "hint": ""
  },
  "import.page-ends-early": {
    "text": "the path is never painted, because the page ends before",
    "hint": ""
  },
  "import.paper-space": {
    "text": "the object is in a layout (paper space), not in the model",
    "hint": ""
  },
  "import.parameters-not-numbers": {
    "text": "the parameters of the object are not numbers",
    "hint": ""
  },
  "import.partly-outside-page": {
    "text": "a part of the object lies outside the visible area of the page",
    "hint": ""
  },
  "import.picture": {
    "text": "pictures are not cut",
    "hint": ""
  },
  "import.picture-block": {
    "text": "the block {block} with {entities:# object|# objects} is the picture of a dimension or a hatch",
    "hint": ""
  },
  "import.pieces-drawn-twice": {
    "text": "{pieces} of {all} segments are drawn twice: they lie exactly on {same:, }",
    "hint": ""
  },
  "import.pieces-drawn-twice-often": {
    "text": "{pieces} of {all} segments are drawn several times: they lie exactly on {same:, } and {more} more",
    "hint": ""
  },
  "import.pieces-no-length": {
    "text": "{pieces} of {all} segments have no length",
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
    "text": "inserts the block {block}",
    "hint": ""
  },
  "import.places-subroutine": {
    "text": "inserts the subroutine {name}",
    "hint": ""
  },
  "import.point": {
    "text": "the object is a point, which has no length",
    "hint": ""
  },
  "import.proxy": {
    "text": "only the program that made this object can read it",
    "hint": "Explode it into lines in that program and export again."
  },
  "import.region": {
    "text": "regions cannot be read",
    "hint": "Explode it into lines in the CAD program and export again."
  },
  "import.repeated": {
    "text": "drawn {times} times",
    "hint": ""
  },
  "import.rules-not-read": {
    "text": "the style sheet has rules that are not supported: {rules:, }",
    "hint": ""
  },
  "import.script": {
    "text": "scripts are not executed",
    "hint": ""
  },
  "import.shading": {
    "text": "shadings are not cut",
    "hint": ""
  },
  "import.short-path-data": {
    "text": "the path data of the object ends inside a command; the path was read up to there, as browsers do",
    "hint": ""
  },
  "import.solid": {
    "text": "the object is a solid or a face, not a flat line",
    "hint": ""
  },
  "import.spot-colour": {
    "text": "drawn in the spot colour {colour}",
    "hint": ""
  },
  "import.subroutine-in-itself": {
    "text": "the subroutine {name} contains itself",
    "hint": ""
  },
  "import.text": {
    "text": "texts are not cut",
    "hint": ""
  },
  "import.text-unknown-letters": {
    "text": "texts are not cut, and the characters of this text cannot be read",
    "hint": ""
  },
  "import.tilted": {
    "text": "the object is not flat: its plane is tilted by {degrees:g}°",
    "hint": ""
  },
  "import.tilted-axis": {
    "text": "the object is not flat: its major axis rises by {rise:g} file units",
    "hint": ""
  },
  "import.too-far": {
    "text": "a coordinate of the object is {coordinate:g}; the limit is {limit:g}",
    "hint": ""
  },
  "import.too-many-fit-points": {
    "text": "the curve has {points:,} fit points; the limit is {limit:,}",
    "hint": ""
  },
  "import.uncentred-arc": {
    "text": "the centre of the arc is {first:g} away from its start, but {second:g} away from its end",
    "hint": ""
  },
  "import.underlay": {
    "text": "underlays (inserted pictures and PDF pages) are not cut",
    "hint": ""
  },
  "import.uneven-height": {
    "text": "the object is not flat: its height z varies from {low:g} to {high:g}",
    "hint": ""
  },
  "import.unknown-operator": {
    "text": "the PDF operator {operator!r} is not supported",
    "hint": ""
  },
  "import.unknown-record": {
    "text": "records of this type are not supported",
    "hint": ""
  },
  "import.unsupported-element": {
    "text": "elements of type {kind} are not supported",
    "hint": ""
  },
  "import.unused-block": {
    "text": "the block {block} with {entities:# object|# objects} is not used in the drawing",
    "hint": ""
  },
  "import.unused-subroutine": {
    "text": "the subroutine {name} with {records:# record|# records} is not used in the drawing",
    "hint": ""
  },
  "import.value-angle": {
    "text": "{degrees:g}° is not a finite angle",
    "hint": ""
  },
  "import.value-not-numbers": {
    "text": "{value!r} is not a number",
    "hint": ""
  },
  "import.value-not-transform": {
    "text": "{value!r} is not a transform",
    "hint": ""
  },
  "import.value-transform-numbers": {
    "text": "the transform {name} does not take {count:# number|# numbers}",
    "hint": ""
  },
  "import.value-unit": {
    "text": "{value!r} has an unknown unit of length",
    "hint": ""
  },
  "import.viewport": {
    "text": "the object is a viewport, which only displays lines",
    "hint": ""
  },
  "import.wrong-field-count": {
    "text": "line {line} of the file has {fields:# field|# fields}, which is too few or too many for its record",
    "hint": ""
  },
  "input.not-finite": {
    "text": "{what} has a coordinate that is not a number.",
    "hint": "Draw it again."
  },
  "job.action-requested": {
    "text": "The operator requested: {action}.",
    "hint": ""
  },
  "job.at-line": {
    "text": "At line {line}.",
    "hint": ""
  },
  "job.awaits-kernels": {
    "text": "Waiting until the functions that the machine {machine} needs are compiled, once after an installation.",
    "hint": "Wait: the job is compiled as soon as they are ready."
  },
  "job.being-cancelled": {
    "text": "Job {job} is being cancelled.",
    "hint": "Wait until the machine has stopped."
  },
  "job.cancelled": {
    "text": "Cancelled.",
    "hint": ""
  },
  "job.cancelled-before-request": {
    "text": "Job {job} is being cancelled, so it cannot {request}.",
    "hint": "Wait until the machine has stopped."
  },
  "job.claim-returned": {
    "text": "The claim was returned. {reason}",
    "hint": ""
  },
  "job.claimed": {
    "text": "Claimed.",
    "hint": ""
  },
  "job.claimed-to-confirm": {
    "text": "Claimed; waits for the operator's confirmation.",
    "hint": ""
  },
  "job.compile-cancelled": {
    "text": "The compile was cancelled.",
    "hint": ""
  },
  "job.compile-crashed": {
    "text": "Internal error while compiling: {reason}. Nothing was cut.",
    "hint": "The server's log has the details."
  },
  "job.compile-started": {
    "text": "Attempt {attempt} to compile the job.",
    "hint": ""
  },
  "job.compiles-died": {
    "text": "{attempts} compiles of the job died, the last in stage {stage}.",
    "hint": "Send a smaller drawing, or report this one as a bug."
  },
  "job.confirmed-sheet": {
    "text": "Confirmed: new sheet, board {board}.",
    "hint": ""
  },
  "job.confirmed-table": {
    "text": "Confirmed: table clear, board {board}.",
    "hint": ""
  },
  "job.copy-done": {
    "text": "Copy {copy} of {copies} is done.",
    "hint": ""
  },
  "job.copy-done-next-sheet": {
    "text": "Copy {copy} of {copies} is done: put a new sheet on the table.",
    "hint": ""
  },
  "job.declared-finished": {
    "text": "Declared finished at line {line} of {lines}.",
    "hint": ""
  },
  "job.executed": {
    "text": "Every line was executed.",
    "hint": ""
  },
  "job.fully-executed": {
    "text": "Job {job} was executed to its last line ({lines}), so it is not queued again.",
    "hint": "Look at the table. Mark the job finished if the sheet is complete, otherwise scrap it."
  },
  "job.gateway-fell-silent": {
    "text": "The gateway {gateway} fell silent.",
    "hint": ""
  },
  "job.gateway-lost": {
    "text": "The gateway {gateway} fell silent. The machine may have executed more lines than it reported.",
    "hint": ""
  },
  "job.gateway-silent": {
    "text": "The gateway {gateway} that claimed job {job} does not answer.",
    "hint": "Switch on the machine and its gateway, then confirm when the job waits again."
  },
  "job.held-before-start": {
    "text": "Held before the first line.",
    "hint": ""
  },
  "job.interrupted": {
    "text": "Interrupted at line {line} of {lines}{copy}. {cause}",
    "hint": "{cause:hint} Look at the table. Queue the job again to cut a new sheet from the first line, mark it finished if the sheet is complete, or scrap it."
  },
  "job.interrupted-at-end": {
    "text": "Interrupted at line {line} of {lines}{copy}. {cause}",
    "hint": "{cause:hint} Look at the table. Mark the job finished if the sheet is complete, otherwise scrap it."
  },
  "job.interrupted-between-copies": {
    "text": "Interrupted after copy {copy} of {copies}, before a line of the next. {cause}",
    "hint": "{cause:hint} Look at the table. Queue the job again for the remaining copies, mark it finished, or scrap it."
  },
  "job.late-report": {
    "text": "Reported late: {report}",
    "hint": ""
  },
  "job.no-confirmation-awaited": {
    "text": "Job {job} is {state}, so it waits for no confirmation.",
    "hint": "{advice}"
  },
  "job.no-sheet-awaited": {
    "text": "Job {job} is held, not waiting for a sheet.",
    "hint": "Resume it."
  },
  "job.no-work": {
    "text": "There is nothing to make in this drawing: every edge is ignored.",
    "hint": "Give at least one edge a line type that the machine makes."
  },
  "job.not-confirmed": {
    "text": "Job {job} was started without a confirmation of its sheet.",
    "hint": "Check the table, then confirm the job or cancel it."
  },
  "job.not-running": {
    "text": "Job {job} is {state}; no machine runs it.",
    "hint": "Claim it first."
  },
  "job.not-taken": {
    "text": "Job {job} is queued, and its machine {machine} has not taken it yet.",
    "hint": "Confirm it when its turn has come; its reason states what it waits for."
  },
  "job.nothing-sent": {
    "text": "The gateway sent nothing to the machine.",
    "hint": ""
  },
  "job.nothing-to-confirm": {
    "text": "Job {job} is running.",
    "hint": "There is nothing to confirm."
  },
  "job.of-copy": {
    "text": " of copy {copy} of {copies}",
    "hint": ""
  },
  "job.ordered": {
    "text": "Ordered.",
    "hint": ""
  },
  "job.other-board": {
    "text": "Job {job} is for the board {board}, not {given}.",
    "hint": "Put {board} on the table."
  },
  "job.program-refused": {
    "text": "The program does not cut what was drawn: {findings: }{more}",
    "hint": "Change the drawing, the line types or the board; nothing was cut."
  },
  "job.released": {
    "text": "Released.",
    "hint": ""
  },
  "job.released-by-order": {
    "text": "Released, as its order requested.",
    "hint": ""
  },
  "job.requeued": {
    "text": "Queued again.",
    "hint": ""
  },
  "job.scrapped": {
    "text": "Scrapped.",
    "hint": ""
  },
  "job.stale-epoch": {
    "text": "This gateway no longer owns job {job}, which is {state} (epoch {epoch}; it is in epoch {current} now).",
    "hint": "Stop the machine and claim again."
  },
  "job.started": {
    "text": "Started.",
    "hint": ""
  },
  "job.started-unconfirmed": {
    "text": "Started without the operator's confirmation.",
    "hint": ""
  },
  "job.unknown": {
    "text": "There is no job {job}.",
    "hint": "GET /api/jobs lists them."
  },
  "job.verified": {
    "text": "Compiled and verified.",
    "hint": ""
  },
  "job.worker-silent": {
    "text": "The worker {worker} stopped responding in stage {stage}.",
    "hint": ""
  },
  "job.wrong-state": {
    "text": "Job {job} is {state}, so it cannot become {goal}.",
    "hint": "{advice}"
  },
  "job.wrong-state-for-request": {
    "text": "Job {job} is {state}; the request {request} is for a job that is {states: or }.",
    "hint": "{advice}"
  },
  "language.bad-entry-point": {
    "text": "The entry point {name!r} of {group} does not provide a controller language of this name.",
    "hint": "Correct or remove the package that declares it."
  },
  "language.no-driver": {
    "text": "Programs in {language} cannot be sent to a machine, because there is no gateway driver for this language.",
    "hint": "{advice}"
  },
  "language.unknown": {
    "text": "The controller language {name!r} does not exist.",
    "hint": "Choose one of {known:, }."
  },
  "language.unusable": {
    "text": "{machine} cannot be driven with {language}: {reason}.",
    "hint": "Choose {own}, the language of the machine file."
  },
  "layer.not-finite": {
    "text": "A coordinate on the layer {layer} is not a number.",
    "hint": "Draw the edges of this layer again."
  },
  "library.invalid": {
    "text": "The {shelf} {name!r} cannot be used: {faults:; }.",
    "hint": "Correct its TOML file; knifetip schema {shelf} describes all fields."
  },
  "library.unknown": {
    "text": "The {shelf} {name!r} does not exist.",
    "hint": "Choose one of {known:, }."
  },
  "library.unknown-file": {
    "text": "The {shelf} {name!r} does not exist: {reason}.",
    "hint": "Check the path of the file, or choose one of {known:, }."
  },
  "library.unreadable": {
    "text": "The {shelf} {name!r} cannot be read: {detail}.",
    "hint": "Correct its TOML file."
  },
  "machine.busy": {
    "text": "Job {job} is on the table of {machine}.",
    "hint": "One job at a time: finish it, queue it again or scrap it."
  },
  "machine.busy-with-another": {
    "text": "Another job is on the table of {machine}.",
    "hint": "One job at a time: finish it, queue it again or scrap it."
  },
  "machine.no-cutter": {
    "text": "{machine} has no cutter {cutter!r}: none of its tools is a rotating cutter or a laser.",
    "hint": "Choose a machine with a rotating cutter or a laser; only these can be calibrated."
  },
  "machine.no-such-cutter": {
    "text": "{machine} has no cutter {cutter!r}.",
    "hint": "Choose one of {known:, }."
  },
  "milling.shared-edge": {
    "text": "Two parts share edge {edge}, but the cutter removes {diameter:g} mm from one of them.",
    "hint": "Move the parts at least {diameter:g} mm apart, or choose a machine with a knife."
  },
  "offset.bad-distance": {
    "text": "The offset distance is not a number of 0 mm or more.",
    "hint": "Correct the radius of the tool."
  },
  "offset.bad-interference": {
    "text": "{interference!r} is not a method for places where the tool does not fit.",
    "hint": "Choose 'trim' or 'refuse'."
  },
  "offset.bad-side": {
    "text": "The side of a path must be +1 (left) or -1 (right).",
    "hint": "Give +1 or -1."
  },
  "offset.dead-end": {
    "text": "The offset of path {path} by {radius:g} mm does not close: {depth:.4g} mm of it beside segment {segment} have no continuation.",
    "hint": "Draw the contour without overlaps, or change the radius a little."
  },
  "offset.interference": {
    "text": "A tool of radius {radius:g} mm beside segment {segment} would cut {depth:.4g} mm into segment {other}.",
    "hint": "Choose a smaller tool, or accept uncut remains where the tool does not fit."
  },
  "offset.mixed-group": {
    "text": "Path {path} has another radius or side than the other paths of its group.",
    "hint": "Reverse the path, or put it into a group of its own."
  },
  "offset.self-contact": {
    "text": "The offset of path {path} by {radius:g} mm does not close: the contour touches itself at ({x:.4f}, {y:.4f}), in segments {one} and {two}.",
    "hint": "Trim the two segments where they meet, or move one of them away."
  },
  "override.ambiguous": {
    "text": "An override must name its edges in exactly one way.",
    "hint": "Give edges, or handles, or layer and colour."
  },
  "override.no-edges-there": {
    "text": "The drawing has no edge {place: and }.",
    "hint": "Choose a layer and colour that GET /api/drawings/ID/edges lists."
  },
  "override.no-such-edge": {
    "text": "Edge {edge} does not exist; the drawing has {count:# edge|# edges}.",
    "hint": "Number the edges from 0."
  },
  "override.no-such-handle": {
    "text": "No edge has the handle {handle!r}.",
    "hint": "Choose a handle that GET /api/drawings/ID/edges lists."
  },
  "override.of-colour": {
    "text": "of colour {colour}",
    "hint": ""
  },
  "override.on-layer": {
    "text": "on layer {layer!r}",
    "hint": ""
  },
  "pdf.blank": {
    "text": "The first page of the PDF contains no drawing.",
    "hint": "Export the drawing as the first page."
  },
  "pdf.content-damaged": {
    "text": "The content of {where} of the PDF {reason}, so lines of the drawing may be missing.",
    "hint": "Export the drawing again, or send it as DXF."
  },
  "pdf.cut-short": {
    "text": "The PDF is cut short: its {bytes:,} bytes do not end with %%EOF, so lines of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again."
  },
  "pdf.encrypted": {
    "text": "The PDF is encrypted, so it cannot be read.",
    "hint": "Save it without a password and without restrictions."
  },
  "pdf.expands-too-far": {
    "text": "The page of the PDF and its repeated forms expand to more than {limit:.1f} MB.",
    "hint": "Export a single carton, with its symbols expanded."
  },
  "pdf.form": {
    "text": "The PDF is an XFA form, whose page contains no drawing.",
    "hint": "Print the drawing to a PDF, or send it as DXF."
  },
  "pdf.form-named": {
    "text": "form {name}",
    "hint": ""
  },
  "pdf.illustrator-only": {
    "text": "The Illustrator file was saved without PDF content, so its page contains no line.",
    "hint": "Save it with the option 'Create PDF Compatible File', or as PDF."
  },
  "pdf.layers-too-deep": {
    "text": "The layers of the PDF are nested more than {limit:,} levels deep.",
    "hint": "Export the drawing again with fewer nested layers."
  },
  "pdf.nested-arrays": {
    "text": "has arrays that are nested too deep",
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
  "pdf.open-array": {
    "text": "ends inside an array",
    "hint": ""
  },
  "pdf.open-image": {
    "text": "ends inside an image",
    "hint": ""
  },
  "pdf.open-text": {
    "text": "ends inside a text",
    "hint": ""
  },
  "pdf.page": {
    "text": "the page",
    "hint": ""
  },
  "pdf.page-too-large": {
    "text": "The page of the PDF extends to {size:g} mm; the limit is {limit:g} mm.",
    "hint": "Export the drawing in its true size."
  },
  "pdf.part-missing": {
    "text": "A part of the page of the PDF is missing, so lines of the drawing may be missing.",
    "hint": "Export the drawing again, or send it as DXF."
  },
  "pdf.stream-cut-short": {
    "text": "A data stream of the PDF is cut short, so lines of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again."
  },
  "pdf.stream-damaged": {
    "text": "A data stream of the PDF is damaged ({reason}), so lines of the drawing may be missing.",
    "hint": "Export the drawing again, or send it as DXF."
  },
  "pdf.stream-too-large": {
    "text": "A data stream of the PDF is larger than {limit:.1f} MB when unpacked.",
    "hint": "Export a single carton, without pictures."
  },
  "pdf.too-many-states": {
    "text": "The PDF saves more than {limit:,} graphics states at once.",
    "hint": "Export the drawing again from the program that drew it."
  },
  "profile.bad-if-match": {
    "text": "The header If-Match is {match!r}, which is not a version.",
    "hint": "Send the ETag of the profile, for example \"3\"."
  },
  "profile.bad-name": {
    "text": "{name!r} is not a valid profile name.",
    "hint": "Use up to 64 lower-case letters, digits, - and _; put other characters into the title."
  },
  "profile.exists": {
    "text": "A profile {name} already exists, at version {version}.",
    "hint": "Send If-Match: \"{version}\" to replace it, or choose another name."
  },
  "profile.invalid-field": {
    "text": "The profile cannot be read: {fault}.",
    "hint": "See ProfileIn in /api/openapi.json for the expected fields."
  },
  "profile.nested-too-deep": {
    "text": "The profile {name!r} is nested too deeply.",
    "hint": "Write a title and a list of [[rule]] tables."
  },
  "profile.not-an-extension": {
    "text": "The profile {name!r} cannot be written as an extension of {extends!r}, because it does not contain all rules of it.",
    "hint": "Write it without extends."
  },
  "profile.not-kept": {
    "text": "The server has no custom profile {name}.",
    "hint": "Choose one of the profiles that GET /api/profiles lists."
  },
  "profile.not-toml": {
    "text": "The profile {name!r} is not valid TOML: {reason}.",
    "hint": "Correct this line."
  },
  "profile.not-utf8": {
    "text": "{name} is not UTF-8 text.",
    "hint": "Save it as UTF-8."
  },
  "profile.not-utf8-byte": {
    "text": "The profile {name!r} is not UTF-8 text: byte {byte} is invalid.",
    "hint": "Save it as UTF-8."
  },
  "profile.shipped": {
    "text": "The profile {name!r} is part of knifetip and cannot be changed.",
    "hint": "Save your profile under another name; it can extend this one."
  },
  "profile.shipped-command": {
    "text": "The profile {name!r} is part of knifetip and cannot be changed.",
    "hint": "Choose another name with --name."
  },
  "profile.stale": {
    "text": "Another user has changed the profile {name}: it is at version {version}, but this change was made from version {given}.",
    "hint": "Check the profile again, then send your change with If-Match: \"{version}\"."
  },
  "profile.too-long": {
    "text": "The profile {name!r} has {size} kB; the limit is {limit} kB.",
    "hint": "Combine rules: a rule can list many layers, and * matches any characters."
  },
  "profile.too-many": {
    "text": "The server already has {limit} profiles, the largest number allowed.",
    "hint": "Delete a profile that is not used."
  },
  "program.bad-tolerance": {
    "text": "A tolerance of {tolerance} mm is too small for the path blending of the controller.",
    "hint": "Give 0.001 mm or more."
  },
  "program.control-byte": {
    "text": "Line {line} of the program contains the byte 0x{byte}, a control command that the controller would execute at once.",
    "hint": "Remove it, or compile the job again."
  },
  "program.line-too-long": {
    "text": "Row {row} of the toolpath needs a program line of {length} characters ({line} …), but {dialect} accepts only {limit}.",
    "hint": "Check the coordinates of the drawing: they are larger than any table."
  },
  "program.line-too-long-to-send": {
    "text": "Line {line} of the program has {length} bytes, but {name} accepts only {limit}.",
    "hint": "Compile the job again with shorter comments."
  },
  "program.no-placement": {
    "text": "{program} does not contain the position of the drawing on the sheet.",
    "hint": "Give the position from its report with --placement X,Y."
  },
  "program.not-bytes": {
    "text": "The program is of type {type}, but must be bytes.",
    "hint": "Pass the bytes of the file."
  },
  "program.not-fetched": {
    "text": "The program of job {job} could not be loaded from the server ({reason}); nothing was sent to the machine.",
    "hint": "Queue the job again."
  },
  "program.too-large": {
    "text": "The program has {bytes:,} bytes; the limit is {limit:,}.",
    "hint": "Split the job into several sheets."
  },
  "program.too-many-lines": {
    "text": "The program has {lines:,} lines; the limit is {limit:,}.",
    "hint": "Split the job into several sheets."
  },
  "program.too-many-moves": {
    "text": "The program has {moves:,} moves; the limit is {limit:,}.",
    "hint": "Split the job into several sheets."
  },
  "program.wrong-checksum": {
    "text": "The program of job {job} was damaged on its way from the server (SHA-256 {arrived}… instead of {expected}…); nothing was sent to the machine.",
    "hint": "Queue the job again. If this happens again, compile the job again."
  },
  "question.guess": {
    "text": " It is most likely {type} ({percent} %): {reason}.",
    "hint": ""
  },
  "question.line-type": {
    "text": "{edges:# edge|# edges} on layer \"{layer}\" (colour {colour}, linetype {linetype}) {edges:has|have} no line type: total length {length:,.1f} {unit:unit}, extent {width:,.1f} × {height:,.1f} {unit:unit} at ({x:,.1f}, {y:,.1f}). Which line type should {edges:it|they} get?{guess}",
    "hint": ""
  },
  "question.shape": {
    "text": " The shape of the drawing shows: {reason}.",
    "hint": ""
  },
  "question.tool": {
    "text": "{machine} has no tool for {edges:# edge|# edges} of type {type}. Which line type should {edges:it|they} get?",
    "hint": ""
  },
  "question.unit": {
    "text": "{reason} In which unit is it drawn? Its size would be {sizes:, }.{evidence}",
    "hint": ""
  },
  "question.unit-contradicted": {
    "text": "The file states the unit {stated:unit}, but the drawing does not fit this unit.",
    "hint": ""
  },
  "question.unit-doubtful": {
    "text": "The file states the unit {stated:unit}, but the drawing could also be in {other:unit}.",
    "hint": ""
  },
  "question.unit-evidence": {
    "text": " Strongest evidence for {unit:unit}: {evidence:; }.",
    "hint": ""
  },
  "question.unit-not-stated": {
    "text": "The file does not state the unit of the drawing.",
    "hint": ""
  },
  "question.unit-size": {
    "text": "{width:mm} × {height:mm} mm in {unit:unit}",
    "hint": ""
  },
  "question.unit-unreadable": {
    "text": "The unit of the drawing is not known: {evidence}.",
    "hint": ""
  },
  "reading.crashed": {
    "text": "{name} is damaged and cannot be read ({reason}).",
    "hint": "Export the drawing again as DXF, CF2, SVG or PDF, if necessary from another program."
  },
  "reading.damaged": {
    "text": "The {format} is damaged and cannot be read ({reason}).",
    "hint": "Export the drawing again, if necessary from another program."
  },
  "reading.empty": {
    "text": "The file is empty.",
    "hint": "Send the drawing as {formats:or}."
  },
  "reading.expands-too-far": {
    "text": "The repeated parts of the {format} expand to more than {limit:,} elements.",
    "hint": "Export a single carton, with blocks and symbols expanded."
  },
  "reading.nested-too-deep": {
    "text": "Blocks, symbols or groups of the {format} are nested more than {limit} levels deep.",
    "hint": "Explode them in the program that drew the file, and export again."
  },
  "reading.too-large": {
    "text": "The file has {size:.1f} MB; the limit is {limit:.1f} MB.",
    "hint": "Export a single carton, without pictures."
  },
  "reading.too-many-elements": {
    "text": "The {format} has more than {limit:,} elements.",
    "hint": "Export a single carton."
  },
  "reading.too-many-entities": {
    "text": "The file has {count:,} entities; the limit is {limit:,}.",
    "hint": "Export a single carton."
  },
  "reading.too-many-segments": {
    "text": "The {format} has more than {limit:,} lines and curves.",
    "hint": "Export a single carton, without pictures made of lines."
  },
  "reading.too-slow": {
    "text": "Reading the {format} takes longer than {seconds:g} s.",
    "hint": "Export a single carton without pictures, and convert curves to lines and arcs."
  },
  "reading.truncated": {
    "text": "The {format} is truncated and cannot be read.",
    "hint": "Send the complete file, or export the drawing again."
  },
  "reading.unexpected": {
    "text": "The {format} is damaged and cannot be read (internal error {reason}).",
    "hint": "Export the drawing again, if necessary from another program."
  },
  "reading.unknown-kind": {
    "text": "The file is {what}, not a drawing that can be read.",
    "hint": "Send the drawing as {formats:or}."
  },
  "request.body-too-large": {
    "text": "The request is larger than {limit} MB, the limit at this address.",
    "hint": "Send the data in several requests."
  },
  "request.foreign-origin": {
    "text": "Cross-site request refused: it was sent by a page of another website.",
    "hint": "Send it from the page of this server, or from a program that is not a browser."
  },
  "request.foreign-page": {
    "text": "Cross-site request refused: it was sent by a page of {origin}.",
    "hint": "Send it from the page of this server, or from a program that is not a browser."
  },
  "request.html-form": {
    "text": "The API does not accept data of type {media}.",
    "hint": "Send JSON with Content-Type: application/json."
  },
  "request.invalid": {
    "text": "The request is invalid: {faults:; }.",
    "hint": "Correct these fields; /api/openapi.json describes them."
  },
  "request.key-needed": {
    "text": "This request needs the key of the server.",
    "hint": "Send the header Authorization: Bearer KEY, or sign in on the page."
  },
  "request.key-reused": {
    "text": "The Idempotency-Key {key} was already used for a different request.",
    "hint": "Use a new key for each new request."
  },
  "request.local-only": {
    "text": "This server has no key, so it accepts only requests from its own computer.",
    "hint": "Start it with --key-file PATH or --key KEY, or open it at http://localhost."
  },
  "request.no-host": {
    "text": "The request does not have exactly one Host header.",
    "hint": "Send one Host header, as HTTP/1.1 requires."
  },
  "request.not-marked": {
    "text": "The request has no header that shows that it does not come from a page of another website.",
    "hint": "Send the header X-Knifetip with any value."
  },
  "request.not-storable": {
    "text": "The request contains characters or numbers that the database cannot store.",
    "hint": "Remove control characters, and use finite numbers."
  },
  "request.nothing-there": {
    "text": "The address {path} does not exist on this server.",
    "hint": "Choose an address that /api/openapi.json describes."
  },
  "request.refused": {
    "text": "The request was refused: {detail}.",
    "hint": ""
  },
  "request.upload-too-large": {
    "text": "The file is larger than {limit} MB, the limit of this server.",
    "hint": "Send a smaller file."
  },
  "request.wrong-host": {
    "text": "This server does not accept requests for the host {host!r}.",
    "hint": "Use its IP address, or start it with --allow-host {host}."
  },
  "request.wrong-key": {
    "text": "The key is wrong.",
    "hint": "Send the key of this server in the header Authorization: Bearer KEY."
  },
  "request.wrong-method": {
    "text": "The method {method} is not supported at {path}.",
    "hint": "Choose a method that /api/openapi.json describes for this address."
  },
  "rs274.after-end": {
    "text": "The line comes after the end of the program (M2 or M30).",
    "hint": "Delete the line."
  },
  "rs274.axis-without-motion": {
    "text": "The line has coordinates, but no motion word (G0, G1, G2 or G3).",
    "hint": "Add the motion word."
  },
  "rs274.bad-arc": {
    "text": "The distances from the centre of the arc to its start and to its end differ by more than {limit:g} mm.",
    "hint": "Correct the centre (I, J) or the end (X, Y) of the arc."
  },
  "rs274.bad-character": {
    "text": "The character {character!r} is not allowed here.",
    "hint": "Remove it."
  },
  "rs274.bad-feed": {
    "text": "The feed (F) is not greater than 0.",
    "hint": "Give a feed greater than 0."
  },
  "rs274.bad-line-number": {
    "text": "The line number (N) is not a whole number of 0 or more.",
    "hint": "Correct or delete the line number."
  },
  "rs274.centre-without-arc": {
    "text": "The line has the centre of an arc (I, J), but no arc motion (G2 or G3).",
    "hint": "Add G2 or G3, or delete I and J."
  },
  "rs274.change-without-station": {
    "text": "The line changes the tool (M6), but the program has not named a station (T) before.",
    "hint": "Write the T word of the station before M6."
  },
  "rs274.control-byte": {
    "text": "The byte {byte} is a control command that the controller would execute at once, even in a comment.",
    "hint": "Remove it."
  },
  "rs274.ends-lowered": {
    "text": "The program ends while a station is lowered.",
    "hint": "Release the station (M65) and lift the head before the end."
  },
  "rs274.ends-oscillating": {
    "text": "The program ends while a tool oscillates or rotates.",
    "hint": "Switch it off (M5) before the end."
  },
  "rs274.ends-output-on": {
    "text": "The program ends while an output is on.",
    "hint": "Switch the output off (M65) before the end."
  },
  "rs274.ends-with-offset": {
    "text": "The program ends while the offset of a station is active.",
    "hint": "Cancel the offset (G49) before the end."
  },
  "rs274.g64-unsupported": {
    "text": "G64 is not accepted by controllers without a tool table.",
    "hint": "Remove it."
  },
  "rs274.incomplete-arc": {
    "text": "The arc has no X, Y, I or J.",
    "hint": "Give all four."
  },
  "rs274.letter-without-number": {
    "text": "The letter {letter} has no number.",
    "hint": "Add the number or delete the letter."
  },
  "rs274.line-too-long": {
    "text": "The line is longer than {limit} characters, the limit of the controller.",
    "hint": "Shorten the line."
  },
  "rs274.missing-p": {
    "text": "The line has no P word, which its other words need.",
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
    "text": "the coordinate system (G54)",
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
  "rs274.mode-g94": {
    "text": "the feed in mm/min (G94)",
    "hint": ""
  },
  "rs274.motion-without-axis": {
    "text": "The line has a motion word (G0 to G3), but no coordinates.",
    "hint": "Add the coordinates or delete the motion word."
  },
  "rs274.moves-and-switches": {
    "text": "The line moves the head and switches something at the same time.",
    "hint": "Write the move and the switching on two lines."
  },
  "rs274.moves-unstated": {
    "text": "The line moves before the program has set {mode}.",
    "hint": "Set it at the beginning of the program."
  },
  "rs274.nested-comment": {
    "text": "A comment begins inside another comment.",
    "hint": "Close the first comment before it."
  },
  "rs274.no-end": {
    "text": "The program has no end (M2 or M30).",
    "hint": "Add M2 as the last line."
  },
  "rs274.no-feed": {
    "text": "The line cuts, but no feed (F) has been set since the feed mode was chosen.",
    "hint": "Add an F word."
  },
  "rs274.not-settled": {
    "text": "The line moves before the switched tool or output has reached its state.",
    "hint": "Add a dwell (G4) before it."
  },
  "rs274.number-too-large": {
    "text": "A number is larger than 1,000,000.",
    "hint": "Correct the number."
  },
  "rs274.offset-without-station": {
    "text": "The line applies the offset of a station (G43), but the program has not named a station (T) before.",
    "hint": "Write the T word of the station before G43."
  },
  "rs274.open-comment": {
    "text": "A comment is not closed.",
    "hint": "Close it with ) on the same line."
  },
  "rs274.repeated-word": {
    "text": "Two words of the line set the same value.",
    "hint": "Delete one of them."
  },
  "rs274.speed-without-m3": {
    "text": "The line has a spindle speed (S), but no M3.",
    "hint": "Add M3 or delete the speed."
  },
  "rs274.stray-p": {
    "text": "The P word belongs to no other word of the line, or to two of them.",
    "hint": "Delete it, or write the words on separate lines."
  },
  "rs274.stray-q": {
    "text": "The Q word belongs to no other word of the line.",
    "hint": "Delete it."
  },
  "rs274.timed-without-f": {
    "text": "The move is timed (G93), but the line has no F word with its duration.",
    "hint": "Add the F word."
  },
  "rs274.too-many-digits": {
    "text": "A number has more than 15 digits.",
    "hint": "Round the number."
  },
  "rs274.unbounded-rounding": {
    "text": "The line cuts while the program does not limit how far the controller may round corners.",
    "hint": "Set the limit with G64 P before it."
  },
  "rs274.unknown-letter": {
    "text": "The letter {letter} is not supported.",
    "hint": "Remove the word."
  },
  "rs274.unknown-output": {
    "text": "{machine} does not have the output in this line.",
    "hint": "Choose an output of the machine file."
  },
  "rs274.unknown-station": {
    "text": "{machine} does not have the station (T) in this line.",
    "hint": "Choose a station of the machine file."
  },
  "rs274.unknown-word": {
    "text": "{word} is not supported.",
    "hint": "Remove it."
  },
  "rs274.wrong-dwell": {
    "text": "The dwell (G4) is shorter than the {settle:g} s that the machine needs after switching.",
    "hint": "Make the dwell {settle:g} s or longer."
  },
  "rs274.wrong-speed": {
    "text": "The speed (S) at M3 is not the speed of the tool in the machine file.",
    "hint": "Correct the speed, or compile the job again."
  },
  "rule.block": {
    "text": "block {patterns:or}",
    "hint": ""
  },
  "rule.colour": {
    "text": "colour {colours:or}",
    "hint": ""
  },
  "rule.conditions": {
    "text": "{conditions:, }",
    "hint": ""
  },
  "rule.entity": {
    "text": "object type {kinds:or}",
    "hint": ""
  },
  "rule.everything": {
    "text": "every edge",
    "hint": ""
  },
  "rule.layer": {
    "text": "layer {patterns:or}",
    "hint": ""
  },
  "rule.linetype": {
    "text": "linetype {patterns:or}",
    "hint": ""
  },
  "run.executed": {
    "text": "{executed} of {lines} lines were executed.",
    "hint": ""
  },
  "run.in-buffer": {
    "text": "{executed} of {lines} lines were executed, and up to {rest} more, which were in the controller's buffer, may have been.",
    "hint": ""
  },
  "run.nothing-sent": {
    "text": "No line was sent.",
    "hint": ""
  },
  "segment.not-finite": {
    "text": "Segment {segment} of the path has a coordinate or a bulge that is not a number.",
    "hint": "Draw the segment again."
  },
  "server.address-in-use": {
    "text": "The server cannot use the address {host}:{port}: {reason}.",
    "hint": "Stop the program that uses the port, or choose another port with --port."
  },
  "server.answered": {
    "text": "The request to {url} failed with the HTTP status {status}.",
    "hint": "Check the address of the server, and its log."
  },
  "server.busy": {
    "text": "The server is busy: {waiting:# request is|# requests are} already waiting, so this request was not started.",
    "hint": "Send it again in {seconds} s."
  },
  "server.database-silent": {
    "text": "The database of the server does not respond.",
    "hint": "Try again in a moment. If this happens again, check the database."
  },
  "server.internal-error": {
    "text": "Internal error of the server. Nothing was cut.",
    "hint": "Report it with the log of the server."
  },
  "server.not-started": {
    "text": "The server could not start with the database {database}.",
    "hint": "Correct the cause, which the lines above show."
  },
  "server.stopping": {
    "text": "The server is shutting down and accepts no new requests.",
    "hint": "Try again in a moment."
  },
  "server.unreachable": {
    "text": "The server {server} cannot be reached: {reason}.",
    "hint": "Check --server and the network."
  },
  "settings.bad-host": {
    "text": "{host!r} is not a host name.",
    "hint": "Write NAME or NAME:PORT."
  },
  "settings.bad-key": {
    "text": "{what} has {length} characters, but must have {shortest} to 200 ASCII characters without spaces.",
    "hint": "Choose another key, or let --key-file PATH generate one."
  },
  "settings.key-file": {
    "text": "The key file {file} cannot be used: {reason}.",
    "hint": "Name a file that the server can read and write."
  },
  "settings.two-keys": {
    "text": "The server was given both a key and a key file.",
    "hint": "Give only one of --key and --key-file."
  },
  "store.no-column": {
    "text": "The {kind} {id} has no {column} yet.",
    "hint": "Wait until it is compiled; its state and reason show why it may have failed."
  },
  "store.unknown": {
    "text": "The {kind} {id} does not exist.",
    "hint": "Choose one that GET /api/{kind}s lists."
  },
  "stored.text": {
    "text": "{text}",
    "hint": "{hint}"
  },
  "svg.cut-short": {
    "text": "The SVG is cut short: it ends at line {line}, after {count:# element|# elements}, so lines of the drawing may be missing.",
    "hint": "Send the complete file, or export the drawing again as plain SVG."
  },
  "svg.damaged-at": {
    "text": "The SVG is damaged at line {line}, column {column}: {reason}.",
    "hint": "Export the drawing again as plain SVG."
  },
  "svg.empty": {
    "text": "The SVG contains no element.",
    "hint": "Export the drawing again as plain SVG."
  },
  "svg.external-entity": {
    "text": "The DOCTYPE of the SVG has an entity {name!r} that refers to another file, which is not loaded.",
    "hint": "Save it as plain SVG, without a DOCTYPE."
  },
  "svg.long-entity": {
    "text": "The DOCTYPE of the SVG has an entity {name!r} of {length:,} characters, which would expand the file too far.",
    "hint": "Save it as plain SVG, without a DOCTYPE."
  },
  "svg.markup-entity": {
    "text": "The DOCTYPE of the SVG has an entity {name!r} that contains markup.",
    "hint": "Save it as plain SVG, without a DOCTYPE."
  },
  "svg.nested-too-deep": {
    "text": "The elements of the SVG are nested more than {limit} levels deep.",
    "hint": "Ungroup the drawing and export it again."
  },
  "svg.other-xml": {
    "text": "The file is XML, but its outermost element is {element} instead of svg.",
    "hint": "Save the drawing as plain SVG."
  },
  "svg.packed-cut-short": {
    "text": "The compressed SVG (.svgz) is cut short.",
    "hint": "Send the complete file, or export the drawing again as plain SVG."
  },
  "svg.packed-damaged": {
    "text": "The compressed SVG (.svgz) is damaged: {reason}.",
    "hint": "Export the drawing again as plain SVG."
  },
  "svg.too-many-rules": {
    "text": "The style sheet of the SVG has {count:,} rules; the limit is {limit:,}.",
    "hint": "Export the drawing with the style in each element."
  },
  "svg.unpacks-too-far": {
    "text": "The compressed SVG (.svgz) is larger than {limit:.1f} MB when unpacked.",
    "hint": "Export a single carton, without pictures."
  },
  "tool.bad-radius": {
    "text": "The radius of a tool is not a number of 0 mm or more.",
    "hint": "Correct it in the machine file."
  },
  "tool.cannot-work": {
    "text": "Station {station} ({name}) of {machine} cannot be used: {reason}",
    "hint": "Complete the tool in the machine file."
  },
  "tool.missing": {
    "text": "{machine} has no tool for {count:# edge|# edges} of type {type}.",
    "hint": "Choose another line type for the edges, or another machine."
  },
  "tool.short-lead": {
    "text": "its lead of {lead:g} mm must be 0 or greater than its radius of {radius:g} mm",
    "hint": ""
  },
  "tool.tilted": {
    "text": "The tool is tilted by {tilt:.2f}°, but only tools tilted by up to {limit:g}° can be lifted along their axis.",
    "hint": "Choose a tool that is less tilted."
  },
  "tool.without-power": {
    "text": "The power of the laser is 0.",
    "hint": "Set its power in the machine file."
  },
  "tool.without-speed": {
    "text": "The spindle speed of the cutter is 0.",
    "hint": "Set its speed in the machine file."
  },
  "toolpath.arc-too-long": {
    "text": "Internal error: {place} is an arc of more than half a turn: {move}.",
    "hint": "Report it with the drawing."
  },
  "toolpath.empty": {
    "text": "The toolpath has no moves, so nothing would be cut.",
    "hint": "Give at least one edge a line type for which the machine has a tool."
  },
  "toolpath.feed-too-fast": {
    "text": "{place} has a feed that no machine can reach: {move}.",
    "hint": "Correct the feed of the tool in the machine file."
  },
  "toolpath.no-approach": {
    "text": "Internal error: {place} starts a cut with station {station} before a rapid move has reached its start.",
    "hint": "Report it with the drawing."
  },
  "toolpath.no-feed": {
    "text": "{place} has no feed: {move}.",
    "hint": "Set the feed of the tool in the machine file."
  },
  "toolpath.not-finite": {
    "text": "Internal error: {place} has a value that is not a number: {move}.",
    "hint": "Report it with the drawing."
  },
  "toolpath.rapid-arc": {
    "text": "Internal error: {place} is a rapid move along an arc: {move}.",
    "hint": "Report it with the drawing."
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
    "text": "Internal error: row {row} of the toolpath is a swivel move without a turn, so its feed in degrees per minute has no meaning.",
    "hint": "Report it with the drawing."
  },
  "toolpath.too-far": {
    "text": "{place} is more than {limit:g} mm away from the origin: {move}.",
    "hint": "Check the unit of the drawing."
  },
  "toolpath.unknown-motion": {
    "text": "Internal error: {place} has an unknown motion type: {move}.",
    "hint": "Report it with the drawing."
  },
  "toolpath.unknown-station": {
    "text": "{place} is for station {station}, which {machine} does not have.",
    "hint": "Choose one of the stations {known:, }."
  },
  "track.too-flat": {
    "text": "The path of the tool meets the edge of the board at {angle:.2f}° from the perpendicular (limit {limit:g}°), so the tool does not leave the board (path {track}).",
    "hint": "End the line inside the board, or draw it across the edge."
  },
  "travel.above": {
    "text": "{tool} (station {station}) would exceed the upper end of the travel of axis {axis} ({low:g} to {high:g}{unit}) by {excess:.2f}{unit}{place}.",
    "hint": "Move or turn the drawing on the table, or choose a larger machine."
  },
  "travel.below": {
    "text": "{tool} (station {station}) would exceed the lower end of the travel of axis {axis} ({low:g} to {high:g}{unit}) by {excess:.2f}{unit}{place}.",
    "hint": "Move or turn the drawing on the table, or choose a larger machine."
  },
  "unit.cf2-inches": {
    "text": "the CF2 states inches (record UI)",
    "hint": ""
  },
  "unit.cf2-millimetres": {
    "text": "the CF2 states millimetres (record UM)",
    "hint": ""
  },
  "unit.cf2-none": {
    "text": "the CF2 states no unit: it has neither a UM nor a UI record",
    "hint": ""
  },
  "unit.cf2-scale-applied": {
    "text": "its coordinates were multiplied by the record SCALE,{x:g},{y:g}, which gives the size that its records LL and UR state",
    "hint": ""
  },
  "unit.cf2-scale-invalid": {
    "text": "its record SCALE,{x:g},{y:g} is invalid and was ignored",
    "hint": ""
  },
  "unit.cf2-scale-not-applied": {
    "text": "its record SCALE,{x:g},{y:g} was not applied, because the coordinates already have the size that its records LL and UR state",
    "hint": ""
  },
  "unit.cf2-scale-undecided": {
    "text": "its record SCALE,{x:g},{y:g} was not applied, because its records LL and UR do not show whether the coordinates are already scaled",
    "hint": ""
  },
  "unit.cf2-scaled": {
    "text": "{unit}; {scale}",
    "hint": ""
  },
  "unit.dimensions-larger": {
    "text": "Dimensions on the sheet have different scales: {count:# dimension is|# dimensions are} drawn {factor:.3g} times larger than {others:# other|# others}.",
    "hint": "Check which dimensions belong to the carton, and delete details at another scale."
  },
  "unit.dimensions-smaller": {
    "text": "Dimensions on the sheet have different scales: {count:# dimension is|# dimensions are} drawn {factor:.3g} times smaller than {others:# other|# others}.",
    "hint": "Check which dimensions belong to the carton, and delete details at another scale."
  },
  "unit.drawn-in-imperial": {
    "text": "fractions of inches that are stored in {unit:unit}",
    "hint": ""
  },
  "unit.drawn-in-inches": {
    "text": "fractions of inches",
    "hint": ""
  },
  "unit.drawn-in-metric": {
    "text": "round millimetres that are stored in {unit:unit}",
    "hint": ""
  },
  "unit.drawn-in-millimetres": {
    "text": "millimetres",
    "hint": ""
  },
  "unit.given": {
    "text": "set by the user",
    "hint": ""
  },
  "unit.header": {
    "text": "the header states the unit ($INSUNITS = {value})",
    "hint": ""
  },
  "unit.header-decimal-inches": {
    "text": "the header displays lengths in feet and decimal inches ($LUNITS = 3)",
    "hint": ""
  },
  "unit.header-factor": {
    "text": "the header multiplies the displayed dimensions by {factor:g} ({variable})",
    "hint": ""
  },
  "unit.header-fractions": {
    "text": "the header displays lengths in feet and fractions of inches ($LUNITS = 4)",
    "hint": ""
  },
  "unit.header-imperial": {
    "text": "the header sets imperial units ($MEASUREMENT = 0)",
    "hint": ""
  },
  "unit.header-metric": {
    "text": "the header sets metric units ($MEASUREMENT = 1)",
    "hint": ""
  },
  "unit.header-missing": {
    "text": "the file states no unit ($INSUNITS is missing)",
    "hint": ""
  },
  "unit.header-not-a-number": {
    "text": "the header states no valid unit: $INSUNITS = {value!r} is not a number",
    "hint": ""
  },
  "unit.header-undefined": {
    "text": "the header states no valid unit: $INSUNITS = {value} is not defined",
    "hint": ""
  },
  "unit.header-unitless": {
    "text": "the header states that the drawing has no unit ($INSUNITS = 0)",
    "hint": ""
  },
  "unit.header-unsupported": {
    "text": "the header states a unit that is not supported: {name:unit} ($INSUNITS = {value})",
    "hint": ""
  },
  "unit.imprecise": {
    "text": "in {unit:unit} the lengths are too imprecise to show whether they are multiples of a round number",
    "hint": ""
  },
  "unit.inconclusive": {
    "text": "{stated}, but the drawing does not give enough evidence for {unit:unit}",
    "hint": ""
  },
  "unit.multiples": {
    "text": "in {unit:unit} {count} of {all} different lengths ({percent:.0f} % of their total) are multiples of {grid}",
    "hint": ""
  },
  "unit.no-number-matches": {
    "text": "in {unit:unit} none of {all:# number|# numbers} on the sheet is the length of an edge",
    "hint": ""
  },
  "unit.not-given": {
    "text": "the unit is not known",
    "hint": ""
  },
  "unit.number": {
    "text": "{text}",
    "hint": ""
  },
  "unit.number-in": {
    "text": "{text} ({unit:unit})",
    "hint": ""
  },
  "unit.numbers-match": {
    "text": "in {unit:unit} {count} of {all} numbers on the sheet {count:is the length|are the lengths} of an edge: {numbers:, }",
    "hint": ""
  },
  "unit.numbers-match-often": {
    "text": "in {unit:unit} {count} of {all} numbers on the sheet are the lengths of edges: {numbers:, } …",
    "hint": ""
  },
  "unit.overruled": {
    "text": "{stated}; the drawing supports {unit:unit}: {reason}",
    "hint": ""
  },
  "unit.page-in-pixels": {
    "text": "the file states its size without a unit, as pages in pixels or points do",
    "hint": ""
  },
  "unit.page-in-points": {
    "text": "the file was written by Illustrator, which uses points",
    "hint": ""
  },
  "unit.paper-size": {
    "text": "in {unit:unit} the drawing has exactly the size of a sheet of paper ({sheet})",
    "hint": ""
  },
  "unit.part-drawn-twice": {
    "text": "The drawing contains the same part at two sizes: one is {factor:.3g} times larger than the other. One of them is a detail, or was inserted with a wrong unit.",
    "hint": "Delete the part with the wrong size, or ignore its edges."
  },
  "unit.parts-differ": {
    "text": "Parts of the drawing have different units: one part is drawn in {one}, another part in {other}.",
    "hint": "Scale one of the parts in the CAD program and export the drawing again."
  },
  "unit.pdf": {
    "text": "the PDF states its coordinates in points of 1/72 inch",
    "hint": ""
  },
  "unit.pdf-scaled": {
    "text": "the PDF states coordinate units of {scale:g} points of 1/72 inch (UserUnit)",
    "hint": ""
  },
  "unit.read-against-evidence": {
    "text": "The drawing is most likely in {best:unit}: {best_width:mm} × {best_height:mm} mm. It was read in {unit:unit}: {width:mm} × {height:mm} mm.",
    "hint": "Check the size, and choose another unit if it is wrong."
  },
  "unit.read-against-header": {
    "text": "The header states {stated:unit}, so the drawing would measure {stated_width:mm} × {stated_height:mm} mm. It was read in {unit:unit}: {width:mm} × {height:mm} mm.",
    "hint": "Check the size, and choose another unit if it is wrong."
  },
  "unit.scale-mentioned": {
    "text": "A text on the sheet mentions the scale {scales:, }, so the drawing may not have its true size.",
    "hint": "Check the size of the drawing."
  },
  "unit.share-stated": {
    "text": "the header states {stated:unit}; {percent:.3g} % of the drawings with such a header are in {unit:unit}",
    "hint": ""
  },
  "unit.share-unstated": {
    "text": "the file states no unit; {percent:.3g} % of such drawings are in {unit:unit}",
    "hint": ""
  },
  "unit.shortest-edges": {
    "text": "in {unit:unit} its shortest edges are {length:mm} mm long",
    "hint": ""
  },
  "unit.size-unusual": {
    "text": "in {unit:unit} the drawing measures {width:mm} × {height:mm} mm, an unusual size for a carton",
    "hint": ""
  },
  "unit.size-usual": {
    "text": "in {unit:unit} the drawing measures {width:mm} × {height:mm} mm, a usual size for a carton",
    "hint": ""
  },
  "unit.svg-no-size": {
    "text": "the SVG has neither a width nor a height; {pixel}",
    "hint": ""
  },
  "unit.svg-no-unit": {
    "text": "the SVG states its size without a unit of length ({size: }); {pixel}",
    "hint": ""
  },
  "unit.svg-pixel": {
    "text": "one coordinate unit is 1/96 inch (0.2646 mm) in a browser, but 1/72 inch (0.3528 mm) in Illustrator",
    "hint": ""
  },
  "unit.svg-pixel-illustrator": {
    "text": "one coordinate unit is 1/96 inch (0.2646 mm) in a browser, but 1/72 inch (0.3528 mm) in Illustrator, which wrote the file",
    "hint": ""
  },
  "unit.svg-size": {
    "text": "the SVG states its size ({size: }) for a viewBox of {width:g} × {height:g}",
    "hint": ""
  },
  "unit.svg-size-in-pixels": {
    "text": "the SVG states its size ({size: }) and has no viewBox, so one coordinate unit is 1/96 inch",
    "hint": ""
  },
  "unit.text-states": {
    "text": "a text on the sheet states the unit: “{text}”",
    "hint": ""
  },
  "unit.unsupported": {
    "text": "{unit!r} is not a supported unit of length.",
    "hint": "Choose one of {known:or}."
  },
  "verify.bad-tolerance": {
    "text": "The tolerance of the check is {tolerance} mm, which is not a valid length.",
    "hint": "Give a number greater than 0, usually 0.01 mm."
  },
  "verify.beam-on-rapid": {
    "text": "The laser beam is on during a rapid move of {length:.3f} mm.",
    "hint": "Switch the beam off (M5) before the rapid move."
  },
  "verify.beam-refocused": {
    "text": "The laser beam is on while its focus moves up or down by {height:.3f} mm.",
    "hint": "Switch the beam off (M5) before the height changes."
  },
  "verify.beside-line": {
    "text": "The path of the {tool:tool} is {distance:.3f} mm away from the drawn line.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.beyond-rotation": {
    "text": "Axis {joint} turns to {position:.3f}°, but its travel is {low:g}° to {high:g}°.",
    "hint": "Turn the drawing on the table, or choose a machine with more travel."
  },
  "verify.beyond-travel": {
    "text": "Axis {joint} moves to {position:.3f} mm, but its travel is {low:g} to {high:g} mm.",
    "hint": "Move the drawing on the table, or choose a larger machine."
  },
  "verify.bridge-near-corner": {
    "text": "The bridge at {place:.3f} mm along the contour is {distance:.3f} mm too close to a sharp corner.",
    "hint": "Compile the job again, or choose a smaller spacing of bridges for the board."
  },
  "verify.bridge-spacing": {
    "text": "The bridge at {place:.3f} mm along the contour is {distance:.3f} mm away from the next bridge, but the board allows at most {most:g} mm.",
    "hint": "Compile the job again, or allow a larger spacing of bridges for the board."
  },
  "verify.bridge-spare": {
    "text": "The bridge at {place:.3f} mm along the contour is not needed, because its two neighbours are only {distance:.3f} mm apart.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.bridge-width": {
    "text": "The bridge at {place:.3f} mm along the contour is {width:.3f} mm wide in the top face of the board, but the board needs {planned:g} mm.",
    "hint": "Compile the job again for this board."
  },
  "verify.centre-off-path": {
    "text": "The centre of the cutter is {distance:.4f} mm away from its planned path, and the controller may round corners by another {rounding:.4f} mm. The tolerance is {tolerance:g} mm.",
    "hint": "Increase the tolerance, or report an internal error with the program file."
  },
  "verify.cleaning-beyond": {
    "text": "Internal error in cleaning: the cleaned edge extends beyond everything that was drawn.",
    "hint": "Report it with the drawing."
  },
  "verify.cleaning-dropped": {
    "text": "Internal error in cleaning: {length:.3f} mm of the edge were lost.",
    "hint": "Report it with the drawing."
  },
  "verify.cleaning-incomplete": {
    "text": "Internal error in cleaning: the kept, merged and dropped parts of the edge do not add up to its length.",
    "hint": "Report it with the drawing."
  },
  "verify.cleaning-invented": {
    "text": "Internal error in cleaning: the cleaned edge has no counterpart in the drawing.",
    "hint": "Report it with the drawing."
  },
  "verify.cleaning-moved": {
    "text": "Internal error in cleaning: the edge was moved by {distance:.4f} mm.",
    "hint": "Report it with the drawing."
  },
  "verify.cleaning-type": {
    "text": "Internal error in cleaning: the drawn edge is {drawn}, but the cleaned edge is {worked}.",
    "hint": "Report it with the drawing."
  },
  "verify.comes-out-anywhere": {
    "text": "The knife leaves the board at a point that is neither the end of an edge nor the point where it entered.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.comes-out-past": {
    "text": "The knife leaves the board {distance:.3f} mm beyond the end of the edge.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.comes-out-short": {
    "text": "The knife leaves the board {distance:.3f} mm before the end of the edge.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.crease-too-short": {
    "text": "The crease is too short for the creasing wheel.",
    "hint": "Join it to a collinear crease, set it to ignored, or choose a smaller wheel."
  },
  "verify.cuts-part": {
    "text": "The cutter removes {depth:.3f} mm from a part that must remain whole.",
    "hint": "Move the parts further apart, or choose a thinner cutter."
  },
  "verify.cutter-at-rest": {
    "text": "The cutter moves through the board while its spindle is off.",
    "hint": "Start the spindle (M3) before the cutter enters the board."
  },
  "verify.flank-inside": {
    "text": "The flank of the V-groove meets the top face {distance:.4f} mm inside its planned position; the tolerance is {tolerance:g} mm.",
    "hint": "Check the tilt and the offsets of the V-cutter in the machine file, then compile again."
  },
  "verify.flank-outside": {
    "text": "The flank of the V-groove meets the top face {distance:.4f} mm outside its planned position; the tolerance is {tolerance:g} mm.",
    "hint": "Check the tilt and the offsets of the V-cutter in the machine file, then compile again."
  },
  "verify.flank-through-cut": {
    "text": "A flank of the V-groove extends {depth:.3f} mm beyond the cut at edge {edge}, which lies {distance:.3f} mm beside the groove, at {place:.1f} mm from the start of the groove.",
    "hint": "Move the groove and the cut further apart, or make the groove less deep."
  },
  "verify.goes-in-anywhere": {
    "text": "The knife enters the board at a point where no edge begins.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.groove-arc": {
    "text": "The V-groove is an arc, which a tilted blade cannot follow.",
    "hint": "Draw it with straight lines, or give it another line type."
  },
  "verify.groove-past-ends": {
    "text": "The V-cutter cuts {length:.2f} mm beyond the ends of the groove, but the board allows {most:.2f} mm.",
    "hint": "Choose a narrower blade, or allow a longer overcut for this board."
  },
  "verify.groove-shallower": {
    "text": "The V-cutter cuts {depth:.3f} mm deep although an earlier pass was already {before:.3f} mm deep.",
    "hint": "Order the passes by increasing depth."
  },
  "verify.inside-part": {
    "text": "The cutter cuts into a part at X{x:.3f} Y{y:.3f} (coordinates of the sheet).",
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
    "text": "The edge at X{x:.3f} Y{y:.3f} (coordinates of the sheet) lies on a piece that line {line} has already cut loose, so the piece may move.",
    "hint": "Make this edge before the contour around the piece is cut."
  },
  "verify.lowers-second": {
    "text": "The line lowers station {station} while station {other} may still be lowered.",
    "hint": "Release station {other} first (M65 P{output})."
  },
  "verify.moves-before-stated": {
    "text": "The program moves the head before it switches off {thing}.",
    "hint": "Switch it off first, or only lift the head straight up to Z {height:.3f} mm or higher."
  },
  "verify.moves-with-beam": {
    "text": "The program moves the head before it switches the spindle off (M5), so a laser beam may still be on.",
    "hint": "Write M5 before the first move."
  },
  "verify.never-stated": {
    "text": "The program never switches off {thing}, so it may still be on.",
    "hint": "Switch it off at the beginning of the program."
  },
  "verify.no-station": {
    "text": "The line cuts, but the program has not selected a station (T and M6) before.",
    "hint": "Select the station before the first cut."
  },
  "verify.not-worked": {
    "text": "{length:.3f} mm of the edge are not {work}{where}.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.off-line": {
    "text": "The path of the {tool:tool} is {distance:.4f} mm away from the drawn line, and the controller may round corners by another {rounding:.4f} mm. The tolerance is {tolerance:g} mm.",
    "hint": "Increase the tolerance, or report an internal error with the program file."
  },
  "verify.oscillation-on": {
    "text": "Station {station} processes the board while the oscillation is on, although its tool must not oscillate.",
    "hint": "Switch the oscillation off (M5) before this station is used."
  },
  "verify.other-placement": {
    "text": "The program places the drawing at X{x:.4f} Y{y:.4f} on the sheet, but the job places it at X{job_x:.4f} Y{job_y:.4f}.",
    "hint": "Compile the job again, or verify the program with its own placement."
  },
  "verify.output": {
    "text": "output {output} (M65 P{output})",
    "hint": ""
  },
  "verify.output-off": {
    "text": "Station {station} processes the board while its output {output} is off, so its tool is not lowered.",
    "hint": "Switch output {output} on (M64) before the station is used."
  },
  "verify.pass-too-deep": {
    "text": "The {tool:tool} cuts {depth:.3f} mm deep at once along {length:.3f} mm without an earlier pass, but at most {step:g} mm per pass are allowed.",
    "hint": "Add a shallower pass, or allow deeper passes for this board."
  },
  "verify.past-end": {
    "text": "The {tool:tool} continues {length:.3f} mm beyond the end of the edge.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.past-open-cut": {
    "text": "The cutter cuts {length:.3f} mm beyond the end of an open cut.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.past-stop": {
    "text": "The {tool:tool} continues {length:.3f} mm beyond the point where it must stop.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.perforation-cut": {
    "text": "A cut of the perforation is {length:.3f} mm long instead of {planned:.3f} mm.",
    "hint": "Compile the job again for this board."
  },
  "verify.perforation-gap": {
    "text": "A gap of the perforation is {length:.3f} mm long at {place:.3f} mm from its start, but the board needs gaps of {planned:g} mm.",
    "hint": "Compile the job again for this board."
  },
  "verify.rapid-in-board": {
    "text": "A rapid move takes station {station} {depth:.3f} mm below the top of the board.",
    "hint": "Lift the tool above the board before the rapid move."
  },
  "verify.slanted": {
    "text": "Station {station} moves {distance:.3f} mm sideways out of its line while it enters or leaves the board.",
    "hint": "Enter and leave the board along the axis of the tool."
  },
  "verify.spindle": {
    "text": "the spindle (M5)",
    "hint": ""
  },
  "verify.stray": {
    "text": "The {tool:tool} processes {length:.3f} mm of the board at X{x:.3f} Y{y:.3f} (coordinates of the sheet), but no edge is there.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.stray-along": {
    "text": "The {tool:tool} processes {length:.3f} mm along edge {edge}, whose line type ({type}) must not be processed with this tool.",
    "hint": "Check the line type of the edge, then compile the job again."
  },
  "verify.stray-plunge": {
    "text": "The {tool:tool} enters the board at X{x:.3f} Y{y:.3f} (coordinates of the sheet), but no edge is there.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.stray-plunge-along": {
    "text": "The {tool:tool} enters the board on edge {edge}, whose line type ({type}) must not be processed with this tool.",
    "hint": "Check the line type of the edge, then compile the job again."
  },
  "verify.switches-at-unknown-height": {
    "text": "The line switches an output or the spindle before the program has set the height of the head.",
    "hint": "Lift the head to {needed:.3f} mm first."
  },
  "verify.switches-low": {
    "text": "The line switches an output or the spindle while axis Z is at {height:.3f} mm, which is too low.",
    "hint": "Lift the head to {needed:.3f} mm first."
  },
  "verify.too-few-bridges": {
    "text": "{bridges:# bridge holds|# bridges hold} the part, but the board needs at least {fewest}.",
    "hint": "Compile the job again, or require fewer bridges for this board."
  },
  "verify.turn-at-feed": {
    "text": "Axis C turns by {degrees:.4f}° in a line whose feed is in mm/min, so the duration of the turn is not defined.",
    "hint": "Give the duration of the line (G93)."
  },
  "verify.turn-in-board": {
    "text": "Axis C turns by {degrees:.3f}° while the tool is in the board; at most {most:.2f}° is allowed.",
    "hint": "Lift the tool before it turns."
  },
  "verify.turn-off-path": {
    "text": "Axis C turns by {degrees:.3f}° in the board, although the path turns by {path:.3f}°.",
    "hint": "Turn the tool by the same angle as the path."
  },
  "verify.two-lowered": {
    "text": "Station {station} processes the board while station {other} is lowered too (output {output} is on).",
    "hint": "Release station {other} first (M65 P{output})."
  },
  "verify.unclassified": {
    "text": "The edge has no line type, so it is not known how it must be processed.",
    "hint": "Give the edge a line type."
  },
  "verify.unknown-position": {
    "text": "The line starts or ends at a position that the program has not set.",
    "hint": "Give X, Y, Z and C before this line."
  },
  "verify.where-from-start": {
    "text": ", beginning {place:.3f} mm from its start",
    "hint": ""
  },
  "verify.where-past-end": {
    "text": ", where the tool must continue beyond its end",
    "hint": ""
  },
  "verify.where-past-start": {
    "text": ", where the tool must begin before its start",
    "hint": ""
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
    "text": "grooved in the direction from its end to its start",
    "hint": ""
  },
  "verify.work-grooved-from-start": {
    "text": "grooved in the direction from its start to its end",
    "hint": ""
  },
  "verify.wrong-depth": {
    "text": "The {tool:tool} is {depth:.3f} mm below the top of the board instead of {planned:.3f} mm.",
    "hint": "Compile the job again for this board."
  },
  "verify.wrong-feed": {
    "text": "Station {station} has a feed of {feed:g} mm/min instead of {planned:g} mm/min.",
    "hint": "Compile the job again with the present machine file."
  },
  "verify.wrong-heading": {
    "text": "The {tool:tool} is turned {degrees:.3f}° away from the direction of the line, which moves its edge {swing:.3f} mm sideways.",
    "hint": "Compile the job again. If the finding remains, report it as an internal error with the program file."
  },
  "verify.wrong-time": {
    "text": "The move of station {station} takes {seconds:.4f} s instead of {planned:.4f} s.",
    "hint": "Compile the job again with the present machine file."
  },
  "waiting.confirmed": {
    "text": "Confirmed; {machine} is starting.",
    "hint": ""
  },
  "waiting.for-gateway": {
    "text": "No gateway of {machine} asks for work.",
    "hint": "Switch on the machine and its gateway."
  },
  "waiting.for-machine": {
    "text": "Waiting until {machine} takes it.",
    "hint": ""
  },
  "waiting.for-person": {
    "text": "No gateway of {machine} asks for work.",
    "hint": "{advice}"
  },
  "waiting.for-sheet": {
    "text": "Copy {copy} of {copies} is done.",
    "hint": "Put a new sheet of {board} on the table and confirm."
  },
  "waiting.for-start": {
    "text": "Waiting for the operator at {machine}: table clear, board {board!r}{tools}.",
    "hint": "Check the table, then confirm to start."
  },
  "waiting.for-turn": {
    "text": "Waiting for its turn at {machine}; other jobs come first.",
    "hint": ""
  },
  "waiting.taken": {
    "text": "{machine} is taken by job {job}, which is {state}.",
    "hint": ""
  },
  "waiting.taken-interrupted": {
    "text": "{machine} is taken by job {job}, which is interrupted.",
    "hint": "Mark that job finished, queue it again or scrap it first."
  },
  "waiting.taken-unconfirmed": {
    "text": "{machine} is taken by job {job}, which waits for its confirmation.",
    "hint": ""
  },
  "waiting.tool": {
    "text": "{name} (station {station})",
    "hint": ""
  },
  "waiting.tools": {
    "text": ", tools: {tools:, }",
    "hint": ""
  },
  "waiting.unconfirmed-run": {
    "text": "{machine} was started without the operator's confirmation: board {board!r}{tools}.",
    "hint": "Look at the table. Confirm to let the job go on, or cancel it."
  },
  "worker.died": {
    "text": "The process that computed the drawing ended unexpectedly (exit code {code}), probably because the memory was full.",
    "hint": "Send a smaller drawing, or split this one."
  },
  "worker.memory": {
    "text": "The drawing needs more than {limit} GB of memory, the limit for one drawing.",
    "hint": "Send a smaller drawing, or split this one."
  },
  "worker.timeout": {
    "text": "The stage {stage} took longer than {seconds:.0f} s.",
    "hint": "Send a smaller drawing, or split this one."
  }
} as const satisfies Catalogue;

export const UNITS: Readonly<Record<string, string>> = {
  "": "units of the file",
  "mm": "mm",
  "cm": "cm",
  "m": "metres",
  "in": "inches",
  "ft": "feet",
  "pt": "points",
  "px": "pixels",
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
};

export const TOOLS: Readonly<Record<string, string>> = {
  "cutter": "cutter",
  "knife": "knife",
  "v-cutter": "V-cutter",
  "wheel": "wheel"
};
