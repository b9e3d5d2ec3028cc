/** The fields in which two versions of a machine, a board or a tool differ. */

import { Table } from "@mantine/core";
import { translate } from "../../language/translate";
import type { Difference } from "../../state/library/definitions";

interface Props {
  readonly changes: readonly Difference[];
  /** Headings of the columns with the values before and after. */
  readonly before: string;
  readonly after: string;
}

export function DifferenceTable({ changes, ...headings }: Props) {
  return (
    <Table data-testid="differences">
      <Table.Thead>
        <Table.Tr>
          <Table.Th>{translate("differenceTable.field")}</Table.Th>
          <Table.Th>{headings.before}</Table.Th>
          <Table.Th>{headings.after}</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {changes.map(({ path, before, after }) => (
          <Table.Tr key={path}>
            <Table.Td>{path}</Table.Td>
            <Table.Td>{before}</Table.Td>
            <Table.Td>{after}</Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </Table>
  );
}
