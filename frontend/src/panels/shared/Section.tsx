/** A collapsible section of a side panel. */

import { Box, Flex } from "@mantine/core";
import { IconChevronDown } from "@tabler/icons-react";
import { type ReactNode, useId, useState } from "react";
import css from "./panels.module.css";

interface Props {
  id?: string;
  title: ReactNode;
  /** Shown at the right of the title. */
  aside?: ReactNode;
  open?: boolean;
  /** Less padding at the sides, for rows. */
  flush?: boolean;
  children: ReactNode;
}

export function Section({ id, title, aside, open = true, flush = false, children }: Props) {
  const [shown, setShown] = useState(open);
  const body = useId();
  return (
    <section className={css.section} id={id}>
      <button
        type="button"
        className={css.sectionHead}
        aria-expanded={shown}
        aria-controls={body}
        onClick={() => setShown(!shown)}
      >
        <Flex component="span" flex={1} align="center" gap={8} miw={0}>
          {title}
        </Flex>
        {aside}
        <IconChevronDown size={15} className={css.chevron} data-open={shown} aria-hidden />
      </button>
      {shown && (
        <Box id={body} px={flush ? 8 : 16} pb={flush ? 8 : 16}>
          {children}
        </Box>
      )}
    </section>
  );
}
