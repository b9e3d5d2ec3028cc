"""The database: its connection, tables and migrations, and whose changes it records."""
