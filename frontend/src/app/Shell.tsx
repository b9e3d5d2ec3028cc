/** Frame of all pages: the page, the rail with the other places, and messages above both. */

import type { ReactNode } from "react";
import { useLocation } from "wouter";
import { translate } from "../language/translate";
import { OperatorDialog } from "../panels/accounts/OperatorForm";
import { PreparationBanner } from "../panels/drawing/PreparationBanner";
import { NotificationList } from "../panels/shared/NotificationList";
import { ProgressOverlay } from "../panels/shared/ProgressOverlay";
import { useSchemeColours } from "../panels/shared/scheme";
import { useMe } from "../state/accounts/accounts";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { DropZone } from "./DropZone";
import { PaletteHost } from "./PaletteHost";
import { Rail } from "./Rail";

export function Shell({ children }: { children: ReactNode }) {
  useSchemeColours();
  const lost = useUiStore((ui) => ui.connection === "broken");
  // A device at a machine shows the page of its station only.
  const [path] = useLocation();
  // The library takes files of its own, and a person at a machine opens no drawings.
  const takesDrawings = !/^\/(library|station)/.test(path);
  const paired = useMe()?.kind === "device";
  return (
    <div className={css.shell} data-bare={paired}>
      <div className={css.place}>
        {lost && (
          <p className={css.lost} role="status" data-testid="server-lost">
            {translate("shell.theServerDoesNotRespond")}
          </p>
        )}
        <PreparationBanner />
        {children}
      </div>
      {!paired && <Rail />}
      <section className={css.messages} aria-label={translate("shell.messages")}>
        <ProgressOverlay />
        <NotificationList />
      </section>
      <PaletteHost />
      <OperatorDialog />
      {takesDrawings && <DropZone />}
    </div>
  );
}
