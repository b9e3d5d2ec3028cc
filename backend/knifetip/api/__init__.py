"""The REST API: routes, access control and server-sent events; and the service in one process."""
