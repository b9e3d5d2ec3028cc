/** Keyboard and mouse shortcuts. */

import { Modal } from "@mantine/core";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../state/palette";
import { useUiStore } from "../state/store";
import { USE_PROFILE_TYPE } from "./labels";
import css from "./panels.module.css";

const KEYS: readonly (readonly [string, string])[] = [
  ["F", "Show the whole drawing"],
  ["Shift F", "Show the whole table"],
  ["+  −", "Zoom in; zoom out"],
  ["Arrow keys", "Move the view"],
  ["Ctrl Z", "Undo the last change"],
  ["Ctrl Shift Z", "Redo the undone change"],
  ["Esc", "Clear the selection of edges"],
  ["Ctrl A", "Select all edges"],
  ["[  ]", "Show or hide the left panel; the right panel"],
  ["N  H  T  R", "Show or hide drawing; head path; path of tool tip; moves above board"],
  ["S  P", "Show or hide tool width; points where a tool enters or leaves the board"],
  ["C", "Change what the colours show: line type, deviation or overcut"],
  ["?", "Show or hide this list"],
];

const MOUSE: readonly (readonly [string, string])[] = [
  ["Wheel", "Zoom at the cursor"],
  ["Drag", "Move the view"],
  ["Click", "Select an edge; with Shift, add it to the selection"],
  ["Shift drag", "Select the edges in a box"],
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
      title="Keyboard and mouse shortcuts"
      size="lg"
      centered
    >
      <div
        style={{
          display: "grid",
          gridTemplateColumns: "repeat(auto-fit, minmax(min(260px, 100%), 1fr))",
          gap: 28,
        }}
      >
        <Keys rows={KEYS} />
        <div style={{ display: "grid", gap: 20, alignContent: "start" }}>
          <Keys rows={MOUSE} />
          <div>
            <p className={css.note} style={{ margin: "0 0 8px" }}>
              Set the line type of the selected edges
            </p>
            <Keys rows={[...choices, ["0", USE_PROFILE_TYPE]]} />
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
