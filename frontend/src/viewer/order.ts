/** What lies over what: the larger above. */
export const ORDER = {
  grid: 1,
  frame: 2,
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
  /** The nominal line, where its colour is what is looked at: the paths step back under it. */
  map: 8.5,
  hovered: 9,
  // One within the other, so that all are seen where a tool is lifted, turned and set down.
  lift: 9.1,
  swivel: 9.2,
  plunge: 9.3,
  corners: 9.5,
  pin: 9.6,
  halo: 10,
  mark: 11,
} as const;
