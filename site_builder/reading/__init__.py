"""From `repository/` on the disk to a catalogue, with every field checked."""
