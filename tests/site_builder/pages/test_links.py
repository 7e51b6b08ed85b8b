"""A crawler: every link of every page leads somewhere, under any sub-path."""

import re
from urllib.parse import unquote, urldefrag, urljoin, urlsplit

import pytest

ELSEWHERE = ("https:", "http:", "mailto:", "data:")

UNLINKED = {"offline/missing/index.html"}
"""What a service worker shows in place of a page that is not kept."""


def links_of(html):
    return re.findall(r'(?:href|src)="([^"]*)"', html)


def target(root, page, link):
    """The file that a link of a page means, as a static host resolves it below some sub-path."""
    address = urldefrag(urljoin(f"http://host/sub/path/{page}", link.replace("&amp;", "&")))[0]
    path = urlsplit(address).path
    assert path.startswith("/sub/path/"), f"{page}: {link} leaves the site"
    file = root / unquote(path.removeprefix("/sub/path/"))
    return file / "index.html" if path.endswith("/") else file


def crawl(root):
    """Addresses of the pages that can be reached from the front page, and links that lead nowhere."""
    seen, todo, broken = set(), ["index.html"], []
    while todo:
        page = todo.pop()
        if page in seen:
            continue
        seen.add(page)
        html = (root / page).read_text("utf-8")
        ids = set(re.findall(r'\bid="([^"]*)"', html))
        for link in links_of(html):
            if link.startswith(ELSEWHERE):
                continue
            if link.startswith("#"):
                if link[1:] not in ids:
                    broken.append((page, link))
                continue
            file = target(root, page, link)
            if not file.is_file():
                broken.append((page, link))
            elif file.suffix == ".html":
                todo.append(file.relative_to(root).as_posix())
    return seen, broken


@pytest.fixture
def whole(site, tmp_path):
    """The demo's site with a page where the viewer would be."""
    import shutil

    root = tmp_path / "site"
    shutil.copytree(site, root)
    (root / "viewer").mkdir()
    (root / "viewer" / "index.html").write_text("<!doctype html><title>viewer</title>", "utf-8")
    return root


def test_C2_every_link_of_every_page_resolves(whole):
    seen, broken = crawl(whole)
    assert broken == []
    pages = {file.relative_to(whole).as_posix() for file in whole.rglob("*.html")}
    assert seen == pages - UNLINKED, "every page can be reached from the front page"


def test_C2_no_link_begins_at_the_hosts_root(site):
    for file in site.rglob("*.html"):
        for link in links_of(file.read_text("utf-8")):
            assert not link.startswith("/"), (file, link)


def test_C3_the_sitemap_lists_every_page(site):
    listed = set(
        re.findall(r"<loc>https://meshes\.example\.org/hex/(.*?)</loc>", (site / "sitemap.xml").read_text())
    )
    pages = {file.relative_to(site).as_posix().removesuffix("index.html") for file in site.rglob("*.html")}
    assert listed == pages - {"embed/", "offline/", "offline/missing/"}
