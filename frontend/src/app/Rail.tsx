/** The rail: links to the places of the page; below the page on a phone. */

import { Indicator, VisuallyHidden } from "@mantine/core";
import {
  IconBooks,
  IconCommand,
  IconHistory,
  IconLayoutList,
  IconSettings,
  IconTool,
  IconVector,
  IconWashMachine,
} from "@tabler/icons-react";
import type { ReactNode } from "react";
import { useLocation } from "wouter";
import { translate } from "../language/translate";
import { AccountButton } from "../panels/accounts/AccountButton";
import { usePaletteRequests } from "../state/commands/paletteRequests";
import { useMachineState } from "../state/job/useMachineState";
import { drawingPath, WORK_TABLE } from "../state/routes";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { Logo } from "./Logo";

export function Rail() {
  const [path] = useLocation();
  const drawing = useUiStore((ui) => ui.drawing);
  const drawn = useUiStore(drawingPath);
  return (
    <nav className={css.rail} aria-label={translate("rail.places")}>
      <span className={css.brand}>
        <Logo size={26} />
      </span>
      <Place href="/" at={WORK_TABLE.test(path)} label={translate("rail.work")} testId="to-work">
        <IconLayoutList />
      </Place>
      <Place
        href={drawn}
        at={path.startsWith("/drawings/")}
        label={translate("rail.drawing")}
        off={drawing === null ? translate("rail.openADrawingFirst") : null}
        testId="to-drawing"
      >
        <IconVector />
      </Place>
      <Machines at={path.startsWith("/machines")} />
      <Place
        href="/station"
        at={path.startsWith("/station")}
        label={translate("rail.station")}
        testId="to-stations"
      >
        <IconTool />
      </Place>
      <Place
        href="/library"
        at={path.startsWith("/library")}
        label={translate("rail.library")}
        testId="open-library"
      >
        <IconBooks />
      </Place>
      <Place
        href="/history"
        at={path.startsWith("/history")}
        label={translate("rail.history")}
        testId="history-button"
      >
        <IconHistory />
      </Place>
      <span className={css.gap} />
      <button
        type="button"
        className={`${css.railPlace} ${css.palette}`}
        title={translate("palette.openKey")}
        onClick={() => usePaletteRequests.getState().request()}
        data-testid="open-palette"
      >
        <IconCommand />
        <span>{translate("palette.commands")}</span>
      </button>
      <AccountButton className={`${css.railPlace} ${css.account}`} />
      <Place
        href="/settings"
        at={path.startsWith("/settings") || path === "/webhooks"}
        label={translate("rail.settings")}
        testId="open-settings"
      >
        <IconSettings />
      </Place>
    </nav>
  );
}

/** The link to the machines, with the state of the one on which jobs are made. */
function Machines({ at }: { at: boolean }) {
  const { text, colour, word } = useMachineState();
  return (
    <>
      <Place
        href="/machines"
        at={at}
        label={translate("rail.machines")}
        hint={text}
        testId="to-machines"
      >
        <Indicator lh={0} color={colour} size={9} offset={2} withBorder disabled={word === ""}>
          <IconWashMachine />
        </Indicator>
      </Place>
      <VisuallyHidden role="status" data-testid="machine-status">
        {text}
      </VisuallyHidden>
    </>
  );
}

interface PlaceProps {
  readonly href: string;
  readonly at: boolean;
  readonly label: string;
  /** More about the place. */
  readonly hint?: string;
  /** Why there is nothing at this place; null if there is. */
  readonly off?: string | null;
  readonly testId: string;
  readonly children: ReactNode;
}

function Place({ href, at, label, hint, off = null, testId, children }: PlaceProps) {
  const shown = (
    <>
      {children}
      <span>{label}</span>
    </>
  );
  if (off !== null)
    return (
      <span className={css.railPlace} title={off} data-off data-testid={testId}>
        {shown}
      </span>
    );
  return (
    <a
      className={css.railPlace}
      href={`#${href}`}
      title={hint}
      aria-current={at ? "page" : undefined}
      data-testid={testId}
    >
      {shown}
    </a>
  );
}
