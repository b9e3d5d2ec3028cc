"""The REST API: routes, access control, server-sent events, and the service in one process."""
