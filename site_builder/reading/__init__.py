"""From `repository/` on the disk to a catalogue, with every field checked."""

import sys

# jsonschema would compile a grammar of addresses, if Jupyter has brought one: 2 s before every command, for a check
# that no schema here asks for.
sys.modules.setdefault("rfc3987_syntax", None)  # type: ignore[arg-type]
