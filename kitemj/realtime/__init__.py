"""A live flight kept in step with the wall clock, in a process of its own."""
