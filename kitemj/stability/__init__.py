"""Where the kite stands, whether it stays there, and the cycles it flies by itself."""
