"""What a person hears of a kite: wind in the lines, flutter of the cloth, a thud at the ground."""
