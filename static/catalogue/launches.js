import { HELD, MARK, transact } from "../offline/database.js";
import { takeLaunches } from "../offline/launches.js";

/** Files that are opened with the installed application go to the viewer. @param {URL} root of the site */
export function passLaunches(root) {
  takeLaunches(async (files) => {
    const found = files.map((file) => ({ path: file.name, file }));
    await transact("readwrite", (store) => store.put({ files: found }, HELD));
    sessionStorage.setItem(MARK, HELD);
    location.assign(new URL("viewer/index.html", root));
  });
}
