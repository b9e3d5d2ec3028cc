/** The drawing that is open: its name, its size, and what decided how it was read. */

import { ActionIcon, Select, Tooltip } from "@mantine/core";
import { IconArrowLeft } from "@tabler/icons-react";
import { settle } from "../state/actions";
import { useDrawing, useProfiles } from "../state/queries";
import { usePage } from "../state/store";
import { count, size } from "../state/words";
import css from "./panels.module.css";

export function DocumentPanel() {
  const { data: drawing } = useDrawing();
  const { data: profiles } = useProfiles();
  const open = usePage((page) => page.open);
  const busy = usePage((page) => page.busy);
  if (drawing === undefined) return null;
  return (
    <section className={css.section} style={{ padding: "12px 16px 16px" }}>
      <div style={{ display: "flex", alignItems: "center", gap: 8, marginLeft: -6 }}>
        <Tooltip label="All drawings">
          <ActionIcon
            variant="subtle"
            color="gray"
            aria-label="All drawings"
            data-testid="close-drawing"
            onClick={() => open(null)}
          >
            <IconArrowLeft size={17} />
          </ActionIcon>
        </Tooltip>
        <h2 className={css.docName} style={{ margin: 0 }} title={drawing.name}>
          {drawing.name}
        </h2>
      </div>
      <dl className={css.facts}>
        <dt>Size</dt>
        <dd data-testid="drawing-size">
          {drawing.unit === null ? "unit not known" : size(drawing.width, drawing.height)}
        </dd>
        <dt>Unit of the file</dt>
        <dd title={drawing.evidence}>{drawing.unit ?? "?"}</dd>
        <dt>Edges</dt>
        <dd>
          {drawing.segments.toLocaleString("en")}
          {drawing.overrides > 0 && ` · ${count(drawing.overrides, "override")}`}
        </dd>
      </dl>
      {profiles && profiles.length > 1 && (
        <Select
          mt={12}
          size="xs"
          label="Line type profile"
          data={profiles.map(({ name, title }) => ({ value: name, label: title || name }))}
          value={drawing.profile}
          allowDeselect={false}
          disabled={busy}
          data-testid="profile-select"
          onChange={(profile) => {
            if (profile !== null && profile !== drawing.profile) void settle({ profile });
          }}
        />
      )}
    </section>
  );
}
