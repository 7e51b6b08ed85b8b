/**
 * Tables with `data-sortable` get a button in each column's head; a column with `data-fixed` doesn't.
 *
 * @param {ParentNode} page
 */
export function enableSorting(page) {
  for (const table of page.querySelectorAll("table[data-sortable]")) {
    for (const head of table.querySelectorAll("thead th:not([data-fixed])")) {
      const button = document.createElement("button");
      button.type = "button";
      button.append(...head.childNodes);
      button.addEventListener("click", () => sortBy(/** @type {HTMLTableElement} */ (table), head));
      head.append(button);
    }
  }
}

/**
 * @param {HTMLTableElement} table
 * @param {Element} head the column's head
 */
function sortBy(table, head) {
  const column = [...(head.parentElement?.children ?? [])].indexOf(head);
  const numeric = head.classList.contains("number");
  const down = head.getAttribute("aria-sort") === "ascending";
  for (const other of table.querySelectorAll("th[aria-sort]")) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const body = table.tBodies[0];
  const rows = [...body.rows].map((row) => ({ row, key: keyOf(row.cells[column], numeric) }));
  rows.sort((a, b) => compare(a.key, b.key, down));
  body.append(...rows.map(({ row }) => row));
}

/**
 * @param {HTMLTableCellElement} cell
 * @param {boolean} numeric whether its column holds numbers
 */
function keyOf(cell, numeric) {
  const text = (cell.textContent ?? "").trim();
  if (!numeric) return text === "–" ? null : text;
  const value = Number.parseFloat(
    text
      .replaceAll(",", "")
      .replaceAll("−", "-")
      .replace(/^[^\d-]+/, ""),
  );
  return Number.isNaN(value) ? null : value;
}

/**
 * What isn't known comes last, whichever way.
 *
 * @param {string | number | null} a
 * @param {string | number | null} b
 * @param {boolean} down
 */
export function compare(a, b, down) {
  if (a === null || b === null) return (a === null ? 1 : 0) - (b === null ? 1 : 0);
  const order =
    typeof a === "number" && typeof b === "number"
      ? a - b
      : String(a).localeCompare(String(b), "en", { numeric: true });
  return down ? -order : order;
}
