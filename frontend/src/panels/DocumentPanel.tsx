/** The drawing that is open: its name, its size, and what decided how it was read. */

import { ActionIcon, Select, Tooltip } from "@mantine/core";
import { IconAdjustments, IconArrowLeft } from "@tabler/icons-react";
import type { Drawing, Profile } from "../api/client";
import { settle } from "../state/actions";
import { useDrawing, useProfiles } from "../state/queries";
import { outcome } from "../state/report";
import { inches } from "../state/sizes";
import { usePage } from "../state/store";
import { size, unitless } from "../state/words";
import { REPORT } from "./ImportPanel";
import css from "./panels.module.css";

export function DocumentPanel() {
  const { data: drawing } = useDrawing();
  const { data: profiles } = useProfiles();
  const open = usePage((page) => page.open);
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
          {drawing.unit === null
            ? `${unitless(drawing.width)} × ${unitless(drawing.height)}, unit not known`
            : size(drawing.width, drawing.height)}
        </dd>
        {drawing.unit !== null && (
          <>
            <dt>In inches</dt>
            <dd data-testid="drawing-inches">{inches(drawing.width, drawing.height)}</dd>
          </>
        )}
        <dt>Edges</dt>
        <dd>
          {drawing.segments.toLocaleString("en")}
          {drawing.overrides > 0 && ` · ${drawing.overrides.toLocaleString("en")} decided by hand`}
        </dd>
        {drawing.report && (
          <>
            <dt>Import</dt>
            <dd>
              <button type="button" className={css.link} style={{ margin: 0 }} onClick={show}>
                {outcome(drawing.report)}
              </button>
            </dd>
          </>
        )}
      </dl>
      {profiles && <ProfileChoice drawing={drawing} profiles={profiles} />}
    </section>
  );
}

const show = () =>
  document.getElementById(REPORT)?.scrollIntoView({ behavior: "smooth", block: "start" });

/** By whose rules the drawing is read; the customers' own stand above those that are shipped. */
function ProfileChoice({ drawing, profiles }: { drawing: Drawing; profiles: readonly Profile[] }) {
  const busy = usePage((page) => page.busy);
  const set = usePage((page) => page.set);
  const option = ({ name, title }: Profile) => ({ value: name, label: title || name });
  const own = profiles.filter(({ shipped }) => !shipped);
  const shipped = profiles.filter((profile) => profile.shipped);
  const gone = !profiles.some(({ name }) => name === drawing.profile);
  return (
    <div style={{ marginTop: 12 }}>
      <div style={{ display: "flex", alignItems: "end", gap: 6 }}>
        <Select
          size="xs"
          style={{ flex: 1 }}
          label="Line type profile"
          data={[
            ...(gone
              ? [{ group: "Deleted", items: [{ value: drawing.profile, label: drawing.profile }] }]
              : []),
            ...(own.length > 0 ? [{ group: "Customers", items: own.map(option) }] : []),
            { group: "Shipped", items: shipped.map(option) },
          ]}
          value={drawing.profile}
          allowDeselect={false}
          disabled={busy}
          data-testid="profile-select"
          onChange={(profile) => {
            if (profile !== null && profile !== drawing.profile) void settle({ profile });
          }}
        />
        <Tooltip label={gone ? "It is deleted" : "Rules of this profile"}>
          <ActionIcon
            variant="default"
            size={30}
            disabled={gone}
            aria-label="Edit the profile"
            data-testid="edit-profile"
            onClick={() => set({ editing: drawing.profile })}
          >
            <IconAdjustments size={16} />
          </ActionIcon>
        </Tooltip>
      </div>
      {drawing.profile_state !== "current" && (
        <p className={css.warning} style={{ margin: "8px 0 0" }} data-testid="profile-state">
          {drawing.profile_state === "changed"
            ? "The profile has changed since this drawing was read by it. "
            : "This profile is deleted; the drawing keeps its rules. "}
          {drawing.profile_state === "changed" && (
            <button
              type="button"
              className={css.link}
              disabled={busy}
              data-testid="bring-up-to-date"
              onClick={() => void settle({ profile: drawing.profile })}
            >
              Read it anew
            </button>
          )}
        </p>
      )}
    </div>
  );
}
