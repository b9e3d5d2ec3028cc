/** English texts of options and facts, from their declarations. Written by frontend/options.py: do not edit. */

export const DECLARED_TEXTS = {
  "option.feed_factor": "Feed factor",
  "option.feed_factor.description": "Factor of the feeds of all tools in the board, 0.1 to 1: less than 1 for board that tears or for a worn tool. A laser at a lower feed cuts deeper",
  "option.program_note": "Note in the program",
  "option.program_note.description": "Comment at the head of the program, for a person at the controller, such as the side of the board that lies up. Letters that controllers do not take become spaces; empty for none",
  "edgeOption.contour_starts": "Start and direction",
  "edgeOption.contour_starts.at": "Cut begins here",
  "edgeOption.contour_starts.direction": "Direction",
  "edgeOption.contour_starts.direction.free": "Free",
  "edgeOption.contour_starts.direction.forward": "Forward",
  "edgeOption.contour_starts.direction.reverse": "Reverse",
  "edgeOption.cut_depths": "Passes and depth",
  "edgeOption.cut_depths.passes": "Passes",
  "edgeOption.cut_depths.depth": "Depth from top",
  "edgeOption.crease_depths": "Depth of creases",
  "edgeOption.crease_depths.depth": "Depth of the crease",
  "edgeOption.edge_tools": "Tool of edges",
  "edgeOption.edge_tools.help": "Creases that continue each other need the same wheel. A cutter or laser makes the whole contour of an edge.",
  "edgeOption.edge_tools.station": "Tool",
  "edgeOption.edge_feeds": "Feed of edges",
  "edgeOption.edge_feeds.factor": "Feed factor",
  "fact.program_bytes": "Size of the program"
} as const;
