"""What a host that drives the viewer has its page do, in the page's own language."""

from __future__ import annotations

SHOW = """async ({ offered, beside, name, statuses, settle, open }) => {
  const { hexalab } = window;
  try {
    if (!settle) hexalab.rest();
    await hexalab.reset(); // of the settings of the picture before nothing stays
    if (open) await (offered ? hexalab.openOffered(offered) : hexalab.open(name));
    if (beside) await hexalab.compareOffered(beside); // then settings may name what comes out of that
    if (beside && !settle) hexalab.rest();
    await hexalab.identified();
    const rejections = [];
    for (const status of statuses) rejections.push(...(await hexalab.setStatus(status)));
    if (settle) await hexalab.settled();
    const apart = Boolean(hexalab.comparison()?.second) && hexalab.getStatus().figure.meshes === "apart";
    return { rejections, summary: hexalab.summary(), apart };
  } catch (error) {
    return { failed: error.message ?? String(error) };
  }
}"""
"""Opens a mesh, and what it is compared with, under settings."""

END = "() => window.hexalab.endComparison()"

BASE64 = """(bytes) => {
  let text = "";
  for (let at = 0; at < bytes.length; at += 32768)
    text += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return btoa(text);
}"""

PICTURE = f"""async ({{ format, size, which = "both" }}) => {{
  try {{
    const {{ hexalab }} = window;
    const picture = await (format ? hexalab.figure(format, size, which) : hexalab.screenshot(size));
    return {{ data: ({BASE64})(new Uint8Array(await picture.arrayBuffer())) }};
  }} catch (error) {{
    return {{ failed: error.message ?? String(error) }};
  }}
}}"""
"""Takes the picture of what is shown, or its figure in a format."""

PORTRAY = f"""async ({{ offered, how }}) => {{
  try {{
    window.hexalab.rest();
    const {{ measured, row, made }} = await window.hexalab.portray(offered, how);
    const line = Object.fromEntries(Object.entries(row).map(([name, value]) => [name, String(value)]));
    return {{ measured, line, made: made.map(({{ name, bytes }}) => [name, ({BASE64})(bytes)]) }};
  }} catch (error) {{
    return {{ failed: error.message ?? String(error) }};
  }}
}}"""
"""Draws and measures a mesh as the page's batch does."""
