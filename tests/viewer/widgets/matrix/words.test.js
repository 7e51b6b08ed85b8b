import assert from "node:assert/strict";
import { test } from "node:test";
import { meetingInWords } from "../../../../static/viewer/widgets/matrix/words.js";

const SHEETS = /** @type {const} */ (["sheet", "sheets"]);

for (const [one, other, crossings, beside, words] of /** @type {const} */ ([
  ["3", "17", 24, 12, "Sheets 3 and 17: cross 24 times, 12 faces side by side"],
  ["3", "17", 1, 0, "Sheets 3 and 17: cross once"],
  ["3", "17", 0, 1, "Sheets 3 and 17: 1 face side by side"],
  ["3", "17", 0, 0, "Sheets 3 and 17: do not meet"],
  ["3", "3", 12345, 0, "Sheet 3: crosses itself 12,345 times"],
  ["3", "3", 0, 2, "Sheet 3: 2 faces side by side"],
  ["3", "3", 0, 0, "Sheet 3: does not cross itself"],
]))
  test(`T4: ${words}`, () => {
    assert.equal(meetingInWords({ one, other, crossings, beside }, SHEETS), words);
  });
