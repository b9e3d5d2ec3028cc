/** Form with which a user accepts what the tool cannot make as drawn. */

import { Button, Checkbox, TextInput } from "@mantine/core";
import { useState } from "react";
import type { Finding, Job } from "../api/client";
import { acceptShortfalls } from "../state/actions";
import { pluralize } from "../state/format";
import { useUiStore } from "../state/store";
import verdictCss from "./verdict.module.css";

/** What a shortfall means, by its kind; other kinds are shown as they are. */
const TITLES: Readonly<Record<string, string>> = {
  unreached: "cannot be reached by the tool",
  kerf: "become as wide as the tool",
  fold: "do not fold far enough",
  uncut: "cannot be made over their whole length",
  deviation: "differ from the drawn curve",
};
/** Key of the user's name in the local storage of the browser. */
const NAME = "knifetip.accepted-by";

export function AcceptForm({ job, findings }: { job: Job; findings: readonly Finding[] }) {
  const busy = useUiStore((ui) => ui.busy);
  const [left, setLeft] = useState<ReadonlySet<string>>(new Set());
  const [reason, setReason] = useState("");
  const [by, setBy] = useState(() => localStorage.getItem(NAME) ?? "");
  const open = findings.filter((finding) => finding.severity === "shortfall" && finding.refuses);
  const kinds = [...new Set(open.map((finding) => finding.kind))];
  const chosen = open.filter((finding) => !left.has(finding.kind));
  const isComplete = chosen.length > 0 && reason.trim() !== "" && by.trim() !== "";
  if (open.length === 0) return null;
  const toggle = (kind: string) => {
    const next = new Set(left);
    if (!next.delete(kind)) next.add(kind);
    setLeft(next);
  };
  const accept = () => {
    localStorage.setItem(NAME, by.trim());
    acceptShortfalls(job.id, {
      findings: chosen.map(({ edge, code }) => ({ edge, code })),
      reason: reason.trim(),
      by: by.trim(),
    });
  };
  return (
    <form
      className={verdictCss.accept}
      data-testid="accept-form"
      onSubmit={(event) => {
        event.preventDefault();
        if (isComplete) accept();
      }}
    >
      <p>The program is safe. You can accept these lines as they will be made:</p>
      {kinds.map((kind) => (
        <Checkbox
          key={kind}
          size="xs"
          checked={!left.has(kind)}
          onChange={() => toggle(kind)}
          label={`${pluralize(open.filter((finding) => finding.kind === kind).length, "line")} ${TITLES[kind] ?? kind}`}
        />
      ))}
      <TextInput
        size="xs"
        label="Reason"
        maxLength={500}
        value={reason}
        onChange={(event) => setReason(event.currentTarget.value)}
        data-testid="accept-reason"
      />
      <TextInput
        size="xs"
        label="Your name"
        maxLength={100}
        value={by}
        onChange={(event) => setBy(event.currentTarget.value)}
        data-testid="accept-by"
      />
      <Button
        type="submit"
        size="xs"
        variant="light"
        disabled={!isComplete || busy}
        data-testid="accept-shortfalls"
      >
        Accept {pluralize(chosen.length, "shortfall")}
      </Button>
    </form>
  );
}
