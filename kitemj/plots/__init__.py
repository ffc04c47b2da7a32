"""Figures of flights: read from any file that holds one, drawn for print."""
