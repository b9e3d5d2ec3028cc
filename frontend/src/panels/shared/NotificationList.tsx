/** Notifications of errors and events, each with its hint; they go by themselves, or when closed. */

import { Button, CloseButton } from "@mantine/core";
import { IconAlertTriangleFilled, IconInfoCircleFilled } from "@tabler/icons-react";
import { useEffect, useState } from "react";
import { translate } from "../../language/translate";
import { concernedRows } from "../../state/drawing/rows";
import { type Notification, useNotifications } from "../../state/notifications";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import notificationCss from "./notifications.module.css";
import { Hint } from "./parts";

/** Time for which a notification is shown (ms): enough to read it twice. */
const SHOWN = 15_000;

export function NotificationList() {
  const list = useNotifications((notifications) => notifications.list);
  return (
    <div className={notificationCss.reports} aria-live="assertive">
      {list.map((notification) => (
        <Report key={notification.id} notification={notification} />
      ))}
    </div>
  );
}

function Report({ notification }: { notification: Notification }) {
  const { id, title, detail, hint, notice } = notification;
  const dismiss = useNotifications((notifications) => notifications.dismiss);
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  const { data: edges } = useEdges();
  // It stays while the pointer is over it or something in it has the focus.
  const [kept, setKept] = useState(false);
  useEffect(() => {
    if (kept) return;
    const timer = setTimeout(() => dismiss(id), SHOWN);
    return () => clearTimeout(timer);
  }, [kept, id, dismiss]);
  const rows = edges === undefined ? [] : concernedRows(edges, notification);
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: it is only kept in view, nothing is done
    <div
      className={notificationCss.report}
      onPointerEnter={() => setKept(true)}
      onPointerLeave={() => setKept(false)}
      onFocus={() => setKept(true)}
      onBlur={() => setKept(false)}
      data-testid="report"
    >
      {notice === true ? (
        <IconInfoCircleFilled size={18} color="var(--accent)" aria-hidden />
      ) : (
        <IconAlertTriangleFilled size={18} color="var(--bad)" aria-hidden />
      )}
      <div>
        <div style={{ color: "var(--ink-0)", fontWeight: 600 }}>{title}</div>
        {detail !== "" && <div>{detail}</div>}
        {hint !== "" && <Hint>{hint}</Hint>}
        {rows.length > 0 && (
          <Button mt={8} size="compact-xs" variant="default" onClick={() => zoomToEdges(rows)}>
            {translate("notificationList.showEdgesInTheDrawing", { rows: rows.length })}
          </Button>
        )}
      </div>
      <CloseButton
        size="sm"
        aria-label={translate("notificationList.closeThisMessage")}
        onClick={() => dismiss(id)}
      />
    </div>
  );
}
