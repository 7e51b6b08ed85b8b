"""What the catalogue is made of: sources, meshes, their facts, what they are called, and what is wrong with them."""
