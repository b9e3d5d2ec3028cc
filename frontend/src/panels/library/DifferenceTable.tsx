/** The fields in which two versions of a machine, a board or a tool differ. */

import { translate } from "../../language/translate";
import type { Difference } from "../../state/library/definitions";
import css from "./library.module.css";

interface Props {
  readonly changes: readonly Difference[];
  /** Headings of the columns with the values before and after. */
  readonly before: string;
  readonly after: string;
}

export function DifferenceTable({ changes, ...headings }: Props) {
  return (
    <table className={css.history} data-testid="differences">
      <thead>
        <tr>
          <th>{translate("differenceTable.field")}</th>
          <th>{headings.before}</th>
          <th>{headings.after}</th>
        </tr>
      </thead>
      <tbody>
        {changes.map(({ path, before, after }) => (
          <tr key={path}>
            <td>{path}</td>
            <td>{before}</td>
            <td>{after}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
