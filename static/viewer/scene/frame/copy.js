/**
 * Fills a target, or the canvas, with what is in another: without drawing, which on software GPUs takes longer.
 *
 * @param {import("three").WebGLRenderer} renderer
 * @param {import("three").WebGLRenderTarget} source drawn, and resolved if it has several samples
 * @param {import("three").WebGLRenderTarget | null} target null: the canvas
 * @param {{ width: number, height: number }} size of the target
 */
export function copy(renderer, source, target, { width, height }) {
  const gl = /** @type {WebGL2RenderingContext} */ (renderer.getContext());
  renderer.setRenderTarget(target);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebufferOf(renderer, source));
  const same = source.width === width && source.height === height;
  gl.blitFramebuffer(
    ...[0, 0, source.width, source.height],
    ...[0, 0, width, height],
    gl.COLOR_BUFFER_BIT,
    same ? gl.NEAREST : gl.LINEAR,
  );
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
}

/** @param {import("three").WebGLRenderer} renderer @param {import("three").WebGLRenderTarget} target @returns {WebGLFramebuffer} */
function framebufferOf(renderer, target) {
  const kept = /** @type {{ __webglFramebuffer: WebGLFramebuffer }} */ (renderer.properties.get(target));
  return kept.__webglFramebuffer;
}
