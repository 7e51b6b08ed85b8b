/** Luminance below which a colour is dark: black lines on it, at less than 3 to 1, could not be told from it. */
export const DARK = 0.1;

/**
 * Relative luminance, the curve of sRGB taken as a power of 2.2, as the shader of lines does.
 *
 * @param {ArrayLike<number>} colour components, 0 to 1
 */
export function luminance(colour) {
  return 0.2126 * colour[0] ** 2.2 + 0.7152 * colour[1] ** 2.2 + 0.0722 * colour[2] ** 2.2;
}
