/** Figures of a verdict and facts of a program that are lines with a title. Written by frontend/options.py: do not edit. */

export const PROGRAM_FIGURES = {
  "lowest_travel": {
    "title": {
      "code": "figure.lowest-travel",
      "arguments": {},
      "text": "Lowest travel above the board"
    },
    "unit": "mm"
  }
} as const;

export const EDGE_FIGURES = {
  "bottom_uncut": {
    "title": {
      "code": "figure.bottom-uncut",
      "arguments": {},
      "text": "Uncut on bottom face"
    }
  },
  "top_overcut": {
    "title": {
      "code": "figure.top-overcut",
      "arguments": {},
      "text": "Overcut on top face"
    }
  },
  "slit_length": {
    "title": {
      "code": "figure.slit-length",
      "arguments": {},
      "text": "Slit as wide as the tool"
    }
  }
} as const;

export const PROGRAM_FACTS = {
  "program_bytes": {
    "unit": "bytes"
  }
} as const;
