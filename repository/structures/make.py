"""Structures: how the inside of a hexahedral mesh can be put together."""

import numpy as np
from making.flat import disc, fan, join, rectangle
from making.refinement import HALVES, THIRDS, edge_transition, tiled, transition
from making.solid import box, extrude, moved, outward, polycube, unite
from making.writing import medit, vtk


def valence(number):
    """A column of cells around one straight irregular edge."""
    return extrude(fan(number, 5), np.linspace(0, 1.5, 9))


def l_polycube():
    blocks = np.ones((2, 1, 2))
    blocks[1, :, 1] = 0
    return polycube(blocks, 5)


def staircase():
    steps = np.zeros((3, 2, 3))
    for i in range(3):
        steps[i, :, : 3 - i] = 1
    return polycube(steps, 3)


def tunnels():
    middle = np.arange(3) == 1
    return polycube(np.add.outer(np.add.outer(middle * 1, middle * 1), middle * 1) < 2, 3)


def padded_cube():
    """A grid with one more layer of cells inserted under its whole surface."""
    n, core = 5, 0.6
    points, cells = box(n, n, n, (2.0, 2.0, 2.0))
    parts = [(core * (points - 1.0), cells)]
    flat, quads = rectangle(n, n, 2.0, 2.0)
    for axis in range(3):
        for sign in (-1.0, 1.0):
            surface = np.full((len(flat), 3), sign)
            surface[:, (axis + 1) % 3], surface[:, (axis + 2) % 3] = (flat - 1.0).T
            shell = np.concatenate([core * surface, 0.8 * surface, surface])
            count = len(flat)
            layers = [np.concatenate([quads + k * count, quads + (k + 1) * count], axis=1) for k in (0, 1)]
            parts.append((shell, np.concatenate(layers)))
    return unite(*parts)


def ring():
    """A regular grid bent until its ends meet."""
    points, cells = box(40, 4, 4)
    angle = 2 * np.pi * points[:, 0]
    radius = 1.2 + 0.6 * (points[:, 1] - 0.5)
    bent = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0.6 * (points[:, 2] - 0.5)], 1)
    return outward(*join(bent, cells))


def three_refinement():
    """A coarse layer, a layer of templates, and a fine layer of nine cells for one."""
    fine, fine_cells = box(9, 9, 3, (3.0, 3.0, 1.0))
    coarse, coarse_cells = box(3, 3, 1, (3.0, 3.0, 1.0))
    return unite(
        (fine, fine_cells),
        tiled(transition(THIRDS), 3, 3, corner=(0, 0, 1)),
        (moved(coarse, 0, 0, 2.0), coarse_cells),
    )


def two_refinement():
    """A coarse layer, a layer of templates, and a fine layer of four cells for one."""
    fine, fine_cells = box(8, 8, 2, (4.0, 4.0, 1.0))
    coarse, coarse_cells = box(4, 4, 1, (4.0, 4.0, 1.0))
    return unite(
        (fine, fine_cells),
        tiled(transition(HALVES), 2, 2, size=2.0, corner=(0, 0, 1)),
        (moved(coarse, 0, 0, 3.0), coarse_cells),
    )


def edge_refinement():
    """Templates refined in one direction only, side by side."""
    return tiled(edge_transition(THIRDS, 3), 4, 1)


def octree():
    """Two transitions in a row: 81 cells below for one above."""
    finest, finest_cells = box(18, 18, 2, (2.0, 2.0, 0.25))
    middle, middle_cells = box(6, 6, 1, (2.0, 2.0, 0.25))
    coarse, coarse_cells = box(2, 2, 1, (2.0, 2.0, 0.75))
    small = tiled(transition(THIRDS), 6, 6, size=1 / 3, corner=(0, 0, 0.25))
    large = tiled(transition(THIRDS), 2, 2, corner=(0, 0, 0.25 + 1 / 3 + 0.25))
    top = 0.25 + 1 / 3 + 0.25 + 1
    return unite(
        (finest, finest_cells),
        small,
        (moved(middle, 0, 0, 0.25 + 1 / 3), middle_cells),
        large,
        (moved(coarse, 0, 0, top), coarse_cells),
    )


def self_crossing():
    """A strip of cells that leaves a block, runs round and enters it again from above: its sheets cross themselves."""
    n, steps = 4, 28
    block = rectangle(n, n)
    across = np.linspace(0, 1, n + 1)
    angles_in = np.linspace(5 * np.pi / 4, 13 * np.pi / 4, steps + 1)
    start, end = np.arctan2(-2, -1) + 2 * np.pi, np.arctan2(-1, -2) + 4 * np.pi
    angles_out = np.linspace(start, end, steps + 1)
    inner = 2 + np.sqrt(2) * np.stack([np.cos(angles_in), np.sin(angles_in)], 1)
    outer = 2 + np.sqrt(5) * np.stack([np.cos(angles_out), np.sin(angles_out)], 1)
    points = np.concatenate([(1 - t) * outer + t * inner for t in across])
    ids = np.arange(len(points)).reshape(n + 1, steps + 1)
    quads = np.stack([ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]], axis=-1).reshape(-1, 4)
    flat = join(np.concatenate([block[0], points]), np.concatenate([block[1], quads + len(block[0])]))
    return extrude(flat, np.linspace(0, 0.6, 4))


