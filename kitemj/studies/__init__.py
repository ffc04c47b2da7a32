"""Flights by the thousand: what is varied, who flies it, and the table that comes of it."""
