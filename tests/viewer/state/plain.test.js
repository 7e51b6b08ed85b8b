import assert from "node:assert/strict";
import { test } from "node:test";
import { plain } from "../../../static/viewer/state/plain.js";

const nested = (/** @type {number} */ depth) => {
  let value = /** @type {unknown} */ (1);
  for (let level = 0; level < depth; level++) value = { a: value };
  return value;
};

test("a proxy, typed arrays and getters become what JSON holds", () => {
  const given = new Proxy({ colour: { by: "kind" }, list: new Float32Array([1, 2]), none: undefined }, {});
  assert.deepEqual(plain(given), { colour: { by: "kind" }, list: [1, 2] });
  assert.deepEqual(plain({ get a() { return 1; }, b: NaN }), { a: 1, b: null }); // prettier-ignore
  const odd = JSON.parse('{"__proto__": {"polluted": 1}}');
  assert.equal(Object.getPrototypeOf(plain(odd)), Object.prototype);
  assert.equal(/** @type {any} */ ({}).polluted, undefined);
});

test("what is deep, goes in circles or is no value is refused in words", () => {
  /** @type {any} */
  const circle = {};
  circle.self = circle;
  for (const [value, words] of /** @type {[unknown, RegExp][]} */ ([
    [nested(1_500), /nested more than 64 deep/],
    [nested(20_000), /nested more than 64 deep/],
    [circle, /nested more than 64 deep/],
    [{ a: { b: () => 1 } }, /hold a function at a\.b/],
    [{ a: [1n] }, /hold a bigint at a\[0\]/],
    [{ get a() { throw new Error("not now"); } }, /can't be read: not now/], // prettier-ignore
  ]))
    assert.throws(() => plain(value), words);
  assert.deepEqual(plain(nested(60)), nested(60));
});
