"""The world that a picture shows: kites, lines, pilot, ground and sky, seen by a camera."""
