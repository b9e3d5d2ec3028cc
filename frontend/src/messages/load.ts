/**
 * Sets the texts of the server's messages in the language of the page, and loads only these.
 * Views that the start page does without import it.
 */

import { type Language, language } from "../language/language";
import { type Loaded, setTexts } from "./translateMessage";

const LOAD: Readonly<Record<Language, () => Promise<Loaded>>> = {
  en: () => import("./en.gen"),
  de: () => import("./de.gen"),
};

// The view waits for the texts, so that it never shows a message in two languages.
setTexts(language, await LOAD[language]());
