import { Registration } from "../offline/registration.js";
import { enableCopying } from "./copying.js";
import { enableEmbedding } from "./embedding.js";
import { enableKeeping } from "./keeping.js";
import { passLaunches } from "./launches.js";
import { enableMetrics } from "./metrics.js";
import { enableSorting } from "./sorting.js";
import { startSearch } from "./search.js";

const root = new URL(document.body.dataset.root || "./", location.href);
enableCopying(document);
enableSorting(document);
enableMetrics(document);
enableEmbedding(document);
enableKeeping(document, root);
passLaunches(root);
const form = document.getElementById("search");
if (form instanceof HTMLFormElement) startSearch(form);

// Once the page stands: what is kept for later takes nothing from what is wanted now.
addEventListener("load", () => void new Registration(root).start());
