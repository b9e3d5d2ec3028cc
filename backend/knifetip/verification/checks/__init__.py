"""The checks that a program must pass, each with the findings it reports."""
