import { enableCopying } from "./copying.js";
import { enableSorting } from "./sorting.js";
import { startSearch } from "./search.js";

enableCopying(document);
enableSorting(document);
const form = document.getElementById("search");
if (form instanceof HTMLFormElement) startSearch(form);
