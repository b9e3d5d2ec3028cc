"""Users, API keys, sign-in, rules of access and the audit log."""
