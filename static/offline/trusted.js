/**
 * Trusted Types: the pages' policy lets no text become a script or markup but what passes here
 * (https://www.w3.org/TR/trusted-types/). Browsers without them take the text as it is.
 *
 * @typedef {{ createScriptURL: (address: string) => string, createHTML: (text: string) => string }} Policy
 */

/** @type {Policy} */
const rules = {
  createScriptURL(address) {
    const { origin, protocol } = new URL(address, location.href);
    if (origin !== location.origin || protocol === "data:")
      throw new TypeError(`${address} is no script of this site`);
    return address;
  },
  createHTML: (text) => text,
};

const { trustedTypes } =
  /** @type {{ trustedTypes?: { createPolicy: (name: string, rules: Policy) => Policy } }} */ (
    /** @type {unknown} */ (globalThis)
  );
const policy = trustedTypes?.createPolicy("hexalab", rules) ?? rules;

/** The address of a script of this site. @param {string | URL} address @throws {TypeError} it lies elsewhere */
export function scriptAddress(address) {
  return policy.createScriptURL(String(address));
}

/** A page of this site as a document that runs nothing and shows nothing. @param {string} text */
export function inertDocument(text) {
  return new DOMParser().parseFromString(policy.createHTML(text), "text/html");
}
