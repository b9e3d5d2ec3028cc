/** What the person at the table checks before a start, in rows that are signed with one touch each. */

import { Flex, Stack, Text } from "@mantine/core";
import { IconCheck, IconMinus } from "@tabler/icons-react";
import type { Machine } from "../../api/machines";
import { translate } from "../../language/translate";
import { type CheckGroup, groupChecks, touched } from "../../state/station/checkGroups";
import type { Check } from "../../state/station/checks";
import { HANDS, type HandsClear } from "../../state/station/handsClear";
import { ControlGroup } from "./parts";
import css from "./station.module.css";
import { ToolPicture } from "./ToolPicture";

interface Props {
  readonly machine: Machine;
  readonly checks: readonly Check[];
  readonly ticked: ReadonlySet<string>;
  readonly hands: HandsClear;
  onTick(keys: readonly string[]): void;
}

export function StationChecks(props: Props) {
  const groups = groupChecks(props.checks);
  const signed = groups.filter((group) => isSigned(group, props.ticked));
  return (
    <ControlGroup
      data-testid="checks"
      legend={translate("stationChecks.checkAtTheTableThen", {
        signed: signed.length,
        groups: groups.length,
      })}
    >
      <Stack gap={8}>
        {groups.map((group) => (
          <Row key={group.key} {...props} group={group} />
        ))}
      </Stack>
    </ControlGroup>
  );
}

const isSigned = ({ checks }: CheckGroup, ticked: ReadonlySet<string>): boolean =>
  checks.every(({ key }) => ticked.has(key));

interface RowProps extends Props {
  readonly group: CheckGroup;
}

function Row({ group, machine, ticked, hands, onTick }: RowProps) {
  const { key, title, checks } = group;
  const signed = isSigned(group, ticked);
  const partly = !signed && checks.some((check) => ticked.has(check.key));
  return (
    <label
      className={css.check}
      data-warns={checks.some(({ warns }) => warns)}
      data-testid="check"
      data-check={key}
    >
      <input
        type="checkbox"
        checked={signed}
        ref={(box) => {
          if (box !== null) box.indeterminate = partly;
        }}
        onChange={() => onTick(touched(group, ticked))}
      />
      <span className={css.box} data-partly={partly} aria-hidden>
        {partly ? <IconMinus /> : <IconCheck />}
      </span>
      <Flex component="span" direction="column" gap={6} flex={1} miw={0}>
        {title !== "" && (
          <Text span c="ink.2" fz={15} fw={600}>
            {title}
          </Text>
        )}
        {checks.map((check) => (
          <Statement
            key={check.key}
            check={check}
            ticked={ticked.has(check.key)}
            machine={machine}
            detail={check.key === HANDS ? lastsText(hands) : check.detail}
          />
        ))}
      </Flex>
    </label>
  );
}

const lastsText = ({ left }: HandsClear): string =>
  left > 0
    ? translate("stationChecks.countsForSMore", { left })
    : translate("stationChecks.countsFor60S");

interface StatementProps {
  readonly check: Check;
  readonly ticked: boolean;
  readonly machine: Machine;
  readonly detail: string;
}

function Statement({ check, ticked, machine, detail }: StatementProps) {
  const mounted = machine.stations.find(({ number }) => number === check.station);
  return (
    <Flex
      component="span"
      align="center"
      wrap="wrap"
      gap={10}
      data-statement={check.key}
      data-ticked={ticked}
    >
      {mounted !== undefined && <ToolPicture kind={mounted.tool.kind} />}
      <span>
        <b>{check.title}</b>
        {detail !== "" && <small>{detail}</small>}
      </span>
    </Flex>
  );
}
