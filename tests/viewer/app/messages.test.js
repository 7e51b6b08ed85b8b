import assert from "node:assert/strict";
import { test } from "node:test";
import { Messages } from "../../../static/viewer/app/messages.js";
import { Facts } from "../../../static/viewer/state/facts.js";

/** What is said of two meshes on one page. */
function parts() {
  const facts = new Facts();
  const texts = () => facts.get("messages").map(({ text }) => text);
  return { facts, first: new Messages(facts), second: new Messages(facts, "second "), texts };
}

test("a newer message on a topic takes the older one's place, and so does the same text", () => {
  const { first, texts } = parts();
  first.say("note", "one", { topic: "open" });
  first.say("error", "two", { topic: "open" });
  first.say("note", "three");
  first.say("warning", "three", { topic: "save" });
  assert.deepEqual(texts(), ["two", "three"]);
});

test("S6: what is said of one mesh takes no place of what is said of the other, though it is on the same topic", () => {
  const { first, second, texts } = parts();
  first.say("error", "A can't be read", { topic: "open" });
  second.say("error", "B can't be read", { topic: "open" });
  assert.deepEqual(texts(), ["A can't be read", "B can't be read"]);
  second.say("note", "B is there", { topic: "open" });
  assert.deepEqual(texts(), ["A can't be read", "B is there"]);
});

test("S6: a topic is settled for the mesh that it is about", () => {
  const { first, second, texts } = parts();
  first.say("error", "of A", { topic: "open" });
  second.say("error", "of B", { topic: "open" });
  first.settle("open");
  assert.deepEqual(texts(), ["of B"]);
  second.settle("open", "save");
  assert.deepEqual(texts(), []);
  first.say("error", "of A", { topic: "frame" });
  second.say("error", "of B", { topic: "frame" });
  second.say("error", "of both", { topic: "core" });
  second.settleMesh();
  assert.deepEqual(texts(), ["of A", "of both"], "topics that outlive a mesh stay");
});

test("S6: ids differ whoever says it, so that each message is dismissed by itself", () => {
  const { facts, first, second, texts } = parts();
  first.say("note", "one");
  second.say("note", "two");
  first.say("note", "three", { topic: "save" });
  const ids = facts.get("messages").map(({ id }) => id);
  assert.equal(new Set(ids).size, 3);
  first.dismiss(ids[1]);
  assert.deepEqual(texts(), ["one", "three"]);
});

test("S6: when the second mesh has gone, what was said of it goes, and nothing more is said", () => {
  const { first, second, texts } = parts();
  first.say("note", "of A", { topic: "frame" });
  first.say("note", "of no topic");
  second.say("note", "of B", { topic: "frame" });
  second.end();
  second.error(new Error("The core was closed."), { topic: "describe" });
  assert.deepEqual(texts(), ["of A", "of no topic"]);
  first.say("note", "of A once more");
  assert.equal(texts().length, 3);
});

test("an error is told by its message, and what is no error by its text", () => {
  const { first, facts } = parts();
  first.error(new Error("no memory"), { topic: "save" });
  first.error("gone");
  assert.deepEqual(
    facts.get("messages").map(({ severity, text, topic }) => [severity, text, topic]),
    [
      ["error", "no memory", "save"],
      ["error", "gone", undefined],
    ],
  );
});
