"""The page of the Python interface: every public name, with what it takes, gives and raises, as Python itself knows."""

from __future__ import annotations

import dataclasses
import inspect
import re

import pytest

import hexalab
from site_builder import build
from site_builder.pages import interface

needs_griffe = pytest.mark.skipif(not interface.installed(), reason="needs griffelib, which is not installed")


@pytest.fixture(scope="module")
def sections(site):
    """The page's sections by their names: HTML from one heading to the next."""
    html = (site / "python" / "index.html").read_text("utf-8")
    parts = re.split(r'<section aria-labelledby="(\w+)">', html)[1:]
    return dict(zip(parts[::2], parts[1::2], strict=True))


def listed(html, title):
    """Names in a section's list of that title."""
    found = re.search(rf">{title}</h\d>\s*<dl class=\"terms\">(.*?)</dl>", html, re.DOTALL)
    return re.findall(r"<dt><code>([^<]*)</code>", found[1]) if found else []


@needs_griffe
def test_A1_every_public_name_has_its_section(sections):
    assert sorted(sections) == sorted(hexalab.__all__)
    for name, html in sections.items():
        assert f'<h3 id="{name}">' in html
        assert re.search(r"<p>\w", html), f"{name} is explained"


@needs_griffe
@pytest.mark.parametrize(
    "name", [name for name in hexalab.__all__ if inspect.isfunction(getattr(hexalab, name))]
)
def test_A1_a_functions_parameters_and_what_it_returns_are_there(sections, name):
    signature = inspect.signature(getattr(hexalab, name))
    assert f"hexalab.{name}({', '.join(signature.parameters)[:4]}" in sections[name]
    assert listed(sections[name], "Parameters") == list(signature.parameters)
    assert (">Returns</h4>" in sections[name]) == (signature.return_annotation != "None")


@needs_griffe
@pytest.mark.parametrize(
    "name", [n for n in hexalab.__all__ if dataclasses.is_dataclass(getattr(hexalab, n))]
)
def test_A1_a_classs_fields_properties_and_methods_are_there(sections, name):
    of = getattr(hexalab, name)
    fields = listed(sections[name], "Parameters") or listed(sections[name], "Attributes")
    assert [part for row in fields for part in row.split(", ")] == [
        row.name for row in dataclasses.fields(of)
    ]
    public = {key: value for key, value in vars(of).items() if not key.startswith("_") and value.__doc__}
    methods = [
        key for key, value in public.items() if inspect.isfunction(value) or isinstance(value, classmethod)
    ]
    for method in methods:
        assert f'<h4 id="{name}-{method}">' in sections[name]
    own = {row.name for row in dataclasses.fields(of)}
    assert listed(sections[name], "Properties") == [
        key for key in public if key not in methods and key not in own
    ]


@needs_griffe
def test_A1_exceptions_are_told_and_names_are_linked(sections):
    assert 'class="type">MeshReadError<' in sections["read"]
    assert 'class="type">KeyError<' in sections["quality"]
    assert '<a href="#METRICS"><code>METRICS</code></a>' in sections["quality"]
    assert '"high" or "low"' in sections["Metric"].replace("&#34;", '"')
    assert "depth=..." in sections["certify"], "a default that is nobody's business is not spelt"


@needs_griffe
def test_A1_guide_and_about_lead_to_it(site):
    for page in ("guide", "about"):
        assert 'href="../python/index.html"' in (site / page / "index.html").read_text("utf-8")
    assert "hex/python/" in (site / "sitemap.xml").read_text("utf-8")


def test_A1_without_the_tool_the_site_is_built_and_says_what_it_lacks(demo, monkeypatch):
    monkeypatch.setattr(interface, "installed", lambda: False)
    report = build(demo, demo.parent / "site", runtime=False)
    assert not (demo.parent / "site" / "python").exists()
    assert "python/" not in (demo.parent / "site" / "guide" / "index.html").read_text("utf-8")
    assert interface.NOT_INSTALLED in report.summary


def test_A1_text_becomes_harmless_html():
    text = "A <b> & `x < y`.\n\nSee `read`,\nand ``Mesh.points``."
    assert str(interface.prose(text)) == (
        "<p>A &lt;b&gt; &amp; <code>x &lt; y</code>.</p>"
        '<p>See <a href="#read"><code>read</code></a>, and <code>Mesh.points</code>.</p>'
    )
