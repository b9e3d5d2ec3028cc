"""Store and compile jobs: drawings, jobs, profiles, events, worker processes and transitions."""
