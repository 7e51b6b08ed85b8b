"""Citations: read from BibTeX, put into words, written for other programs."""
