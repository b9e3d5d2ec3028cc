/** Versions of a machine, a board or a tool, and what changed in each. */

import { Button, Table, Title } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import type { Definition } from "../../api/library";
import { formatDateTime } from "../../language/numbers";
import { translate } from "../../language/translate";
import { differences } from "../../state/library/definitions";
import { queries } from "../../state/queries";
import { DifferenceTable } from "./DifferenceTable";
import css from "./library.module.css";

interface Props {
  readonly definition: Definition;
  /** Saves an old version as the newest; null if the entry may not be changed. */
  readonly onRestore: ((old: Definition) => void) | null;
}

export function DefinitionHistory({ definition, onRestore }: Props) {
  const { shelf, name } = definition;
  const { data: versions = [] } = useQuery(queries.definitionVersions(shelf, name));
  const [compared, setCompared] = useState<number | null>(null);
  const { data: old } = useQuery({
    ...queries.definition(shelf, name, compared),
    enabled: compared !== null,
  });
  if (versions.length < 2) return null;
  const changes = old === undefined ? [] : differences(old.fields, definition.fields);
  return (
    <section className={css.group} data-testid="versions">
      <Title order={2} fz={14} mb={12}>
        {translate("definitionHistory.versions")}
      </Title>
      <Table>
        <Table.Tbody>
          {versions.map(({ version, at, by, note }) => (
            <Table.Tr key={version}>
              <Table.Td>{version}</Table.Td>
              <Table.Td>{at == null ? "" : formatDateTime(new Date(at))}</Table.Td>
              <Table.Td>{by}</Table.Td>
              <Table.Td>{note}</Table.Td>
              <Table.Td>
                {version !== definition.version && (
                  <Button
                    size="compact-xs"
                    variant="default"
                    onClick={() => setCompared(version)}
                    data-testid={`compare-${version}`}
                  >
                    {translate("definitionHistory.compare")}
                  </Button>
                )}
              </Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </Table>
      {old !== undefined && compared !== null && (
        <>
          <DifferenceTable
            changes={changes}
            before={translate("definitionHistory.version", { compared })}
            after={translate("definitionHistory.version2", { version: definition.version })}
          />
          {onRestore !== null && (
            <Button mt={10} variant="default" onClick={() => onRestore(old)} data-testid="restore">
              {translate("definitionHistory.restore", { compared })}
            </Button>
          )}
        </>
      )}
    </section>
  );
}
