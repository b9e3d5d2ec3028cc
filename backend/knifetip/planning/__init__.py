"""Plan the operations that make a dieline on a machine: paths, depths and working order."""
