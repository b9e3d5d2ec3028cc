/** Another person has saved a version in between: what differs, and the two ways out. */

import { Button } from "@mantine/core";
import type { Definition } from "../api/client";
import { differences, type Fields } from "../state/definitions";
import { DifferenceTable } from "./DifferenceTable";
import css from "./library.module.css";

interface Props {
  /** What the other person has saved. */
  readonly theirs: Definition;
  /** Who has saved it; empty if it is not known. */
  readonly by: string;
  readonly mine: Fields;
  readonly onTakeTheirs: () => void;
  readonly onKeepMine: () => void;
}

export function ConflictCard({ theirs, by, mine, onTakeTheirs, onKeepMine }: Props) {
  const changes = differences(theirs.fields, mine);
  return (
    <div className={css.conflict} role="alert" data-testid="conflict">
      <b>
        {by || "Another person"} has saved version {theirs.version} since you began. Nothing of
        yours was saved.
      </b>
      {changes.length > 0 && (
        <DifferenceTable changes={changes} before={`Version ${theirs.version}`} after="Yours" />
      )}
      <div className={css.add}>
        <Button onClick={onTakeTheirs} data-testid="take-theirs">
          Load version {theirs.version}, drop my changes
        </Button>
        <Button variant="default" onClick={onKeepMine} data-testid="keep-mine">
          Save mine as version {theirs.version + 1}
        </Button>
      </div>
    </div>
  );
}
