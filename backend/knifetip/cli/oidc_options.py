"""oidc_options: the options that name a provider of OpenID Connect."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from knifetip.api.oidc.settings import OidcSettings


@dataclass(frozen=True, slots=True)
class OidcOptions:
    """Options of the command ``knifetip serve`` for the sign-in by OpenID Connect."""

    oidc_issuer: Annotated[
        str,
        typer.Option(
            envvar="KNIFETIP_OIDC_ISSUER",
            help="URL of a provider of OpenID Connect at which users can sign in. Needs the extra "
            "`oidc`. Default: none.",
        ),
    ] = ""
    oidc_client_id: Annotated[
        str,
        typer.Option(envvar="KNIFETIP_OIDC_CLIENT_ID", help="Name of this server at the provider."),
    ] = ""
    oidc_client_secret_file: Annotated[
        Path | None,
        typer.Option(
            envvar="KNIFETIP_OIDC_CLIENT_SECRET_FILE",
            help="File that contains the secret of this server at the provider.",
        ),
    ] = None
    oidc_roles_claim: Annotated[
        str,
        typer.Option(
            envvar="KNIFETIP_OIDC_ROLES_CLAIM",
            help="Claim of the ID token that contains the roles or groups of a user; a.b for the "
            "member b of the claim a.",
        ),
    ] = "roles"
    oidc_role: Annotated[
        list[str] | None,
        typer.Option(
            envvar="KNIFETIP_OIDC_ROLE",
            help="VALUE=ROLE: users with this value in the claim have the role viewer, designer, "
            "operator or admin; may be repeated. Others cannot sign in.",
        ),
    ] = None
    oidc_title: Annotated[
        str,
        typer.Option(
            envvar="KNIFETIP_OIDC_TITLE",
            help="Name of the provider on the sign-in page. Default: its host name.",
        ),
    ] = ""
    public_url: Annotated[
        str,
        typer.Option(
            envvar="KNIFETIP_PUBLIC_URL",
            help="URL of this server for browsers, such as https://knifetip.example behind a "
            "proxy; the provider sends browsers back to it. Default: that of each request.",
        ),
    ] = ""

    def settings(self) -> OidcSettings | None:
        """Return the settings of the provider; None without one.

        Raises
        ------
        SettingsError
            An option is missing or malformed, or authlib is not installed.
        """
        from knifetip.api.oidc.settings import read_settings  # imported here: slow

        return read_settings(
            self.oidc_issuer,
            self.oidc_client_id,
            secret_file=self.oidc_client_secret_file,
            roles_claim=self.oidc_roles_claim,
            roles=self.oidc_role or (),
            title=self.oidc_title,
            public_url=self.public_url,
        )
