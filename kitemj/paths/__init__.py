"""Paths in the sky: closed curves on the sphere, how a kite glides on them, what they ask of it."""
