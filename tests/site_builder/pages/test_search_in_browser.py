"""The catalogue's pages in a real Chromium: search, sorting, copying; nothing moves, nothing is out of reach."""

import threading
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from hexalab.hosts.serving import make_server

pytestmark = pytest.mark.browser
AXE = Path(__file__).resolve().parents[3] / "node_modules" / "axe-core" / "axe.min.js"

SHIFTS = """() => new Promise((done) => {
  new PerformanceObserver((list) => done(list.getEntries().reduce((sum, entry) => sum + entry.value, 0)))
    .observe({ type: "layout-shift", buffered: true });
  setTimeout(() => done(0), 300);
})"""


@pytest.fixture(scope="module")
def address(site):
    with make_server(site) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield server.address
        server.shutdown()


@pytest.fixture
def page(chromium: Browser, address: str):
    context = chromium.new_context(viewport={"width": 1280, "height": 800}, base_url=address)
    page = context.new_page()
    troubles = []
    page.on("console", lambda message: troubles.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: troubles.append(str(error)))
    yield page
    context.close()
    assert troubles == []


def names(page: Page) -> list[str]:
    return page.locator("#results .card-name, #results tbody th").all_inner_texts()


def found(page: Page, text: str) -> None:
    page.wait_for_function("text => document.getElementById('found').textContent === text", arg=text)


def test_C2_words_filters_and_sorting_find_meshes(page):
    page.goto("index.html")
    assert len(names(page)) == 5
    page.get_by_role("searchbox").fill("nunez first")
    found(page, "1 mesh")
    assert names(page) == ["one folder / first"]
    page.get_by_role("searchbox").fill("second")
    found(page, "1 mesh")
    assert page.locator(".card-facts").all_inner_texts() == ["4,200 cells"], "no dash for what isn't known"
    page.get_by_role("searchbox").fill("")
    found(page, "5 meshes")
    page.get_by_role("button", name="Filters").click()
    page.get_by_role("group", name="Validity").get_by_text("invalid", exact=False).locator(
        "visible=true"
    ).first.click()
    found(page, "1 mesh")
    assert names(page) == ["Turned over"]
    page.get_by_role("button", name="Clear all").click()
    found(page, "5 meshes")
    page.get_by_label("Sort").select_option("-cells")
    page.wait_for_function("() => document.querySelector('.card-name').textContent === 'second'")
    assert names(page) == ["second", "one folder / first", "A row", "pair", "Turned over"]


def test_C2_a_search_is_an_address(page):
    page.goto("index.html#q=row&view=table")
    found(page, "1 mesh")
    assert names(page) == ["A row"]
    assert page.get_by_role("table").is_visible()
    page.get_by_role("link", name="A row").click()
    page.wait_for_url("**/sources/small/row/index.html")
    page.go_back()
    found(page, "1 mesh")


def test_T6_blocks_are_filtered_by_sorted_by_and_shown(page):
    page.goto("index.html#view=table&sort=-blocks")
    page.get_by_role("table").wait_for()
    heads = page.locator("#results thead th").all_inner_texts()
    rows = [row.locator("th, td").all_inner_texts() for row in page.locator("#results tbody tr").all()]
    told = {row[0]: (row[heads.index("Sheets")], row[heads.index("Blocks")]) for row in rows}
    assert told["A row"] == ("7", "1") and told["second"] == ("–", "–")
    assert [row[0] for row in rows][3:] == ["one folder / first", "second"], "what is not known comes last"
    page.get_by_role("button", name="Filters").click()
    page.get_by_role("group", name="Blocks").get_by_text("one").click()
    found(page, "3 meshes")
    assert names(page) == ["pair", "Turned over", "A row"]
    page.wait_for_url("**/index.html#*blocks=one*")


def test_C2_a_search_works_by_keyboard_alone(page):
    page.goto("index.html")
    page.get_by_role("searchbox").focus()
    page.keyboard.type("pair")
    found(page, "3 meshes")  # the others are of the body of that name
    page.keyboard.press("Enter")
    for _ in range(12):
        page.keyboard.press("Tab")
        if page.evaluate("() => document.activeElement.name === 'view'"):
            break
    page.keyboard.press("ArrowRight")
    page.get_by_role("table").wait_for()
    assert names(page) == ["pair", "one folder / first", "second"]


def test_C2_without_scripts_all_is_there_but_the_search(chromium, address):
    context = chromium.new_context(java_script_enabled=False, base_url=address)
    page = context.new_page()
    page.goto("index.html")
    assert len(names(page)) == 5
    assert not page.get_by_role("searchbox").is_visible()
    page.get_by_role("link", name="Hexahedra & their <friends>").first.click()
    assert "belong to the authors" in page.inner_text("main")
    assert page.get_by_role("row").count() == 3
    context.close()


def test_C2_tables_sort_by_their_heads(page):
    page.goto("sources/small/index.html")
    rows = page.locator("table.meshes tbody th")
    page.get_by_role("button", name="Cells").click()
    assert rows.all_inner_texts() == ["pair", "Turned over", "A row"]
    page.get_by_role("button", name="Cells").click()
    assert rows.first.inner_text() == "A row"
    assert page.locator("th[aria-sort]").get_attribute("aria-sort") == "descending"


def test_C2_a_citation_can_be_copied(page):
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.goto("sources/far/index.html")
    page.locator("[data-copy=cite-bibtex]").click()
    page.get_by_text("Copied").wait_for()
    assert page.evaluate("() => navigator.clipboard.readText()").startswith("@article{far,")


@pytest.mark.parametrize("width", [360, 1280])
@pytest.mark.parametrize(
    "path", ["index.html", "sources/far/index.html", "sources/small/pair/index.html", "about/index.html"]
)
def test_V8_nothing_moves_and_nothing_sticks_out(page, path, width):
    page.set_viewport_size({"width": width, "height": 780})
    page.goto(path)
    assert page.evaluate(SHIFTS) < 0.01
    assert page.evaluate("() => document.documentElement.scrollWidth") <= width


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize(
    "path",
    ["index.html", "index.html#q=far", "sources/far/index.html", "sources/small/parts-turned/index.html"],
)
def test_V8_contrast_names_and_structure_for_everybody(chromium, address, path, scheme):
    if not AXE.exists():
        pytest.skip("axe-core isn't installed")
    context = chromium.new_context(base_url=address, color_scheme=scheme, bypass_csp=True)
    page = context.new_page()
    page.goto(path)
    if "#" in path:
        page.get_by_role("button", name="Filters").click()
        page.locator(".chip.is-none").first.wait_for()
    page.add_script_tag(path=AXE)
    result = page.evaluate("() => axe.run()")
    found = {row["id"]: [node["html"][:120] for node in row["nodes"]] for row in result["violations"]}
    context.close()
    assert found == {}
