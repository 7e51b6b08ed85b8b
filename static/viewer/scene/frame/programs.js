import { BufferGeometry, Camera, Group, Mesh, Scene } from "three";

/**
 * Has the GPU compile its programs beside other work: drawing with one that is not compiled yet makes the page wait for it, for
 * the better part of a second where graphics are drawn by software.
 */
export class Programs {
  #renderer;
  #scene = new Scene();
  #camera = new Camera();

  /** @param {import("three").WebGLRenderer} renderer */
  constructor(renderer) {
    this.#renderer = renderer;
  }

  /** @param {Iterable<import("three").Material>} materials @returns {Promise<void>} when all can be drawn with, as far as the browser tells */
  async compile(materials) {
    const group = new Group();
    for (const material of materials) group.add(new Mesh(new BufferGeometry(), material));
    const known = this.#renderer.extensions.has("KHR_parallel_shader_compile");
    if (known) await this.#renderer.compileAsync(group, this.#camera, this.#scene);
    else this.#renderer.compile(group, this.#camera, this.#scene);
  }
}

/** All materials in a tree. @param {import("three").Object3D} root @returns {Set<import("three").Material>} */
export function materialsIn(root) {
  const found = new Set();
  root.traverse((each) => each instanceof Mesh && found.add(each.material));
  return found;
}
