"""The site builder: YAML and meshes in, static pages out."""
