import { takeLaunches } from "../../offline/launches.js";

/** Files that are opened with the installed application. @param {import("../app/app.js").App} app */
export function listenToLaunches(app) {
  takeLaunches((files) => app.openFiles(files).catch(() => {})); // said in a message by whoever failed
}
