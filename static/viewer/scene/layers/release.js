import { Mesh, Texture } from "three";

/**
 * Gives up what a tree of meshes holds on the GPU; it is made anew when next drawn. Called when a context is lost: later, the
 * new context would be asked to delete what lay in the old one.
 *
 * @param {import("three").Object3D} root
 */
export function release(root) {
  root.traverse((each) => {
    if (!(each instanceof Mesh)) return;
    each.geometry.dispose();
    for (const { value } of Object.values(each.material.uniforms))
      if (value instanceof Texture) value.dispose();
    each.material.dispose();
  });
}