def moebius():
    """A bar turned by half round and closed: its cells fit, though top and bottom change places."""
    count, n = 48, 4
    angle = 2 * np.pi * np.arange(count) / count
    section, quads = rectangle(n, n, 1.0, 1.0)
    layers = []
    for a in angle:
        u, v = (section - 0.5).T * np.array([[0.9], [0.35]])
        c, s = np.cos(a / 2), np.sin(a / 2)
        radius, height = 1.6 + c * u - s * v, s * u + c * v
        layers.append(np.stack([radius * np.cos(a), radius * np.sin(a), height], 1))
    stride = len(section)
    turned = np.arange(stride)[::-1]
    cells = [np.concatenate([quads + k * stride, quads + (k + 1) * stride], 1) for k in range(count - 1)]
    cells.append(np.concatenate([quads + (count - 1) * stride, turned[quads]], 1))
    return outward(np.concatenate(layers), np.concatenate(cells))


def mixed():
    """Hexahedra below, a layer of pyramids and tetrahedra above them, wedges at one side."""
    points, cells = box(4, 4, 2, (4.0, 4.0, 2.0))
    top = np.array([[i + 5 * j + 50 for i in range(5)] for j in range(5)])
    apexes = np.array([[i + 0.5, j + 0.5, 2.6] for j in range(4) for i in range(4)])
    apex = len(points) + np.arange(16).reshape(4, 4)
    pyramids = [
        [top[j, i], top[j, i + 1], top[j + 1, i + 1], top[j + 1, i], apex[j, i]]
        for j in range(4)
        for i in range(4)
    ]
    tetrahedra = []
    for j in range(4):
        for i in range(3):
            tetrahedra.append([apex[j, i], apex[j, i + 1], top[j, i + 1], top[j + 1, i + 1]])
    for j in range(3):
        for i in range(4):
            tetrahedra.append([apex[j, i], apex[j + 1, i], top[j + 1, i + 1], top[j + 1, i]])
    ridge = np.array([[4.8, j, 0.0] for j in range(5)])
    start = len(points) + 16
    wedges = []
    for j in range(4):
        low, high = 4 + 5 * j, 4 + 5 * (j + 1)
        wedges.append([low, low + 25, start + j, high, high + 25, start + j + 1])
    return (
        np.concatenate([points, apexes, ridge]), cells,
        {"Pyramids": pyramids, "Tetrahedra": tetrahedra, "Prisms": wedges},
    )  # fmt: skip


def collapsed():
    """A cylinder whose innermost cells repeat two vertices on the axis, as At-Most-Hexa meshes do."""
    around, rings, layers = 12, 3, 5
    angle = 2 * np.pi * np.arange(around) / around
    radius = np.linspace(0, 1, rings + 1)[1:]
    flat = np.concatenate([[[0, 0]]] + [r * np.stack([np.cos(angle), np.sin(angle)], 1) for r in radius])
    ids = 1 + np.arange(around * rings).reshape(rings, around)
    right = np.roll(ids, -1, axis=1)
    centre = np.zeros(around, dtype=int)
    quads = [np.stack([centre, ids[0], right[0], centre], 1)]
    quads += [np.stack([ids[k], ids[k + 1], right[k + 1], right[k]], 1) for k in range(rings - 1)]
    return extrude((flat, np.concatenate(quads)), np.linspace(0, 1.5, layers + 1))


def heated_plate():
    """A graded plate with a temperature at its vertices and a material in its cells."""
    points, cells = box(16, 12, 2, (4.0, 3.0, 0.3))
    points[:, 0] = 4 * (points[:, 0] / 4) ** 1.4
    x, y, _ = points.T
    temperature = 20 + 80 * np.exp(-((x - 1.0) ** 2) - (y - 1.5) ** 2)
    middle = points[cells].mean(axis=1)
    material = (middle[:, 0] > 2.0) + 1.0 * (middle[:, 1] > 2.0)
    return vtk(points, cells, "graded plate", {"material": material}, {"temperature": temperature})


def cylinder_core():
    """The O-grid of a cylinder, coarse enough to count: four irregular edges of valence three run along it."""
    return extrude(disc(2, 2), np.linspace(0, 2, 7))


SOLIDS = {
    **{f"valence-{number}": lambda number=number: valence(number) for number in (3, 5, 6, 8)},
    "l-polycube": l_polycube, "staircase": staircase, "tunnels": tunnels, "padded-cube": padded_cube, "ring": ring,
    "moebius": moebius, "two-refinement": two_refinement, "three-refinement": three_refinement,
    "edge-refinement": edge_refinement, "octree": octree, "self-crossing": self_crossing, "collapsed": collapsed,
    "o-grid": cylinder_core,
}  # fmt: skip

FILES = {f"{name}.mesh": lambda solid=solid: medit(*solid()) for name, solid in SOLIDS.items()}


def _mixed_file():
    points, cells, others = mixed()
    return medit(points, cells, **others)


FILES["mixed.mesh"] = _mixed_file
FILES["heated-plate.vtk"] = heated_plate
