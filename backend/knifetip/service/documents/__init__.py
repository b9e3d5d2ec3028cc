"""Large answers, which are made once by a worker process and stored."""
