/**
 * Language of the page: the one that the user has chosen, or else the first of the browser's
 * languages that the page has. It stays the same until the page is loaded again.
 */

export const LANGUAGES = { en: "English", de: "Deutsch" } as const;
export type Language = keyof typeof LANGUAGES;

const KEY = "knifetip.language";

const isLanguage = (word: string | null | undefined): word is Language =>
  word !== null && word !== undefined && Object.hasOwn(LANGUAGES, word);

/** The language of a tag such as "de-AT"; undefined if the page does not have it. */
const languageOfTag = (tag: string): Language | undefined => {
  const [language] = tag.toLowerCase().split("-");
  return isLanguage(language) ? language : undefined;
};

/** The language for a choice of the user and for the languages of a browser. */
export const chooseLanguage = (chosen: string | null, browser: readonly string[]): Language =>
  isLanguage(chosen)
    ? chosen
    : (browser.map(languageOfTag).find((language) => language !== undefined) ?? "en");

/** The form of the language that the browser asks for, such as "en-GB": dates differ. */
export const chooseLocale = (language: Language, browser: readonly string[]): string =>
  browser.find((tag) => languageOfTag(tag) === language) ?? language;

// Tests run without a page, and in English.
const isPage = typeof document !== "undefined";
const browserLanguages = isPage ? navigator.languages : [];

function rememberedLanguage(): string | null {
  try {
    return isPage ? localStorage.getItem(KEY) : null;
  } catch {
    // The browser does not let the page store anything.
    return null;
  }
}

export const language: Language = chooseLanguage(rememberedLanguage(), browserLanguages);
/** Locale of dates and times. */
export const locale: string = chooseLocale(language, browserLanguages);

/** Remember a language and show the page in it. */
export function changeLanguage(to: Language): void {
  localStorage.setItem(KEY, to);
  window.location.reload();
}
