/** Shown if another user has saved a version meanwhile: the differences, and two choices. */

import { Box, Button, Group } from "@mantine/core";
import type { Definition } from "../../api/library";
import { translate } from "../../language/translate";
import { differences, type Fields } from "../../state/library/definitions";
import panels from "../shared/panels.module.css";
import { DifferenceTable } from "./DifferenceTable";

interface Props {
  /** The version that the other user has saved. */
  readonly theirs: Definition;
  /** Name of this user; empty if it is not known. */
  readonly by: string;
  readonly mine: Fields;
  readonly onTakeTheirs: () => void;
  readonly onKeepMine: () => void;
}

export function ConflictCard({ theirs, by, mine, onTakeTheirs, onKeepMine }: Props) {
  const changes = differences(theirs.fields, mine);
  return (
    <Box
      className={panels.callout}
      data-tone="amber"
      mah="50vh"
      style={{ overflow: "auto" }}
      role="alert"
      data-testid="conflict"
    >
      <b>
        {translate("conflictCard.hasSavedVersionSinceYou", {
          by: by || translate("conflictCard.anotherUser"),
          version: theirs.version,
        })}
      </b>
      {changes.length > 0 && (
        <DifferenceTable
          changes={changes}
          before={translate("conflictCard.version", { version: theirs.version })}
          after={translate("conflictCard.yours")}
        />
      )}
      <Group gap={8} mt={8} align="flex-end">
        <Button onClick={onTakeTheirs} data-testid="take-theirs">
          {translate("conflictCard.discardMyChangesAndLoad", { version: theirs.version })}
        </Button>
        <Button variant="default" onClick={onKeepMine} data-testid="keep-mine">
          {translate("conflictCard.saveMyChangesAsVersion", { version: theirs.version + 1 })}
        </Button>
      </Group>
    </Box>
  );
}
