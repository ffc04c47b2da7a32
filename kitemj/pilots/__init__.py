"""Who steers, and what is told them: pilots, lessons, a course, how a flight met the ground."""
