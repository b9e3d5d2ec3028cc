/** Shown if another user has saved a version meanwhile: the differences, and two choices. */

import { Button } from "@mantine/core";
import type { Definition } from "../api/client";
import { differences, type Fields } from "../state/definitions";
import { DifferenceTable } from "./DifferenceTable";
import css from "./library.module.css";

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
    <div className={css.conflict} role="alert" data-testid="conflict">
      <b>
        {by || "Another user"} has saved version {theirs.version} since you began. Your changes are
        not saved.
      </b>
      {changes.length > 0 && (
        <DifferenceTable changes={changes} before={`Version ${theirs.version}`} after="Yours" />
      )}
      <div className={css.add}>
        <Button onClick={onTakeTheirs} data-testid="take-theirs">
          Discard my changes and load version {theirs.version}
        </Button>
        <Button variant="default" onClick={onKeepMine} data-testid="keep-mine">
          Save my changes as version {theirs.version + 1}
        </Button>
      </div>
    </div>
  );
}
