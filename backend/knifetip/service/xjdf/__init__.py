"""Orders in XJDF and messages in XJMF."""
