/** Options of a job with plain values, and options of edges. Written by frontend/options.py: do not edit. */

export const OPTIONS = {
  "feed_factor": {
    "kind": "number",
    "min": 0.1,
    "max": 1.0,
    "default": 1.0
  },
  "program_note": {
    "kind": "text",
    "maxLength": 60,
    "default": ""
  }
} as const;

export const EDGE_OPTIONS = {
  "contour_starts": {
    "types": [
      "cut",
      "half-cut"
    ],
    "byType": false,
    "ofCutters": false,
    "help": false,
    "fields": {
      "at": {
        "kind": "number",
        "min": 0.0,
        "max": 1.0,
        "default": null,
        "whole": false,
        "unit": "fraction"
      },
      "direction": {
        "kind": "choice",
        "choices": [
          "free",
          "forward",
          "reverse"
        ],
        "default": "free",
        "unit": "direction"
      }
    }
  },
  "cut_depths": {
    "types": [
      "cut",
      "half-cut"
    ],
    "byType": true,
    "ofCutters": false,
    "help": false,
    "fields": {
      "passes": {
        "kind": "number",
        "min": 1,
        "max": 10,
        "default": null,
        "whole": true,
        "unit": ""
      },
      "depth": {
        "kind": "number",
        "min": 0.0,
        "max": 100.0,
        "default": null,
        "whole": false,
        "unit": "mm"
      }
    }
  },
  "crease_depths": {
    "types": [
      "crease",
      "combi"
    ],
    "byType": true,
    "ofCutters": false,
    "help": false,
    "fields": {
      "depth": {
        "kind": "number",
        "min": 0.0,
        "max": 100.0,
        "default": null,
        "whole": false,
        "unit": "mm"
      }
    }
  },
  "edge_tools": {
    "types": [
      "cut",
      "crease",
      "v-groove",
      "perforation",
      "half-cut",
      "combi"
    ],
    "byType": true,
    "ofCutters": false,
    "help": true,
    "fields": {
      "station": {
        "kind": "number",
        "min": 1,
        "max": 255,
        "default": null,
        "whole": true,
        "unit": "station"
      }
    }
  },
  "contour_leads": {
    "types": [
      "cut"
    ],
    "byType": true,
    "ofCutters": true,
    "help": true,
    "fields": {
      "length": {
        "kind": "number",
        "min": 0.0,
        "max": 50.0,
        "default": null,
        "whole": false,
        "unit": "mm"
      },
      "approach": {
        "kind": "number",
        "min": -90.0,
        "max": 90.0,
        "default": null,
        "whole": false,
        "unit": "\u00b0"
      }
    }
  },
  "edge_feeds": {
    "types": [
      "cut",
      "half-cut",
      "perforation"
    ],
    "byType": true,
    "ofCutters": false,
    "help": false,
    "fields": {
      "factor": {
        "kind": "number",
        "min": 0.1,
        "max": 1.0,
        "default": 1.0,
        "whole": false,
        "unit": ""
      }
    }
  },
  "edge_corners": {
    "types": [
      "cut"
    ],
    "byType": true,
    "ofCutters": true,
    "help": true,
    "fields": {
      "type": {
        "kind": "choice",
        "choices": [
          "usual",
          "auto",
          "B",
          "C",
          "D"
        ],
        "default": "usual",
        "unit": "corner"
      },
      "k": {
        "kind": "number",
        "min": 0.01,
        "max": 0.99,
        "default": null,
        "whole": false,
        "unit": ""
      }
    }
  }
} as const;
