"""What every reader of drawings shares: limits, the ledger in the making, the last step."""
