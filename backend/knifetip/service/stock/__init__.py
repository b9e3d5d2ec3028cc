"""Sheets in stock: whole sheets, rolls and stacks, and remnants of sheets that were used."""
