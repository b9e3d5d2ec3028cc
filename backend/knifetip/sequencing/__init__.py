"""Sequencing: orders the tracks of a job and plans the air moves between them."""
