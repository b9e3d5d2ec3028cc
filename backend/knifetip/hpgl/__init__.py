"""Import of plotter files (HPGL and HP-GL/2)."""
