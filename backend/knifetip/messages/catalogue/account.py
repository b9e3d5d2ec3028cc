"""account: messages about users, API keys and signing in."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "key.expired-at-once": entry(
        "The key would already be expired.",
        "Choose a time in the future, or no time for a key that does not expire.",
    ),
    "key.incomplete": entry(
        "A key needs a title and at least one scope.",
        "Write in the title what uses the key, and choose its scopes.",
    ),
    "key.unknown": entry(
        "There is no API key with the id {id}.",
        "List the keys with `knifetip key list`.",
        id="text",
    ),
    "sign-in.slow-down": entry(
        "Too many sign-ins failed for this name.",
        "Wait {seconds} s, then try again.",
        seconds="count",
    ),
    "sign-in.wrong": entry(
        "The name or the password is wrong.",
        "Check both; an administrator can set a new password.",
    ),
    "user.bad-name": entry(
        "{name} is not permitted as the name of a user.",
        "Use 1 to 64 letters, digits and . _ @ + -, with a letter or a digit first.",
        name="text",
    ),
    "user.bad-password": entry(
        "The password has {length} characters, but must have {shortest} to {longest}.",
        "Choose a longer password, for example four words.",
        length="count",
        shortest="count",
        longest="count",
    ),
    "user.bad-role": entry(
        "{role} is not a role of users.",
        "Choose one of {roles:or}; gateways use API keys.",
        role="text",
        roles="texts",
    ),
    "user.exists": entry(
        "There is already a user with the name {name}.",
        "Choose another name, or change that user.",
        name="text",
    ),
    "user.last-admin": entry(
        "{name} is the last active administrator.",
        "Make another user an administrator first.",
        name="text",
    ),
    "user.not-signed-in": entry(
        "Only a user who has signed in with a password can change it.",
        "Sign in with name and password.",
    ),
    "user.unknown": entry(
        "There is no user with the name {name}.",
        "List the users with `knifetip user list`.",
        name="text",
    ),
    "user.wrong-password": entry(
        "The present password is wrong.",
        "Enter the password with which you sign in.",
    ),
}
