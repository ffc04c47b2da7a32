"""What is left of a flight: a table that grows while flying, and flying it again."""
