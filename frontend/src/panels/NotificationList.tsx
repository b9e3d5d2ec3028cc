/** Notifications of errors and events, each with its hint, until dismissed. */

import { Button, CloseButton } from "@mantine/core";
import { IconAlertTriangleFilled, IconInfoCircleFilled } from "@tabler/icons-react";
import { pluralize } from "../state/format";
import { useNotifications } from "../state/notifications";
import { useEdges } from "../state/queries";
import { rowsOfHandles } from "../state/rows";
import { useUiStore } from "../state/store";
import notificationCss from "./notifications.module.css";
import css from "./panels.module.css";

export function NotificationList() {
  const list = useNotifications((notifications) => notifications.list);
  const dismiss = useNotifications((notifications) => notifications.dismiss);
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  const { data: edges } = useEdges();
  return (
    <div className={notificationCss.reports} role="alert" aria-live="assertive">
      {list.map(({ id, title, detail, hint, source, notice }) => {
        const rows = edges === undefined ? [] : rowsOfHandles(edges, source);
        return (
          <div key={id} className={notificationCss.report} data-testid="report">
            {notice === true ? (
              <IconInfoCircleFilled size={18} color="var(--accent)" aria-hidden />
            ) : (
              <IconAlertTriangleFilled size={18} color="var(--bad)" aria-hidden />
            )}
            <div>
              <div style={{ color: "var(--ink-0)", fontWeight: 600 }}>{title}</div>
              {detail !== "" && <div>{detail}</div>}
              {hint !== "" && <div className={css.hint}>{hint}</div>}
              {rows.length > 0 && (
                <Button
                  mt={8}
                  size="compact-xs"
                  variant="default"
                  onClick={() => zoomToEdges(rows)}
                >
                  Show {pluralize(rows.length, "edge")} in the drawing
                </Button>
              )}
            </div>
            <CloseButton size="sm" aria-label="Close this message" onClick={() => dismiss(id)} />
          </div>
        );
      })}
    </div>
  );
}
