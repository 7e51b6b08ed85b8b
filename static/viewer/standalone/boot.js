/**
 * The only script that a page of one file runs by itself: it inflates the viewer and puts it into the page, which lets it run
 * because it knows its hash.
 */
const packed = document.getElementById("program")?.textContent ?? "";
const bytes = Uint8Array.from(atob(packed.trim()), (letter) => letter.charCodeAt(0));
const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
const script = document.createElement("script");
script.type = "module";
script.textContent = await new Response(stream).text();
document.head.append(script);

export {};
