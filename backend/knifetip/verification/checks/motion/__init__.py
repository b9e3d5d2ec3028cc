"""Checks of moves: feeds, outputs, travel, rapids, zones and carriages."""
