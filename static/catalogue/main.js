import { Registration } from "../offline/registration.js";
import { enableCopying } from "./copying.js";
import { enableSorting } from "./sorting.js";
import { startSearch } from "./search.js";

enableCopying(document);
enableSorting(document);
const form = document.getElementById("search");
if (form instanceof HTMLFormElement) startSearch(form);

// Once the page stands: what is kept for later takes nothing from what is wanted now.
addEventListener("load", () => {
  void new Registration(new URL(document.body.dataset.root || "./", location.href)).start();
});
