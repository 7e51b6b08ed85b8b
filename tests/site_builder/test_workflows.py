"""What runs on the code host: a contribution's scripts get a token that can only read, no action changes unseen."""

import re
import tomllib
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / ".github" / "workflows"
FILES = sorted(FOLDER.glob("*.yml"))


def steps(workflow):
    return [step for job in workflow["jobs"].values() for step in job["steps"]]


def triggers(workflow):
    """PyYAML reads the key `on` as YAML 1.1 does: as true."""
    return workflow[True]


WRITES = {
    "collect.propose": {"contents", "pull-requests"},
    "pages.deploy": {"pages", "id-token"},
    "release.publish": {"id-token"},
    "release.attach": {"contents"},
}
"""What jobs may write; all others nothing."""


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_C6_actions_are_pinned_by_commit(file):
    used = [step["uses"] for step in steps(yaml.safe_load(file.read_text("utf-8"))) if "uses" in step]
    assert used
    for action in used:
        assert re.fullmatch(r"[\w-]+/[\w-]+@[0-9a-f]{40}", action), action


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_C6_the_token_can_read_alone_and_is_not_left_behind(file):
    workflow = yaml.safe_load(file.read_text("utf-8"))
    assert workflow["permissions"] == {"contents": "read"}
    for name, job in workflow["jobs"].items():
        assert job["timeout-minutes"] <= 120
        writes = {key for key, value in job.get("permissions", {}).items() if value == "write"}
        assert writes == WRITES.get(f"{file.stem}.{name}", set())
        assert not (writes and any("run" in step for step in job["steps"])), (
            "only actions may hold such a token"
        )
    for step in steps(workflow):
        if step.get("uses", "").startswith("actions/checkout@"):
            assert step["with"]["persist-credentials"] is False
        assert "${{ github.event" not in step.get("run", ""), "what strangers write never becomes a script"
    assert "secrets." not in file.read_text("utf-8")


def test_C6_contributions_run_on_pull_request_alone():
    workflow = yaml.safe_load((FOLDER / "validate.yml").read_text("utf-8"))
    assert list(triggers(workflow)) == ["pull_request"]
    assert "repository/**" in triggers(workflow)["pull_request"]["paths"]
    (upload,) = [step for step in steps(workflow) if "upload-artifact" in step.get("uses", "")]
    assert "build/site" in upload["with"]["path"].split(), "the pages come with their styles"


def test_C8_what_was_collected_is_proposed_and_nothing_else():
    workflow = yaml.safe_load((FOLDER / "collect.yml").read_text("utf-8"))
    assert set(triggers(workflow)) == {"schedule", "workflow_dispatch"}
    collect, propose = workflow["jobs"]["collect"], workflow["jobs"]["propose"]
    assert any("hexalab collect --check" in step.get("run", "") for step in collect["steps"])
    assert propose["needs"] == "collect"
    (proposal,) = [step for step in propose["steps"] if "create-pull-request" in step["uses"]]
    assert proposal["with"]["add-paths"] == "repository"


def test_C6_the_site_is_built_for_the_address_where_it_will_be():
    workflow = yaml.safe_load((FOLDER / "pages.yml").read_text("utf-8"))
    build, deploy = workflow["jobs"]["build"], workflow["jobs"]["deploy"]
    assert build["permissions"] == {"contents": "read", "pages": "read"}
    assert deploy["needs"] == "build"
    assert deploy["permissions"] == {"pages": "write", "id-token": "write"}
    (step,) = [step for step in build["steps"] if "HEXALAB_SITE_ADDRESS" in step.get("env", {})]
    assert "--strict" in step["run"]


def test_C6_every_pull_request_is_tested_as_a_whole():
    workflow = yaml.safe_load((FOLDER / "ci.yml").read_text("utf-8"))
    assert triggers(workflow) == {"pull_request": None, "push": {"branches": ["main"]}}
    assert workflow["concurrency"]["group"].endswith("${{ github.ref }}")
    assert "pull_request" in workflow["concurrency"]["cancel-in-progress"]
    assert [step["run"] for step in workflow["jobs"]["everything"]["steps"] if "run" in step] == [".ci/run"]
    assert "make lint test" in (ROOT / ".ci" / "run").read_text("utf-8")


def test_C6_the_core_is_tested_on_every_python_and_system():
    job = yaml.safe_load((FOLDER / "ci.yml").read_text("utf-8"))["jobs"]["core"]
    matrix = job["strategy"]["matrix"]
    assert {system.split("-")[0] for system in matrix["system"]} == {"ubuntu", "macos", "windows"}
    assert job["runs-on"] == "${{ matrix.system }}"
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert matrix["python"] == ["3.11", "3.12", "3.13", "3.x"]
    assert project["requires-python"] == f">={matrix['python'][0]}"
    install, test = (step["run"] for step in job["steps"] if "run" in step)
    (numpy,) = [package for package in project["dependencies"] if package.startswith("numpy")]
    assert f'"{numpy}" pytest hypothesis' in install
    assert test == "python -m pytest tests/core tests/repro"


def test_C6_hypothesis_repeats_itself_on_a_pull_request_and_draws_anew_at_night():
    from hypothesis import settings

    assert settings.get_profile("ci").derandomize
    assert not settings.get_profile("nightly").derandomize
    for profile in ("here", "ci", "nightly"):
        assert settings.get_profile(profile).deadline is None, "no test asserts seconds"
    workflow = yaml.safe_load((FOLDER / "nightly.yml").read_text("utf-8"))
    assert set(triggers(workflow)) == {"schedule", "workflow_dispatch"}
    assert [step["run"] for step in steps(workflow) if "run" in step] == ["make nightly"]
    recipe = (ROOT / "Makefile").read_text("utf-8").split("\nnightly:")[1].split("\n\n")[0]
    assert "--hypothesis-profile=nightly" in recipe
    assert '-m "nightly or hypothesis"' in recipe


def test_A4_a_release_is_tested_and_published_without_a_token_that_is_kept():
    workflow = yaml.safe_load((FOLDER / "release.yml").read_text("utf-8"))
    assert triggers(workflow) == {"push": {"tags": ["v*.*.*"]}}
    build, publish, attach = (workflow["jobs"][name] for name in ("build", "publish", "attach"))
    runs = [step["run"] for step in build["steps"] if "run" in step]
    assert "make lint test" in runs and "make wheel" in runs[-1]
    assert (publish["needs"], attach["needs"]) == ("build", "publish")
    (upload,) = [step for step in publish["steps"] if "pypi-publish" in step["uses"]]
    assert "with" not in upload and "secrets." not in (FOLDER / "release.yml").read_text("utf-8")
