"""Large values of drawings and jobs, in the database or beside it."""
