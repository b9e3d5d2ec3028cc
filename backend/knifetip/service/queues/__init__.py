"""The queues of machines, as users see and change them."""
