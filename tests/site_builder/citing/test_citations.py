"""Citations: formatted, exported, and safe."""

import json

import pytest

from site_builder.citing.bibtex import BibtexError, csl_reference, read_bibtex
from site_builder.citing.citations import citation, plain
from site_builder.citing.exports import bibtex, csl_json, ris
from site_builder.reading.repository import _csl_item

ARTICLE = {
    "type": "article-journal",
    "title": "All-Hex Mesh Generation via Volumetric PolyCube Deformation",
    "author": [
        {"family": "Gregson", "given": "James"},
        {"family": "Sheffer", "given": "Alla"},
        {"family": "Zhang", "given": "Eugene"},
    ],
    "issued": 2011,
    "container-title": "Computer Graphics Forum",
    "volume": 30,
    "issue": 5,
    "page": "1407-1416",
    "DOI": "10.1111/j.1467-8659.2011.02015.x",
}
PREPRINT = {
    "type": "article",
    "title": "Weighted Ranking",
    "author": [{"family": "Xu", "given": "Gang"}],
    "issued": 2019,
    "arXiv": "1901.00238",
}


def item(reference):
    return _csl_item("key", reference)


def test_C2_an_article_in_apa_style():
    assert plain(citation(item(ARTICLE), "APA")) == (
        "Gregson, J., Sheffer, A., & Zhang, E. (2011). All-Hex Mesh Generation via Volumetric PolyCube Deformation. "
        "Computer Graphics Forum, 30(5), 1407–1416. https://doi.org/10.1111/j.1467-8659.2011.02015.x"
    )
    assert "<i>Computer Graphics Forum</i>" in citation(item(ARTICLE), "APA")


def test_C2_an_article_in_the_acm_style():
    assert plain(citation(item(ARTICLE), "ACM")) == (
        "James Gregson, Alla Sheffer, and Eugene Zhang. 2011. All-Hex Mesh Generation via Volumetric PolyCube "
        "Deformation. Computer Graphics Forum 30, 5 (2011), 1407–1416. https://doi.org/10.1111/j.1467-8659.2011.02015.x"
    )


def test_C2_an_article_number_stands_where_pages_would():
    reference = {**ARTICLE, "number": 121}
    del reference["page"]
    assert "30(5), Article 121." in plain(citation(item(reference), "APA"))
    assert "(2011), Article 121" in plain(citation(item(reference), "ACM"))


def test_C2_a_preprint_names_arxiv():
    text = plain(citation(item(PREPRINT), "APA"))
    assert "(arXiv:1901.00238)" in text
    assert "https://arxiv.org/abs/1901.00238" in text


@pytest.mark.parametrize("style", ["APA", "ACM"])
def test_C2_markup_in_a_reference_comes_out_as_text(style):
    attack = "<script>alert(1)</script><i onload=x>\ue000i\ue002"
    reference = {**ARTICLE, "title": attack, "container-title": attack, "volume": "<b>1</b>"}
    reference["author"] = [{"family": attack, "given": "<i>G</i>"}]
    html = citation(item(reference), style)
    assert "<script" not in html
    assert "<b>1" not in html
    assert "onload=x&gt;" in html
    allowed = ("<i>", "</i>", "<b>", "</b>", "<sup>", "</sup>", "<sub>", "</sub>")
    rest = str(html)
    for tag in allowed:
        rest = rest.replace(tag, "")
    assert "<" not in rest


def test_C2_bibtex_comes_back_as_it_went():
    entry = read_bibtex(bibtex([item(ARTICLE)]))
    assert entry.key == "key"
    assert csl_reference(entry) == {**ARTICLE, "volume": "30", "issue": "5"}


def test_C2_bibtex_escapes_what_tex_would_read():
    text = bibtex([item({**ARTICLE, "title": "50% of {braces} & $money$ \\input{/etc/passwd}"})])
    assert r"50\% of \textbraceleft{}braces\textbraceright{} \& \$money\$ \textbackslash{}input" in text
    body = text.split("title = ", 1)[1].split(",\n", 1)[0]
    assert body.count("{") == body.count("}")


def test_C2_bibtex_writes_letters_as_tex_does():
    reference = {
        **ARTICLE,
        "title": "ℓ1 “padding” – a 2×2 study of Polycube\u2010maps",
        "author": [
            {"family": "Patanè", "given": "Giuseppe"},
            {"family": "Šesták", "given": "Łukasz"},
            {"family": "Groß", "given": "François"},
            {"family": "王", "given": "Wei"},
        ],
    }
    text = bibtex([item(reference)])
    assert r"title = {{{$\ell$}1 ``padding'' -- a 2{$\times$}2 study of Polycube-maps}}" in text
    assert (
        r"Patan{\`e}, Giuseppe and {\v{S}}est{\'a}k, {\L}ukasz and Gro{\ss}, Fran{\c{c}}ois and 王, Wei"
        in text
    )
    back = csl_reference(read_bibtex(text))
    assert back["author"] == reference["author"]
    assert back["title"] == "ℓ1 “padding” – a 2×2 study of Polycube-maps"


