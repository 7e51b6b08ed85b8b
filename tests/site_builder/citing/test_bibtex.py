"""SPEC C6: entries as publishers, preprint servers, managers and authors write them, and the CSL that they are."""

from __future__ import annotations

from typing import Any

import pytest

from site_builder.citing.bibtex import csl_reference, read_bibtex, untex

ENTRIES: dict[str, tuple[str, dict[str, Any]]] = {
    "parentheses": (
        r"""@article(key, author = "Gao, Xifeng and Panozzo, Daniele", title = {A {T}itle}, journal = {TOG},
            year = 2017, volume = {36}, number = {4}, pages = {114:1--114:13}, articleno = {114})""",
        {
            "type": "article-journal", "title": "A Title", "issued": 2017, "container-title": "TOG", "volume": "36",
            "issue": "4", "number": "114",
            "author": [{"family": "Gao", "given": "Xifeng"}, {"family": "Panozzo", "given": "Daniele"}],
        },
    ),
    "biblatex, as Zotero exports it": (
        r"""@article{livesuLoopyCutsPracticalFeaturepreserving2020,
            title = {{{LoopyCuts}}: Practical Feature-Preserving Block Decomposition for Strongly Hex-Dominant Meshing},
            shorttitle = {{{LoopyCuts}}},
            author = {Livesu, Marco and Pietroni, Nico and Puppo, Enrico and Sheffer, Alla and Cignoni, Paolo},
            date = {2020-07-08}, journaltitle = {ACM Transactions on Graphics}, shortjournal = {ACM Trans. Graph.},
            volume = {39}, number = {4}, pages = {121:121:1--121:121:17}, issn = {0730-0301},
            doi = {10.1145/3386569.3392472}, url = {https://dl.acm.org/doi/10.1145/3386569.3392472},
            urldate = {2024-01-31}, langid = {english}}""",
        {
            "type": "article-journal",
            "title": "LoopyCuts: Practical Feature-Preserving Block Decomposition for Strongly Hex-Dominant Meshing",
            "issued": "2020-07", "container-title": "ACM Transactions on Graphics", "volume": "39", "issue": "4",
            "page": "121:121:1-121:121:17", "DOI": "10.1145/3386569.3392472",
            "author": [
                {"family": "Livesu", "given": "Marco"}, {"family": "Pietroni", "given": "Nico"},
                {"family": "Puppo", "given": "Enrico"}, {"family": "Sheffer", "given": "Alla"},
                {"family": "Cignoni", "given": "Paolo"},
            ],
        },
    ),
    "Wiley": (
        r"""@article{https://doi.org/10.1111/cgf.13100,
            author = {Livesu, M. and Muntoni, A. and Puppo, E. and Scateni, R.},
            title = {Skeleton-driven Adaptive Hexahedral Meshing of Tubular Shapes},
            journal = {Computer Graphics Forum}, volume = {35}, number = {7}, pages = {237-246},
            keywords = {Categories and Subject Descriptors (according to ACM CCS), I.3.5},
            doi = {https://doi.org/10.1111/cgf.13021}, url = {https://onlinelibrary.wiley.com/doi/abs/10.1111/cgf.13021},
            abstract = {Abstract 100\% of tubes}, year = {2016}}""",
        {
            "type": "article-journal", "title": "Skeleton-driven Adaptive Hexahedral Meshing of Tubular Shapes",
            "issued": 2016, "container-title": "Computer Graphics Forum", "volume": "35", "issue": "7",
            "page": "237-246", "DOI": "10.1111/cgf.13021",
            "author": [
                {"family": "Livesu", "given": "M."}, {"family": "Muntoni", "given": "A."},
                {"family": "Puppo", "given": "E."}, {"family": "Scateni", "given": "R."},
            ],
        },
    ),
    "Elsevier": (
        r"""@article{BRACCI201924, title = {HexaLab.net: An online viewer for hexahedral meshes},
            journal = {Computer-Aided Design}, volume = {110}, pages = {24-36}, year = {2019}, issn = {0010-4485},
            doi = {https://doi.org/10.1016/j.cad.2018.12.003},
            author = {Matteo Bracci and Marco Tarini and Nico Pietroni and Marco Livesu and Paolo Cignoni}}""",
        {
            "type": "article-journal", "title": "HexaLab.net: An online viewer for hexahedral meshes", "issued": 2019,
            "container-title": "Computer-Aided Design", "volume": "110", "page": "24-36",
            "DOI": "10.1016/j.cad.2018.12.003",
            "author": [
                {"family": "Bracci", "given": "Matteo"}, {"family": "Tarini", "given": "Marco"},
                {"family": "Pietroni", "given": "Nico"}, {"family": "Livesu", "given": "Marco"},
                {"family": "Cignoni", "given": "Paolo"},
            ],
        },
    ),
    "arXiv": (
        r"""@misc{reberol2019robust, title={Robust Hex-Dominant Mesh Generation}, author={Maxence Reberol},
            year={2019}, eprint={1901.00238}, archivePrefix={arXiv}, primaryClass={cs.CG},
            url={https://arxiv.org/abs/1901.00238}}""",
        {
            "type": "article", "title": "Robust Hex-Dominant Mesh Generation", "issued": 2019, "arXiv": "1901.00238",
            "author": [{"family": "Reberol", "given": "Maxence"}],
        },
    ),
    "a proceedings, by crossref": (
        r"""@inproceedings{a, author = {Le, H\'el\`ene}, title = {Of $\ell_1$ and $2\times 2$}, crossref = {imr},
            pages = {1--9}}
            @proceedings{imr, title = {28th International Meshing Roundtable}, year = {2019}, month = oct,
            publisher = {Zenodo}}""",
        {
            "type": "paper-conference", "title": "Of ℓ_1 and 2×2", "issued": "2019-10",
            "container-title": "28th International Meshing Roundtable", "page": "1-9",
            "author": [{"family": "Le", "given": "Hélène"}],
        },
    ),
    "a thesis of biblatex": (
        r"""@thesis{t, type = {phdthesis}, author = {von der Heide, Jr., J{\"u}rgen}, title = {Netze},
            subtitle = {Eine Studie},
            institution = {RWTH Aachen}, location = {Aachen}, date = {2018/2019}}""",
        {
            "type": "thesis", "title": "Netze: Eine Studie", "issued": 2018, "publisher": "RWTH Aachen",
            "author": [{"family": "von der Heide Jr.", "given": "Jürgen"}],
        },
    ),
    "a data set": (
        r"""@dataset{zenodo, author = {{The Mesh Group}}, title = {HexMe: 63 models}, month = {3}, year = 2022,
            publisher = {Zenodo}, version = {v1.0}, doi = {10.5281/zenodo.6405151}}""",
        {
            "type": "dataset", "title": "HexMe: 63 models", "issued": "2022-03", "publisher": "Zenodo",
            "DOI": "10.5281/zenodo.6405151", "author": [{"literal": "The Mesh Group"}],
        },
    ),
    "IEEE, with commands and a macro of its own": (
        r"""@string{tvcg = {IEEE Transactions on Visualization and Computer Graphics}}
            @ARTICLE{9000000, author={M{\"o}ller, Torsten and {\L}ukasz, {\v{S}}imon}, journal=tvcg,
            title={\emph{Sharp} features: \textbf{edges} \& corners in 3\textsuperscript{rd} \'Edition -- na{\"\i}ve?},
            year={2021}, volume={27}, number={12}, pages={4000-4010}, doi={10.1109/TVCG.2020.1\_2}}""",
        {
            "type": "article-journal", "issued": 2021,
            "title": "Sharp features: edges & corners in 3rd Édition – naïve?",
            "container-title": "IEEE Transactions on Visualization and Computer Graphics", "volume": "27",
            "issue": "12", "page": "4000-4010", "DOI": "10.1109/TVCG.2020.1_2",
            "author": [{"family": "Möller", "given": "Torsten"}, {"family": "Łukasz", "given": "Šimon"}],
        },
    ),
    "a page of the web": (
        r"""@online{w, author = {Doe, Jane}, title = {A \ {line} break}, date = {2023-11}, url = {https://x.org/a_b}}""",
        {
            "type": "article", "title": "A line break", "issued": "2023-11",
            "author": [{"family": "Doe", "given": "Jane"}],
        },
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", ENTRIES)
def test_C6_ten_usual_entries(name: str) -> None:
    text, reference = ENTRIES[name]
    assert csl_reference(read_bibtex(text)) == reference


@pytest.mark.parametrize(
    ("tex", "text"),
    [
        (r"\c{c}\'{\i}\v z{\ss}\aa", "çížßå"),
        (r"``a'' -- b --- c~d", "“a” – b — c d"),
        (r"10\,000 cells, 50\% of \$5", "10 000 cells, 50% of $5"),
        (r"\url{https://x.org/a}", "https://x.org/a"),
        (r"\textit{a} {\sc b} \unknown{c}", "a b c"),
    ],
)
def test_C6_tex_becomes_text(tex: str, text: str) -> None:
    assert untex(tex) == text
