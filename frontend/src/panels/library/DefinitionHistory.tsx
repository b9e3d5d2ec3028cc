/** Versions of a machine, a board or a tool, and what changed in each. */

import { Button } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import type { Definition } from "../../api/client";
import { formatDateTime } from "../../language/numbers";
import { translate } from "../../language/translate";
import { differences } from "../../state/library/definitions";
import { queries } from "../../state/queries";
import { DifferenceTable } from "./DifferenceTable";
import css from "./library.module.css";

export function DefinitionHistory({ definition }: { definition: Definition }) {
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
      <h2>{translate("definitionHistory.versions")}</h2>
      <table className={css.history}>
        <tbody>
          {versions.map(({ version, at, by, note }) => (
            <tr key={version}>
              <td>{version}</td>
              <td>{at == null ? "" : formatDateTime(new Date(at))}</td>
              <td>{by}</td>
              <td>{note}</td>
              <td>
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
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      {old !== undefined && compared !== null && (
        <DifferenceTable
          changes={changes}
          before={translate("definitionHistory.version", { compared })}
          after={translate("definitionHistory.version2", { version: definition.version })}
        />
      )}
    </section>
  );
}