@pytest.mark.parametrize(
    ("kind", "field"), [("thesis", "school"), ("report", "institution"), ("dataset", "howpublished")]
)
def test_C2_bibtex_has_the_field_that_a_type_wants(kind, field):
    reference = {**PREPRINT, "type": kind, "publisher": "Somebody"}
    del reference["arXiv"]
    assert f"  {field} = {{Somebody}}" in bibtex([item(reference)])


def test_C2_ris_has_the_tags_that_managers_read():
    lines = ris([item(ARTICLE)]).split("\r\n")
    assert lines[0] == "TY  - JOUR"
    assert "AU  - Gregson, James" in lines
    assert "SP  - 1407" in lines
    assert "EP  - 1416" in lines
    assert "DO  - 10.1111/j.1467-8659.2011.02015.x" in lines
    assert lines[-2] == "ER  - "


def test_C2_csl_json_is_what_processors_take():
    (read,) = json.loads(csl_json([item(PREPRINT)]))
    assert read["issued"] == {"date-parts": [[2019]]}
    assert read["number"] == "arXiv:1901.00238"
    assert "arXiv" not in read


ACM_ENTRY = r"""
% from the publisher's page
@comment{nothing}
@article{10.1145/3528223.3530123,
    author = {Br\"{u}ckler, Hendrik and Bommes, David and Patan\`e, G. and {\'E}tienne de la Tour},
    title = {Volume parametrization {quantization} for   hexahedral
       meshing \& more},
    year = {2022}, month = jul, volume = {41}, number = {4}, articleno = {60}, numpages = {19},
    journal = "ACM Trans. " # "Graph.",
    url = {https://doi.org/10.1145/3528223.3530123}
}
"""


def test_C6_a_publishers_bibtex_is_read():
    assert csl_reference(read_bibtex(ACM_ENTRY)) == {
        "type": "article-journal",
        "title": "Volume parametrization quantization for hexahedral meshing & more",
        "author": [
            {"family": "Brückler", "given": "Hendrik"},
            {"family": "Bommes", "given": "David"},
            {"family": "Patanè", "given": "G."},
            {"family": "de la Tour", "given": "Étienne"},
        ],
        "issued": "2022-07",
        "container-title": "ACM Trans. Graph.",
        "volume": "41",
        "issue": "4",
        "number": "60",
        "DOI": "10.1145/3528223.3530123",
    }


AUTHORS_OWN_ENTRY = r"""
% @article{commented, title = {Not this}, author = {A B}, year = 1999}
@comment{ @article{put-aside, title = {Nor this}, author = {A B}, year = 1999} }
@string{eg = "Eurographics"}
@phdthesis{key,
    author = {{The CGAL Project} and {Barnes and Noble} and Erd{\H{o}}s, P{\'a}l and Le Brun, Jr., Andr\'e
       and Ludwig van Beethoven and others},
    title = {A ``Quoted'' <i>Hexahedral</i> Title},
    school = {Universit\'{e} de Lorraine}, series = eg, year = 2022
}
"""


def test_C6_an_authors_own_bibtex_is_read():
    entry = read_bibtex(AUTHORS_OWN_ENTRY)
    assert entry.fields["series"] == "Eurographics"
    assert csl_reference(entry) == {
        "type": "thesis",
        "title": "A “Quoted” Hexahedral Title",
        "author": [
            {"literal": "The CGAL Project"},
            {"literal": "Barnes and Noble"},
            {"family": "Erdős", "given": "Pál"},
            {"family": "Le Brun Jr.", "given": "André"},
            {"family": "van Beethoven", "given": "Ludwig"},
        ],
        "issued": 2022,
        "publisher": "Université de Lorraine",
    }


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("no bibtex here", "no entry"),
        ("@article{key,\n title = {open", "can't be read, line 2"),
        ("@article{key, title = {T}}", "lacks author, year"),
        ("@article{key, title = {T}, author = {A}, year = {soon}}", "is no year"),
    ],
)
def test_C6_bibtex_that_cannot_be_used_says_why(text, message):
    with pytest.raises(BibtexError, match=message):
        csl_reference(read_bibtex(text))
