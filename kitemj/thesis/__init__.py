"""The thesis made again: what it measured and drew, computed here, side by side."""
