/** What went wrong, with the hint, until it is read. */

import { Button, CloseButton } from "@mantine/core";
import { IconAlertTriangleFilled, IconInfoCircleFilled } from "@tabler/icons-react";
import { useEdges } from "../state/queries";
import { useReports } from "../state/reports";
import { rowsOfHandles } from "../state/rows";
import { usePage } from "../state/store";
import { count } from "../state/words";
import css from "./panels.module.css";
import reportCss from "./reports.module.css";

export function ReportsList() {
  const list = useReports((reports) => reports.list);
  const dismiss = useReports((reports) => reports.dismiss);
  const look = usePage((page) => page.look);
  const { data: edges } = useEdges();
  return (
    <div className={reportCss.reports} role="alert" aria-live="assertive">
      {list.map(({ id, title, detail, hint, source, notice }) => {
        const rows = edges === undefined ? [] : rowsOfHandles(edges, source);
        return (
          <div key={id} className={reportCss.report} data-testid="report">
            {notice === true ? (
              <IconInfoCircleFilled size={18} color="var(--accent)" aria-hidden />
            ) : (
              <IconAlertTriangleFilled size={18} color="var(--bad)" aria-hidden />
            )}
            <div>
              <div style={{ color: "var(--ink-0)", fontWeight: 600 }}>{title}</div>
              <div>{detail}</div>
              {hint !== "" && <div className={css.hint}>{hint}</div>}
              {rows.length > 0 && (
                <Button mt={8} size="compact-xs" variant="default" onClick={() => look(rows)}>
                  Show {count(rows.length, "edge")}
                </Button>
              )}
            </div>
            <CloseButton size="sm" aria-label="Dismiss" onClick={() => dismiss(id)} />
          </div>
        );
      })}
    </div>
  );
}
