"""People and pixels: sticks, pacing, pictures, film."""
