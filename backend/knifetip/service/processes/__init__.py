"""Worker processes: the pool, the tasks they execute, and the kernels they compile."""
