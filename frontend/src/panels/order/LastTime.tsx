/** Fill in the options of the last order of the customer on the board and the machine. */

import { Button, Group, Stack, Text } from "@mantine/core";
import { IconArrowBackUp, IconHistory } from "@tabler/icons-react";
import { useState } from "react";
import { translate } from "../../language/translate";
import { asLastTime, type LastTime as Decided, isSame } from "../../state/order/lastTime";
import { useDrawing, useLastJob } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { dateTimeText } from "../../state/times";
import { Note } from "../shared/parts";

export function LastTime() {
  const { data: drawing } = useDrawing();
  const machine = useUiStore((ui) => ui.machine);
  const board = useUiStore((ui) => ui.board);
  const customer = useUiStore((ui) => ui.details.customer) || (drawing?.customer ?? "");
  const corners = useUiStore((ui) => ui.corners);
  const lift = useUiStore((ui) => ui.lift);
  const options = useUiStore((ui) => ui.options);
  const set = useUiStore((ui) => ui.set);
  const [before, setBefore] = useState<Decided | null>(null);
  const wanted = machine !== null && board !== null;
  const conditions = { machine: machine ?? "", board: board ?? "", ...(customer && { customer }) };
  const { data: job } = useLastJob(conditions, wanted);
  if (!wanted || job == null || drawing === undefined) return null;
  const decided = asLastTime(job, drawing.id);
  const same = isSame(decided, { corners, lift, options });
  const from = translate("lastTime.from", {
    order: job.external_id || job.drawing_name,
    when: dateTimeText(job.created),
  });
  return (
    <Stack gap={4} data-testid="last-time">
      <Group gap={8} wrap="wrap">
        <Button
          size="xs"
          variant="default"
          leftSection={<IconHistory size={15} aria-hidden />}
          disabled={same}
          onClick={() => {
            setBefore({ corners, lift, options });
            set(decided);
          }}
          data-testid="as-last-time"
        >
          {translate("lastTime.asLastTime")}
        </Button>
        {before !== null && (
          <Button
            size="xs"
            variant="subtle"
            leftSection={<IconArrowBackUp size={15} aria-hidden />}
            onClick={() => {
              set(before);
              setBefore(null);
            }}
            data-testid="undo-last-time"
          >
            {translate("lastTime.undo")}
          </Button>
        )}
      </Group>
      <Note role="status">
        {same ? translate("lastTime.sameAs", { from }) : from}
        <Text span inherit style={{ overflowWrap: "anywhere" }}>
          {customer === ""
            ? ` ${translate("lastTime.anyCustomer")}`
            : ` ${translate("lastTime.ofCustomer", { customer })}`}
        </Text>
      </Note>
    </Stack>
  );
}
