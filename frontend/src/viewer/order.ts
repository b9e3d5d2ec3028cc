/** Drawing order of the layers: larger is above. */
export const ORDER = {
  grid: 1,
  frame: 2,
  sheet: 2.5,
  zones: 2.6,
  datum: 3,
  chosen: 4,
  retypePreviews: 4.2,
  bands: 4.5,
  rims: 4.6,
  nominal: 5,
  uncut: 5.4,
  uncutRims: 5.5,
  rapids: 6,
  head: 7,
  tip: 8,
  /** The edges while coloured by a figure: above the tool paths. */
  map: 8.5,
  hovered: 9,
  // The dots have different sizes, so that a lift, swivel and plunge at one point are all visible.
  lift: 9.1,
  swivel: 9.2,
  plunge: 9.3,
  corners: 9.5,
  pin: 9.6,
  halo: 10,
  mark: 11,
} as const;
