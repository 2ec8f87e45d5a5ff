"""Writes one HTML file with the pictures and tables of a study: python3 -m harmos.report."""
