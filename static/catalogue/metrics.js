import { decimal } from "./results.js";

/**
 * A list of metrics above a table, which names a CSV file in `data-metric` and the table in `data-table`: the columns with
 * `data-place` show the chosen metric's worst value and its mean, read from that file.
 *
 * @param {Document} page
 */
export function enableMetrics(page) {
  for (const choice of page.querySelectorAll("select[data-metric]")) {
    const table = page.getElementById(choice instanceof HTMLElement ? (choice.dataset.table ?? "") : "");
    if (choice instanceof HTMLSelectElement && table instanceof HTMLTableElement) follow(choice, table);
  }
}

/** @param {HTMLSelectElement} choice @param {HTMLTableElement} table */
function follow(choice, table) {
  /** @type {Promise<Record<string, string>[]> | undefined} */
  let loading;
  choice.addEventListener("change", async () => {
    loading ??= load(choice.dataset.metric ?? "");
    try {
      show(table, choice.selectedOptions[0], await loading);
      choice.setCustomValidity("");
    } catch (error) {
      loading = undefined;
      choice.setCustomValidity(
        `The numbers could not be read: ${error instanceof Error ? error.message : error}`,
      );
      choice.reportValidity();
    }
  });
}

/** @param {string} address */
async function load(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(String(answer.status));
  return records(await answer.text());
}

/** @param {HTMLTableElement} table @param {HTMLOptionElement} option @param {Record<string, string>[]} rows */
function show(table, option, rows) {
  const { symbol = "", better = "high" } = option.dataset;
  const high = better === "high";
  /** @type {[string, string, string][]} place, statistic, the word before the symbol */
  const columns = [
    ["worst", high ? "min" : "max", high ? "min" : "max"],
    ["mean", "mean", "mean"],
  ];
  const byMesh = new Map(rows.map((row) => [row.mesh, row]));
  for (const [place, statistic, word] of columns) {
    rename(
      table.querySelector(`th[data-place="${place}"]`),
      `${word} ${symbol}`,
      `${word} of ${option.text}`,
    );
    const cells = [...table.querySelectorAll(`td[data-place="${place}"]`)];
    const values = cells.map((cell) => {
      const mesh = cell.closest("tr")?.dataset.mesh ?? "";
      const text = byMesh.get(mesh)?.[`${option.value}.${statistic}`] ?? "";
      return text === "" ? null : Number(text);
    });
    const ranked = cells.map((cell) => cell.closest("tr")?.hasAttribute("data-ranked") ?? false);
    const rivals = values.filter((_, place) => ranked[place]).filter((value) => value !== null);
    const best = new Set(rivals).size > 1 ? (high ? Math.max(...rivals) : Math.min(...rivals)) : null;
    cells.forEach((cell, place) => {
      cell.textContent = decimal(values[place]);
      cell.classList.toggle("is-best", best !== null && values[place] === best && ranked[place]);
    });
  }
}

/** A column's head, whose text is in the button that sorts. @param {Element | null} head @param {string} text @param {string} title */
function rename(head, text, title) {
  if (!(head instanceof HTMLElement)) return;
  (head.querySelector("button") ?? head).textContent = text;
  head.title = title;
  head.removeAttribute("aria-sort");
}

/**
 * The rows of a CSV file by the names in its first line.
 *
 * @param {string} text
 * @returns {Record<string, string>[]}
 */
export function records(text) {
  const [heads, ...rows] = text.trimEnd().split("\n").map(fields);
  return rows.map((row) => Object.fromEntries(heads.map((head, place) => [head, row[place] ?? ""])));
}

/** The fields of a line; one in quotes may hold commas, and quotes twice. @param {string} line */
function fields(line) {
  return [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, plain]) =>
    quoted === undefined ? plain : quoted.replaceAll('""', '"'),
  );
}
