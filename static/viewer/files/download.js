/**
 * Fetch a file, with progress, and say in words what went wrong.
 *
 * @param {string} address
 * @param {(fraction: number | null, text?: string) => void} report
 * @returns {Promise<ArrayBuffer>}
 */
export async function download(address, report) {
  const { host } = new URL(address, location.href);
  const answer = await fetch(address, { credentials: "same-origin" }).catch((cause) => {
    const reason =
      navigator.onLine === false
        ? "there is no network"
        : "the server can't be reached, or does not let other sites read its files (CORS)";
    throw new Error(`${address} could not be fetched: ${reason}`, { cause });
  });
  if (!answer.ok)
    throw new Error(
      `${address} could not be fetched: ${host} answered ${answer.status} ${answer.statusText}`.trimEnd(),
    );
  const encoded = answer.headers.has("content-encoding");
  const total = encoded ? 0 : Number(answer.headers.get("content-length") ?? 0);
  return answer.body ? collect(answer.body, total, report) : answer.arrayBuffer();
}

/** @param {ReadableStream<Uint8Array>} body @param {number} total bytes announced, or 0 @param {(fraction: number | null, text?: string) => void} report */
async function collect(body, total, report) {
  /** @type {Uint8Array[]} */
  const parts = [];
  let size = 0;
  const reader = body.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    parts.push(value);
    size += value.length;
    report(
      total ? Math.min(1, size / total) : null,
      `fetching, ${megabytes(size)}${total ? ` of ${megabytes(total)}` : ""}`,
    );
  }
  return new Blob(/** @type {BlobPart[]} */ (parts)).arrayBuffer();
}

/** @param {number} bytes */
function megabytes(bytes) {
  return `${(bytes / 1e6).toFixed(1)} MB`;
}
