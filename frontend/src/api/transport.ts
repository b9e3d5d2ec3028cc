/** Sends requests: repeats those that a busy server refused, and raises `ServiceError`. */

import { language } from "../language/language";
import { noAnswer, parseProblem, ServiceError } from "./errors";

/**
 * Headers of each request. Pages of other origins cannot send the first one without a preflight
 * request; errors have texts in the language of the second, for views without a catalogue.
 */
export const OWN_PAGE = { "X-Knifetip": "page", "Accept-Language": language } as const;

/** Maximum number of attempts, and maximum delay between them (s). */
const MAX_ATTEMPTS = 6;
const MAX_DELAY = 30;

/** Delay (s) before a refused request is repeated; null: do not repeat it. */
export function retryAfter(status: number, header: string | null, attempt: number): number | null {
  const seconds = Number.parseInt(header ?? "", 10);
  if ((status !== 503 && status !== 429) || Number.isNaN(seconds) || attempt >= MAX_ATTEMPTS)
    return null;
  // A random part, so that pages refused together do not return together.
  return Math.min(Math.max(seconds, 1), MAX_DELAY) * (1 + Math.random() / 4);
}

const sleep = (seconds: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, seconds * 1000));

/** The session has ended: reloading leads to the sign-in page. */
const signIn = (): void => globalThis.location?.reload();

interface Attempt<T> {
  readonly ok: boolean;
  readonly status: number;
  readonly statusText: string;
  readonly retryAfter: string | null;
  readonly answer: T;
  readonly body: () => string | Promise<string>;
}

/**
 * Repeat a request while the server is busy, at most until it was sent `attempts` times; raises
 * `ServiceError` for every other refusal.
 */
async function withRetries<T>(
  request: () => Promise<Attempt<T>>,
  signal?: AbortSignal,
  attempts = MAX_ATTEMPTS,
) {
  for (let attempt = 1; ; attempt++) {
    const result = await request();
    if (result.ok) return result.answer;
    const delay = retryAfter(result.status, result.retryAfter, attempt);
    if (delay === null || attempt >= attempts) {
      if (result.status === 401) signIn();
      throw new ServiceError(parseProblem(result.status, result.statusText, await result.body()));
    }
    await sleep(delay);
    signal?.throwIfAborted();
  }
}

async function attemptFetch(request: Request): Promise<Attempt<Response>> {
  let answer: Response;
  try {
    answer = await globalThis.fetch(request.clone());
  } catch (cause) {
    if (cause instanceof DOMException && cause.name === "AbortError") throw cause;
    throw noAnswer();
  }
  const { ok, status, statusText, headers } = answer;
  const body = () => answer.text();
  return { ok, status, statusText, retryAfter: headers.get("Retry-After"), answer, body };
}

/** `fetch` with retries and `ServiceError`. */
export const fetchWithRetries = (request: Request): Promise<Response> =>
  withRetries(() => attemptFetch(request), request.signal);

/** `fetch` with `ServiceError`, sent once: a repeated request would arrive late. */
export const fetchOnce = (request: Request): Promise<Response> =>
  withRetries(() => attemptFetch(request), request.signal, 1);

function attemptUpload(
  file: File,
  onProgress: (fraction: number) => void,
): Promise<Attempt<string>> {
  // Unlike fetch, XMLHttpRequest reports the progress of an upload.
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.open("POST", "/api/v1/drawings");
    for (const [name, value] of Object.entries(OWN_PAGE)) request.setRequestHeader(name, value);
    request.upload.onprogress = (event) => {
      if (event.lengthComputable) onProgress(event.loaded / event.total);
    };
    request.onerror = () => reject(noAnswer());
    request.onload = () => {
      const { status, statusText, responseText } = request;
      resolve({
        ok: status >= 200 && status < 300,
        status,
        statusText,
        retryAfter: request.getResponseHeader("Retry-After"),
        answer: responseText,
        body: () => responseText,
      });
    };
    const form = new FormData();
    form.append("file", file, file.name);
    request.send(form);
  });
}

/** Upload a drawing; `onProgress` receives the fraction that was sent (0 … 1). */
export const upload = (file: File, onProgress: (fraction: number) => void): Promise<string> =>
  withRetries(() => attemptUpload(file, onProgress));
