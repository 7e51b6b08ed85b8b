import { viewerIn } from "./embedding_example.js";

/** The example of the guide's page on embedding: buttons that ask a viewer in a frame. @param {Document} page */
export function enableEmbedding(page) {
  const frame = page.getElementById("driven");
  const answer = page.getElementById("driven-answer");
  if (!(frame instanceof HTMLIFrameElement) || !answer) return;
  const address = new URL(frame.dataset.src ?? "", location.href);
  address.searchParams.set("origin", location.origin);
  frame.src = address.href;
  const ask = viewerIn(frame);
  const buttons = [...page.querySelectorAll("button[data-ask]")].filter(
    (one) => one instanceof HTMLButtonElement,
  );
  addEventListener("message", ({ source, data }) => {
    if (source !== frame.contentWindow || data?.hexalab !== "ready") return;
    for (const button of buttons) button.disabled = false;
    answer.textContent = `The viewer is ready: version ${data.version} of the protocol, HexaLab ${data.program}.`;
  });
  for (const button of buttons)
    button.addEventListener("click", async () => {
      const [method, ...args] = JSON.parse(button.dataset.ask ?? "[]");
      try {
        const result = await ask(method, ...args);
        answer.textContent = `${method}: ${JSON.stringify(result)}`.slice(0, 600);
      } catch (error) {
        answer.textContent = `${method}: ${error instanceof Error ? error.message : error}`;
      }
    });
}
