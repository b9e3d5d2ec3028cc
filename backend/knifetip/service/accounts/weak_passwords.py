"""weak_passwords: find passwords that are guessed first (NIST SP 800-63B, section 5.1.1.2).

A password is weak if it consists of words that many people use, of the name of the user or of the
product, of one short piece that is repeated, or of neighbours in the alphabet, in the digits or on
a keyboard.  Digits and signs around and between such words, and signs in the place of letters
(``P4$$word``), do not make it better.
"""

from __future__ import annotations

import re
from typing import Final, Literal

Weakness = Literal["blank", "repeated", "sequence", "common", "name"]

#: Words of which common passwords consist, in small letters.
_WORDS: Final = frozenset(
    [
        "pass",
        "password",
        "passwords",
        "passwort",
        "passwd",
        "passcode",
        "passphrase",
        "pw",
        "pwd",
        "kennwort",
        "secret",
        "geheim",
        "admin",
        "administrator",
        "root",
        "user",
        "username",
        "guest",
        "test",
        "testing",
        "tester",
        "demo",
        "default",
        "changeme",
        "change",
        "me",
        "letmein",
        "let",
        "me",
        "in",
        "welcome",
        "willkommen",
        "hello",
        "hallo",
        "login",
        "logon",
        "signin",
        "master",
        "superman",
        "batman",
        "iloveyou",
        "i",
        "love",
        "you",
        "loveyou",
        "mylove",
        "sunshine",
        "princess",
        "prinzessin",
        "dragon",
        "monkey",
        "shadow",
        "football",
        "fussball",
        "baseball",
        "basketball",
        "hockey",
        "soccer",
        "michael",
        "jordan",
        "jennifer",
        "thomas",
        "daniel",
        "jessica",
        "charlie",
        "ashley",
        "andrew",
        "matthew",
        "joshua",
        "george",
        "summer",
        "winter",
        "spring",
        "autumn",
        "sommer",
        "herbst",
        "fruehling",
        "monday",
        "tuesday",
        "wednesday",
        "thursday",
        "friday",
        "saturday",
        "sunday",
        "january",
        "february",
        "march",
        "april",
        "may",
        "june",
        "july",
        "august",
        "september",
        "october",
        "november",
        "december",
        "computer",
        "internet",
        "server",
        "service",
        "office",
        "company",
        "firma",
        "trustno",
        "trust",
        "no",
        "one",
        "whatever",
        "freedom",
        "starwars",
        "star",
        "wars",
        "pokemon",
        "killer",
        "hunter",
        "ranger",
        "qwerty",
        "qwertz",
        "azerty",
        "qwertyuiop",
        "asdf",
        "asdfgh",
        "asdfghjkl",
        "zxcvbn",
        "zxcvbnm",
        "yxcvbn",
        "yxcvbnm",
        "abc",
        "abcd",
        "new",
        "old",
        "my",
        "the",
        "this",
        "is",
        "is",
        "it",
        "please",
        "bitte",
        "mein",
        "meine",
        "sicher",
        "security",
        "safe",
        "god",
        "money",
        "carton",
        "cutter",
        "table",
    ]
)
_LONGEST_WORD: Final = max(map(len, _WORDS))
#: Letters that signs and digits stand for.
_SIGNS: Final = str.maketrans(
    {
        "@": "a",
        "4": "a",
        "3": "e",
        "1": "i",
        "!": "i",
        "0": "o",
        "$": "s",
        "5": "s",
        "7": "t",
        "|": "l",
    }
)
_ROWS: Final = (
    "abcdefghijklmnopqrstuvwxyz",
    "01234567890",
    "qwertyuiop",
    "qwertzuiopü",
    "asdfghjklöä",
    "zxcvbnm",
    "yxcvbnm",
    "azertyuiop",
    "qsdfghjklm",
    "1qaz2wsx3edc4rfv5tgb6yhn7ujm8ik9ol0p",
    "1q2w3e4r5t6z7u8i9o0p",
    "1q2w3e4r5t6y7u8i9o0p",
)
_PRODUCT: Final = "knifetip"
_ENDS: Final = re.compile(r"^[^a-z]+|[^a-z]+$")
_SHORTEST_PART: Final = 3  #: letters of a name that count


def weakness_of(password: str, name: str = "") -> Weakness | None:
    """Return why a password is guessed easily; None if none of the reasons applies."""
    if not password.strip():
        return "blank"
    text = password.casefold()
    if _is_repeated(text):
        return "repeated"
    if _is_sequence(text):
        return "sequence"
    # Digits at the ends are a year or a count more often than letters.
    inner = _ENDS.sub("", text)
    spellings = {_letters(one) for one in (text, text.translate(_SIGNS), inner.translate(_SIGNS))}
    if any(_consists_of(one, _WORDS) for one in spellings):
        return "common"
    parts = {part for part in re.split(r"[^a-z0-9]+", name.casefold()) if part}
    own = {_PRODUCT, _letters(name.casefold()), *map(_letters, parts)}
    own = {one for one in own if len(one) >= _SHORTEST_PART}
    if any(_consists_of(one, _WORDS | own) for one in spellings):
        return "name"
    return None


def _letters(text: str) -> str:
    return "".join(letter for letter in text if letter.isalpha())


def _is_repeated(text: str) -> bool:
    """Return whether a text has at most two different characters, or repeats one short piece."""
    if len(set(text)) <= 2:
        return True
    sizes = range(1, min(len(text) // 2, 6) + 1)
    return any(text == (text[:size] * len(text))[: len(text)] for size in sizes)


def _is_sequence(text: str) -> bool:
    """Return whether a text consists of runs of at least three neighbours in a row of keys."""
    place = 0
    while place < len(text):
        longest = max(_run(text[place:], row) for row in (*_ROWS, *(row[::-1] for row in _ROWS)))
        if longest < _SHORTEST_PART:
            return False
        place += longest
    return True


def _run(text: str, row: str) -> int:
    """Return the number of characters at the start of a text that follow each other in a row."""
    start = row.find(text[0])
    if start < 0:
        return 0
    count = 0
    while count < len(text) and start + count < len(row) and row[start + count] == text[count]:
        count += 1
    return count


def _consists_of(text: str, words: frozenset[str]) -> bool:
    """Return whether a text of at least one letter is made of words, one after the other."""
    longest = max(_LONGEST_WORD, max(map(len, words), default=0))
    reached = {0}
    for end in range(1, len(text) + 1):
        starts = range(max(0, end - longest), end)
        if any(start in reached and text[start:end] in words for start in starts):
            reached.add(end)
    return bool(text) and len(text) in reached
