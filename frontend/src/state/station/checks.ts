/** What a person checks at the table, one by one, before a job or its next copy starts. */

import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import type { Drawing } from "../../api/drawings";
import type { Confirmation, Job } from "../../api/jobs";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { formatSize } from "../format";
import { needsOperator } from "../job/jobs";
import { queries, useDrawing, useJob } from "../queries";
import { useWornTools } from "./wornTools";

export interface Check {
  /** Id of the check, as the confirmation states it. */
  readonly key: string;
  readonly title: string;
  /** More about it; empty for nothing. */
  readonly detail: string;
  /** Number of the station if a tool is checked; null otherwise. */
  readonly station: number | null;
  /** The tool is worn. */
  readonly warns: boolean;
}

type Tool = Confirmation["tools"][number];

/** A change of this text makes all ticks void: they were made for something else. */
export const checksKey = ({ id, copies_done, waiting_for, registration }: Job): string =>
  `${id} ${copies_done} ${waiting_for} ${JSON.stringify(registration?.measured ?? [])}`;

export const formatMetres = (length: number): string =>
  formatNumber(length, { maximumFractionDigits: length < 10 ? 1 : 0 });

function wearText({ used, life, warning }: Tool): string {
  if (used === null) return "";
  const worn =
    life === null
      ? translate("checks.itHasWorkedM", { used: formatMetres(used) })
      : translate("checks.itHasWorkedOfM", { used: formatMetres(used), life: formatMetres(life) });
  if (warning === "over") return translate("checks.itsLifeIsUsedUp", { worn });
  return warning === "near" ? translate("checks.changeItSoon", { worn }) : worn;
}

/** Size that a sheet without a size of its own must have at least; empty if it is not known. */
function needText({ sheet, rest_of_sheet }: Confirmation, drawing: Drawing | undefined): string {
  if (drawing === undefined || sheet !== null || rest_of_sheet) return "";
  const [left, bottom, right, top] = drawing.bounds;
  return translate("checks.theDrawingNeeds", { right: formatSize(right - left, top - bottom) });
}

/** The checks that the server asks for, with the wear of the tools. */
export function checksOf(asked: Confirmation, drawing: Drawing | undefined): readonly Check[] {
  return asked.checks.map(({ id, message, station }) => {
    const tool = asked.tools.find((one) => one.station === station);
    return {
      key: id,
      title: messageText(message),
      detail: id === "sheet" ? needText(asked, drawing) : tool === undefined ? "" : wearText(tool),
      station,
      warns: tool !== undefined && tool.warning !== "",
    };
  });
}

const NO_KEYS: ReadonlySet<string> = new Set();

/**
 * The checks of the open job, which of them the person has ticked (null: not known yet), and the
 * decision about worn tools.
 */
export function useChecks() {
  const { data: job } = useJob();
  const { data: drawing } = useDrawing();
  const [ticks, setTicks] = useState({ of: "", keys: NO_KEYS });
  const of = job === undefined ? "" : checksKey(job);
  const { data: asked } = useQuery({
    ...queries.confirmation(job?.id ?? "", of),
    enabled: job !== undefined && needsOperator(job),
  });
  const checks = asked === undefined ? null : checksOf(asked, drawing);
  const ticked = ticks.of === of ? ticks.keys : NO_KEYS;
  const tick = (changed: readonly string[]) => {
    const keys = new Set(ticked);
    for (const key of changed) if (!keys.delete(key)) keys.add(key);
    setTicks({ of, keys });
  };
  return { checks, ticked, tick, wornTools: useWornTools(asked, of) };
}
