import { VIEWS } from "../state/camera.js";
import { optionsOf } from "../state/choices.js";
import { buttons } from "../widgets/controls.js";

/** @param {string} name @param {string} text @param {string} key @returns {import("../widgets/bind.js").Action} */
const viewButton = (name, text, key) => ({
  name: `View from ${name}`,
  text,
  hint: `View from ${name} (${key})`,
  press: ({ store }) => store.set({ camera: VIEWS[name] }),
});

/** @param {import("../widgets/bind.js").Context} known */
function nothingHidden({ facts }) {
  const shown = facts.get("shown")?.cells;
  return shown !== undefined && shown === facts.get("summary")?.cells ? "nothing is hidden" : "";
}

/** Whether another mesh keeps the view. */
const KEEPING = [
  { value: "changed", name: "keeps a view that was changed" },
  { value: "always", name: "keeps the view always" },
  { value: "never", name: "opens in its own view" },
];

/** @type {import("../widgets/section.js").Section} */
export const surroundings = {
  id: "surroundings",
  title: "View and light",
  controls: [
    {
      kind: "choice",
      id: "lighting",
      label: "Lighting",
      hint: "AO: ambient occlusion, on and off (Q)",
      path: "lighting.mode",
      options: optionsOf("lighting.mode"),
    },
    {
      kind: "slider",
      id: "shade",
      label: "Shade",
      hint: "How much the light darkens: less where colours are to be read off",
      path: "lighting.shade",
      status: ["lighting.mode"],
      range: [0, 1, 0.05],
      digits: 2,
      why: ({ store }) => (store.status.lighting.mode === "none" ? "there is no light" : ""),
    },
    {
      kind: "slider",
      id: "silhouette",
      label: "Silhouette",
      hint: "The outline of what is hidden: none, flat, shaded",
      path: "silhouette",
      facts: ["shown", "summary"],
      range: [0, 1, 0.05],
      digits: 2,
      why: nothingHidden,
    },
    {
      kind: "choice",
      id: "see-through",
      label: "See through",
      hint: "Hidden cells drawn faintly before what is shown",
      path: "see_through.cells",
      options: optionsOf("see_through.cells"),
    },
    {
      kind: "slider",
      id: "see-through-opacity",
      label: "Opacity",
      hint: "Of the cells that are seen through",
      path: "see_through.opacity",
      status: ["see_through.cells"],
      facts: ["shown", "summary"],
      range: [0, 1, 0.05],
      digits: 2,
      hidden: ({ store }) => store.status.see_through.cells === "none",
      why: nothingHidden,
    },
    {
      kind: "colours",
      id: "background",
      label: "Background",
      items: [{ path: "background", name: "Background" }],
    },
    buttons({
      label: "Look from",
      full: true,
      items: [
        viewButton("front", "Front", "1"),
        viewButton("right", "Right", "3"),
        viewButton("top", "Top", "7"),
        viewButton("isometric", "Iso", "9"),
        viewButton("back", "Back", "2"),
        viewButton("left", "Left", "4"),
        viewButton("bottom", "Below", "8"),
        {
          name: "Reset the camera",
          text: "Reset",
          hint: "The view that the mesh opened with (Enter)",
          press: ({ app }) => app.views.reset(),
        },
        {
          name: "Fit what is shown",
          text: "Fit shown",
          hint: "Fit what is shown (. or Home, or a double click beside the mesh)",
          press: ({ app }) => app.views.fitShown(),
        },
      ],
    }),
    {
      kind: "choice",
      id: "projection",
      label: "Projection",
      path: "camera.projection",
      hint: "5",
      options: optionsOf("camera.projection"),
    },
    {
      kind: "slider",
      id: "field-of-view",
      label: "Angle",
      hint: "Vertical angle of view, degrees",
      path: "camera.field_of_view",
      status: ["camera.projection"],
      range: [5, 90, 1],
      digits: 0,
      why: ({ store }) =>
        store.status.camera.projection === "orthographic" ? "an orthographic view has no angle" : "",
    },
    {
      kind: "choice",
      id: "keeping",
      label: "Next mesh",
      hint: "Under which view another mesh is opened",
      facts: ["keeping"],
      options: () => KEEPING,
      read: ({ facts }) => facts.get("keeping"),
      write: (keeping, { facts }) => {
        facts.set({ keeping: /** @type {import("../state/opening_view.js").Keeping} */ (keeping) });
        return null;
      },
    },
    {
      kind: "toggle",
      id: "remember",
      hidden: ({ app }) => !app.host.keeps,
      label: "Last file",
      hint: "Keep the file that was opened last in this browser, to open it again after a reload",
      facts: ["remember"],
      read: ({ facts }) => facts.get("remember"),
      write: (remember, { facts }) => {
        facts.set({ remember });
        return null;
      },
    },
    {
      kind: "slider",
      id: "line-width",
      label: "Line width",
      hint: "In pixels",
      path: "separation.line_width",
      status: ["separation.mode", "irregular.mode"],
      range: [0.5, 4, 0.25],
      digits: 2,
      why: ({ store }) =>
        ["fissure", "rounded"].includes(store.status.separation.mode) && store.status.irregular.mode === 0
          ? "no lines are drawn in this mode"
          : "",
    },
  ],
};
