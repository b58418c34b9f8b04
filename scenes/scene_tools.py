# SPDX-License-Identifier: MIT
"""Shapes on an exact grid, and the writer of the project's scene JSON (docs/scene-format.md).

Every coordinate is a whole number of grid steps of 1/64 m, held as an int until it is written.
A body is the convex hull of its points, found in integers: it is closed, convex and wound
anticlockwise from outside by construction, and every polygon of more than three vertices is
exactly planar.
"""

import json
import math
from itertools import combinations

GRID = 64


def to_grid(metres):
    """Grid steps of a length that must lie on the grid."""
    steps = metres * GRID
    if steps != int(steps):
        raise ValueError(f"{metres} m is not a multiple of 1/{GRID} m")
    return int(steps)


def snap(metres, step=1 / GRID):
    """The multiple of `step` nearest to a length."""
    return round(metres / step) * step


class Frame:
    """A place on the ground. The axes are turned by a vector of sixteenths, so that a turned
    shape stays on the grid and its planes stay planes; its length may differ a little from 16,
    which scales the plan by as much."""

    def __init__(self, x, y, z=0, turn=(16, 0)):
        self.origin = (x, y, z)
        self.turn = turn

    def place(self, point):
        c, s = self.turn
        x, y, z = point
        ox, oy, oz = self.origin
        return (to_grid(ox + (c * x - s * y) / 16),
                to_grid(oy + (s * x + c * y) / 16),
                to_grid(oz + z))


# --- Points of shapes, in metres, in a frame's own axes ---------------------------------------

def box(x0, x1, y0, y1, z0, z1):
    return [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]


def along_y(profile, y0, y1):
    """A prism along y over a profile of (x, z)."""
    return [(x, y, z) for y in (y0, y1) for x, z in profile]


def along_x(profile, x0, x1):
    """A prism along x over a profile of (y, z)."""
    return [(x, y, z) for x in (x0, x1) for y, z in profile]


def upright(plan, z0, z1):
    """A prism along z over a plan of (x, y)."""
    return [(x, y, z) for z in (z0, z1) for x, y in plan]


def ring(sides, radius, phase=0.5, step=1 / 4):
    """A regular polygon, anticlockwise, rounded to `step`."""
    angles = (2 * math.pi * (i + phase) / sides for i in range(sides))
    return [(snap(radius * math.cos(a), step), snap(radius * math.sin(a), step)) for a in angles]


def scaled(plan, factor):
    """A plan scaled by sixteenths: its edges stay parallel to those of `plan`, exactly."""
    return [(x * factor / 16, y * factor / 16) for x, y in plan]


def taper(plan, z0, factor, z1):
    """A frustum: `plan` at z0, scaled by `factor` sixteenths at z1."""
    return [(x, y, z0) for x, y in plan] + [(x, y, z1) for x, y in scaled(plan, factor)]


def shifted(points, dx=0, dy=0, dz=0):
    return [(x + dx, y + dy, z + dz) for x, y, z in points]


def mirrored(points):
    """The same shape on the other side of x = 0."""
    return [(-x, y, z) for x, y, z in points]


# --- Convex hulls in integers ------------------------------------------------------------------

def subtract(a, b):
    return tuple(p - q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def plan_hull(points):
    """Indices of the strict convex hull of points of the plane, anticlockwise."""
    order = sorted(range(len(points)), key=lambda i: points[i])

    def chain(indices):
        out = []
        for i in indices:
            while len(out) > 1 and turn_of(points[out[-2]], points[out[-1]], points[i]) <= 0:
                out.pop()
            out.append(i)
        return out[:-1]

    return chain(order) + chain(reversed(order))


def turn_of(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def polygon_on_plane(points, indices, normal):
    """The hull of coplanar points, anticlockwise as seen from the normal's side."""
    axis = max(range(3), key=lambda k: abs(normal[k]))
    u, v = (axis + 1) % 3, (axis + 2) % 3
    hull = [indices[i] for i in plan_hull([(points[i][u], points[i][v]) for i in indices])]
    if normal[axis] < 0:
        hull.reverse()
    first = hull.index(min(hull))
    return hull[first:] + hull[:first]


def hull_faces(points):
    """The faces of the convex hull: (vertex indices anticlockwise from outside, normal)."""
    faces, planes = [], set()
    for i, j, k in combinations(range(len(points)), 3):
        normal = cross(subtract(points[j], points[i]), subtract(points[k], points[i]))
        sides = [dot(normal, subtract(p, points[i])) for p in points]
        if not any(normal) or (min(sides) < 0 < max(sides)):
            continue
        if max(sides) > 0:
            normal = tuple(-c for c in normal)
        on_plane = tuple(n for n, side in enumerate(sides) if side == 0)
        if on_plane not in planes:
            planes.add(on_plane)
            faces.append((polygon_on_plane(points, on_plane, normal), normal))
    return faces


# --- Bodies, models, ground --------------------------------------------------------------------

class Body:
    """One convex object. `paint` may give a face a colour of its own by its outward normal."""

    def __init__(self, name, points, colour, frame=Frame(0, 0), paint=None):
        self.name, self.colour = name, colour
        points = list(dict.fromkeys(frame.place(p) for p in points))
        faces = hull_faces(points)
        used = sorted({i for vertices, _ in faces for i in vertices})
        number = {old: new for new, old in enumerate(used)}
        self.vertices = [points[i] for i in used]
        self.faces = [([number[i] for i in vertices], paint(normal) if paint else None)
                      for vertices, normal in faces]

    def edge_count(self):
        return sum(len(vertices) for vertices, _ in self.faces) // 2

    def to_json(self):
        return {"name": self.name, "colour": self.colour,
                "vertices": [metres(v) for v in self.vertices],
                "faces": [vertices if colour is None else {"vertices": vertices, "colour": colour}
                          for vertices, colour in self.faces]}


class Model:
    def __init__(self, name):
        self.name, self.bodies = name, []

    def add(self, name, points, colour, frame=Frame(0, 0), paint=None):
        self.bodies.append(Body(name, points, colour, frame, paint))
        return self.bodies[-1]

    def to_json(self):
        return {"name": self.name, "objects": [body.to_json() for body in self.bodies]}


def paint_top(colour):
    """Faces that look upwards get a colour of their own."""
    return lambda normal: colour if normal[2] > 0 else None


def metres(point):
    """A grid point in metres; every value is an exact double."""
    return [c // GRID if c % GRID == 0 else c / GRID for c in point]


def ground_face(plan, colour):
    """A level face at z = 0, anticlockwise from above."""
    points = [(to_grid(snap(x)), to_grid(snap(y))) for x, y in plan]
    hull = plan_hull(points)
    return {"vertices": [metres((*points[i], 0)) for i in hull], "colour": colour}


# --- Writing -----------------------------------------------------------------------------------

OPENED = ("systems", "models", "objects", "descriptions", "faces", "ground",
          "motion")  # an entry a line


def indented(key, value, depth):
    """JSON with one line for each object's vertices and one for each face."""
    pad = "  " * depth
    head = pad + (json.dumps(key) + ": " if key is not None else "")
    if isinstance(value, list) and key in OPENED:
        items = ",\n".join(indented(None, item, depth + 1) for item in value)
        return f"{head}[\n{items}\n{pad}]"
    if isinstance(value, dict) and any(k in OPENED for k in value):
        items = ",\n".join(indented(k, v, depth + 1) for k, v in value.items())
        return f"{head}{{\n{items}\n{pad}}}"
    return head + json.dumps(value)


def write_scene(path, scene):
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(indented(None, scene, 0) + "\n")
