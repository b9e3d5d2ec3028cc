"""oidc: sign-in of users at a provider by OpenID Connect (ADR 91)."""
