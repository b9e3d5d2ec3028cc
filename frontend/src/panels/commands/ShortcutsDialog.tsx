/** Keyboard and mouse shortcuts. */

import { Kbd, Modal, Title } from "@mantine/core";
import { translate } from "../../language/translate";
import { COMMANDS, GROUPS } from "../../state/commands/commands";
import { GROUP_TITLES, keyTexts } from "../../state/commands/commandTexts";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";

const MOUSE: readonly (readonly [string, string])[] = [
  [translate("shortcutsDialog.wheel"), translate("shortcutsDialog.zoomAtTheCursor")],
  [translate("shortcutsDialog.drag"), translate("shortcutsDialog.moveTheView")],
  [translate("shortcutsDialog.click"), translate("shortcutsDialog.selectAnEdgeWithShift")],
  [translate("shortcutsDialog.shiftDrag"), translate("shortcutsDialog.selectTheEdgesInA")],
  [translate("shortcutsDialog.altDrag"), translate("shortcutsDialog.selectTheEdgesInALasso")],
];

const WITH_KEYS = COMMANDS.filter(({ keys }) => keys.length > 0);

export function ShortcutsDialog() {
  const open = useUiStore((ui) => ui.helpOpen);
  const set = useUiStore((ui) => ui.set);
  return (
    <Modal
      opened={open}
      onClose={() => set({ helpOpen: false })}
      title={translate("shortcutsDialog.keyboardAndMouseShortcuts")}
      size="xl"
      centered
    >
      <div style={{ columns: "260px 2", columnGap: 28 }}>
        <Keys title={translate("shortcutsDialog.mouse")} rows={MOUSE} />
        {GROUPS.map((group) => {
          const rows = WITH_KEYS.filter((one) => one.group === group);
          return (
            rows.length > 0 && (
              <Keys
                key={group}
                title={GROUP_TITLES[group]}
                rows={rows.map((one) => [keyTexts(one), one.title] as const)}
              />
            )
          );
        })}
      </div>
    </Modal>
  );
}

interface KeysProps {
  readonly title: string;
  readonly rows: readonly (readonly [string, string])[];
}

function Keys({ title, rows }: KeysProps) {
  return (
    <section style={{ marginBottom: 20, breakInside: "avoid" }}>
      <Title order={3} fz={12} mb={8} c="ink.3">
        {title}
      </Title>
      <dl className={css.facts} style={{ margin: 0, gap: "8px 14px", alignItems: "center" }}>
        {rows.map(([key, does]) => (
          <div key={does} style={{ display: "contents" }}>
            <dt>
              <Kbd style={{ height: 22, padding: "0 7px", whiteSpace: "nowrap" }}>{key}</Kbd>
            </dt>
            <dd style={{ textAlign: "left" }}>{does}</dd>
          </div>
        ))}
      </dl>
    </section>
  );
}
