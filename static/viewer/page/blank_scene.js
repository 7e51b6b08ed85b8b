/** Stands in for the scene where the browser has no WebGL 2: takes everything, draws nothing. */
export class BlankScene {
  timings = {};
  hurried = false;
  outward = false;
  warmUp() {}
  setMesh() {}
  setSurface() {}
  setSilhouette() {}
  setIrregular() {}
  setCellColours() {}
  setStatus() {}
  resize() {}
  highlight() {}
  showPlane() {}
  invalidate() {}
  flush() {}
  dispose() {}

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

  async screenshot() {
    throw new Error("there is no picture to save: this browser lacks WebGL 2");
  }
}
