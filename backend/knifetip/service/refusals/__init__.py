"""Which requests are refused, and what their answers state."""
