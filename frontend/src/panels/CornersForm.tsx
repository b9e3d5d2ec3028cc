/** How a cutter goes round corners: for all of them, and for some that are pointed at. */

import { Button, CloseButton, SegmentedControl, Slider } from "@mantine/core";
import { IconHandClick } from "@tabler/icons-react";
import { useId } from "react";
import { CORNER_TYPES, type CornerType, withKnob, withType } from "../state/corners";
import { usePage } from "../state/store";
import cornerCss from "./corners.module.css";
import css from "./panels.module.css";

const TITLES: Readonly<Record<CornerType, string>> = {
  auto: "Auto",
  B: "B arc",
  C: "C sharp",
  D: "D blend",
};

const SAID: Readonly<Record<CornerType, string>> = {
  auto: "Each corner as is fastest on this machine.",
  B: "The centre goes round on an arc, and the cutter touches the corner all the way.",
  C: "The centre goes straight on to a sharp bend, stops there, and turns.",
  D: "The centre goes straight on, round a smaller arc, and straight back: no stop, no touch.",
};

/** The centre's way past a corner at (34, 26), r = 14 above it and to its right. */
const WAYS: Readonly<Record<Exclude<CornerType, "auto">, string>> = {
  B: "M2 12H34A14 14 0 0 1 48 26V42",
  C: "M2 12H48V42",
  D: "M2 12H41A7 7 0 0 1 48 19V42",
};

export function CornersForm() {
  const corners = usePage((page) => page.corners);
  const picking = usePage((page) => page.picking);
  const set = usePage((page) => page.set);
  const fit = useId();
  const hasKnob = corners.type === "D" || corners.type === "auto";
  return (
    <fieldset className={cornerCss.corners} data-testid="corners">
      <legend>Corners of the cutter's path</legend>
      <div className={cornerCss.cornerTypes}>
        {CORNER_TYPES.map((type) => (
          <button
            key={type}
            type="button"
            className={cornerCss.cornerType}
            aria-pressed={corners.type === type}
            title={SAID[type]}
            onClick={() => set({ corners: { ...corners, type } })}
            data-testid={`corner-${type}`}
          >
            <CornerPicture type={type} />
            {TITLES[type]}
          </button>
        ))}
      </div>
      <p className={css.note}>{SAID[corners.type]}</p>
      {hasKnob && (
        <Knob
          label="k of D corners"
          value={corners.k}
          onChange={(k) => set({ corners: { ...corners, k } })}
        />
      )}
      <div className={cornerCss.cornerFit}>
        <span id={fit}>Where the cutter does not fit</span>
        <SegmentedControl
          size="xs"
          fullWidth
          aria-labelledby={fit}
          data={[
            { value: "trim", label: "Leave uncut" },
            { value: "refuse", label: "Refuse the job" },
          ]}
          value={corners.interference}
          onChange={(word) =>
            set({ corners: { ...corners, interference: word === "refuse" ? "refuse" : "trim" } })
          }
          data-testid="interference"
        />
      </div>
      <Single />
      <Button
        size="xs"
        variant={picking ? "light" : "default"}
        leftSection={<IconHandClick size={15} aria-hidden />}
        aria-pressed={picking}
        onClick={() => set({ picking: !picking })}
        data-testid="pick-corner"
      >
        {picking ? "Click cuts near their corners · done" : "Choose single corners"}
      </Button>
    </fieldset>
  );
}

/** The corners that are made otherwise, one to a row. */
function Single() {
  const corners = usePage((page) => page.corners);
  const set = usePage((page) => page.set);
  if (corners.at.length === 0) return null;
  return (
    <ul className={cornerCss.cornerList} data-testid="single-corners">
      {corners.at.map((one, which) => (
        <li key={`${one.x} ${one.y}`}>
          <div className={cornerCss.cornerRow}>
            <span className={css.figure}>
              {one.x.toFixed(1)}, {one.y.toFixed(1)}
            </span>
            <SegmentedControl
              size="xs"
              data={CORNER_TYPES.map((type) => ({
                value: type,
                label: type === "auto" ? "Auto" : type,
              }))}
              value={one.type}
              onChange={(word) => {
                const type = CORNER_TYPES.find((known) => known === word);
                if (type !== undefined) set({ corners: withType(corners, which, type) });
              }}
              aria-label={`Type of the corner at ${one.x.toFixed(1)}, ${one.y.toFixed(1)}`}
            />
            <CloseButton
              size="sm"
              aria-label={`Make the corner at ${one.x.toFixed(1)}, ${one.y.toFixed(1)} as the others`}
              onClick={() => set({ corners: withType(corners, which, null) })}
            />
          </div>
          {one.type === "D" && (
            <Knob
              label="k"
              value={one.k ?? corners.k}
              onChange={(k) => set({ corners: withKnob(corners, which, k) })}
            />
          )}
        </li>
      ))}
    </ul>
  );
}

interface KnobProps {
  label: string;
  value: number;
  onChange: (k: number) => void;
}

function Knob({ label, value, onChange }: KnobProps) {
  return (
    <div className={cornerCss.cornerRow}>
      <span style={{ whiteSpace: "nowrap" }}>{label}</span>
      <Slider
        style={{ flex: 1 }}
        size="sm"
        min={0.05}
        max={0.95}
        step={0.05}
        value={value}
        label={null}
        thumbLabel={label}
        onChange={(k) => onChange(Number(k.toFixed(2)))}
      />
      <span className={css.figure}>{value.toFixed(2)}</span>
    </div>
  );
}

function CornerPicture({ type }: { type: CornerType }) {
  const all = type === "auto";
  return (
    <svg viewBox="0 0 56 44" width="56" height="44" aria-hidden="true">
      <path d="M2 26H34V44H2Z" className={cornerCss.cornerPart} />
      <circle cx="20" cy="12" r="10" className={cornerCss.cornerDisc} />
      {(all ? (["B", "C", "D"] as const) : [type]).map((word) => (
        <path key={word} d={WAYS[word]} className={cornerCss.cornerWay} data-faint={all} />
      ))}
    </svg>
  );
}
