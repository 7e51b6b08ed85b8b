/** @typedef {import("../scene/scene_like.js").SceneLike} SceneLike */

/**
 * Stands in for the scene where the browser has no WebGL 2: takes everything, draws nothing.
 *
 * @implements {SceneLike}
 */
export class BlankScene {
  /** @type {Record<string, number>} */
  timings = {};
  frames = 0;
  hurried = false;
  outward = false;
  covered = 0;
  lighting = {
    /** @returns {Promise<Float32Array>} */
    async baked() {
      throw new Error("there is no light to save: this browser lacks WebGL 2");
    },
  };
  async prepare() {}
  setMesh() {}
  setBeside() {}
  setSurface() {}
  setSilhouette() {}
  setOver() {}
  setCellColours() {}
  setStatus() {}
  resize() {}
  highlight() {}
  mark() {}
  showPlane() {}
  invalidate() {}
  flush() {}
  rest() {}
  dispose() {}

  /** @param {import("../state/status.js").Status["camera"]} camera */
  constructor(camera) {
    this.camera = camera;
  }

  halfHeight() {
    return 1;
  }

  cameraOnShown() {
    return null;
  }

  pick() {
    return null;
  }

  on() {
    return () => {};
  }

  async settled() {}

  drawn() {
    return { faces: 0, triangles: 0, edges: 0, cells: 0 };
  }

  /** @returns {Promise<Blob>} */
  async screenshot() {
    throw new Error("there is no picture to save: this browser lacks WebGL 2");
  }
}
