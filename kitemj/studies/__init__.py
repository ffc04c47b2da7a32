"""Studies: what is varied, the processes that fly it, and the table of results."""
