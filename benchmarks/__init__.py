"""What `make bench` runs: the figures of the specification, native and in the browser."""
