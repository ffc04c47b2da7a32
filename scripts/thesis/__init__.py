"""The thesis made again: what it measured and drew, computed here, side by side."""

import kitemj.cockpit  # noqa: F401  before any section imports pygame: it keeps that quiet
