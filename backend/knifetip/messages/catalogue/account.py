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
    "oidc.bad-role": entry(
        "{pair} maps no value of the provider to a role.",
        "Write VALUE=ROLE, with one of {roles:or} as role.",
        pair="text",
        roles="texts",
    ),
    "oidc.bad-token": entry(
        "The sign-in was refused because the token of the provider is wrong: {reason}.",
        "Sign in again. If this repeats, let an administrator compare issuer, client id and clocks "
        "of provider and server.",
        reason="text",
    ),
    "oidc.bad-url": entry(
        "{url} is not a URL of HTTPS.",
        "Give a URL that begins with https://; http:// is permitted for this computer only.",
        url="text",
    ),
    "oidc.code-refused": entry(
        "The provider has refused the sign-in: {reason}.",
        "Sign in again. If this repeats, let an administrator check client id, secret and redirect "
        "URL of this server at the provider.",
        reason="text",
    ),
    "oidc.declined": entry(
        "The provider has not signed you in: {reason}.",
        "Sign in again, or ask the administrator of the provider whether you may use this server.",
        reason="text",
    ),
    "oidc.disabled": entry(
        "The user {name} is disabled.",
        "An administrator can enable the user with `knifetip user enable`.",
        name="text",
    ),
    "oidc.no-client": entry(
        "The name of this server at the provider is missing.",
        "Give it with --oidc-client-id.",
    ),
    "oidc.no-issuer": entry(
        "There are options for OpenID Connect, but no provider.",
        "Give its URL with --oidc-issuer.",
    ),
    "oidc.no-role": entry(
        "{name} has no role at this server.",
        "Ask the administrator of the provider for one of the roles or groups that this server "
        "knows (--oidc-role).",
        name="text",
    ),
    "oidc.no-roles": entry(
        "No role of the provider is mapped, so that nobody could sign in.",
        "Give at least one --oidc-role VALUE=ROLE, such as shop-admins=admin.",
    ),
    "oidc.not-begun": entry(
        "This sign-in was not begun in this browser, is too old, or was finished already.",
        "Sign in again, and permit cookies of this server.",
    ),
    "oidc.not-installed": entry(
        "Sign-in by OpenID Connect needs authlib, which is not installed.",
        "Install it with `pip install 'knifetip[oidc]'`.",
    ),
    "oidc.unreachable": entry(
        "The provider {issuer} does not answer as it should.",
        "Try again in a minute; the log of the server has the reason.",
        issuer="text",
    ),
    "oidc.used": entry(
        "This sign-in was used already.",
        "Sign in again.",
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
    "user.at-provider": entry(
        "{name} signs in at a provider and has no password here.",
        "Change the password at the provider.",
        name="text",
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
