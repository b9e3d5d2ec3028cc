"""The OpenAPI description of the REST API, with examples and errors."""
