/** What no file system takes in a name, or only some do. */
const UNSAFE = /[\\/:*?"<>|\u0000-\u001f]+/g;

/** A file's name without its ending, and without .gz behind that. @param {string} name */
export function stemOf(name) {
  return name.replace(/\.gz$/i, "").replace(/\.[^./]+$/, "");
}

/** The stem of a mesh's name, such that a file can be called by it. @param {string} name */
export function safeStem(name) {
  return (
    stemOf(name)
      .replace(UNSAFE, "-")
      .replace(/^\.+|[. ]+$/g, "") || "hexalab"
  );
}
