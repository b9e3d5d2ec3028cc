/** The keys and what they do. */

import { Modal } from "@mantine/core";
import { CHOICES, LINE_LOOKS } from "../state/palette";
import { usePage } from "../state/store";
import css from "./panels.module.css";

const KEYS: readonly (readonly [string, string])[] = [
  ["F", "Fit the drawing"],
  ["Shift F", "Fit the table"],
  ["+  −", "Zoom"],
  ["Arrow keys", "Pan"],
  ["Ctrl Z", "Undo"],
  ["Ctrl Shift Z", "Redo"],
  ["Esc", "Choose nothing"],
  ["Ctrl A", "Choose all edges"],
  ["[  ]", "Fold the side panels away"],
  ["N  H  T  R", "Nominal, head path, tip path, rapids"],
  ["S  P", "What tools sweep; plunges, lifts and swivels"],
  ["C", "Colour by line type, deviation, overcut"],
  ["?", "This list"],
];

const MOUSE: readonly (readonly [string, string])[] = [
  ["Wheel", "Zoom at the cursor"],
  ["Drag", "Pan"],
  ["Click", "Choose an edge; with Shift one more"],
  ["Shift drag", "Choose by a box"],
];

export function ShortcutsDialog() {
  const open = usePage((page) => page.helpOpen);
  const set = usePage((page) => page.set);
  const choices = CHOICES.map((type) => [LINE_LOOKS[type].key, LINE_LOOKS[type].title] as const);
  return (
    <Modal
      opened={open}
      onClose={() => set({ helpOpen: false })}
      title="Keys and mouse"
      size="lg"
      centered
    >
      <div style={{ display: "grid", gridTemplateColumns: "1fr 1fr", gap: 28 }}>
        <Keys rows={KEYS} />
        <div style={{ display: "grid", gap: 20, alignContent: "start" }}>
          <Keys rows={MOUSE} />
          <div>
            <p className={css.note} style={{ margin: "0 0 8px" }}>
              Line type of the chosen edges
            </p>
            <Keys rows={[...choices, ["0", "As the profile says"]]} />
          </div>
        </div>
      </div>
    </Modal>
  );
}

function Keys({ rows }: { rows: readonly (readonly [string, string])[] }) {
  return (
    <dl className={css.facts} style={{ margin: 0, gap: "8px 14px", alignItems: "center" }}>
      {rows.map(([key, does]) => (
        <div key={key} style={{ display: "contents" }}>
          <dt>
            <span className={css.key} style={{ height: 22, padding: "0 7px" }}>
              {key}
            </span>
          </dt>
          <dd style={{ textAlign: "left" }}>{does}</dd>
        </div>
      ))}
    </dl>
  );
}
