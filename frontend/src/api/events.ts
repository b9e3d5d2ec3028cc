/**
 * Server-sent events with reconnection.
 *
 * EventSource reconnects after a dropped connection (and sends Last-Event-ID), but closes when the
 * server answers with an error, for example during a restart. A closed one is opened again after a
 * delay that doubles up to 30 s.
 */

export type ConnectionState = "connecting" | "open" | "broken";

/** The part of EventSource that is used here. */
export interface EventSourceLike {
  readyState: number;
  onopen: ((event: Event) => void) | null;
  onerror: ((event: Event) => void) | null;
  addEventListener(name: string, listener: (event: MessageEvent<string>) => void): void;
  close(): void;
}

interface Listener {
  /** `event` is the name of the event, `data` its parsed JSON. */
  onEvent: (event: string, data: unknown) => void;
  onConnection: (state: ConnectionState) => void;
}

const CLOSED = 2;
const SHORTEST_WAIT = 500;
const LONGEST_WAIT = 30_000;

/** Receive these events until the returned function is called. */
export function openEventStream(
  url: string,
  names: readonly string[],
  { onEvent, onConnection }: Listener,
  open: (url: string) => EventSourceLike = (address) =>
    new EventSource(address) as unknown as EventSourceLike,
): () => void {
  let source: EventSourceLike | null = null;
  let wait = SHORTEST_WAIT;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let ended = false;

  const connect = () => {
    if (ended) return;
    onConnection("connecting");
    const line = open(url);
    source = line;
    line.onopen = () => {
      wait = SHORTEST_WAIT;
      onConnection("open");
    };
    line.onerror = () => {
      onConnection("broken");
      if (line.readyState !== CLOSED || ended) return;
      line.close();
      timer = setTimeout(connect, wait);
      wait = Math.min(wait * 2, LONGEST_WAIT);
    };
    for (const name of names) {
      line.addEventListener(name, (event) => {
        let data: unknown;
        try {
          data = JSON.parse(event.data);
        } catch {
          // Keep-alive messages have no JSON.
          return;
        }
        onEvent(name, data);
      });
    }
  };

  connect();
  return () => {
    ended = true;
    clearTimeout(timer);
    source?.close();
  };
}
