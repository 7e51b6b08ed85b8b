"""What a contributor runs: the check of a source, and the start of one."""
