"""What a mesh fills, where that isn't the body of its model: such meshes are no rivals of those that fill it."""

DOMAINS = {
    "box": "the box around the body",
    "polycube": "the body's polycube",
}
"""Each by its id, as `domain` of source.yaml names it."""
