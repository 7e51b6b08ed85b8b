"""Measuring and portraying one remote mesh: in this process, in another, or on a machine of a cluster."""

from __future__ import annotations

import base64
import hashlib
import json
from io import BytesIO
from pathlib import Path
from typing import Any

from PIL import Image

from hexalab.errors import HexaLabError
from hexalab.hosts.headless import RenderError
from hexalab.hosts.labour import Craft
from hexalab.hosts.offers import BytesOffer
from hexalab.hosts.rendering import Bench

from ..measuring.measurer import measure
from ..model.facts import Facts
from ..pictures.portrait import portrait
from ..pictures.shot import STYLE, Status
from ..pictures.studio import DIRECTIONS
from .jobs import CollectJob, Outcome, failed

WIDTH, HEIGHT = 480, 320
FINENESS = 2
"""How many times larger a picture is drawn than it is kept: edges come out smooth."""

QUALITY = 80
"""Of WebP: at 480 x 320 some ten kilobytes."""

BENCH = Bench(DIRECTIONS)


def run(values: dict[str, Any]) -> Outcome:
    """Do a job, a dict of `CollectJob.as_dict`; what goes wrong with its mesh is told in the outcome."""
    job = CollectJob.of_dict(values)
    own = CollectJob("", "", "", "", "").version
    if job.version != own:
        return failed(job, f"this worker has HexaLab {own}, the job was made by {job.version}")
    try:
        data = Path(job.file).read_bytes()
        facts = measured(job, data)
        status = portrait(facts)
        picture = pictured(BytesOffer(job.name, data), status)
    except RenderError as error:
        BENCH.clear()
        return failed(job, str(error))
    except (HexaLabError, OSError, MemoryError) as error:
        return failed(job, str(error) or type(error).__name__)
    shows = shown(facts.sha256 or "", status)
    told = base64.b64encode(picture).decode()
    return Outcome(id=job.id, facts=facts.to_dict(), picture=told, shows=shows, problem="")


def measured(job: CollectJob, data: bytes) -> Facts:
    """The facts of a job's mesh, if it is the one that source.yaml names.

    Raises
    ------
    HexaLabError
        It is another, or can't be read.
    """
    found = hashlib.sha256(data).hexdigest()
    if job.sha256 and found != job.sha256:
        raise HexaLabError(
            f"another file than source.yaml names: found SHA-256 {found}, expected {job.sha256}"
        )
    return measure(data, job.name, job.up)


def pictured(mesh: BytesOffer, status: Status) -> bytes:
    """The portrait of a mesh, a WebP."""
    drawn = BENCH.ready().render(mesh, status, width=FINENESS * WIDTH, height=FINENESS * HEIGHT)
    if drawn.rejections:
        raise HexaLabError(f"the status of its portrait is wrong: {drawn.rejections}")
    out = BytesIO()
    image = Image.open(BytesIO(drawn.data)).convert("RGB").resize((WIDTH, HEIGHT), Image.Resampling.LANCZOS)
    image.save(out, "WEBP", quality=QUALITY, method=6)
    return out.getvalue()


def shown(sha256: str, status: Status) -> str:
    """What a portrait shows, as a hash: while that is the same, the picture is."""
    parts = [STYLE, sha256, status, WIDTH, HEIGHT, FINENESS, QUALITY]
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:32]


def finish() -> None:
    """Close the browser."""
    BENCH.clear()


CRAFT: Craft[CollectJob, Outcome] = Craft(__name__, failed)
