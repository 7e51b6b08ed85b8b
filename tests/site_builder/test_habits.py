"""What others join by: forms that ask, hooks that run what CI runs, documents that name what is there."""

import re
from pathlib import Path

import pytest
import yaml

import hexalab

ROOT = Path(__file__).resolve().parents[2]
FORMS = sorted((ROOT / ".github" / "ISSUE_TEMPLATE").glob("[!c]*.yml"))


def text_of(name):
    return (ROOT / name).read_text("utf-8")


def test_C6_there_is_a_form_for_a_mesh_a_number_and_a_wish():
    assert {file.stem for file in FORMS} == {"mesh_read_wrongly", "wrong_number", "wish"}
    assert yaml.safe_load(text_of(".github/ISSUE_TEMPLATE/config.yml")) == {"blank_issues_enabled": True}


@pytest.mark.parametrize("file", FORMS, ids=lambda file: file.stem)
def test_C6_an_issue_form_is_one_that_the_host_takes(file):
    form = yaml.safe_load(file.read_text("utf-8"))
    assert form["name"] and form["description"]
    ids = [field["id"] for field in form["body"]]
    assert len(set(ids)) == len(ids)
    for field in form["body"]:
        assert field["type"] in ("textarea", "input")
        assert field["attributes"]["label"]
    assert any(field.get("validations", {}).get("required") for field in form["body"])


def test_C6_hooks_run_the_tools_of_make_lint():
    makefile = text_of("Makefile")
    parts = re.search(r"^lint: (.+)$", makefile, re.MULTILINE)[1].split()
    recipes = [re.search(rf"^{part}:.*\n((?:\t.*\n)+)", makefile, re.MULTILINE)[1] for part in parts]
    lines = "".join(recipes).replace("$(BIN)", ".venv/bin").splitlines()
    linted = {" ".join(line.split()[:2]) for line in lines}
    hooks = [
        hook for repo in yaml.safe_load(text_of(".pre-commit-config.yaml"))["repos"] for hook in repo["hooks"]
    ]
    run = {" ".join(hook["entry"].split()[:2]) for hook in hooks}
    assert {command.split(" -")[0] for command in linted} == {command.split(" -")[0] for command in run}
    assert all(hook["language"] == "system" for hook in hooks)


def test_C6_the_changelog_tells_of_this_version_and_of_what_comes():
    titles = re.findall(r"^## \[(.+?)\]", text_of("CHANGELOG.md"), re.MULTILINE)
    assert titles[:2] == ["Unreleased", hexalab.__version__]


@pytest.mark.parametrize("name", ["README.md", "CONTRIBUTING.md", "SECURITY.md"])
def test_C6_documents_name_what_is_there(name):
    text = text_of(name)
    links = [link for link in re.findall(r"\]\(([^)#]+)\)", text) if "://" not in link]
    missing = [link for link in links if not (ROOT / link).exists()]
    assert missing == []
    folder = ""
    for row in re.findall(r"^\| (`[^|]*/`(?:, `[^|]*/`)*) \|", text, re.MULTILINE):
        for path in re.findall(r"`([^`]+/)`", row):
            folder = path.split("/")[0] if (ROOT / path).is_dir() else folder
            assert (ROOT / path).is_dir() or (ROOT / folder / path).is_dir(), path


def test_C6_the_readme_opens_with_the_picture_and_the_two_commands():
    text = text_of("README.md")
    order = [text.index(part) for part in ("![", "For those who", "make serve", "make test", "## What it is")]
    assert order == sorted(order)
