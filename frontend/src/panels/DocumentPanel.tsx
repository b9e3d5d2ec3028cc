/** The open drawing: name, size, import summary and line-type profile. */

import { ActionIcon, Select, Tooltip } from "@mantine/core";
import { IconAdjustments, IconArrowLeft } from "@tabler/icons-react";
import type { Drawing, Profile } from "../api/client";
import { renderHint, renderText } from "../messages/render";
import { useRefusal } from "../state/accounts";
import { patchDrawing } from "../state/actions";
import { formatSize, formatUnitless } from "../state/format";
import { importWarnings, summarizeReport } from "../state/importReport";
import { useDrawing, useProfiles } from "../state/queries";
import { formatInches } from "../state/sizes";
import { useUiStore } from "../state/store";
import { REPORT } from "./ImportPanel";
import { TO_ALL_DRAWINGS } from "./labels";
import { Refusal } from "./Permitted";
import css from "./panels.module.css";
import { ShareControl } from "./ShareControl";

const EDIT_PROFILE = "Edit the rules of this profile";

export function DocumentPanel() {
  const { data: drawing } = useDrawing();
  const { data: profiles } = useProfiles();
  const open = useUiStore((ui) => ui.open);
  if (drawing === undefined) return null;
  return (
    <section className={css.section} style={{ padding: "12px 16px 16px" }}>
      <div style={{ display: "flex", alignItems: "center", gap: 8, marginLeft: -6 }}>
        <Tooltip label={TO_ALL_DRAWINGS}>
          <ActionIcon
            variant="subtle"
            color="gray"
            aria-label={TO_ALL_DRAWINGS}
            data-testid="close-drawing"
            onClick={() => open(null)}
          >
            <IconArrowLeft size={17} />
          </ActionIcon>
        </Tooltip>
        <h1 className={css.docName} style={{ margin: 0 }} title={drawing.name}>
          {drawing.name}
        </h1>
      </div>
      <dl className={css.facts}>
        <dt>Drawing size</dt>
        <dd data-testid="drawing-size">
          {drawing.unit === null
            ? `${formatUnitless(drawing.width)} × ${formatUnitless(drawing.height)}, unit unknown`
            : formatSize(drawing.width, drawing.height)}
        </dd>
        {drawing.unit !== null && (
          <>
            <dt>Size in inches</dt>
            <dd data-testid="drawing-inches">{formatInches(drawing.width, drawing.height)}</dd>
          </>
        )}
        <dt>Number of edges</dt>
        <dd>
          {drawing.segments.toLocaleString("en")}
          {drawing.overrides > 0 &&
            `, ${drawing.overrides.toLocaleString("en")} with a line type set by hand`}
        </dd>
        {drawing.report && (
          <>
            <dt>Import report</dt>
            <dd>
              <button
                type="button"
                className={css.link}
                style={{ margin: 0 }}
                onClick={scrollToReport}
              >
                {summarizeReport(drawing.report)}
              </button>
            </dd>
          </>
        )}
      </dl>
      {importWarnings(drawing).map((warning) => (
        <p
          key={warning.text}
          className={css.warning}
          style={{ margin: "8px 0 0" }}
          data-testid="import-warning"
        >
          {renderText(warning)} {renderHint(warning)}
        </p>
      ))}
      {profiles && <ProfileChoice drawing={drawing} profiles={profiles} />}
      <ShareControl drawing={drawing} />
    </section>
  );
}

const scrollToReport = () =>
  document.getElementById(REPORT)?.scrollIntoView({ behavior: "smooth", block: "start" });

/** Choice of the profile; customer profiles are listed before built-in ones. */
function ProfileChoice({ drawing, profiles }: { drawing: Drawing; profiles: readonly Profile[] }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}");
  const editing = useRefusal("PUT /api/v1/profiles/{name}");
  const set = useUiStore((ui) => ui.set);
  const option = ({ name, title }: Profile) => ({ value: name, label: title || name });
  const own = profiles.filter(({ shipped }) => !shipped);
  const shipped = profiles.filter((profile) => profile.shipped);
  const isDeleted = !profiles.some(({ name }) => name === drawing.profile);
  return (
    <div style={{ marginTop: 12 }}>
      <div style={{ display: "flex", alignItems: "end", gap: 6 }}>
        <Select
          size="xs"
          style={{ flex: 1 }}
          label="Profile (rules for line types)"
          data={[
            ...(isDeleted
              ? [
                  {
                    group: "Deleted profile",
                    items: [{ value: drawing.profile, label: drawing.profile }],
                  },
                ]
              : []),
            ...(own.length > 0 ? [{ group: "Customer profiles", items: own.map(option) }] : []),
            { group: "Built-in profiles", items: shipped.map(option) },
          ]}
          value={drawing.profile}
          allowDeselect={false}
          disabled={busy || refusal !== null}
          data-testid="profile-select"
          onChange={(profile) => {
            if (profile !== null && profile !== drawing.profile) void patchDrawing({ profile });
          }}
        />
        <Tooltip label={isDeleted ? "This profile was deleted" : EDIT_PROFILE}>
          <ActionIcon
            variant="default"
            size={30}
            disabled={isDeleted || editing !== null}
            title={editing ?? undefined}
            aria-label={EDIT_PROFILE}
            data-testid="edit-profile"
            onClick={() => set({ editedProfile: drawing.profile })}
          >
            <IconAdjustments size={16} />
          </ActionIcon>
        </Tooltip>
      </div>
      <Refusal reason={refusal} />
      {drawing.profile_state !== "current" && (
        <p className={css.warning} style={{ margin: "8px 0 0" }} data-testid="profile-state">
          {drawing.profile_state === "changed"
            ? "The profile has changed since it was applied to this drawing. "
            : "This profile was deleted. The drawing still uses the rules of the deleted profile. "}
          {drawing.profile_state === "changed" && (
            <button
              type="button"
              className={css.link}
              disabled={busy || refusal !== null}
              data-testid="apply-again"
              onClick={() => void patchDrawing({ profile: drawing.profile })}
            >
              Apply the changed profile to the drawing
            </button>
          )}
        </p>
      )}
    </div>
  );
}
