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
  "board.named": {
    "text": "{name} ({caliper:g} mm)",
    "hint": ""
  },
  "board.not-in-library": {
    "text": "{name}",
    "hint": ""
  },
  "bridges.no-room": {
    "text": "The contour at edge {edge} is {length:.1f} mm long and has no places for {fewest:# bridge|# bridges} of {gap:.2f} mm, at most {spacing:.1f} mm apart and clear of its corners and narrow slots.",
    "hint": "Choose narrower bridges or a longer spacing, or cut this board without bridges."
  },
  "calibration.bad-points": {
    "text": "The {count} measured points contain a value that is not a number, or there are none.",
    "hint": "Measure at least one point on a slanted part of the contour."
  },
  "calibration.choose-cutter": {
    "text": "{machine} has {count:# cutter|# cutters}.",
    "hint": "Choose one: {cutters:, }."
  },
  "calibration.missing-column": {
    "text": "{file}, line {line}: {columns} is missing.",
    "hint": "Its first line must be azimuth,dx,dy; then degrees and mm follow, for example 45,-0.05,0.06."
  },
  "calibration.not-a-number": {
    "text": "{file}, line {line}: {reason}.",
    "hint": "Write numbers with a decimal point."
  },
  "calibration.not-csv": {
    "text": "{file} is not a CSV file: {reason}.",
    "hint": "Save it as CSV in UTF-8."
  },
  "calibration.undetermined": {
    "text": "The contour runs along {along} at every measured point, so {other} is not determined (the sum of squares is {weight:.4f}; {least} is needed).",
    "hint": "Measure one more point where the contour runs along {direction}, or at 45°."
  },
  "calibration.wrong-sign": {
    "text": "By the measured points the tool is drawn into the board (δx {x:.3f}, δy {y:.3f} mm).",
    "hint": "Check the signs of ΔX and ΔY, and the side on which the tool runs."
  },
  "cf2.cut-short": {
    "text": "The CF2 is cut short: it ends at line {line} inside {inside}, so lines may be missing.",
    "hint": "Send it again, or export it again as CF2."
  },
  "cf2.decimal-commas": {
    "text": "Line {line} of the CF2 has {fields} fields where {record} has {expected}: its decimals seem to use commas, which also separate the fields.",
    "hint": "Export it with a decimal point."
  },
  "cf2.empty": {
    "text": "The CF2 draws nothing: it has neither a MAIN section nor a subroutine.",
    "hint": "Send it again, or export it again as CF2."
  },
  "classification.around": {
    "text": "surrounds a whole carton",
    "hint": ""
  },
  "classification.arrow": {
    "text": "has an arrowhead, or belongs to a line that has one",
    "hint": ""
  },
  "classification.as-its-style": {
    "text": "as all of its style do",
    "hint": ""
  },
  "classification.bleed": {
    "text": "surrounds a blank at the same distance everywhere, as a bleed does",
    "hint": ""
  },
  "classification.board-ends": {
    "text": ": the board ends there, unless the outline is open",
    "hint": ""
  },
  "classification.closes-nothing": {
    "text": " and closes nothing",
    "hint": ""
  },
  "classification.contradicted": {
    "text": "{rule}; but {reason}",
    "hint": ""
  },
  "classification.convention": {
    "text": "colour convention \"{name}\" fits: the outline closes, {folds} of {lines:# dividing line is a fold|# dividing lines are folds}",
    "hint": ""
  },
  "classification.cuts-panel-off": {
    "text": "it would cut a panel off its blank",
    "hint": ""
  },
  "classification.dashed": {
    "text": "in dashes",
    "hint": ""
  },
  "classification.divider": {
    "text": "divides two panels",
    "hint": ""
  },
  "classification.divides-panels": {
    "text": ", and a {type} divides panels",
    "hint": ""
  },
  "classification.frame": {
    "text": "frames the whole drawing",
    "hint": ""
  },
  "classification.free": {
    "text": "lies free inside a panel",
    "hint": ""
  },
  "classification.hole": {
    "text": "closes a hole in a panel",
    "hint": ""
  },
  "classification.inner": {
    "text": "lies inside a hole, or divides one",
    "hint": ""
  },
  "classification.layer-denies": {
    "text": "but its layer is called \"{layer}\"",
    "hint": ""
  },
  "classification.layer-name": {
    "text": "its layer name contains \"{word}\"",
    "hint": ""
  },
  "classification.legend": {
    "text": "lies outside every blank, beside the name of a line type: a legend",
    "hint": ""
  },
  "classification.letter": {
    "text": "lies in a row of small shapes, as letters do",
    "hint": ""
  },
  "classification.like-outline": {
    "text": "in the style of the outline",
    "hint": ""
  },
  "classification.like-outline-not-folds": {
    "text": "in the style of the outline; another style has the folds",
    "hint": ""
  },
  "classification.linetype-name": {
    "text": "its linetype name contains \"{word}\"",
    "hint": ""
  },
  "classification.mark": {
    "text": "closes a shape much smaller than the blank",
    "hint": ""
  },
  "classification.mirror-cut": {
    "text": "its mirror image is cut",
    "hint": ""
  },
  "classification.mirror-folded": {
    "text": "its mirror image is folded",
    "hint": ""
  },
  "classification.mixed": {
    "text": "{reason}, with the greater part of its length",
    "hint": ""
  },
  "classification.named": {
    "text": "is not part of the carton by its name, and the outlines close without it",
    "hint": ""
  },
  "classification.no-rule": {
    "text": "no rule of profile {profile}",
    "hint": ""
  },
  "classification.no-rule-but-shape": {
    "text": "no rule of profile {profile}; {shape}",
    "hint": ""
  },
  "classification.none-closes": {
    "text": ", as all of its style do, and none closes an outline",
    "hint": ""
  },
  "classification.not-made": {
    "text": ", and is not to be made",
    "hint": ""
  },
  "classification.on-cut": {
    "text": "{rule}; it lies on a cut",
    "hint": ""
  },
  "classification.open": {
    "text": "belongs to an outline that does not close",
    "hint": ""
  },
  "classification.other-style-closes": {
    "text": "but another style closes most of it",
    "hint": ""
  },
  "classification.outline": {
    "text": "closes the outline of a blank",
    "hint": ""
  },
  "classification.override": {
    "text": "override",
    "hint": ""
  },
  "classification.paired": {
    "text": "some of them in pairs",
    "hint": ""
  },
  "classification.panel-hangs": {
    "text": "and a panel hangs on it",
    "hint": ""
  },
  "classification.panels-hang": {
    "text": "and panels hang on most of them",
    "hint": ""
  },
  "classification.role-against": {
    "text": "it {role}{against}",
    "hint": ""
  },
  "classification.rule": {
    "text": "profile {profile}: {rule}",
    "hint": ""
  },
  "classification.shape": {
    "text": "shape: it {parts:, }",
    "hint": ""
  },
  "classification.slit": {
    "text": "begins at another line and ends inside a panel",
    "hint": ""
  },
  "classification.slot": {
    "text": "closes a slot or a round hole in a panel",
    "hint": ""
  },
  "classification.speck": {
    "text": "lies outside every blank, by itself, and is small",
    "hint": ""
  },
  "classification.stray": {
    "text": "lies outside every blank",
    "hint": ""
  },
  "classification.swapped": {
    "text": "the lines that it calls crease close the outline",
    "hint": ""
  },
  "classification.swapped-both": {
    "text": "the lines that it calls crease close the outline, and those that it calls cut divide the panels",
    "hint": ""
  },
  "classification.swapped-like": {
    "text": "{reason}; {convention}",
    "hint": ""
  },
  "classification.table": {
    "text": "lies beside a text: a title block, a dimension or a label",
    "hint": ""
  },
  "classification.unknown": {
    "text": "gives no information by its shape",
    "hint": ""
  },
  "classification.votes": {
    "text": "{votes:; }",
    "hint": ""
  },
  "classification.with-text": {
    "text": "{reason}, with a text beside it",
    "hint": ""
  },
  "cleaning.as-drawn": {
    "text": "",
    "hint": ""
  },
  "cleaning.dropped-speck": {
    "text": "dropped: {length:.4g} mm long and connects nothing",
    "hint": ""
  },
  "cleaning.end-moved": {
    "text": "an end moved by {distance:.2g} mm to meet another",
    "hint": ""
  },
  "cleaning.fitted": {
    "text": "it is a part of a flattened curve that became one line or arc",
    "hint": ""
  },
  "cleaning.fitted-edge": {
    "text": "merged: a flattened curve, one with edge {edge} within {distance:.2g} mm",
    "hint": ""
  },
  "cleaning.ignored": {
    "text": "ignored: shown, and kept out of the tool path",
    "hint": ""
  },
  "cleaning.joined": {
    "text": "it was merged into a collinear edge",
    "hint": ""
  },
  "cleaning.joined-edge": {
    "text": "merged into the collinear edge {edge}",
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
    "text": "{length:.4g} mm of it lie on other edges",
    "hint": ""
  },
  "cleaning.longer": {
    "text": "collinear edges were merged into it",
    "hint": ""
  },
  "cleaning.moved": {
    "text": "an end was moved to meet another edge",
    "hint": ""
  },
  "cleaning.no-work": {
    "text": "left as it is: no work",
    "hint": ""
  },
  "cleaning.on-edge": {
    "text": "merged: it lies on edge {edge}",
    "hint": ""
  },
  "cleaning.part-dropped": {
    "text": "a speck of {length:.2g} mm dropped",
    "hint": ""
  },
  "cleaning.shortened": {
    "text": "a part of it lies on other edges",
    "hint": ""
  },
  "cleaning.speck": {
    "text": "it is a speck that connects nothing",
    "hint": ""
  },
  "cleaning.twice": {
    "text": "it lies on other edges",
    "hint": ""
  },
  "cleaning.unclassified": {
    "text": "not decided yet",
    "hint": ""
  },
  "command.bad-corner": {
    "text": "--corner-at {text!r} is not X,Y=TYPE or X,Y=TYPE:K.",
    "hint": "Write for example --corner-at 300,100=C or 300,100=D:0.3."
  },
  "command.bad-layer": {
    "text": "--layer {pair!r} is not NAME=TYPE.",
    "hint": "Write for example --layer FOLDS=crease."
  },
  "command.bad-line-type": {
    "text": "--layer {pair!r}: {reason}.",
    "hint": "Choose one of them."
  },
  "command.file-too-large": {
    "text": "{path} is larger than {limit} MB.",
    "hint": "Export a single carton, without pictures."
  },
  "command.no-such-layer": {
    "text": "There is no layer {layer!r} in {file}.",
    "hint": "Its layers are {layers:, }."
  },
  "command.unreadable-file": {
    "text": "Cannot read {path}: {reason}.",
    "hint": "Check the file's name and permissions."
  },
  "command.unwritable-file": {
    "text": "Cannot write {path}: {reason}.",
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
    "text": "{interference!r} is not a way to handle places where the cutter does not fit.",
    "hint": "Choose trim or refuse."
  },
  "corner.bad-k": {
    "text": "The corner parameter k at the corner where edge {edge} begins is {k}.",
    "hint": "Give a k from 0 (as B) to 1 (as C)."
  },
  "corner.bad-k-at": {
    "text": "The corner parameter k{where} is {k}; a D corner needs one between 0 and 1.",
    "hint": "Choose B instead of 0, and C instead of 1."
  },
  "corner.bad-place": {
    "text": "The corner at ({x}, {y}) has no valid position.",
    "hint": "Give X and Y in the drawing's millimetres."
  },
  "corner.bad-share": {
    "text": "Corner {corner} is of type D with k = {k}.",
    "hint": "Give a k from 0 (as B) to 1 (as C)."
  },
  "corner.inside": {
    "text": "The corner at ({x:g}, {y:g}) is an inside corner, which the cutter passes in one way only.",
    "hint": "Choose types for outside corners."
  },
  "corner.no-contour": {
    "text": "No corner of a milled contour is within {within:g} mm of ({x:g}, {y:g}).",
    "hint": "This drawing has no contour that the cutter mills round corners."
  },
  "corner.no-cutter": {
    "text": "Corner types were chosen, and {machine} has no rotating cutter.",
    "hint": "Leave the corner types out, or choose a machine that mills."
  },
  "corner.not-found": {
    "text": "No corner of a milled contour is within {within:g} mm of ({x:g}, {y:g}): the nearest is {distance:.2f} mm away.",
    "hint": "Give its X and Y in the drawing's millimetres: the nearest are {known:, }."
  },
  "corner.unknown-number": {
    "text": "Corner {corner} has the type {type}, which does not exist.",
    "hint": "Give B, C or D."
  },
  "corner.unknown-type": {
    "text": "There is no corner type {type!r}.",
    "hint": "The types are B, C, D and auto."
  },
  "corner.unknown-type-at": {
    "text": "There is no corner type {type!r}{where}.",
    "hint": "The types are B, C, D and auto."
  },
  "crease.tight-bend": {
    "text": "The crease at edge {edge} bends with a radius of {radius:.2f} mm, and its double would lie {offset:.2f} mm inside it.",
    "hint": "Draw a wider bend, or set the board's double crease to 0."
  },
  "crease.too-short": {
    "text": "The crease at edge {edge} is {length:.2f} mm long, too short for a wheel of {radius:.1f} mm radius that keeps {clearance:.2f} mm off its ends.",
    "hint": "Join it to its neighbour, ignore it, or choose a board that allows short creases to be pressed in place."
  },
  "curve.bad-ellipse": {
    "text": "The ellipse has no size, or no sweep that is a number.",
    "hint": "Draw it again."
  },
  "curve.bad-spline": {
    "text": "The spline of degree {degree} with {points} control points and {knots} knots is damaged.",
    "hint": "Draw it again, or export it as lines and arcs."
  },
  "curve.bad-tolerance": {
    "text": "A curve cannot be fitted within {tolerance} mm.",
    "hint": "Give a tolerance greater than 0."
  },
  "curve.not-finite": {
    "text": "The curve has points that are not numbers.",
    "hint": "Draw it again, as lines and arcs."
  },
  "curve.not-fitted": {
    "text": "The curve cannot be approximated within {tolerance:g} mm.",
    "hint": "Draw it again, as lines and arcs."
  },
  "curve.parameters": {
    "text": "The curve's parameters do not increase.",
    "hint": "Draw it again, as lines and arcs."
  },
  "curve.too-many-pieces": {
    "text": "The curve needs more than {limit:,} pieces to stay within {tolerance:g} mm.",
    "hint": "Increase the tolerance, or simplify the curve."
  },
  "curve.too-many-spans": {
    "text": "The curve has {spans:,} spans; the limit is {limit:,}.",
    "hint": "Simplify it before exporting."
  },
  "cut.too-many-crossings": {
    "text": "More than {limit:,} pairs of cuts cross or lie beside each other.",
    "hint": "Delete hatching and what is drawn many times over, or split the drawing."
  },
  "cut.too-short": {
    "text": "The cut at edge {edge} is {length:.2f} mm long and ends inside a panel or at a bridge; the slanted blade needs {lead:.2f} mm.",
    "hint": "Ignore it, join it to another cut, or choose a steeper blade."
  },
  "cutter.does-not-fit": {
    "text": "The cutter of {diameter:.2f} mm does not fit into the contour at edge {edge}, nor into {others} more.",
    "hint": "Choose a thinner cutter, or ignore the contour."
  },
  "cutter.misses-bridge": {
    "text": "The cutter does not reach the contour at edge {edge} where a bridge is needed, {distance:.1f} mm along it.",
    "hint": "Choose a thinner cutter, another spacing of bridges, or a board without them."
  },
  "cutter.short-lead": {
    "text": "The cutter's lead is {lead:g} mm, not longer than its radius of {radius:g} mm.",
    "hint": "Give the cutter a lead longer than its radius."
  },
  "database.bad-url": {
    "text": "{url!r} is not the URL of a database.",
    "hint": "Write sqlite:///FILE or postgresql://USER@HOST/NAME."
  },
  "database.in-memory": {
    "text": "A database in memory would lose its jobs.",
    "hint": "Name a file: sqlite:///FILE."
  },
  "deflection.arc-too-small": {
    "text": "The cutter's centre follows an arc of {radius:.3f} mm radius near ({x:.2f}, {y:.2f}), and the tool gives way by {deflection:.3f} mm.",
    "hint": "Choose a smaller k or the B type, or measure the deflection again."
  },
  "deflection.path-too-short": {
    "text": "Near ({x:.2f}, {y:.2f}) the path of the cutter's centre is too short, or turns too sharply, to correct for the deflection.",
    "hint": "Join short edges there, or measure the deflection again."
  },
  "drawing.changing": {
    "text": "Drawing {drawing} is being changed by others at the same time.",
    "hint": "Try again in a moment."
  },
  "drawing.deleted": {
    "text": "Deleted.",
    "hint": ""
  },
  "drawing.in-use": {
    "text": "Job {job} was made from drawing {drawing}, which is kept as its record.",
    "hint": "Only drawings without jobs can be deleted."
  },
  "drawing.larger-than-table": {
    "text": "The drawing is {width:.1f} × {height:.1f} mm, and {machine} has room for {room_x:.0f} × {room_y:.0f} mm.",
    "hint": "Check the unit of the drawing, turn it, or choose a larger machine."
  },
  "drawing.open-questions": {
    "text": "{count:# question|# questions} must be answered first: {questions: }",
    "hint": "Answer them on the drawing; nothing is cut by default."
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
    "text": "Drawing {drawing} is at revision {revision}, and the request names {named}.",
    "hint": "Look at the drawing again; if the change is still wanted, repeat the request."
  },
  "drawing.types-set": {
    "text": "{count:# line type was|# line types were} set.",
    "hint": ""
  },
  "drawing.unit-for-cleaning": {
    "text": "The drawing does not state its unit, so the size of specks and gaps is not known.",
    "hint": "Set it with PATCH /api/drawings/ID, or on the page."
  },
  "drawing.unit-unknown": {
    "text": "The drawing does not state its unit ({evidence}).",
    "hint": "Set it with PATCH /api/drawings/ID, or on the page."
  },
  "drawing.unknown": {
    "text": "There is no drawing {drawing}.",
    "hint": "GET /api/drawings lists them."
  },
  "drawing.upload-too-large": {
    "text": "{name} is larger than {limit} MB.",
    "hint": "Send a smaller drawing."
  },
  "dxf.blocks-expand-too-far": {
    "text": "The blocks of the drawing expand to {count} entities; the limit is {limit:,}.",
    "hint": "Export a single carton, or explode the blocks and delete the copies."
  },
  "dxf.blocks-too-deep": {
    "text": "Blocks are nested {depth} deep; the limit is {limit}.",
    "hint": "Explode the blocks in the CAD program and export again."
  },
  "dxf.cut-short": {
    "text": "The file is cut short: it stops {where} in section {section}, after {count:# entity|# entities}, so lines may be missing.",
    "hint": "Send or export it again."
  },
  "dxf.no-section": {
    "text": "The file is not a DXF: it has no section.",
    "hint": "Export the drawing as DXF (text or binary, any version)."
  },
  "dxf.not-a-group-code": {
    "text": "The file is not a DXF: line {line} is {text!r}, not a group code.",
    "hint": "Export the drawing as DXF (text or binary, any version)."
  },
  "dxf.other-kind": {
    "text": "The file is {kind}, not a DXF.",
    "hint": "Export the drawing as DXF (text or binary, any version)."
  },
  "dxf.too-large-unusual": {
    "text": "The DXF has {size:.1f} MB and uses features that are read slowly; the limit for such a file is {limit:.1f} MB.",
    "hint": "Export a single carton, or save it as DXF R2000."
  },
  "edge.no-length": {
    "text": "Edge {edges:, } has no length, so it has no direction.",
    "hint": "Delete it from the drawing, or increase the debris tolerance."
  },
  "edge.not-finite": {
    "text": "Edge {edge} has a coordinate that is not a number.",
    "hint": "Draw it again."
  },
  "edge.place": {
    "text": " at edge {edge}",
    "hint": ""
  },
  "edge.too-crowded": {
    "text": "More than {limit:,} pairs of line ends lie within {distance} mm of each other.",
    "hint": "Delete what is drawn many times over."
  },
  "edge.too-far": {
    "text": "Edge {edge} lies {distance:.3g} mm from the drawing's origin.",
    "hint": "Check the drawing's unit, or delete what was drawn there."
  },
  "edge.too-many-overlaps": {
    "text": "{edges:,} edges overlap each other in more than {limit:,} places.",
    "hint": "Delete what was drawn many times over."
  },
  "error.at-edge": {
    "text": "{error} Place: handle {handle}, layer \"{layer}\".",
    "hint": "{error:hint}"
  },
  "error.at-edges": {
    "text": "At edge {edges: and edge }: {error}",
    "hint": "{error:hint}"
  },
  "error.in-file": {
    "text": "{name}: {error}",
    "hint": "{error:hint}"
  },
  "field.invalid": {
    "text": "{path} {fault}",
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
  "field.unknown": {
    "text": "{path} is not a field",
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
    "text": " And {count} more.",
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
    "text": "The V-groove at edge {edge} meets the board's edge at {angle:.1f}°, almost along it, so its flanks would not leave the board.",
    "hint": "End it before the edge, or meet the edge at 5° or more."
  },
  "groove.curved": {
    "text": "{count:# V-groove edge is an arc|# V-groove edges are arcs}, the first of them edge {edge}; a straight blade cannot follow an arc.",
    "hint": "Draw straight lines, or give them another line type."
  },
  "groove.overcut": {
    "text": "The blade runs {overrun:.2f} mm past each end of a V-groove inside the board; the board allows {allowed:.2f} mm.",
    "hint": "Choose a narrower blade, or allow a longer overcut for this board."
  },
  "groove.runs-out": {
    "text": "The V-groove at edge {edge} would run {distance:.2f} mm over the board's edge, and cut into the board beyond.",
    "hint": "End it before the edge, meet the edge more squarely, or move the blanks apart."
  },
  "groove.through-cut": {
    "text": "The V-groove at edge {groove} is {width:.2f} mm wide at the top face, and its flank runs {through:.2f} mm through the cut at edge {cut}, which lies {distance:.2f} mm beside it, {place:.1f} mm from where the groove begins.",
    "hint": "Move them {through:.2f} mm further apart, or make the groove less deep."
  },
  "groove.through-cut-at-it": {
    "text": "The V-groove at edge {groove} is {width:.2f} mm wide at the top face, and its flank runs {through:.2f} mm through the cut at edge {cut}, which lies {distance:.2f} mm beside it, {place:.1f} mm from where the groove begins.",
    "hint": "End the groove at the cut, or move one of them."
  },
  "groove.tight-bend": {
    "text": "The V-groove at edge {edge} bends with a radius of {radius:.1f} mm; a blade of {blade:.2f} mm deviates from it by more than {error:.3f} mm.",
    "hint": "Draw a wider bend, choose a narrower blade, or allow this board a larger error."
  },
  "groove.too-deep": {
    "text": "The V-groove at edge {edge} is {depth:.2f} mm deep, and the board is only {caliper:.2f} mm thick.",
    "hint": "Choose a shallower groove or a thicker board."
  },
  "groove.too-short": {
    "text": "The V-groove at edge {edge} is {length:.2f} mm long, and the blade is {blade:.2f} mm wide.",
    "hint": "Draw the groove longer, or choose a narrower blade."
  },
  "hpgl.bad-byte": {
    "text": "The byte {byte} has no meaning here.",
    "hint": "Remove it."
  },
  "hpgl.bad-feed": {
    "text": "{place} has a feed of {feed:g} mm/min, and {device} has whole cm/s from {slowest} to {fastest}.",
    "hint": "Give the tool a feed that is a multiple of {step:g} mm/min."
  },
  "hpgl.bad-number": {
    "text": "A sign has no number, or a number has too many digits.",
    "hint": ""
  },
  "hpgl.depth-change": {
    "text": "{place} changes its depth while it works.",
    "hint": "Work in one pass."
  },
  "hpgl.ends-down": {
    "text": "The program ends with the tool down.",
    "hint": ""
  },
  "hpgl.ends-with-pen": {
    "text": "The program ends without putting the tool away (SP0).",
    "hint": ""
  },
  "hpgl.force-out-of-range": {
    "text": "The force (FS) is not between {low} and {high}.",
    "hint": ""
  },
  "hpgl.initialised-again": {
    "text": "The device is initialised again (IN) after the start.",
    "hint": ""
  },
  "hpgl.lone-letter": {
    "text": "A letter does not belong to an instruction of two letters.",
    "hint": ""
  },
  "hpgl.loose-number": {
    "text": "A number belongs to no instruction.",
    "hint": ""
  },
  "hpgl.moves-before-pa": {
    "text": "The line moves before absolute coordinates are stated (PA).",
    "hint": ""
  },
  "hpgl.needs-no-number": {
    "text": "The instruction takes no number.",
    "hint": ""
  },
  "hpgl.needs-one-number": {
    "text": "The instruction needs exactly one number.",
    "hint": ""
  },
  "hpgl.never-down": {
    "text": "The toolpath never goes down.",
    "hint": "Give at least one edge a line type that the machine makes."
  },
  "hpgl.no-approach": {
    "text": "{place} begins the work of its station, and no rapid leads there.",
    "hint": "Begin each station with a rapid."
  },
  "hpgl.no-device": {
    "text": "{machine} has no HPGL device.",
    "hint": "Describe it under [controller] of its TOML."
  },
  "hpgl.no-force-setting": {
    "text": "The device has no force setting (FS).",
    "hint": ""
  },
  "hpgl.no-instruction": {
    "text": "The program has no instruction.",
    "hint": ""
  },
  "hpgl.no-pen": {
    "text": "{machine} has no pen for {work} with station {station}.",
    "hint": "Add a [[controller.pen]] to its TOML."
  },
  "hpgl.no-pen-selected": {
    "text": "The line lowers the tool, and no pen is selected.",
    "hint": ""
  },
  "hpgl.no-speed": {
    "text": "The line works, and no speed has been set (VS).",
    "hint": ""
  },
  "hpgl.no-speed-setting": {
    "text": "The device has no speed setting (VS).",
    "hint": ""
  },
  "hpgl.no-terminator": {
    "text": "The program ends without a semicolon.",
    "hint": ""
  },
  "hpgl.not-initialised": {
    "text": "The first instruction is not IN.",
    "hint": ""
  },
  "hpgl.outside-area": {
    "text": "The line leaves the area of the device.",
    "hint": ""
  },
  "hpgl.plunge-without-move": {
    "text": "The line lowers the tool and moves nowhere, so its heading is not known.",
    "hint": ""
  },
  "hpgl.press": {
    "text": "{place} presses the tool in one place, where HPGL cannot turn it.",
    "hint": "Choose a board with short_crease = \"refuse\", or another machine."
  },
  "hpgl.selects-while-down": {
    "text": "The line selects a pen while the tool is down.",
    "hint": "Lift it first (PU)."
  },
  "hpgl.slanted-plunge": {
    "text": "{place} goes down or up along a slope.",
    "hint": "Choose a tool that goes straight down."
  },
  "hpgl.speed-out-of-range": {
    "text": "The speed (VS) is not between {low} and {high}.",
    "hint": ""
  },
  "hpgl.swivel": {
    "text": "{place} turns the head about the tip.",
    "hint": "Give the knife no trail: the device compensates it."
  },
  "hpgl.turn-in-board": {
    "text": "The tool turns by {degrees:.2f}° in the board; at most {most:.2f}° is allowed.",
    "hint": "Lift it before the corner."
  },
  "hpgl.unknown-instruction": {
    "text": "The instruction {name} is not supported.",
    "hint": ""
  },
  "hpgl.unknown-pen": {
    "text": "The device has no such pen.",
    "hint": ""
  },
  "hpgl.wrong-force": {
    "text": "The line lowers pen {pen} with another force than its own (FS{force}).",
    "hint": ""
  },
  "hpgl.x-without-y": {
    "text": "An X has no Y.",
    "hint": ""
  },
  "import.angles-not-numbers": {
    "text": "its angles are not numbers",
    "hint": ""
  },
  "import.annotations": {
    "text": "{count} notes and form fields on the page are not cut",
    "hint": ""
  },
  "import.area-outline": {
    "text": "outline of a filled area: the drawing has no strokes",
    "hint": ""
  },
  "import.area-outline-on-page": {
    "text": "outline of a filled area: the page has no strokes",
    "hint": ""
  },
  "import.array": {
    "text": "{columns} columns × {rows} rows",
    "hint": ""
  },
  "import.bad-operands": {
    "text": "the operands of its operator {operator!r} are invalid",
    "hint": ""
  },
  "import.bad-path-data": {
    "text": "its path data is wrong at character {character} ({text!r}): read up to there, as in a browser",
    "hint": ""
  },
  "import.bad-place": {
    "text": "its position cannot be read: {reason}",
    "hint": ""
  },
  "import.bad-points": {
    "text": "its points cannot be read: {points!r}",
    "hint": ""
  },
  "import.bad-radius": {
    "text": "its radius is {radius:g}",
    "hint": ""
  },
  "import.bad-size": {
    "text": "its {name} cannot be read: {reason}",
    "hint": ""
  },
  "import.bad-transform": {
    "text": "its transform cannot be read: {reason}",
    "hint": ""
  },
  "import.bad-window": {
    "text": "its window cannot be read: {reason}",
    "hint": ""
  },
  "import.block-external": {
    "text": "its block {block!r} is in another file",
    "hint": "Bind it before exporting."
  },
  "import.block-in-itself": {
    "text": "its block {block!r} contains itself",
    "hint": ""
  },
  "import.block-missing": {
    "text": "its block {block!r} is not in the file",
    "hint": ""
  },
  "import.bridge": {
    "text": "1 bridge of {width:g} in the die board",
    "hint": ""
  },
  "import.bridges": {
    "text": "{bridges:g} bridges of {width:g} in the die board",
    "hint": ""
  },
  "import.clip-path": {
    "text": "it is only a clipping path",
    "hint": ""
  },
  "import.contains-itself": {
    "text": "it contains itself",
    "hint": ""
  },
  "import.coordinate-not-a-number": {
    "text": "a coordinate is not a number",
    "hint": ""
  },
  "import.curves-fitted": {
    "text": "curves fitted with {pieces} lines and arcs within {tolerance:.2g} file units",
    "hint": ""
  },
  "import.curves-fitted-relative": {
    "text": "curves fitted with {pieces} lines and arcs within {tolerance:.2g} file units (1/250,000 of the drawing)",
    "hint": ""
  },
  "import.damaged": {
    "text": "it is damaged: {reason}",
    "hint": ""
  },
  "import.damaged-or-frame": {
    "text": "it is damaged, or only the frame of a text",
    "hint": ""
  },
  "import.dimension": {
    "text": "dimensions and notes are not cut",
    "hint": ""
  },
  "import.drawn-twice": {
    "text": "it is drawn twice: the same as {same:, }",
    "hint": ""
  },
  "import.drawn-twice-often": {
    "text": "it is drawn twice: the same as {same:, } and {more} more",
    "hint": ""
  },
  "import.empty-path": {
    "text": "its path is empty",
    "hint": ""
  },
  "import.end-mark": {
    "text": "an end mark",
    "hint": ""
  },
  "import.endless-line": {
    "text": "a construction line without end",
    "hint": ""
  },
  "import.extrusion-not-a-number": {
    "text": "its extrusion is not a number",
    "hint": ""
  },
  "import.few-vertices": {
    "text": "it has {vertices} vertices: no line between them",
    "hint": ""
  },
  "import.filled-area": {
    "text": "a filled area has no line of its own",
    "hint": ""
  },
  "import.filled-area-beside-strokes": {
    "text": "a filled area without a stroke, in a drawing with strokes",
    "hint": ""
  },
  "import.filled-area-on-page": {
    "text": "a filled area without a stroke, on a page with strokes",
    "hint": ""
  },
  "import.fit-points": {
    "text": "drawn through its fit points",
    "hint": ""
  },
  "import.font-shape": {
    "text": "a shape out of a font file is not read: explode it into lines",
    "hint": ""
  },
  "import.height-not-a-number": {
    "text": "its height is not a number",
    "hint": ""
  },
  "import.height-too-far": {
    "text": "its height is {height:g}; the limit is {limit:g}",
    "hint": ""
  },
  "import.hidden": {
    "text": "it is hidden",
    "hint": ""
  },
  "import.hidden-layer": {
    "text": "it is hidden: the layer {layer} is switched off",
    "hint": ""
  },
  "import.image": {
    "text": "images are not cut",
    "hint": ""
  },
  "import.incomplete": {
    "text": "it is incomplete: it has no {part}",
    "hint": ""
  },
  "import.interrupted-path": {
    "text": "another object starts before the path is painted",
    "hint": ""
  },
  "import.invisible": {
    "text": "it is marked as invisible",
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
    "text": "laid flat from z = {height:g}",
    "hint": ""
  },
  "import.layer-frozen": {
    "text": "its layer is frozen",
    "hint": ""
  },
  "import.layer-not-plotted": {
    "text": "its layer is not plotted",
    "hint": ""
  },
  "import.layer-off": {
    "text": "its layer is off",
    "hint": ""
  },
  "import.light": {
    "text": "a light is not cut",
    "hint": ""
  },
  "import.lone-vertex": {
    "text": "a vertex without its polyline",
    "hint": ""
  },
  "import.mesh": {
    "text": "it is a mesh, not a flat line",
    "hint": ""
  },
  "import.missing-id": {
    "text": "no element has the id {id!r}",
    "hint": ""
  },
  "import.missing-subroutine": {
    "text": "the subroutine {name} does not exist",
    "hint": ""
  },
  "import.multiple-line": {
    "text": "a multiple line is not read: explode it into lines",
    "hint": ""
  },
  "import.no-length": {
    "text": "it has no length: {length:g}",
    "hint": ""
  },
  "import.no-major-axis": {
    "text": "its major axis has a length of 0",
    "hint": ""
  },
  "import.no-paint": {
    "text": "it has neither a stroke nor a fill",
    "hint": ""
  },
  "import.no-parameter-range": {
    "text": "it has no length: it starts and ends at parameter {parameter:g}",
    "hint": ""
  },
  "import.no-points": {
    "text": "it has no points",
    "hint": ""
  },
  "import.no-scale": {
    "text": "its scale is {x:g} × {y:g}: nothing is left of it",
    "hint": ""
  },
  "import.no-size": {
    "text": "its width and height are {width:g} and {height:g}",
    "hint": ""
  },
  "import.no-sweep": {
    "text": "it has no length: it starts and ends at {degrees:g}°",
    "hint": ""
  },
  "import.not-a-line": {
    "text": "{kind} is not a kind of line that is read",
    "hint": ""
  },
  "import.not-clipped": {
    "text": "the clipping around it is not applied",
    "hint": ""
  },
  "import.not-flat": {
    "text": "it is not flat",
    "hint": ""
  },
  "import.not-svg": {
    "text": "its content is not SVG",
    "hint": ""
  },
  "import.not-visible": {
    "text": "it is fully transparent",
    "hint": ""
  },
  "import.nothing-named": {
    "text": "no form or image has the name {name!r}",
    "hint": ""
  },
  "import.on-layer": {
    "text": "on the layer {layer}",
    "hint": ""
  },
  "import.other-file": {
    "text": "it refers to another file, {file!r}, which is not fetched",
    "hint": ""
  },
  "import.other-pages": {
    "text": "only the first of {pages} pages is read",
    "hint": ""
  },
  "import.outside-page": {
    "text": "it lies outside the visible area of the page",
    "hint": ""
  },
  "import.page-ends-early": {
    "text": "the page ends before the path is painted",
    "hint": ""
  },
  "import.paper-space": {
    "text": "it is in paper space",
    "hint": ""
  },
  "import.parameters-not-numbers": {
    "text": "its parameters are not numbers",
    "hint": ""
  },
  "import.partly-outside-page": {
    "text": "part of it lies outside the visible area of the page",
    "hint": ""
  },
  "import.picture": {
    "text": "pictures are not cut",
    "hint": ""
  },
  "import.picture-block": {
    "text": "the block {block} of {entities:# entity|# entities}: it shows a dimension or a hatch",
    "hint": ""
  },
  "import.pieces-drawn-twice": {
    "text": "{pieces} of {all} pieces are drawn twice, with {same:, }",
    "hint": ""
  },
  "import.pieces-drawn-twice-often": {
    "text": "{pieces} of {all} pieces are drawn twice, with {same:, } and {more} more",
    "hint": ""
  },
  "import.pieces-no-length": {
    "text": "{pieces} of {all} pieces have no length",
    "hint": ""
  },
  "import.place-not-a-number": {
    "text": "its position is not a number",
    "hint": ""
  },
  "import.placement-not-a-number": {
    "text": "its place, scale or rotation is not a number",
    "hint": ""
  },
  "import.places-block": {
    "text": "places the block {block}",
    "hint": ""
  },
  "import.places-subroutine": {
    "text": "inserts the subroutine {name}",
    "hint": ""
  },
  "import.point": {
    "text": "a point has no length",
    "hint": ""
  },
  "import.proxy": {
    "text": "only the program that made it can read it: explode it into lines",
    "hint": ""
  },
  "import.region": {
    "text": "a region is not read: explode it into lines",
    "hint": ""
  },
  "import.repeated": {
    "text": "drawn {times} times",
    "hint": ""
  },
  "import.rules-not-read": {
    "text": "rules that are not supported: {rules:, }",
    "hint": ""
  },
  "import.script": {
    "text": "scripts are not run",
    "hint": ""
  },
  "import.shading": {
    "text": "shadings are not cut",
    "hint": ""
  },
  "import.short-path-data": {
    "text": "its path data ends inside a command: read up to there, as in a browser",
    "hint": ""
  },
  "import.solid": {
    "text": "it is a solid or a face, not a flat line",
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
    "text": "text is not cut",
    "hint": ""
  },
  "import.text-unknown-letters": {
    "text": "text is not cut, and its encoding is unknown",
    "hint": ""
  },
  "import.tilted": {
    "text": "it is not flat: its plane is tilted by {degrees:g}°",
    "hint": ""
  },
  "import.tilted-axis": {
    "text": "it is not flat: its major axis rises by {rise:g}",
    "hint": ""
  },
  "import.too-far": {
    "text": "a coordinate is {coordinate:g}; the limit is {limit:g}",
    "hint": ""
  },
  "import.too-many-fit-points": {
    "text": "it goes through {points:,} points; the limit is {limit:,}",
    "hint": ""
  },
  "import.uncentred-arc": {
    "text": "its centre is {first:g} from one end and {second:g} from the other",
    "hint": ""
  },
  "import.underlay": {
    "text": "a picture or an underlay is not cut",
    "hint": ""
  },
  "import.uneven-height": {
    "text": "it is not flat: z goes from {low:g} to {high:g}",
    "hint": ""
  },
  "import.unknown-operator": {
    "text": "the operator {operator!r} is unknown",
    "hint": ""
  },
  "import.unknown-record": {
    "text": "records of this type are not supported",
    "hint": ""
  },
  "import.unreadable-line": {
    "text": "line {line} cannot be read: {reason}",
    "hint": ""
  },
  "import.unreadable-record": {
    "text": "it cannot be read: {reason}",
    "hint": ""
  },
  "import.unsupported-element": {
    "text": "elements of type {kind} are not supported",
    "hint": ""
  },
  "import.unused-block": {
    "text": "the block {block} of {entities:# entity|# entities}: no INSERT places it on the sheet",
    "hint": ""
  },
  "import.unused-subroutine": {
    "text": "the subroutine {name} with {records:# record|# records} is never called",
    "hint": ""
  },
  "import.viewport": {
    "text": "a viewport shows lines and is none",
    "hint": ""
  },
  "import.wrong-field-count": {
    "text": "line {line} has {fields} fields",
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
    "text": "The entry point {name!r} of {group} is not a controller language of this name.",
    "hint": "Correct or remove the package that declares it."
  },
  "language.no-driver": {
    "text": "Programs for {language} cannot be streamed: there is no gateway driver.",
    "hint": "{advice}"
  },
  "language.unknown": {
    "text": "There is no controller language {name!r}.",
    "hint": "Available: {known:, }."
  },
  "language.unusable": {
    "text": "{machine} cannot be driven with {language}: {reason}.",
    "hint": "Its own language is {own}."
  },
  "layer.not-finite": {
    "text": "Layer {layer} has a coordinate that is not a number.",
    "hint": "Give finite lengths."
  },
  "library.invalid": {
    "text": "The {shelf} {name!r} cannot be used: {faults:; }.",
    "hint": "Correct it; knifetip schema {shelf} describes all fields."
  },
  "library.unknown": {
    "text": "There is no {shelf} {name!r}.",
    "hint": "Available: {known:, }."
  },
  "library.unknown-file": {
    "text": "There is no {shelf} {name!r}: {reason}.",
    "hint": "Available: {known:, }."
  },
  "library.unreadable": {
    "text": "The {shelf} {name!r} cannot be read: {detail}.",
    "hint": "Fix the TOML file."
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
    "text": "{machine} has no cutter {cutter!r}.",
    "hint": "Only a rotating cutter or a beam can be calibrated."
  },
  "machine.no-such-cutter": {
    "text": "{machine} has no cutter {cutter!r}.",
    "hint": "It has {known:, }."
  },
  "milling.shared-edge": {
    "text": "Two blanks share edge {edge}, and the cutter removes {diameter:g} mm from one or the other.",
    "hint": "Move them at least {diameter:g} mm apart, each with an edge of its own, or choose a machine with a knife."
  },
  "offset.bad-distance": {
    "text": "The distance of an offset is not a number of 0 mm or more.",
    "hint": "Correct the tool."
  },
  "offset.bad-interference": {
    "text": "{interference!r} is not a way to handle interference.",
    "hint": "Give 'trim' or 'refuse'."
  },
  "offset.bad-side": {
    "text": "The side of a path is neither left nor right.",
    "hint": "Give +1 or -1."
  },
  "offset.dead-end": {
    "text": "The offset of path {path} at {radius:g} mm cannot be closed: {depth:.4g} mm of it beside segment {segment} lead nowhere.",
    "hint": "Draw the contour without overlaps, or change the radius a little."
  },
  "offset.interference": {
    "text": "A tool of radius {radius:g} mm beside segment {segment} would cut {depth:.4g} mm into segment {other}.",
    "hint": "Choose a smaller tool, or allow it to leave uncut what it cannot reach."
  },
  "offset.mixed-group": {
    "text": "Path {path} has another radius or side than the group that it belongs to.",
    "hint": "Reverse it, or give it a group of its own."
  },
  "offset.self-contact": {
    "text": "The offset of path {path} at {radius:g} mm cannot be closed: the contour touches itself at ({x:.4f}, {y:.4f}), in segments {one} and {two}.",
    "hint": "Trim the two segments to where they meet, or move one of them off the other."
  },
  "override.ambiguous": {
    "text": "An override must name its edges in exactly one way.",
    "hint": "Give edges, or handles, or layer and colour."
  },
  "override.no-edges-there": {
    "text": "There is no edge {place: and }.",
    "hint": "GET …/edges lists layers and colours."
  },
  "override.no-such-edge": {
    "text": "The drawing has {count:# edge|# edges}; there is no edge {edge}.",
    "hint": "Edges are numbered from 0."
  },
  "override.no-such-handle": {
    "text": "No edge has the handle {handle!r}.",
    "hint": "GET …/edges lists the handles."
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
    "text": "There is no drawing on the first page of the PDF.",
    "hint": "Export the drawing as a page of its own."
  },
  "pdf.content-damaged": {
    "text": "The content of the PDF's {where} {reason}, so lines may be missing.",
    "hint": "Export it again, or send the drawing as DXF."
  },
  "pdf.cut-short": {
    "text": "The PDF is cut short: its {bytes:,} bytes do not end with %%EOF, so lines may be missing.",
    "hint": "Send or export it again."
  },
  "pdf.encrypted": {
    "text": "The PDF is encrypted.",
    "hint": "Save it without a password and without restrictions."
  },
  "pdf.expands-too-far": {
    "text": "The page of the PDF and the forms that it repeats expand to more than {limit:.1f} MB of drawing.",
    "hint": "Export a single carton, with its symbols expanded."
  },
  "pdf.form": {
    "text": "The PDF is a form (XFA) and has no drawing on its page.",
    "hint": "Print it to a PDF, or send the drawing itself."
  },
  "pdf.illustrator-only": {
    "text": "The Illustrator file was saved without PDF content, and there is no line on its page.",
    "hint": "Save it with 'Create PDF Compatible File', or as PDF."
  },
  "pdf.layers-too-deep": {
    "text": "Layers of the PDF are nested more than {limit:,} deep.",
    "hint": "Export it again from the program that drew it."
  },
  "pdf.no-header": {
    "text": "The file is not a PDF: it does not begin with %PDF.",
    "hint": "Export it again, or send the drawing as DXF."
  },
  "pdf.no-page": {
    "text": "The PDF has no page.",
    "hint": "Export it again, or send the drawing as DXF."
  },
  "pdf.page-too-large": {
    "text": "The page of the PDF reaches to {size:g} mm; the limit is {limit:g} mm.",
    "hint": "Export it in its true size."
  },
  "pdf.part-missing": {
    "text": "A part of the PDF's page is missing, so lines may be missing.",
    "hint": "Export it again, or send the drawing as DXF."
  },
  "pdf.stream-cut-short": {
    "text": "A stream of the PDF is cut short, so lines may be missing.",
    "hint": "Send or export it again."
  },
  "pdf.stream-damaged": {
    "text": "A stream of the PDF is damaged ({reason}), so lines may be missing.",
    "hint": "Export it again, or send the drawing as DXF."
  },
  "pdf.stream-too-large": {
    "text": "A stream of the PDF unpacks to more than {limit:.1f} MB.",
    "hint": "Export a single carton, without pictures."
  },
  "pdf.too-many-states": {
    "text": "The PDF saves more than {limit:,} graphics states at once.",
    "hint": "Export it again from the program that drew it."
  },
  "profile.bad-if-match": {
    "text": "If-Match is {match!r}, which is not a version.",
    "hint": "Send the ETag of the profile, for example \"3\"."
  },
  "profile.bad-name": {
    "text": "{name!r} is not a valid profile name.",
    "hint": "Use up to 64 lower-case letters, digits, - and _; the page shows the title."
  },
  "profile.exists": {
    "text": "There is a profile {name} already, at version {version}.",
    "hint": "To replace it, send If-Match: \"{version}\"; or choose another name."
  },
  "profile.invalid-field": {
    "text": "The profile cannot be read: {place}: {fault}.",
    "hint": "See ProfileIn in /api/openapi.json for the expected fields."
  },
  "profile.nested-too-deep": {
    "text": "The profile {name!r} is nested too deeply.",
    "hint": "A profile is a title and a list of [[rule]]."
  },
  "profile.not-an-extension": {
    "text": "The rules of {name!r} are not those of {extends!r} with additions.",
    "hint": "Write it out without extends."
  },
  "profile.not-kept": {
    "text": "There is no custom profile {name}.",
    "hint": "GET /api/profiles lists them."
  },
  "profile.not-toml": {
    "text": "The profile {name!r} is not TOML: {reason}.",
    "hint": "Fix that line."
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
    "hint": "Save yours under another name; it can extend this one."
  },
  "profile.shipped-command": {
    "text": "The profile {name!r} is part of knifetip and cannot be changed.",
    "hint": "Save yours under another --name."
  },
  "profile.stale": {
    "text": "Profile {name} is at version {version}, and this change was made from version {given}: another user changed it in between.",
    "hint": "Check it again, then send your change with If-Match: \"{version}\"."
  },
  "profile.too-long": {
    "text": "The profile {name!r} is {size} kB long; the limit is {limit} kB.",
    "hint": "One rule can take many layers, and * matches any letters."
  },
  "profile.too-many": {
    "text": "There are {limit} profiles already.",
    "hint": "Delete one that is not used."
  },
  "program.bad-tolerance": {
    "text": "A tolerance of {tolerance} mm leaves nothing for the controller's path blending.",
    "hint": "Give 0.001 mm or more."
  },
  "program.control-byte": {
    "text": "Line {line} has the byte 0x{byte}, which the controller would execute at once.",
    "hint": "Compile the job again; a program contains none of ? ! ~ and no control bytes."
  },
  "program.line-too-long": {
    "text": "Row {row} of the toolpath needs a line of {length} characters ({line} …), and {dialect} accepts {limit}.",
    "hint": "Check the coordinates: they exceed any real table."
  },
  "program.line-too-long-to-send": {
    "text": "Line {line} has {length} bytes; {name} accepts {limit}.",
    "hint": "Compile the job again with shorter notes."
  },
  "program.no-placement": {
    "text": "{program} does not state where on the sheet it places the drawing.",
    "hint": "Give --placement X,Y, as its report states it."
  },
  "program.not-bytes": {
    "text": "The program is a {type}, not bytes.",
    "hint": "Give the bytes of the file."
  },
  "program.not-fetched": {
    "text": "The program of job {job} could not be fetched ({reason}); nothing was sent to the machine.",
    "hint": "Queue the job again."
  },
  "program.too-large": {
    "text": "The program has {bytes:,} bytes; at most {limit:,} are read.",
    "hint": "Split the job into several sheets."
  },
  "program.too-many-lines": {
    "text": "The program has {lines:,} lines; at most {limit:,} are read.",
    "hint": "Split the job into several sheets."
  },
  "program.too-many-moves": {
    "text": "The program has {moves:,} moves; at most {limit:,} are read.",
    "hint": "Split the job into several sheets."
  },
  "program.wrong-checksum": {
    "text": "The program of job {job} arrived with SHA-256 {arrived}…, not {expected}…; nothing was sent to the machine.",
    "hint": "Queue the job again; if this is repeated, compile it again."
  },
  "question.guess": {
    "text": " Most likely {type} ({percent} %): {reason}.",
    "hint": ""
  },
  "question.line-type": {
    "text": "{edges:# edge|# edges} on layer \"{layer}\", colour {colour}, linetype {linetype}, total length {length:,.1f} {unit:unit}, in a box of {width:,.1f} × {height:,.1f} {unit:unit} at ({x:,.1f}, {y:,.1f}): what {edges:is it|are they}?{guess}",
    "hint": ""
  },
  "question.shape": {
    "text": " By its {reason}.",
    "hint": ""
  },
  "question.tool": {
    "text": "{machine} has no tool for {type} ({edges:# edge|# edges}). Which line type should they get?",
    "hint": ""
  },
  "question.unit": {
    "text": "{reason} The drawing's size would be {sizes:, }.{evidence}",
    "hint": ""
  },
  "question.unit-contradicted": {
    "text": "The file states {stated:unit} as its unit, but the drawing does not look like it.",
    "hint": ""
  },
  "question.unit-doubtful": {
    "text": "The file states {stated:unit} as its unit, but the drawing could also be in {other:unit}.",
    "hint": ""
  },
  "question.unit-evidence": {
    "text": " Strongest evidence for {unit:unit}: {evidence:; }.",
    "hint": ""
  },
  "question.unit-not-stated": {
    "text": "The file does not state its unit.",
    "hint": ""
  },
  "question.unit-size": {
    "text": "{width:mm} × {height:mm} mm in {unit:unit}",
    "hint": ""
  },
  "question.unit-unreadable": {
    "text": "The file does not state a unit of length that is supported ({evidence}).",
    "hint": ""
  },
  "reading.crashed": {
    "text": "{name}: the file is damaged and cannot be read ({reason}).",
    "hint": "Export it again as DXF, CF2, SVG or PDF, from another program if necessary."
  },
  "reading.damaged": {
    "text": "The {format} is damaged and cannot be read ({reason}).",
    "hint": "Export it again, from another program if necessary."
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
    "text": "Blocks, symbols or groups of the {format} are nested more than {limit} deep.",
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
    "text": "The {format} takes longer than {seconds:g} s to read.",
    "hint": "Export a single carton, with curves as lines and arcs and without pictures."
  },
  "reading.unexpected": {
    "text": "The {format} is damaged in an unexpected way and cannot be read ({reason}).",
    "hint": "Export it again, from another program if necessary."
  },
  "reading.unknown-kind": {
    "text": "The file is {what}, not a drawing that can be read.",
    "hint": "Send the drawing as {formats:or}."
  },
  "request.body-too-large": {
    "text": "A request may have at most {limit} MB here.",
    "hint": "Send it in several requests."
  },
  "request.foreign-origin": {
    "text": "Cross-site request refused: a page of another origin sent it.",
    "hint": "Send it from this server's page, or from a program that is not a browser."
  },
  "request.foreign-page": {
    "text": "Cross-site request refused: a page of {origin} sent it.",
    "hint": "Send it from this server's page, or from a program that is not a browser."
  },
  "request.html-form": {
    "text": "The API does not accept {media}.",
    "hint": "Send it with Content-Type: application/json."
  },
  "request.invalid": {
    "text": "The request cannot be read: {faults:; }.",
    "hint": "See /api/openapi.json for what is expected."
  },
  "request.key-needed": {
    "text": "This request needs a key.",
    "hint": "Send Authorization: Bearer KEY, or sign in at the page."
  },
  "request.key-reused": {
    "text": "The Idempotency-Key {key} was used for another request.",
    "hint": "Use a new key for a new request."
  },
  "request.local-only": {
    "text": "Without a key this server answers only requests from its own machine.",
    "hint": "Start it with --key-file PATH or --key KEY, or open it at http://localhost."
  },
  "request.no-host": {
    "text": "A request needs exactly one Host header.",
    "hint": "Use HTTP/1.1."
  },
  "request.not-marked": {
    "text": "The request does not show that it was not sent by a page of another site.",
    "hint": "Send an X-Knifetip header with it (any value)."
  },
  "request.not-storable": {
    "text": "The request contains text or numbers that cannot be stored.",
    "hint": ""
  },
  "request.nothing-there": {
    "text": "There is nothing at {path}.",
    "hint": "See /api/openapi.json for the available paths."
  },
  "request.refused": {
    "text": "{detail}",
    "hint": ""
  },
  "request.upload-too-large": {
    "text": "A request may have at most {limit} MB here.",
    "hint": "Send a smaller drawing."
  },
  "request.wrong-host": {
    "text": "This server does not answer requests for the host {host!r}.",
    "hint": "Use its address, or start it with --allow-host and this name."
  },
  "request.wrong-key": {
    "text": "The key is wrong.",
    "hint": "Send Authorization: Bearer KEY."
  },
  "request.wrong-method": {
    "text": "{method} is not supported at {path}.",
    "hint": "See /api/openapi.json for the supported methods."
  },
  "rs274.after-end": {
    "text": "The line comes after the end of the program.",
    "hint": ""
  },
  "rs274.axis-without-motion": {
    "text": "The line has axis words and no G0, G1, G2 or G3.",
    "hint": ""
  },
  "rs274.bad-arc": {
    "text": "The ends of the arc differ in radius by more than {limit:g} mm.",
    "hint": ""
  },
  "rs274.bad-character": {
    "text": "The character {character!r} has no meaning here.",
    "hint": "Remove it."
  },
  "rs274.bad-feed": {
    "text": "The feed (F) is not greater than 0.",
    "hint": ""
  },
  "rs274.bad-line-number": {
    "text": "The line number (N) is not a whole number of 0 or more.",
    "hint": ""
  },
  "rs274.centre-without-arc": {
    "text": "The line has the centre of an arc (I, J) and no G2 or G3.",
    "hint": ""
  },
  "rs274.change-without-station": {
    "text": "The line changes the station (M6), and none has been called (T).",
    "hint": ""
  },
  "rs274.control-byte": {
    "text": "The byte {byte} acts on the controller at once, even in a comment.",
    "hint": "Remove it."
  },
  "rs274.ends-lowered": {
    "text": "The program ends with a station lowered.",
    "hint": ""
  },
  "rs274.ends-oscillating": {
    "text": "The program ends while a tool oscillates or turns.",
    "hint": ""
  },
  "rs274.ends-output-on": {
    "text": "The program ends with an output on.",
    "hint": ""
  },
  "rs274.ends-with-offset": {
    "text": "The program ends with the offset of a station in force.",
    "hint": "Cancel it (G49) before the end."
  },
  "rs274.g64-unsupported": {
    "text": "G64 is rejected by controllers without a tool table.",
    "hint": "Remove it."
  },
  "rs274.incomplete-arc": {
    "text": "The arc lacks X, Y, I or J.",
    "hint": ""
  },
  "rs274.letter-without-number": {
    "text": "The letter {letter} has no number.",
    "hint": ""
  },
  "rs274.line-too-long": {
    "text": "The line is longer than {limit} characters, more than a controller reads.",
    "hint": ""
  },
  "rs274.missing-p": {
    "text": "The line lacks its P word.",
    "hint": ""
  },
  "rs274.mode-g17": {
    "text": "the XY plane (G17)",
    "hint": ""
  },
  "rs274.mode-g21": {
    "text": "millimetres (G21)",
    "hint": ""
  },
  "rs274.mode-g40": {
    "text": "no radius compensation (G40)",
    "hint": ""
  },
  "rs274.mode-g49": {
    "text": "no tool length (G49)",
    "hint": ""
  },
  "rs274.mode-g54": {
    "text": "the coordinate system (G54)",
    "hint": ""
  },
  "rs274.mode-g90": {
    "text": "absolute distances (G90)",
    "hint": ""
  },
  "rs274.mode-g91-1": {
    "text": "arc centres from the start (G91.1)",
    "hint": ""
  },
  "rs274.mode-g94": {
    "text": "the feed mode (G94)",
    "hint": ""
  },
  "rs274.motion-without-axis": {
    "text": "The line has a motion word and no axis word.",
    "hint": ""
  },
  "rs274.moves-and-switches": {
    "text": "The line moves and switches something at once.",
    "hint": "Write them on two lines."
  },
  "rs274.moves-unstated": {
    "text": "The line moves before the program states {mode}.",
    "hint": ""
  },
  "rs274.nested-comment": {
    "text": "A comment opens inside another comment.",
    "hint": "Close the first one before it."
  },
  "rs274.no-end": {
    "text": "The program ends without M2 or M30.",
    "hint": ""
  },
  "rs274.no-feed": {
    "text": "The line feeds, and no F has been stated since the feed mode was set.",
    "hint": ""
  },
  "rs274.not-settled": {
    "text": "The line moves before what was switched has settled.",
    "hint": "Dwell (G4) before it."
  },
  "rs274.number-too-large": {
    "text": "A number is beyond 1,000,000.",
    "hint": ""
  },
  "rs274.offset-without-station": {
    "text": "The line applies the offset of a station (G43), and none has been called (T).",
    "hint": ""
  },
  "rs274.open-comment": {
    "text": "A comment is not closed.",
    "hint": "End it with ) on the same line."
  },
  "rs274.repeated-word": {
    "text": "Two words of the line set the same thing.",
    "hint": ""
  },
  "rs274.speed-without-m3": {
    "text": "The line has a speed (S) and no M3.",
    "hint": ""
  },
  "rs274.stray-p": {
    "text": "The P word belongs to no other word of the line, or to two.",
    "hint": ""
  },
  "rs274.stray-q": {
    "text": "The Q word belongs to no other word of the line.",
    "hint": ""
  },
  "rs274.timed-without-f": {
    "text": "The move is timed (G93) and has no F.",
    "hint": ""
  },
  "rs274.too-many-digits": {
    "text": "A number has more than 15 digits.",
    "hint": ""
  },
  "rs274.unbounded-rounding": {
    "text": "The line works while nothing limits how far corners are rounded.",
    "hint": "State the limit with G64 P before it."
  },
  "rs274.unknown-letter": {
    "text": "The letter {letter} is not supported.",
    "hint": ""
  },
  "rs274.unknown-output": {
    "text": "{machine} has no such output.",
    "hint": ""
  },
  "rs274.unknown-station": {
    "text": "{machine} has no such station (T).",
    "hint": ""
  },
  "rs274.unknown-word": {
    "text": "{word} is not supported.",
    "hint": ""
  },
  "rs274.wrong-dwell": {
    "text": "The dwell (G4) does not last as long as the machine needs ({settle:g} s).",
    "hint": ""
  },
  "rs274.wrong-speed": {
    "text": "M3 has another speed (S) than the tool's.",
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
    "text": "Segment {segment} has a coordinate or a bulge that is not a number.",
    "hint": "Draw it again."
  },
  "server.address-in-use": {
    "text": "Cannot listen on {host}:{port}: {reason}.",
    "hint": "Stop the program that uses the port, or choose another with --port."
  },
  "server.answered": {
    "text": "{url} answered {status}.",
    "hint": ""
  },
  "server.busy": {
    "text": "{waiting:# request waits|# requests wait} for a free process; this one was not started.",
    "hint": "Send it again in {seconds} s."
  },
  "server.database-silent": {
    "text": "The database does not answer.",
    "hint": "Try again in a moment."
  },
  "server.internal-error": {
    "text": "Internal error. Nothing was cut.",
    "hint": "The server's log has the details."
  },
  "server.not-started": {
    "text": "The server did not start with the database {database}.",
    "hint": "The log lines above show the cause."
  },
  "server.stopping": {
    "text": "The server is stopping.",
    "hint": "Try again in a moment."
  },
  "server.unreachable": {
    "text": "Cannot reach {server}: {reason}.",
    "hint": "Check --server and the network."
  },
  "settings.bad-host": {
    "text": "{host!r} is not a host name.",
    "hint": "Write NAME or NAME:PORT."
  },
  "settings.bad-key": {
    "text": "{what} must have {shortest} to 200 ASCII characters without spaces; it has {length}.",
    "hint": "With --key-file PATH a random key is generated."
  },
  "settings.key-file": {
    "text": "Cannot use the key file {file}: {reason}.",
    "hint": "Name a file that can be written."
  },
  "settings.two-keys": {
    "text": "Both a key and a key file are given.",
    "hint": "Give one of them."
  },
  "store.no-column": {
    "text": "The {kind} {id} has no {column}.",
    "hint": "The compile makes it; see the job's state and reason."
  },
  "store.unknown": {
    "text": "There is no {kind} {id}.",
    "hint": "GET /api/{kind}s lists them."
  },
  "stored.text": {
    "text": "{text}",
    "hint": "{hint}"
  },
  "svg.cut-short": {
    "text": "The SVG is cut short: it ends at line {line}, after {count:# element|# elements}, so lines may be missing.",
    "hint": "Export it again, as plain SVG."
  },
  "svg.damaged-at": {
    "text": "The SVG is damaged at line {line}, column {column}: {reason}.",
    "hint": "Export it again, as plain SVG."
  },
  "svg.empty": {
    "text": "The SVG is empty.",
    "hint": "Export it again, as plain SVG."
  },
  "svg.external-entity": {
    "text": "The SVG's DOCTYPE has an entity {name!r} that refers to another file, which is not loaded.",
    "hint": "Save it as plain SVG, without a DOCTYPE."
  },
  "svg.long-entity": {
    "text": "The SVG's DOCTYPE has an entity {name!r} of {length:,} characters, which would expand the file too far.",
    "hint": "Save it as plain SVG, without a DOCTYPE."
  },
  "svg.markup-entity": {
    "text": "The SVG's DOCTYPE has an entity {name!r} that contains markup.",
    "hint": "Save it as plain SVG, without a DOCTYPE."
  },
  "svg.nested-too-deep": {
    "text": "Elements of the SVG are nested more than {limit} deep.",
    "hint": "Ungroup the drawing and export it again."
  },
  "svg.other-xml": {
    "text": "The file is XML with the outermost element {element}, not svg.",
    "hint": "Save it as plain SVG."
  },
  "svg.packed-cut-short": {
    "text": "The packed SVG (.svgz) is cut short.",
    "hint": "Export it again, as plain SVG."
  },
  "svg.packed-damaged": {
    "text": "The packed SVG (.svgz) is damaged: {reason}.",
    "hint": "Export it again, as plain SVG."
  },
  "svg.too-many-rules": {
    "text": "The SVG's style sheet has {count:,} rules; the limit is {limit:,}.",
    "hint": "Export it with the style in each element."
  },
  "svg.unpacks-too-far": {
    "text": "The packed SVG (.svgz) holds more than {limit:.1f} MB.",
    "hint": "Export a single carton, without pictures."
  },
  "tool.bad-radius": {
    "text": "A tool's radius is not a number of 0 mm or more.",
    "hint": "Correct the tool."
  },
  "tool.cannot-work": {
    "text": "Station {station} ({name}) of {machine} cannot work: {reason}",
    "hint": "Complete the tool in the machine's file."
  },
  "tool.missing": {
    "text": "{machine} has no tool for {type} ({count:# edge|# edges}).",
    "hint": "Give them another line type, or choose another machine."
  },
  "tool.tilted": {
    "text": "The tool is tilted by {tilt:.2f}°, and moving along its axis lifts it only up to {limit:g}°.",
    "hint": "Choose a tool that is less tilted."
  },
  "tool.without-power": {
    "text": "The laser has no power.",
    "hint": ""
  },
  "tool.without-speed": {
    "text": "The cutter has no spindle speed.",
    "hint": ""
  },
  "toolpath.arc-too-long": {
    "text": "{place} is an arc of more than half a turn: {move}.",
    "hint": "Send the drawing with a report: an earlier stage went wrong."
  },
  "toolpath.empty": {
    "text": "The toolpath has no moves.",
    "hint": "Give at least one edge a line type that the machine makes."
  },
  "toolpath.feed-too-fast": {
    "text": "{place} has a feed beyond any machine: {move}.",
    "hint": "Check the tool's feed."
  },
  "toolpath.no-approach": {
    "text": "{place} begins the work of station {station} and is not a rapid: the head is not there yet.",
    "hint": "Begin each station with a rapid."
  },
  "toolpath.no-feed": {
    "text": "{place} has no feed: {move}.",
    "hint": "Give the tool a feed."
  },
  "toolpath.not-finite": {
    "text": "{place} has a value that is not a number: {move}.",
    "hint": "Send the drawing with a report: an earlier stage went wrong."
  },
  "toolpath.rapid-arc": {
    "text": "{place} is a rapid along an arc: {move}.",
    "hint": "Send the drawing with a report: an earlier stage went wrong."
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
    "text": "Row {row} of the toolpath is a swivel that moves without turning, so its feed in degrees per minute has no meaning.",
    "hint": "Make it a feed."
  },
  "toolpath.too-far": {
    "text": "{place} is farther than {limit:g} mm away: {move}.",
    "hint": "Check the unit."
  },
  "toolpath.unknown-motion": {
    "text": "{place} has an unknown motion: {move}.",
    "hint": "Send the drawing with a report: an earlier stage went wrong."
  },
  "toolpath.unknown-station": {
    "text": "{place} is for station {station}, which {machine} does not have.",
    "hint": "Its stations are {known:, }."
  },
  "track.too-flat": {
    "text": "Track {track} leaves the board at {angle:.2f}° from square, so its tool never leaves the board (limit {limit:g}°).",
    "hint": "End the line inside the board, or draw it across the edge."
  },
  "travel.above": {
    "text": "{tool} (station {station}) would go {excess:.2f}{unit} above the travel of axis {axis} ({low:g} to {high:g}{unit}){place}.",
    "hint": "Place the drawing elsewhere on the table, turn it, or choose a larger machine."
  },
  "travel.below": {
    "text": "{tool} (station {station}) would go {excess:.2f}{unit} below the travel of axis {axis} ({low:g} to {high:g}{unit}){place}.",
    "hint": "Place the drawing elsewhere on the table, turn it, or choose a larger machine."
  },
  "unit.given": {
    "text": "given",
    "hint": ""
  },
  "unit.header": {
    "text": "$INSUNITS = {value}",
    "hint": ""
  },
  "unit.header-missing": {
    "text": "the file has no $INSUNITS",
    "hint": ""
  },
  "unit.header-not-a-number": {
    "text": "$INSUNITS = {value!r} is not a number",
    "hint": ""
  },
  "unit.header-undefined": {
    "text": "$INSUNITS = {value} has no meaning",
    "hint": ""
  },
  "unit.header-unitless": {
    "text": "$INSUNITS = 0: the file states that it has no unit",
    "hint": ""
  },
  "unit.header-unsupported": {
    "text": "$INSUNITS = {value}: {name}, which are not supported",
    "hint": ""
  },
  "unit.in-file": {
    "text": "{statement}",
    "hint": ""
  },
  "unit.inconclusive": {
    "text": "{stated}; the drawing does not give enough evidence for {unit:unit}",
    "hint": ""
  },
  "unit.not-given": {
    "text": "the unit is not known",
    "hint": ""
  },
  "unit.overruled": {
    "text": "{stated}; the drawing supports {unit:unit}: {reason}",
    "hint": ""
  },
  "unit.unsupported": {
    "text": "{unit!r} is not a supported unit of length.",
    "hint": "Choose one of {known:, }."
  },
  "verify.bad-tolerance": {
    "text": "A tolerance of {tolerance} mm is not a length.",
    "hint": "Give a number greater than 0, usually 0.01 mm."
  },
  "verify.beam-on-rapid": {
    "text": "The beam is on along a rapid of {length:.3f} mm.",
    "hint": ""
  },
  "verify.beam-refocused": {
    "text": "The beam is on while its focus moves by {height:.3f} mm.",
    "hint": ""
  },
  "verify.beside-line": {
    "text": "The {tool:tool} is {distance:.3f} mm off the line.",
    "hint": ""
  },
  "verify.beyond-rotation": {
    "text": "Joint {joint} turns to {position:.3f}°; its travel is {low:g} to {high:g}°.",
    "hint": ""
  },
  "verify.beyond-travel": {
    "text": "Joint {joint} goes to {position:.3f} mm; its travel is {low:g} to {high:g} mm.",
    "hint": ""
  },
  "verify.bridge-near-corner": {
    "text": "The bridge at {place:.3f} mm along the contour is {distance:.3f} mm too near a sharp corner.",
    "hint": ""
  },
  "verify.bridge-spacing": {
    "text": "From the bridge at {place:.3f} mm along the contour it is {distance:.3f} mm to the next; the board allows {most:g} mm.",
    "hint": ""
  },
  "verify.bridge-spare": {
    "text": "The bridge at {place:.3f} mm along the contour is not needed: without it the next two are {distance:.3f} mm apart.",
    "hint": ""
  },
  "verify.bridge-width": {
    "text": "The bridge at {place:.3f} mm along the contour is {width:.3f} mm wide in the top face; the board needs {planned:g} mm.",
    "hint": ""
  },
  "verify.centre-off-path": {
    "text": "The cutter's centre is {distance:.4f} mm off its path, and the controller may round {rounding:.4f} mm more; the tolerance is {tolerance:g} mm.",
    "hint": ""
  },
  "verify.cleaning-beyond": {
    "text": "Cleaning: the edge is worked where nothing was drawn.",
    "hint": ""
  },
  "verify.cleaning-dropped": {
    "text": "Cleaning dropped {length:.3f} mm of the edge.",
    "hint": ""
  },
  "verify.cleaning-incomplete": {
    "text": "Cleaning: the stretches of the edge do not add up to its length.",
    "hint": ""
  },
  "verify.cleaning-invented": {
    "text": "Cleaning: no part of the edge was drawn.",
    "hint": ""
  },
  "verify.cleaning-moved": {
    "text": "Cleaning moved the edge by {distance:.4f} mm.",
    "hint": ""
  },
  "verify.cleaning-type": {
    "text": "Cleaning: the edge is {drawn} and is worked as {worked}.",
    "hint": ""
  },
  "verify.comes-out-anywhere": {
    "text": "The knife comes out neither where an edge ends nor where it went in.",
    "hint": ""
  },
  "verify.comes-out-past": {
    "text": "The knife comes out {distance:.3f} mm past where it should.",
    "hint": ""
  },
  "verify.comes-out-short": {
    "text": "The knife comes out {distance:.3f} mm short of where it should.",
    "hint": ""
  },
  "verify.crease-too-short": {
    "text": "The crease is too short for the wheel.",
    "hint": ""
  },
  "verify.cuts-part": {
    "text": "The cutter takes {depth:.3f} mm off the part.",
    "hint": ""
  },
  "verify.cutter-at-rest": {
    "text": "The cutter works while it does not turn.",
    "hint": ""
  },
  "verify.flank-inside": {
    "text": "A flank comes out {distance:.4f} mm inside its place on the top face; the tolerance is {tolerance:g} mm.",
    "hint": ""
  },
  "verify.flank-outside": {
    "text": "A flank comes out {distance:.4f} mm outside its place on the top face; the tolerance is {tolerance:g} mm.",
    "hint": ""
  },
  "verify.flank-through-cut": {
    "text": "A flank goes {depth:.3f} mm through the cut at edge {edge}, which lies {distance:.3f} mm beside the groove, {place:.1f} mm from its start.",
    "hint": ""
  },
  "verify.goes-in-anywhere": {
    "text": "The knife goes in where no edge begins.",
    "hint": ""
  },
  "verify.groove-arc": {
    "text": "The groove is an arc, which a tilted blade cannot follow.",
    "hint": ""
  },
  "verify.groove-past-ends": {
    "text": "The blade runs {length:.2f} mm past the ends of the groove; the board allows {most:.2f} mm.",
    "hint": ""
  },
  "verify.groove-shallower": {
    "text": "The V-cutter goes {depth:.3f} mm deep after an earlier pass of {before:.3f} mm.",
    "hint": ""
  },
  "verify.inside-part": {
    "text": "The cutter works at X{x:.3f} Y{y:.3f} of the sheet, inside a part.",
    "hint": ""
  },
  "verify.knife-at-rest": {
    "text": "The oscillating knife cuts while its oscillation is off.",
    "hint": ""
  },
  "verify.laser-off": {
    "text": "The laser cuts while it is off.",
    "hint": ""
  },
  "verify.loose-piece": {
    "text": "The edge is worked at X{x:.3f} Y{y:.3f} of the sheet, on a piece that line {line} has already cut loose.",
    "hint": "Cut the contour around the piece afterwards."
  },
  "verify.lowers-second": {
    "text": "The line lowers station {station} while station {other} may be lowered.",
    "hint": "Release station {other} first (M65 P{output})."
  },
  "verify.moves-before-stated": {
    "text": "The program moves before it states {thing}.",
    "hint": "Until it is stated, lift only, straight up to joint Z {height:.3f} mm or higher."
  },
  "verify.moves-with-beam": {
    "text": "The program moves before it states the spindle (M5), so a beam may still be on.",
    "hint": ""
  },
  "verify.never-stated": {
    "text": "The program ends without stating {thing}.",
    "hint": ""
  },
  "verify.no-station": {
    "text": "The line feeds, and no station has been chosen.",
    "hint": ""
  },
  "verify.not-worked": {
    "text": "{length:.3f} mm of the edge are not {work}{where}.",
    "hint": ""
  },
  "verify.off-line": {
    "text": "The {tool:tool} is {distance:.4f} mm off the line, and the controller may round {rounding:.4f} mm more; the tolerance is {tolerance:g} mm.",
    "hint": ""
  },
  "verify.oscillation-on": {
    "text": "Station {station} works while the oscillation is on.",
    "hint": ""
  },
  "verify.other-placement": {
    "text": "The program states the placement X{x:.4f} Y{y:.4f}; the job has X{job_x:.4f} Y{job_y:.4f}.",
    "hint": ""
  },
  "verify.output": {
    "text": "output {output} (M65 P{output})",
    "hint": ""
  },
  "verify.output-off": {
    "text": "Station {station} works while its output {output} is off.",
    "hint": ""
  },
  "verify.pass-too-deep": {
    "text": "The {tool:tool} goes {depth:.3f} mm deep along {length:.3f} mm that no earlier pass has prepared; at most {step:g} mm at once is allowed.",
    "hint": ""
  },
  "verify.past-end": {
    "text": "The {tool:tool} runs {length:.3f} mm past the end of the edge.",
    "hint": ""
  },
  "verify.past-open-cut": {
    "text": "The cutter goes {length:.3f} mm past the end of an open cut.",
    "hint": ""
  },
  "verify.past-stop": {
    "text": "The {tool:tool} works {length:.3f} mm past where it should stop.",
    "hint": ""
  },
  "verify.perforation-cut": {
    "text": "A perforation has a cut of {length:.3f} mm; {planned:.3f} mm is planned.",
    "hint": ""
  },
  "verify.perforation-gap": {
    "text": "The perforation has a gap of {length:.3f} mm, {place:.3f} mm from its start; the board needs gaps of {planned:g} mm.",
    "hint": ""
  },
  "verify.rapid-in-board": {
    "text": "A rapid takes station {station} {depth:.3f} mm below the top of the board.",
    "hint": ""
  },
  "verify.slanted": {
    "text": "Station {station} goes {distance:.3f} mm sideways off its own line while it plunges or lifts in the board.",
    "hint": ""
  },
  "verify.spindle": {
    "text": "the spindle (M5)",
    "hint": ""
  },
  "verify.stray": {
    "text": "The {tool:tool} works {length:.3f} mm at X{x:.3f} Y{y:.3f} of the sheet, where no edge asks for it.",
    "hint": ""
  },
  "verify.stray-along": {
    "text": "The {tool:tool} works {length:.3f} mm along edge {edge}, which is {type} and does not ask for it.",
    "hint": ""
  },
  "verify.stray-plunge": {
    "text": "The {tool:tool} goes down at X{x:.3f} Y{y:.3f} of the sheet, where no edge asks for it.",
    "hint": ""
  },
  "verify.stray-plunge-along": {
    "text": "The {tool:tool} goes down on edge {edge}, which is {type} and does not ask for it.",
    "hint": ""
  },
  "verify.switches-at-unknown-height": {
    "text": "The line switches at a height that no line before it states.",
    "hint": "Lift to {needed:.3f} mm first."
  },
  "verify.switches-low": {
    "text": "The line switches at joint Z {height:.3f} mm.",
    "hint": "Lift to {needed:.3f} mm first."
  },
  "verify.too-few-bridges": {
    "text": "{bridges:# bridge holds|# bridges hold} the part; the board needs at least {fewest}.",
    "hint": ""
  },
  "verify.turn-at-feed": {
    "text": "C turns by {degrees:.4f}° at a feed in mm/min.",
    "hint": "State how long the move takes (G93)."
  },
  "verify.turn-in-board": {
    "text": "C turns by {degrees:.3f}° in the board; at most {most:.2f}° is allowed.",
    "hint": ""
  },
  "verify.turn-off-path": {
    "text": "C turns by {degrees:.3f}° in the board while the path turns by {path:.3f}°.",
    "hint": ""
  },
  "verify.two-lowered": {
    "text": "Station {station} works while station {other} is lowered too (output {output}).",
    "hint": ""
  },
  "verify.unclassified": {
    "text": "The edge has no line type, so its work is not known.",
    "hint": "Give it a line type."
  },
  "verify.unknown-position": {
    "text": "The line moves from or to a position that no line before it states.",
    "hint": ""
  },
  "verify.where-from-start": {
    "text": ", beginning {place:.3f} mm from its start",
    "hint": ""
  },
  "verify.where-past-end": {
    "text": ", where the tool must run out past its end",
    "hint": ""
  },
  "verify.where-past-start": {
    "text": ", where the tool must run out past its start",
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
    "text": "grooved from its end",
    "hint": ""
  },
  "verify.work-grooved-from-start": {
    "text": "grooved from its start",
    "hint": ""
  },
  "verify.wrong-depth": {
    "text": "The {tool:tool} goes {depth:.3f} mm below the top of the board; {planned:.3f} mm is planned.",
    "hint": ""
  },
  "verify.wrong-feed": {
    "text": "Station {station} has a feed of {feed:g} mm/min instead of {planned:g}.",
    "hint": ""
  },
  "verify.wrong-heading": {
    "text": "The {tool:tool} is turned {degrees:.3f}° off the line, so that it swings {swing:.3f} mm.",
    "hint": ""
  },
  "verify.wrong-time": {
    "text": "Station {station} takes {seconds:.4f} s instead of {planned:.4f} s.",
    "hint": ""
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
    "text": "Waiting for the operator at {machine}: table clear, board {board}{tools}.",
    "hint": "Confirm to start."
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
    "text": "{machine} was started without the operator's confirmation: board {board}{tools}.",
    "hint": "Look at the table. Confirm to let the job go on, or cancel it."
  },
  "worker.died": {
    "text": "The worker process ended unexpectedly (exit code {code}), as happens when memory runs out.",
    "hint": "Send a smaller drawing, or split this one."
  },
  "worker.memory": {
    "text": "The drawing needs more than the {limit} GB of memory that one drawing may use.",
    "hint": "Send a smaller drawing, or split this one."
  },
  "worker.timeout": {
    "text": "Stage {stage} was not finished after {seconds:.0f} s.",
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
  "px": "pixels"
};

export const TOOLS: Readonly<Record<string, string>> = {
  "cutter": "cutter",
  "knife": "knife",
  "v-cutter": "V-cutter",
  "wheel": "wheel"
};
