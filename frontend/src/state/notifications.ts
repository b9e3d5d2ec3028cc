/** Notifications: errors and events shown until dismissed. */

import { create } from "zustand";
import { type Problem, ServiceError } from "../api/errors";
import { translate } from "../language/translate";
import { messageHint, messageText } from "../messages/translateMessage";
import type { Concerned } from "./drawing/rows";

export interface Notification extends Concerned {
  readonly id: number;
  /** Code of the error, if the server reported it. */
  readonly code?: string;
  readonly title: string;
  readonly detail: string;
  readonly hint: string;
  /** Not an error. */
  readonly notice?: boolean;
}

interface Notifications {
  readonly list: readonly Notification[];
  add(notification: Omit<Notification, "id">): void;
  dismiss(id: number): void;
  /** Dismiss the notifications that report an error. */
  dismissError(code: string): void;
}

const MAX_SHOWN = 4;
let last = 0;

export const useNotifications = create<Notifications>()((set) => ({
  list: [],
  add: (notification) =>
    set(({ list }) => {
      // The same text is shown once.
      const others = list.filter(
        ({ title, detail }) => title !== notification.title || detail !== notification.detail,
      );
      return { list: [...others, { ...notification, id: ++last }].slice(-MAX_SHOWN) };
    }),
  dismiss: (id) => set(({ list }) => ({ list: list.filter((one) => one.id !== id) })),
  dismissError: (code) => set(({ list }) => ({ list: list.filter((one) => one.code !== code) })),
}));

/** Problems of the page have a title for users; that of the server names the type of the error. */
const fromProblem = (problem: Problem): Omit<Notification, "id"> => ({
  ...(problem.code === "stored.text"
    ? { title: problem.title, detail: messageText(problem) }
    : { title: messageText(problem) || problem.title, detail: "" }),
  code: problem.code,
  hint: messageHint(problem),
  source: problem.source,
  edges: problem.edges,
});

const fromPageError = (detail: string): Omit<Notification, "id"> => ({
  title: translate("notifications.errorInThisPage"),
  detail,
  hint: translate("notifications.reloadThePageAndRepeat"),
  source: [],
  edges: [],
});

export function notifyError(cause: unknown): void {
  const { add } = useNotifications.getState();
  if (cause instanceof ServiceError) add(fromProblem(cause.problem));
  else add(fromPageError(cause instanceof Error ? cause.message : String(cause)));
}
