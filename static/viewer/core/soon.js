/** When something has come, or some milliseconds later. @param {Promise<unknown>} coming @param {number} milliseconds @returns {Promise<unknown>} */
export function soon(coming, milliseconds) {
  return Promise.race([coming, new Promise((resolve) => setTimeout(resolve, milliseconds))]);
}
