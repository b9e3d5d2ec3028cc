"""Tool compensation: compute the head's path from the tip's path, one engine per kind of tool."""
