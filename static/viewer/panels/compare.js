import { optionsOf } from "../state/choices.js";
import { buttons } from "../widgets/controls.js";
import { compareChanges } from "./compare_changes.js";
import { compareChoice } from "./compare_choice.js";
import { compareDistances } from "./compare_distances.js";
import { compareTable } from "./compare_table.js";
import { compareWhole } from "./compare_whole.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** @param {Context} context */
const alone = ({ facts }) => facts.get("second") === null;

/** @param {Context} context */
const withNothing = ({ facts }) => facts.get("comparison") === null;

/** Two meshes, or a mesh and a reference surface (SPEC S6, S7). @type {import("../widgets/section.js").Section} */
export const compare = {
  id: "compare",
  title: "Compare",
  digestOf: { facts: ["comparison"] },
  digest: ({ facts }) => {
    const told = facts.get("comparison");
    return told ? `with ${told.name}` : "";
  },
  controls: [
    { kind: "custom", render: compareChoice },
    {
      kind: "choice",
      id: "compare-layout",
      label: "Pictures",
      hint: "Side by side, or one upon the other, parted by a curtain that can be dragged",
      path: "compare.layout",
      facts: ["second"],
      options: optionsOf("compare.layout"),
      hidden: alone,
    },
    {
      kind: "choice",
      id: "compare-camera",
      label: "Seen",
      hint: "Each fitted to the picture by itself; or both at the same place of the file's coordinates; as fits: at the same place where they nearly are",
      path: "compare.camera",
      facts: ["second", "together"],
      options: (context) =>
        optionsOf("compare.camera")(context).map((option) =>
          option.value === "auto"
            ? { ...option, name: `as fits: ${context.facts.get("together") ? "same place" : "own frames"}` }
            : option,
        ),
      hidden: alone,
    },
    {
      kind: "choice",
      id: "compare-colours",
      label: "Colours",
      hint: "Whether the map's range is that of both meshes together, or each has its own",
      path: "compare.colours",
      facts: ["second"],
      options: optionsOf("compare.colours"),
      hidden: alone,
    },
    {
      kind: "slider",
      id: "compare-reference",
      label: "Surface",
      hint: "The surface of the other, drawn over the mesh as a film",
      enabled: "compare.reference.shown",
      path: "compare.reference.opacity",
      facts: ["comparison"],
      range: [0, 1, 0.05],
      digits: 2,
      hidden: withNothing,
      more: [
        {
          kind: "colours",
          label: "Colour",
          items: [{ path: "compare.reference.colour", name: "Surface of the other" }],
        },
      ],
    },
    { kind: "custom", render: compareTable },
    { kind: "custom", render: compareChanges },
    { kind: "custom", render: compareDistances },
    { kind: "custom", render: compareWhole },
    buttons({
      label: "",
      facts: ["second", "comparison"],
      hidden: withNothing,
      items: [
        {
          name: "End the comparison",
          text: "End comparison",
          press: ({ app }) => app.comparing.close(),
        },
      ],
    }),
  ],
};
