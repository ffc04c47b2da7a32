"""The report on the source thesis: what it measured and drew, computed again with kitemj."""

import kitemj.cockpit  # noqa: F401  before any section imports pygame: it keeps that quiet
