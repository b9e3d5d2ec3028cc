"""What a server and its gateways both use: states of jobs, operations of persons, reports."""
