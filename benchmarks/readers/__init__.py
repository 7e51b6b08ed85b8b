"""What four programs read from the same files: hexalab beside VTK, meshio and gmsh."""
