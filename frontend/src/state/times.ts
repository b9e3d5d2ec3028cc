/** Times of the service (RFC 3339 in UTC), and the due times of orders. */
import { formatDateTime } from "../language/numbers";

/** Seconds since 1970 of a time of the service. */
export const secondsOf = (time: string): number => Date.parse(time) / 1000;

/** Time of the service for seconds since 1970. */
export const timeOf = (seconds: number): string => new Date(seconds * 1000).toISOString();

/** Date and time of day in the language of the browser. */
export const dateTimeText = (time: string): string =>
  formatDateTime(new Date(time), { dateStyle: "medium", timeStyle: "short" });

/** Value of an `<input type="datetime-local">`, in the time zone of the browser; "" for none. */
export function localInput(time: string | null): string {
  if (time === null) return "";
  const date = new Date(time);
  return new Date(date.getTime() - date.getTimezoneOffset() * 60_000).toISOString().slice(0, 16);
}

/** Time of the service for the value of an `<input type="datetime-local">`; null if it is empty. */
export const fromLocalInput = (value: string): string | null =>
  value === "" || Number.isNaN(Date.parse(value)) ? null : new Date(value).toISOString();
