/** Button at the end of a list that has more rows. */

import { Button } from "@mantine/core";
import { translate } from "../../language/translate";

interface Props {
  act: () => void;
  busy?: boolean;
  /** Number of rows not shown, if known. */
  left?: number;
}

export function ShowMore({ act, busy = false, left }: Props) {
  return (
    <Button
      fullWidth
      mt={4}
      size="xs"
      variant="subtle"
      color="gray"
      loading={busy}
      onClick={act}
      data-testid="show-more"
    >
      {left !== undefined
        ? translate("showMore.showMoreEntriesLeft", { left })
        : translate("showMore.showMoreEntries")}
    </Button>
  );
}
