"""Gateway driver of HPGL plotters and flat cutters."""
