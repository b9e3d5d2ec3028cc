/** Keyboard and mouse shortcuts. */

import { Modal } from "@mantine/core";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../state/palette";
import { useUiStore } from "../state/store";
import css from "./panels.module.css";

const KEYS: readonly (readonly [string, string])[] = [
  ["F", "Fit the drawing"],
  ["Shift F", "Fit the table"],
  ["+  −", "Zoom"],
  ["Arrow keys", "Pan"],
  ["Ctrl Z", "Undo"],
  ["Ctrl Shift Z", "Redo"],
  ["Esc", "Clear selection"],
  ["Ctrl A", "Select all edges"],
  ["[  ]", "Hide side panels"],
  ["N  H  T  R", "Show drawing, head path, tip path, rapids"],
  ["S  P", "Show swept area; plunges, lifts and swivels"],
  ["C", "Colour by line type, deviation, overcut"],
  ["?", "Show shortcuts"],
];

const MOUSE: readonly (readonly [string, string])[] = [
  ["Wheel", "Zoom at the cursor"],
  ["Drag", "Pan"],
  ["Click", "Select edge (Shift: add)"],
  ["Shift drag", "Select with a box"],
];

export function ShortcutsDialog() {
  const open = useUiStore((ui) => ui.helpOpen);
  const set = useUiStore((ui) => ui.set);
  const choices = ASSIGNABLE_TYPES.map(
    (type) => [LINE_STYLES[type].key, LINE_STYLES[type].title] as const,
  );
  return (
    <Modal
      opened={open}
      onClose={() => set({ helpOpen: false })}
      title="Shortcuts"
      size="lg"
      centered
    >
      <div style={{ display: "grid", gridTemplateColumns: "1fr 1fr", gap: 28 }}>
        <Keys rows={KEYS} />
        <div style={{ display: "grid", gap: 20, alignContent: "start" }}>
          <Keys rows={MOUSE} />
          <div>
            <p className={css.note} style={{ margin: "0 0 8px" }}>
              Line type of selected edges
            </p>
            <Keys rows={[...choices, ["0", "Reset to profile"]]} />
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
