/** Keyboard and mouse shortcuts. */

import { Kbd, Modal } from "@mantine/core";
import { translate } from "../../language/translate";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../../state/drawing/palette";
import { useUiStore } from "../../state/store";
import { USE_PROFILE_TYPE } from "./labels";
import css from "./panels.module.css";
import { Note } from "./parts";

const KEYS: readonly (readonly [string, string])[] = [
  ["F", translate("shortcutsDialog.showTheWholeDrawing")],
  [translate("shortcutsDialog.shiftF"), translate("shortcutsDialog.showTheWholeTable")],
  ["+  −", translate("shortcutsDialog.zoomInZoomOut")],
  [translate("shortcutsDialog.arrowKeys"), translate("shortcutsDialog.moveTheView")],
  [translate("shortcutsDialog.ctrlZ"), translate("shortcutsDialog.undoTheLastChange")],
  [translate("shortcutsDialog.ctrlShiftZ"), translate("shortcutsDialog.redoTheUndoneChange")],
  [translate("shortcutsDialog.esc"), translate("shortcutsDialog.clearTheSelectionOfEdges")],
  [translate("shortcutsDialog.ctrlA"), translate("shortcutsDialog.selectAllEdges")],
  ["]", translate("shortcutsDialog.showOrHideTheLeft")],
  ["N  H  T  R", translate("shortcutsDialog.showOrHideDrawingHead")],
  ["S  P", translate("shortcutsDialog.showOrHideToolWidth")],
  ["M", translate("shortcutsDialog.measureADistance")],
  [translate("shortcutsDialog.delete"), translate("shortcutsDialog.ignoreTheSelectedEdges")],
  ["C", translate("shortcutsDialog.changeWhatTheColoursShow")],
  ["?", translate("shortcutsDialog.showOrHideThisList")],
];

const MOUSE: readonly (readonly [string, string])[] = [
  [translate("shortcutsDialog.wheel"), translate("shortcutsDialog.zoomAtTheCursor")],
  [translate("shortcutsDialog.drag"), translate("shortcutsDialog.moveTheView")],
  [translate("shortcutsDialog.click"), translate("shortcutsDialog.selectAnEdgeWithShift")],
  [translate("shortcutsDialog.shiftDrag"), translate("shortcutsDialog.selectTheEdgesInA")],
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
      title={translate("shortcutsDialog.keyboardAndMouseShortcuts")}
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
            <Note style={{ margin: "0 0 8px" }}>
              {translate("shortcutsDialog.setTheLineTypeOf")}
            </Note>
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
            <Kbd style={{ height: 22, padding: "0 7px" }}>{key}</Kbd>
          </dt>
          <dd style={{ textAlign: "left" }}>{does}</dd>
        </div>
      ))}
    </dl>
  );
}
