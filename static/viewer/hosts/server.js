import { CoreClient } from "../core/client.js";
import { ServerTransport } from "../core/server_transport.js";
import { fetchedSheet, nothingAhead } from "./host.js";
import { Offers } from "./offers.js";

/** Where the token is kept, so that the page can be loaded again; it leaves the address at once. */
const TOKEN = "hexalab.token";

/** `hexalab view`: files of this machine, and the native core. @returns {import("./host.js").Host} */
export function server() {
  const offers = new Offers();
  const address = new URL(".", document.baseURI).href;
  const directions = Number(new URLSearchParams(location.search).get("directions")) || undefined;
  let token = tokenOf(location);
  const transport = new ServerTransport(address, token, {
    hello: (hello) => {
      token = hello.token;
      sessionStorage.setItem(TOKEN, token);
      offers.take(hello);
    },
    news: ({ changed, gone, stopped }) => {
      if (changed !== undefined) offers.tell("changed", changed);
      if (gone !== undefined) offers.tell("gone", gone);
      if (stopped) offers.tellStopped();
    },
  });
  return {
    root: "",
    keeps: false,
    shares: false,
    steps: true,
    embedded: false,
    directions,
    addressed: "",
    beside: "",
    client: new CoreClient(transport),
    another: () => new CoreClient(new ServerTransport(address, token, { hello: () => {}, news: () => {} })),
    ahead: nothingAhead(),
    sheet: fetchedSheet,
    offers,
  };
}

/** @param {Location} location */
function tokenOf({ hash, pathname }) {
  const token = new URLSearchParams(hash.slice(1)).get("token");
  if (token === null) return sessionStorage.getItem(TOKEN) ?? "";
  history.replaceState(history.state, "", pathname);
  return token;
}
