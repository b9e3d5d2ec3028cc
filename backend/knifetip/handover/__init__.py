"""What leaves knifetip for paper and for other programs: job tickets and exported drawings."""
