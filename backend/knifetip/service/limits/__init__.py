"""What a server accepts at a time: sizes, connections, requests and waiting tasks."""
