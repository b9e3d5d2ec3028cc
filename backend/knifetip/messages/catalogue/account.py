"""account: messages about users, API keys and signing in."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "key.expired-at-once": entry(
        "The expiry of the key is in the past.",
        "Choose a time in the future, or leave the expiry out for a key that does not expire.",
    ),
    "key.incomplete": entry(
        "An API key must have a title and at least one scope.",
        "Enter a title that names the program that uses the key, and choose its scopes.",
    ),
    "key.limited": entry(
        "This API key is limited to the customer {customer}, but the answer to this request would "
        "contain the data of all customers.",
        "Use a key that is not limited to a customer.",
        customer="text",
    ),
    "key.other-customer": entry(
        "This API key is limited to the customer {customer} and cannot be used for {given!r}.",
        "Leave the customer out, or use a key for that customer.",
        customer="text",
        given="text",
    ),
    "key.other-machine": entry(
        "This API key is limited to {machines:or} and cannot be used for the machine {machine!r}.",
        "Choose another machine, or use a key for that machine.",
        machine="text",
        machines="texts",
    ),
    "key.revoked": entry(
        "The API key {id} was revoked.",
        "Create a new key.",
        id="text",
    ),
    "key.unlimited-scope": entry(
        "A key with the scope {scope} cannot be limited to a customer or to machines.",
        "Choose only scopes of {scopes:, }, or remove the limit.",
        scope="text",
        scopes="texts",
    ),
    "key.unknown": entry(
        "There is no API key with the id {id}.",
        "List the keys with `knifetip key list`.",
        id="text",
    ),
    "oidc.bad-role": entry(
        "The option --oidc-role {pair} is not valid.",
        "Write it as VALUE=ROLE, where ROLE is {roles:or}.",
        pair="text",
        roles="texts",
    ),
    "oidc.bad-token": entry(
        "The sign-in was refused, because the ID token of the provider is not valid: {reason}.",
        "Sign in again. If the error persists, ask an administrator to compare the issuer, the "
        "client id and the clocks of provider and server.",
        reason="text",
    ),
    "oidc.bad-url": entry(
        "{url} is not an https URL.",
        "Give a URL that begins with https://; http:// is permitted for this computer only.",
        url="text",
    ),
    "oidc.code-refused": entry(
        "The provider refused the authorization code of the sign-in: {reason}.",
        "Sign in again. If the error persists, ask an administrator to check the client id, the "
        "secret and the redirect URL of this server at the provider.",
        reason="text",
    ),
    "oidc.declined": entry(
        "The provider did not sign you in: {reason}.",
        "Sign in again, or ask the administrator of the provider whether you may use this server.",
        reason="text",
    ),
    "oidc.disabled": entry(
        "The user {name} is disabled.",
        "An administrator can enable the user with `knifetip user enable`.",
        name="text",
    ),
    "oidc.no-client": entry(
        "The client id of this server at the OpenID Connect provider is missing.",
        "Set it with --oidc-client-id.",
    ),
    "oidc.no-issuer": entry(
        "Options for OpenID Connect are set, but the provider is missing.",
        "Set the URL of the provider with --oidc-issuer.",
    ),
    "oidc.no-role": entry(
        "The user {name} has no role on this server.",
        "Ask the administrator of the provider for one of the roles or groups that the option "
        "--oidc-role of this server lists.",
        name="text",
    ),
    "oidc.no-roles": entry(
        "No value of the provider is mapped to a role, so no user could sign in.",
        "Set at least one --oidc-role VALUE=ROLE, for example shop-admins=admin.",
    ),
    "oidc.not-begun": entry(
        "This sign-in was not started in this browser, has expired, or is already finished.",
        "Sign in again. Cookies of this server must be permitted in the browser.",
    ),
    "oidc.not-installed": entry(
        "Sign-in by OpenID Connect needs authlib, which is not installed.",
        "Install it with `pip install 'knifetip[oidc]'`.",
    ),
    "oidc.unreachable": entry(
        "The provider {issuer} cannot be reached or sent an invalid answer.",
        "Try again in a minute. The log of the server contains the reason.",
        issuer="text",
    ),
    "oidc.used": entry(
        "This sign-in at the provider was already used.",
        "Sign in again.",
    ),
    "sign-in.slow-down": entry(
        "Too many attempts to sign in failed.",
        "Wait {seconds} s, then try again.",
        seconds="count",
    ),
    "sign-in.wrong": entry(
        "The name or the password is wrong.",
        "Check both. An administrator can set a new password.",
    ),
    "sign-in.wrong-code": entry(
        "This pairing code is wrong, has expired or was already used.",
        "Ask an administrator for a new code. Each code is for one device and expires after ten "
        "minutes.",
    ),
    "user.at-provider": entry(
        "The user {name} signs in at a provider and has no password on this server.",
        "Change the password at the provider.",
        name="text",
    ),
    "user.bad-name": entry(
        "{name} is not a valid name of a user.",
        "Use 1 to 64 letters, digits and . _ @ + -, and begin with a letter or a digit.",
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
        "A user cannot have the role {role}.",
        "Choose {roles:or}. Gateways use API keys instead of users.",
        role="text",
        roles="texts",
    ),
    "user.exists": entry(
        "A user with the name {name} already exists.",
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
    "user.password-blank": entry("the password consists only of blanks"),
    "user.password-common": entry("the password consists of words that many people use"),
    "user.password-name": entry("the password consists of the name of the user or of the program"),
    "user.password-repeated": entry("the password repeats a few characters"),
    "user.password-sequence": entry(
        "the characters of the password follow each other on the keyboard"
    ),
    "user.weak-password": entry(
        "The password is too easy to guess: {why}.",
        "Choose another one, for example four words that have nothing to do with each other.",
        why="message",
    ),
    "user.unknown": entry(
        "There is no user with the name {name}.",
        "List the users with `knifetip user list`.",
        name="text",
    ),
    "user.wrong-password": entry(
        "The current password is wrong.",
        "Enter the password with which you sign in.",
    ),
}
