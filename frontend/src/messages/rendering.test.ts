/** The page renders every message as the server does: `tests/unit/messages/test_page.py` runs this. */

import { readFileSync } from "node:fs";
import { afterEach, expect, test } from "vitest";
import * as german from "./de.gen";
import * as english from "./en.gen";
import { messageHint, messageText, type ServerMessage, setTexts } from "./translateMessage";

interface Sample {
  readonly message: ServerMessage;
  readonly text: string;
  readonly hint: string;
}

const LANGUAGES = { en: english, de: german };
const file = process.env.KNIFETIP_MESSAGES;

afterEach(() => setTexts("en", english));

test.skipIf(file === undefined).each(["en", "de"] as const)(
  "messages are rendered as the server renders them in %s",
  (language) => {
    const samples: Readonly<Record<string, Sample[]>> = JSON.parse(
      readFileSync(file ?? "", "utf8"),
    );
    setTexts(language, LANGUAGES[language]);
    const ofLanguage = samples[language] ?? [];
    expect(ofLanguage.length).toBeGreaterThan(1000);
    const wrong = ofLanguage
      .map(({ message, text, hint }) => ({
        ...{ code: message.code, text, page: messageText(message) },
        ...{ hint, pageHint: messageHint(message) },
      }))
      .filter(({ text, page, hint, pageHint }) => page !== text || pageHint !== hint);
    expect(wrong).toEqual([]);
  },
);
