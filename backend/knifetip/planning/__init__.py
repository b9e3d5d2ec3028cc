"""Plan the operations that make a dieline on a machine: their paths, depths and working order."""
