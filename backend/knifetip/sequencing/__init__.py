"""Put the tracks of a job into order, and plan the air moves between them."""
