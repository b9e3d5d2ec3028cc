/** The open drawing: name, size, import summary and line-type profile. */

import { ActionIcon, Box, Group, Select, Tooltip } from "@mantine/core";
import { IconAdjustments } from "@tabler/icons-react";
import type { Drawing } from "../../api/drawings";
import type { Profile } from "../../api/library";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { messageHint, messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { patchDrawing } from "../../state/actions";
import { importWarnings, summarizeReport } from "../../state/drawing/importReport";
import { formatInches } from "../../state/drawing/sizes";
import { formatSize, formatUnitless } from "../../state/format";
import { useDrawing, useProfiles } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Refusal } from "../accounts/Permitted";
import { FoldLink } from "../fold/FoldLink";
import { DrawingExport } from "../handover/Handover";
import { CustomerField } from "../order/CustomerField";
import css from "../shared/panels.module.css";
import { LinkButton } from "../shared/parts";
import { Section } from "../shared/Section";
import { REPORT } from "./ImportPanel";
import { ShareControl } from "./ShareControl";

const EDIT_PROFILE = translate("documentPanel.editTheRulesOfThis");

export function DocumentPanel() {
  const { data: drawing } = useDrawing();
  const { data: profiles } = useProfiles();
  if (drawing === undefined) return null;
  return (
    <Section title={translate("documentPanel.file")}>
      <Box component="dl" className={css.facts} data-end fz={12}>
        <dt>{translate("documentPanel.drawingSize")}</dt>
        <dd data-testid="drawing-size">
          {drawing.unit === null
            ? translate("documentPanel.unitUnknown", {
                width: formatUnitless(drawing.width),
                height: formatUnitless(drawing.height),
              })
            : formatSize(drawing.width, drawing.height)}
        </dd>
        {drawing.unit !== null && (
          <>
            <dt>{translate("documentPanel.sizeInInches")}</dt>
            <dd data-testid="drawing-inches">{formatInches(drawing.width, drawing.height)}</dd>
          </>
        )}
        <dt>{translate("documentPanel.numberOfEdges")}</dt>
        <dd>
          {drawing.overrides > 0
            ? translate("documentPanel.withALineTypeSet", {
                segments: drawing.segments,
                overrides: drawing.overrides,
              })
            : formatNumber(drawing.segments)}
        </dd>
        {drawing.report && (
          <>
            <dt>{translate("documentPanel.importReport")}</dt>
            <dd>
              <LinkButton type="button" onClick={scrollToReport}>
                {summarizeReport(drawing.report)}
              </LinkButton>
            </dd>
          </>
        )}
      </Box>
      {importWarnings(drawing).map((warning) => (
        <p
          key={warning.text}
          className={css.callout}
          data-tone="amber"
          style={{ margin: "8px 0 0" }}
          data-testid="import-warning"
        >
          {messageText(warning)} {messageHint(warning)}
        </p>
      ))}
      {profiles && <ProfileChoice drawing={drawing} profiles={profiles} />}
      <CustomerField drawing={drawing} />
      <ShareControl drawing={drawing} />
      <Group gap={8} mt={12}>
        {drawing.unit !== null && <FoldLink drawing={drawing.id} />}
        <DrawingExport drawing={drawing} />
      </Group>
    </Section>
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
          label={translate("documentPanel.profileRulesForLineTypes")}
          data={[
            ...(isDeleted
              ? [
                  {
                    group: translate("documentPanel.deletedProfile"),
                    items: [{ value: drawing.profile, label: drawing.profile }],
                  },
                ]
              : []),
            ...(own.length > 0
              ? [{ group: translate("documentPanel.customerProfiles"), items: own.map(option) }]
              : []),
            { group: translate("documentPanel.builtInProfiles"), items: shipped.map(option) },
          ]}
          value={drawing.profile}
          allowDeselect={false}
          disabled={busy || refusal !== null}
          data-testid="profile-select"
          onChange={(profile) => {
            if (profile !== null && profile !== drawing.profile) void patchDrawing({ profile });
          }}
        />
        <Tooltip
          label={isDeleted ? translate("documentPanel.thisProfileWasDeleted") : EDIT_PROFILE}
        >
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
        <p
          className={css.callout}
          data-tone="amber"
          style={{ margin: "8px 0 0" }}
          data-testid="profile-state"
        >
          {drawing.profile_state === "changed"
            ? translate("documentPanel.theProfileHasChangedSince")
            : translate("documentPanel.thisProfileWasDeletedThe")}{" "}
          {drawing.profile_state === "changed" && (
            <LinkButton
              type="button"
              disabled={busy || refusal !== null}
              data-testid="apply-again"
              onClick={() => void patchDrawing({ profile: drawing.profile })}
            >
              {translate("documentPanel.applyTheChangedProfileTo")}
            </LinkButton>
          )}
        </p>
      )}
    </div>
  );
}
