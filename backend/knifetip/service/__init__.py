"""The service: orders, jobs, machines and accounts, by subject, with their REST API."""
