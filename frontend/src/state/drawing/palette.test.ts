import { describe, expect, test } from "vitest";
import { COLOURS, SCALE, type Scheme } from "./palette";

/** Björn Ottosson's OKLab, in which equal distances look equal. */
function oklab(hex: string): [number, number, number] {
  const linear = [1, 3, 5].map((at) => {
    const part = Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  const [r = 0, g = 0, b = 0] = linear;
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

const apart = (a: string, b: string): number => {
  const [from, to] = [oklab(a), oklab(b)];
  return Math.hypot(from[0] - to[0], from[1] - to[1], from[2] - to[2]);
};

describe.each(["dark", "light"] as const)("the scale of the figures, %s", (scheme) => {
  const { stops, beyond, unworked } = SCALE[scheme];
  const steps = stops.slice(1).map((stop, at) => apart(stops[at] ?? "", stop));
  const mean = steps.reduce((sum, step) => sum + step, 0) / steps.length;

  test("white is light and has no hue", () => {
    expect(oklab("#ffffff")[0]).toBeCloseTo(1, 4);
    expect(oklab("#ffffff")[1]).toBeCloseTo(0, 4);
  });

  test("has steps that look alike", () => {
    for (const step of steps) expect(Math.abs(step / mean - 1)).toBeLessThan(0.08);
  });

  test("grows lighter all the way", () => {
    const light = stops.map((stop) => oklab(stop)[0]);
    expect(light).toEqual([...light].sort((a, b) => a - b));
  });

  test("has distinct colours for above the limit and not machined", () => {
    for (const stop of stops) {
      expect(apart(stop, beyond)).toBeGreaterThan(2.5 * mean);
      expect(apart(stop, unworked)).toBeGreaterThan(1.5 * mean);
    }
  });
});

/** Relative luminance of WCAG 2. */
function luminance(hex: string): number {
  const [r = 0, g = 0, b = 0] = [1, 3, 5].map((at) => {
    const part = Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

const contrast = (a: string, b: string): number => {
  const [dark = 0, light = 0] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (light + 0.05) / (dark + 0.05);
};

describe.each<Scheme>(["dark", "light"])("the lines of the %s scheme", (scheme) => {
  const colours = COLOURS[scheme];
  const lines = [
    "cut",
    "crease",
    "v-groove",
    "perforation",
    "half-cut",
    "combi",
    "ignored",
  ] as const;
  test.each([...lines, "unclassified", "head", "tip", "uncut", "zone"] as const)(
    "%s stands out from the table",
    (name) => {
      // WCAG 2.2, 1.4.11: graphical objects.
      expect(contrast(colours[name], colours.table)).toBeGreaterThan(3);
    },
  );
});
