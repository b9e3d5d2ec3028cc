"""Test pieces: wizards that measure a machine and a board; see ``knifetip.testpieces``."""
