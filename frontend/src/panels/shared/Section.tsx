/** A collapsible section of a side panel. */

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
        <span className={css.sectionTitle}>{title}</span>
        {aside}
        <IconChevronDown size={15} className={css.chevron} data-open={shown} aria-hidden />
      </button>
      {shown && (
        <div id={body} className={flush ? css.flush : css.sectionBody}>
          {children}
        </div>
      )}
    </section>
  );
}
