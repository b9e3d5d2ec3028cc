"""The REST API: its routes, its access control and its server-sent events.

The module ``embedded`` runs the server, a gateway and a simulated machine in one process.
"""
