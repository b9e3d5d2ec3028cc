"""Changes of jobs, drawings, stations and the library as server-sent events."""
