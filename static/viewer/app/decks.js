/**
 * A file of several that came together.
 *
 * @typedef {{ path: string, text: () => Promise<string> }} Part `text`: what stands in it, or near its ends
 */

/** Whether a file may include others: an Abaqus deck. @param {string} path */
export const isDeck = (path) => /\.inp$/i.test(path);

/**
 * Those that may be shown: a deck that others include is a part of these.
 *
 * @template {Part} Some
 * @param {Some[]} files
 * @returns {Promise<Some[]>} as they came, without the parts
 */
export async function mainOf(files) {
  if (files.length < 2) return files;
  const included = new Set();
  for (const file of files)
    if (isDeck(file.path)) for (const name of includedBy(await file.text())) included.add(name);
  const main = files.filter(({ path }) => !included.has(lastOf(path)));
  return main.length ? main : files;
}

/** Last names, in small letters, of the files that a deck includes. @param {string} text */
export function includedBy(text) {
  const lines = text.matchAll(/^\*INCLUDE\s*,\s*INPUT\s*=\s*("[^"]*"|'[^']*'|[^,\r\n]*)/gim);
  return [...lines].map(([, name]) =>
    lastOf(
      name
        .trim()
        .replace(/^["']|["']$/g, "")
        .trim(),
    ),
  );
}

/** @param {string} path */
function lastOf(path) {
  return (path.split(/[\\/]/).pop() ?? path).toLowerCase();
}

/** Bytes at a deck's start and end in which its includes are looked for: a large mesh stands between them. */
const LOOKED_AT = 2 ** 20;

/** A file's text; of a large one its start and its end. @param {File} file */
export async function edgesOf(file) {
  try {
    if (file.size <= 2 * LOOKED_AT) return await file.text();
    return `${await file.slice(0, LOOKED_AT).text()}\n${await file.slice(-LOOKED_AT).text()}`;
  } catch {
    return ""; // that it can't be read is told when it is opened
  }
}
