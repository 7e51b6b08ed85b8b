/** Kinds of cells, in the order of the core's `SHAPES`: what a hexahedron has collapsed to may be none of the others. */
export const KINDS = ["hexahedron", "wedge", "pyramid", "tetrahedron", "other"];

/** What one, and several, are called. @type {Record<string, [string, string]>} */
export const KIND_NAMES = {
  hexahedron: ["hexahedron", "hexahedra"],
  wedge: ["wedge", "wedges"],
  pyramid: ["pyramid", "pyramids"],
  tetrahedron: ["tetrahedron", "tetrahedra"],
  other: ["otherwise collapsed", "otherwise collapsed"],
};
