"""The catalogue as one table: a row for each mesh, its columns and their meaning, its files."""
