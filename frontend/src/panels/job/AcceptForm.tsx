/** Form with which a user accepts what the tool cannot make as drawn. */

import { Button, Checkbox, Flex, Text, TextInput } from "@mantine/core";
import { useState } from "react";
import type { EarlierExceptions, Finding, Job } from "../../api/jobs";
import { operatorName } from "../../api/operator";
import { translate } from "../../language/translate";
import { useOperator } from "../../state/accounts/operator";
import { acceptShortfalls } from "../../state/actions";
import { useEarlierExceptions } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { dateTimeText } from "../../state/times";
import css from "../shared/panels.module.css";

/** Texts of the shortfalls of a kind. */
const TEXTS = {
  unreached: "acceptForm.unreached",
  kerf: "acceptForm.kerf",
  fold: "acceptForm.fold",
  uncut: "acceptForm.uncut",
  beside: "acceptForm.beside",
  near: "acceptForm.near",
  deviation: "acceptForm.deviation",
} as const;

const isKnown = (kind: string): kind is keyof typeof TEXTS => Object.hasOwn(TEXTS, kind);

/** Greatest number of characters of a reason. */
const REASON_LENGTH = 500;

export function AcceptForm({ job, findings }: { job: Job; findings: readonly Finding[] }) {
  const busy = useUiStore((ui) => ui.busy);
  const [left, setLeft] = useState<ReadonlySet<string>>(new Set());
  const { data: earlier = null } = useEarlierExceptions(job.id);
  const [typed, setTyped] = useState<string | null>(null);
  const [by, setBy] = useState(operatorName);
  const open = findings.filter((finding) => finding.severity === "shortfall" && finding.refuses);
  const kinds = [...new Set(open.map((finding) => finding.kind))];
  const chosen = open.filter((finding) => !left.has(finding.kind));
  const reason = typed ?? (earlier === null ? "" : reasonOf(earlier));
  const isComplete = reason.trim() !== "" && by.trim() !== "";
  const again = new Set(earlier?.findings.map(keyOf));
  const same = open.filter((finding) => again.has(keyOf(finding)));
  const isSame = chosen.length === same.length && chosen.every((one) => again.has(keyOf(one)));
  if (open.length === 0) return null;
  const toggle = (kind: string) => {
    const next = new Set(left);
    if (!next.delete(kind)) next.add(kind);
    setLeft(next);
  };
  const accept = (findings: readonly Finding[]) => {
    if (!isComplete || findings.length === 0) return;
    useOperator.getState().keep(by);
    acceptShortfalls(job.id, {
      findings: findings.map(({ edge, code }) => ({ edge, code })),
      reason: reason.trim(),
      by: by.trim(),
    });
  };
  return (
    <Flex
      component="form"
      direction="column"
      gap={8}
      mt={14}
      pt={12}
      fz={12.5}
      className={css.divided}
      data-testid="accept-form"
      onSubmit={(event) => {
        event.preventDefault();
        accept(chosen);
      }}
    >
      <p>{translate("acceptForm.theProgramIsSafeYou")}</p>
      {earlier !== null && <Earlier exceptions={earlier} />}
      {kinds.map((kind) => (
        <Checkbox
          key={kind}
          size="xs"
          checked={!left.has(kind)}
          onChange={() => toggle(kind)}
          label={kindText(kind, open.filter((finding) => finding.kind === kind).length)}
        />
      ))}
      <TextInput
        size="xs"
        label={translate("acceptForm.reason")}
        maxLength={REASON_LENGTH}
        value={reason}
        onChange={(event) => setTyped(event.currentTarget.value)}
        data-testid="accept-reason"
      />
      <TextInput
        size="xs"
        label={translate("acceptForm.yourName")}
        maxLength={100}
        value={by}
        onChange={(event) => setBy(event.currentTarget.value)}
        data-testid="accept-by"
      />
      {same.length > 0 && !isSame && (
        <Button
          size="xs"
          variant="light"
          disabled={!isComplete || busy}
          onClick={() => accept(same)}
          data-testid="accept-same"
        >
          {translate("acceptForm.acceptTheSameShortfallsAs", { same: same.length })}
        </Button>
      )}
      <Button
        type="submit"
        size="xs"
        variant={isSame || same.length === 0 ? "light" : "default"}
        disabled={!isComplete || chosen.length === 0 || busy}
        data-testid="accept-shortfalls"
      >
        {isSame
          ? translate("acceptForm.acceptTheSameShortfallsAs", { same: chosen.length })
          : translate("acceptForm.acceptShortfalls", { chosen: chosen.length })}
      </Button>
    </Flex>
  );
}

/** What `count` shortfalls of a kind mean; a kind without a text is shown by its name. */
const kindText = (kind: string, count: number): string =>
  isKnown(kind)
    ? translate(TEXTS[kind], { count })
    : translate("acceptForm.other", { count, kind });

/** Who accepted which of the shortfalls for an earlier job of the same drawing. */
function Earlier({ exceptions }: { exceptions: EarlierExceptions }) {
  const names = [...new Set(exceptions.findings.map(({ acceptance }) => acceptance.by))];
  const time = dateTimeText(exceptions.created);
  return (
    <Text c="ink.3" data-testid="earlier-exceptions">
      {translate("acceptForm.acceptedOfTheseLinesFor", {
        names: names.join(", "),
        findings: exceptions.findings.length,
        time,
      })}
    </Text>
  );
}

const keyOf = ({ edge, code }: { edge: number; code: string }): string => `${edge} ${code}`;

/** Reasons given for an earlier job, cut to the greatest length of a reason. */
function reasonOf({ findings }: EarlierExceptions): string {
  const reasons = new Set(findings.map(({ acceptance }) => acceptance.reason));
  return [...reasons].join("; ").slice(0, REASON_LENGTH);
}
