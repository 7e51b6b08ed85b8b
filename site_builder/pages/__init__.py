"""From a catalogue to HTML and to indexes for machines."""
