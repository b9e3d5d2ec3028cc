"""accounts: users, API keys, sessions and the audit log of a server (ADR 83)."""
