"""The subcommands of `kitemj`: each reads its words and calls one room."""
