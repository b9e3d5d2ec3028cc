"""Storage of drawings, jobs, profiles and events; transitions and compiles of jobs."""
