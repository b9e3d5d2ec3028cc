"""Common parts of routes: scopes, parameters, conditional requests, problems."""
