// Runs before the first paint, so that what only scripts can do is there from the start and nothing moves.
document.documentElement.classList.add("has-js");
