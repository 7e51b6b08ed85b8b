"""The style sheet of a report's page: the tokens of light and dark, and paper."""

STYLE = """
:root { color-scheme: light dark; --paper: #fbfaf7; --surface: #fff; --ink: #1d1f23; --quiet: #5d6167;
  --hairline: #e2dfd8; --accent: #0b6e74; --invalid: #c8372d; --warning: #96610f; --good: #2f7d4f; }
@media (prefers-color-scheme: dark) { :root { --paper: #14161a; --surface: #1c1f24; --ink: #e9e7e2; --quiet: #a3a7ad;
  --hairline: #2e3238; --accent: #4fb7bd; --invalid: #f0776d; --warning: #d9a441; --good: #6cc08f; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 15px/1.5 system-ui, sans-serif; }
main, header, footer { max-width: 1040px; margin: 0 auto; padding: 0 20px; }
header { padding-top: 28px; }
h1 { font-size: 28px; line-height: 1.25; margin: 0 0 12px; overflow-wrap: anywhere; font-weight: 650; }
h2 { font-size: 20px; line-height: 1.3; margin: 36px 0 8px; font-weight: 650; }
p { margin: 8px 0; max-width: 72ch; }
a { color: var(--accent); }
.quiet, figcaption, footer { color: var(--quiet); font-size: 13px; }
.verdict { display: flex; flex-wrap: wrap; gap: 4px 12px; align-items: baseline; padding: 12px 16px; margin: 0;
  background: var(--surface); border: 1px solid var(--hairline); border-left: 4px solid; border-radius: 6px;
  max-width: none; }
.verdict strong { font-size: 20px; }
.verdict span { color: var(--ink); }
.passed { color: var(--good); } .missed, .error { color: var(--invalid); } .warning { color: var(--warning); }
dl { display: grid; grid-template-columns: max-content 1fr; margin: 0; }
dt, dd { padding: 4px 0; border-top: 1px solid var(--hairline); margin: 0; }
dt { color: var(--quiet); padding-right: 24px; } dd { overflow-wrap: anywhere; font-variant-numeric: tabular-nums; }
dt:first-of-type, dd:first-of-type { border-top: 0; }
.hash { font-family: ui-monospace, monospace; font-size: 13px; }
.scroll { overflow-x: auto; position: relative; }
.scroll:focus-visible, a:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
table { border-collapse: collapse; width: 100%; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: 5px 12px 5px 0; text-align: left; vertical-align: top; border-top: 1px solid var(--hairline);
  font-weight: 400; }
thead th { color: var(--quiet); border-top: 0; vertical-align: bottom; }
th:last-child, td:last-child { padding-right: 0; }
.number { text-align: right; white-space: nowrap; }
.state, .whole { white-space: nowrap; }
.name { min-width: 9em; overflow-wrap: anywhere; }
.words { min-width: 15em; overflow-wrap: anywhere; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 310px), 1fr)); gap: 16px; }
.histograms { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 220px), 1fr)); gap: 16px 24px; }
figure { margin: 0; break-inside: avoid; }
.pictures img { display: block; width: 100%; height: auto; background: #fff; border: 1px solid var(--hairline);
  border-radius: 6px; }
.pictures figcaption { padding-top: 6px; }
.histograms figcaption { color: var(--ink); }
.histogram { display: block; width: 100%; height: auto; }
.histogram text { font: 10px system-ui, sans-serif; fill: var(--quiet); } .histogram .end { text-anchor: end; }
.bar { fill: var(--accent); } .outside { fill: var(--invalid); }
.axis { stroke: var(--hairline); } .acceptable { stroke: var(--good); stroke-width: 1.5; fill: none; }
footer { padding-top: 28px; padding-bottom: 36px; }
@media (max-width: 560px) {
  main, header, footer { padding-left: 14px; padding-right: 14px; }
  header { padding-top: 18px; } h1 { font-size: 23px; }
  dl { grid-template-columns: 1fr; } dt { padding-bottom: 0; } dd { border-top: 0; padding-top: 0; }
}
@media print {
  :root { color-scheme: light; --paper: #fff; --surface: #fff; --ink: #000; --quiet: #444; --hairline: #bbb;
    --accent: #0b6e74; --invalid: #b02a20; --warning: #7a4f0c; --good: #1f6a3e; }
  @page { size: A4; margin: 14mm; }
  body { font-size: 9.5pt; } main, header, footer { max-width: none; padding: 0; }
  h1 { font-size: 17pt; } h2 { font-size: 12.5pt; margin-top: 16pt; break-after: avoid; }
  table, .quiet, figcaption, footer, .hash { font-size: 8pt; }
  .scroll { overflow: visible; } .words, .name { min-width: 0; }
  tr { break-inside: avoid; } thead { display: table-header-group; }
  .pictures { grid-template-columns: repeat(3, 1fr); gap: 8pt; }
  .histograms { grid-template-columns: repeat(4, 1fr); gap: 8pt 12pt; }
}
""".strip()
"""CSS; a page knows it by its hash, and lets no other in."""
