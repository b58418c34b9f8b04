#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the scenes beside this script, in exact arithmetic and without the makers' code.

For every JSON scene: faces planar and convex; objects of more than one face closed, convex and
wound anticlockwise from outside; fixed objects with disjoint interiors (touching is allowed); the
objects of a model, and the fixed models, can be parted step by step by planes of their faces
without cutting any. For the airfield: the moving aircraft keep clear of everything (sampled at
every quarter of a frame, with doubles). For the decks: Stump's selection gives the published
planes, pairs and counts. For fuchs-overlap.json: BSP trees by rule 1 have five pieces. For
stump-not-listable.json and stump-reassigned.json: the table's planes part its pairs, and the
published counts.
Prints a table; the exit status is 1 if anything is wrong."""

import json
import math
import sys
from fractions import Fraction
from itertools import combinations, product
from pathlib import Path

HERE = Path(__file__).resolve().parent
problems = []


def fault(where, what):
    problems.append(f"{where}: {what}")


# --- Vectors -----------------------------------------------------------------------------------

def subtract(a, b):
    return tuple(p - q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def exact(point):
    return tuple(Fraction(c) for c in point)


def normal_of(points):
    """The polygon's area vector: right-handed over its vertices."""
    total = (0, 0, 0)
    for a, b in zip(points[1:], points[2:]):
        part = cross(subtract(a, points[0]), subtract(b, points[0]))
        total = tuple(t + p for t, p in zip(total, part))
    return total


# --- Scenes ------------------------------------------------------------------------------------

def flat(entries, places=()):
    """The objects among entries and those of choices, each with its descriptions: pairs of a
    choice's name and the number of the description, from its end."""
    for entry in entries:
        descriptions = entry.get("descriptions")
        if descriptions is None:
            yield entry | {"places": places}
            continue
        for number, description in enumerate(descriptions):
            place = (entry["name"], number - len(descriptions))
            yield from flat(description["objects"], (*places, place))


class Solid:
    def __init__(self, model, data):
        self.model, self.name = model, data.get("name", "?")
        self.places = data["places"]
        self.vertices = [exact(v) for v in data["vertices"]]
        self.faces = [f["vertices"] if isinstance(f, dict) else f for f in data["faces"]]
        self.normals = [normal_of([self.vertices[i] for i in f]) for f in self.faces]
        ends = [tuple(sorted(e)) for f in self.faces for e in zip(f, f[1:] + f[:1])]
        self.edges = sorted(set(ends))
        self.low = [min(v[k] for v in self.vertices) for k in range(3)]
        self.high = [max(v[k] for v in self.vertices) for k in range(3)]

    def edge_directions(self):
        return [subtract(self.vertices[a], self.vertices[b]) for a, b in self.edges]


def models_of(scene):
    """(model name, objects) of the fixed system; (system, model name, objects) of the moving."""
    fixed = [(m["name"], list(flat(m["objects"]))) for m in scene.get("models", [])]
    if "objects" in scene:
        fixed.append(("", list(flat(scene["objects"]))))
    moving = [(s, m["name"], list(flat(m["objects"])))
              for s in scene.get("systems", []) for m in s["models"]]
    return fixed, moving


def shown_together(a, b):
    """False for two descriptions of one choice."""
    ours, theirs = dict(a.places), dict(b.places)
    return all(theirs.get(choice, number) == number for choice, number in ours.items())


def variants(solids):
    """What stands with every choice at its most, and at its least detailed description."""
    places = {place for solid in solids for place in solid.places}
    most = [s for s in solids if all(number == -1 for _, number in s.places)]
    least = [s for s in solids
             if not any((choice, number - 1) in places for choice, number in s.places)]
    return [most] if len(most) == len(solids) else [most, least]


def check_polygon(where, points):
    normal = normal_of(points)
    if not any(normal):
        return fault(where, "a face without area")
    if any(dot(normal, subtract(p, points[0])) != 0 for p in points):
        fault(where, "a face that is not planar")
    for a, b, c in zip(points, points[1:] + points[:1], points[2:] + points[:2]):
        if dot(normal, cross(subtract(b, a), subtract(c, b))) <= 0:
            fault(where, "a face that is not convex")
            return None
    return None


def check_solid(where, solid):
    for face in solid.faces:
        check_polygon(where, [solid.vertices[i] for i in face])
    if len(solid.faces) == 1:
        return
    directed = [e for f in solid.faces for e in zip(f, f[1:] + f[:1])]
    if len(set(directed)) != len(directed) or any((b, a) not in directed for a, b in directed):
        fault(where, "not closed")
    for face, normal in zip(solid.faces, solid.normals):
        corner = solid.vertices[face[0]]
        if any(dot(normal, subtract(v, corner)) > 0 for v in solid.vertices):
            fault(where, "not convex, or a face is wound the wrong way")
    if len(solid.vertices) - len(solid.edges) + len(solid.faces) != 2:
        fault(where, "vertices - edges + faces is not 2")


def apart(a, b):
    """Whether two convex solids have disjoint interiors: the separating axis test, exact."""
    if any(a.high[k] <= b.low[k] or b.high[k] <= a.low[k] for k in range(3)):
        return True
    if any(separates(axis, a, b) for axis in a.normals + b.normals):
        return True
    axes = (cross(p, q) for p, q in product(a.edge_directions(), b.edge_directions()))
    return any(separates(axis, a, b) for axis in axes if any(axis))


def separates(axis, a, b):
    ours, theirs = ([dot(axis, v) for v in solid.vertices] for solid in (a, b))
    return max(ours) <= min(theirs) or max(theirs) <= min(ours)


def check_scene(path):
    scene = json.loads(path.read_text(encoding="utf-8"))
    fixed, moving = models_of(scene)
    solids = [Solid(name, o) for name, objects in fixed for o in objects]
    movers = [(system, [Solid(name, o) for o in objects]) for system, name, objects in moving]
    for solid in solids + [s for _, group in movers for s in group]:
        check_solid(f"{path.name}: {solid.model} {solid.name}", solid)
    ground = [[exact(v) for v in face["vertices"]] for face in scene.get("ground", [])]
    for number, points in enumerate(ground, start=1):
        check_polygon(f"{path.name}: ground face {number}", points)
    for group in [solids] + [group for _, group in movers]:
        for a, b in combinations(group, 2):
            if (len(a.faces) > 1 and len(b.faces) > 1 and shown_together(a, b)
                    and not apart(a, b)):
                fault(path.name, f"{a.model} {a.name} and {b.model} {b.name} overlap")
    if path.name != "fuchs-blocks.json":  # its ring of bars cannot be parted
        check_separable(path.name, [s for s in solids if not s.places],
                        [group for _, group in movers])
    check_choices(path.name, solids)
    check_traffic(path.name, solids, movers)
    report(path.name, solids + [s for _, group in movers for s in group], ground)
    return solids


def check_separable(name, fixed, moving):
    """Stump's condition for a listable set without cuts, within each model and between them."""
    models = {}
    for solid in fixed:
        models.setdefault(solid.model, []).append(solid)
    for group in [*models.values(), *moving]:
        if all(len(solid.faces) > 1 for solid in group):
            divide(f"{name}: {group[0].model}", {s.name: s.vertices for s in group}, group)
    points = {model: [v for s in group for v in s.vertices] for model, group in models.items()}
    divide(f"{name}: models", points, fixed)


def check_choices(name, solids):
    """The same for choices, whose descriptions stand as one, and within each description shown."""
    choices = {}
    for solid in solids:
        if solid.places:
            choices.setdefault(solid.places[0][0], []).append(solid)
    if not choices:
        return
    points = {choice: [v for s in group for v in s.vertices] for choice, group in choices.items()}
    wide_first = sorted(solids, key=lambda s: s.low[0] - s.high[0] + s.low[1] - s.high[1])
    divide(f"{name}: choices", points, wide_first)
    for choice, group in choices.items():
        for standing in variants(group):
            divide(f"{name}: {choice}", {s.name: s.vertices for s in standing}, standing)


def divide(where, points, solids):
    """Parts named sets of points by planes of the solids' faces until each stands alone."""
    planes = [(normal, dot(normal, solid.vertices[face[0]]))
              for solid in solids for face, normal in zip(solid.faces, solid.normals)]
    groups = [list(points)]
    while groups:
        group = groups.pop()
        if len(group) < 2:
            continue
        tables = ({name: side_of(plane, points[name]) for name in group} for plane in planes)
        table = next((t for t in tables if set(t.values()) == {1, -1}), None)
        if table is None:
            fault(where, "no plane of a face parts " + ", ".join(group))
        else:
            groups += [[n for n in group if table[n] == side] for side in (1, -1)]


def report(name, solids, ground):
    faces = sum(len(s.faces) for s in solids)
    edges = sum(len(s.edges) for s in solids)
    sides = sum(len(points) for points in ground)
    print(f"{name:24} {len(solids):4} objects {faces:5} faces {edges:5} edges; "
          f"{len(ground):3} ground faces {sides:4} edges")


# --- Moving systems ----------------------------------------------------------------------------

def placement_at(motion, frame):
    """Position and attitude by linear interpolation, angles the short way round."""
    after = next((i for i, key in enumerate(motion) if key["frame"] > frame), len(motion))
    first = motion[max(after - 1, 0)]
    second = motion[min(after, len(motion) - 1)]
    span = second["frame"] - first["frame"]
    t = (frame - first["frame"]) / span if span else 0
    position = [a + t * (b - a) for a, b in zip(first["position"], second["position"])]
    attitude = [a + t * ((b - a + 180) % 360 - 180)
                for a, b in zip(first["attitude"], second["attitude"])]
    return position, attitude


def axes_of(attitude):
    """Right, ahead and up of a system in the environment."""
    heading, pitch, roll = (math.radians(a) for a in attitude)
    ahead = (math.sin(heading) * math.cos(pitch), math.cos(heading) * math.cos(pitch),
             math.sin(pitch))
    level = (math.cos(heading), -math.sin(heading), 0)
    upright = cross(level, ahead)
    right = tuple(math.cos(roll) * a - math.sin(roll) * b for a, b in zip(level, upright))
    return right, ahead, cross(right, ahead)


def bounds_at(system, solids, frame):
    """The box about a moving system's objects at a frame."""
    position, attitude = placement_at(system["motion"], frame)
    axes = axes_of(attitude)
    points = [[position[k] + sum(float(v[j]) * axes[j][k] for j in range(3)) for k in range(3)]
              for solid in solids for v in solid.vertices]
    return [min(p[k] for p in points) for k in range(3)], [max(p[k] for p in points)
                                                          for k in range(3)]


def check_traffic(name, solids, movers):
    boxes = [(solid.low, solid.high, solid.name) for solid in solids]
    for quarter in range(4 * 299 + 1 if movers else 0):
        moved = [(*bounds_at(system, group, quarter / 4), system["name"])
                 for system, group in movers]
        for a, b in [*combinations(moved, 2), *product(moved, boxes)]:
            if all(a[0][k] < b[1][k] and b[0][k] < a[1][k] for k in range(3)):
                fault(name, f"frame {quarter / 4}: {a[2]} comes within the box of {b[2]}")
        if any(low[2] < -0.5 for low, _, _ in moved):
            fault(name, f"frame {quarter / 4}: an aircraft sinks into the ground")


# --- Stump's decks -----------------------------------------------------------------------------

def read_deck(path):
    """Objects as (vertices, faces) and the operator's planes as three points each."""
    objects, planes, vertices, faces = [], [], {}, []
    for card in path.read_text(encoding="ascii").splitlines():
        if card[:2] == "V ":
            if faces:
                vertices, faces = {}, []
            if not vertices:
                objects.append((vertices, faces))
            vertices[int(card[4:7])] = tuple(Fraction(card[c:c + 8].strip()) for c in (7, 15, 23))
        elif card[:2] == "F ":
            faces.append([int(card[c:c + 3]) for c in range(4, len(card), 3)])
        elif card[:2] == "S ":
            numbers = [Fraction(card[c:c + 8].strip()) for c in range(4, 76, 8)]
            planes.append([tuple(numbers[k:k + 3]) for k in (0, 3, 6)])
    return objects, planes


def plane_through(first, second, third):
    normal = cross(subtract(first, second), subtract(third, second))
    return normal, dot(normal, second)


def side_of(plane, vertices):
    """1, -1 or 0: on the TRUE side, on the FALSE side, cut."""
    sides = [dot(plane[0], v) - plane[1] for v in vertices]
    return 1 if min(sides) >= 0 else -1 if max(sides) <= 0 else 0


class Selection:
    """Stump's binary search over the candidates of a deck."""

    def __init__(self, objects, planes):
        self.candidates = [plane_through(*(vertices[i] for i in face[:3]))
                           for vertices, faces in objects for face in faces]
        self.candidates += [plane_through(*points) for points in planes]
        self.table = [[side_of(plane, vertices.values()) for vertices, _ in objects]
                      for plane in self.candidates]
        self.pairs = {}  # candidate -> TRUE/FALSE pairs, in the order of selection
        self.divide(list(range(len(objects))))

    def splits(self, row, subset):
        sides = {row[i] for i in subset}
        return sides == {1, -1}

    def divide(self, subset):
        if len(subset) < 2:
            return
        usable = [k for k, row in enumerate(self.table) if self.splits(row, subset)]
        best = min(usable, key=lambda k: (abs(sum(self.table[k][i] for i in subset)),
                                          abs(sum(self.table[k])), k))
        true = [i for i in subset if self.table[best][i] == 1]
        false = [i for i in subset if self.table[best][i] == -1]
        self.pairs.setdefault(best, []).extend((t + 1, f + 1) for t, f in product(true, false))
        self.divide(true)
        self.divide(false)

    def report(self):
        """(unit normal, distance to one decimal, pairs) of each chosen plane."""
        return [(tuple(round(float(c) / length, 1) + 0.0 for c in normal),
                 round(float(d) / length, 1), pairs)
                for k, pairs in self.pairs.items()
                for normal, d in [self.candidates[k]]
                for length in [math.sqrt(dot(normal, normal))]]

    def counts(self, count, eye):
        """Priority counts of all objects for an eye; on the plane is TRUE."""
        totals = [0] * count
        for k, pairs in self.pairs.items():
            normal, d = self.candidates[k]
            for true, false in pairs:
                totals[(false if dot(normal, eye) >= d else true) - 1] += 1
        return "".join(map(str, totals))


PUBLISHED = {  # candidates, how many split all objects, planes, counts of the regions
    "stump-case-1": (12, 2, [((1.0, 0.0, 0.0), 10.0, [(2, 1)])], "10 01"),
    "stump-case-2": (27, 5, [((-1.0, 0.0, 0.0), -60.0, [(3, 1), (3, 2), (4, 1), (4, 2)]),
                             ((0.7, 0.7, 0.0), 14.1, [(4, 3), (2, 1)])], "2301 3210 1032 0123"),
    "stump-case-3": (30, None, [((1.0, 0.0, 0.0), 25.0, [(5, 1), (5, 2), (5, 3), (5, 4)]),
                                ((0.0, 1.0, 0.0), 25.0, [(4, 1), (4, 2), (4, 3)]),
                                ((1.0, 0.0, 0.0), 10.0, [(3, 1), (3, 2)]),
                                ((0.0, 1.0, 0.0), 10.0, [(2, 1)])],
                     "01234 10234 21304 32104 43210 32140 23140 12034 21034"),
}


def check_deck(path):
    objects, planes = read_deck(path)
    candidates, splitting, report_expected, regions = PUBLISHED[path.stem]
    selection = Selection(objects, planes)
    everything = range(len(objects))
    found = sum(selection.splits(row, everything) for row in selection.table)
    eyes = product(range(-150, 151, 5), range(-150, 151, 5))
    counts = {selection.counts(len(objects), (x, y, 5)) for x, y in eyes}
    if len(selection.candidates) != candidates or splitting not in (None, found):
        fault(path.name, f"{len(selection.candidates)} candidates, {found} split all objects")
    if selection.report() != report_expected:
        fault(path.name, f"selected {selection.report()}")
    if counts != set(regions.split()):
        fault(path.name, f"counts {sorted(counts)}")
    print(f"{path.name:24} {len(objects):4} objects, {candidates} candidates, {found} split all, "
          f"{len(selection.pairs)} planes, {len(counts)} regions")


# --- Fuchs' three polygons ---------------------------------------------------------------------

def cut(polygon, plane):
    """The parts of a convex polygon on the positive and on the negative side of a plane."""
    sides = [dot(plane[0], p) - plane[1] for p in polygon]
    parts = []
    for sign in (1, -1):
        part = []
        for (p, s), (q, t) in zip(zip(polygon, sides), zip(polygon[1:] + polygon[:1],
                                                          sides[1:] + sides[:1])):
            if sign * s >= 0:
                part.append(p)
            if s * t < 0:
                part.append(tuple(a + s / (s - t) * (b - a) for a, b in zip(p, q)))
        parts.append(part if any(sign * s > 0 for s in sides) else None)
    return parts


def tree_sizes(polygons):
    """The numbers of pieces of the BSP trees whose every root splits as few as any (rule 1)."""
    if not polygons:
        return {0}
    choices = []
    for i, root in enumerate(polygons):
        parts = [cut(p, plane_through(*root[:3])) for p in polygons[:i] + polygons[i + 1:]]
        choices.append([[part[k] for part in parts if part[k]] for k in (0, 1)])
    fewest = min(len(front) + len(back) for front, back in choices)
    return {1 + a + b for front, back in choices if len(front) + len(back) == fewest
            for a, b in product(tree_sizes(front), tree_sizes(back))}


def check_fuchs(solids):
    polygons = [[s.vertices[i] for i in s.faces[0]] for s in solids]
    sizes = tree_sizes(polygons)
    print(f"{'fuchs-overlap.json':24} BSP trees of {sorted(sizes)} pieces")
    if sizes != {5}:
        fault("fuchs-overlap.json", "BSP trees by rule 1 should have five pieces")


# --- Stump's table that is not listable --------------------------------------------------------

def check_table(path, solids, published):
    """Objects on the sides that their pairs say, and the counts at the scene's own eyepoint."""
    scene = json.loads(path.read_text(encoding="utf-8"))
    eye = exact(scene["view"]["eye"])
    counts = [0] * len(solids)
    pairs = set()
    for number, plane in enumerate(scene["separation"], start=1):
        normal, distance = exact(plane["normal"]), Fraction(plane["distance"])
        eye_true = dot(normal, eye) >= distance
        for on_true, on_false in plane["pairs"]:
            pairs.add(frozenset((on_true, on_false)))
            if any(dot(normal, v) < distance for v in solids[on_true - 1].vertices) or any(
                    dot(normal, v) > distance for v in solids[on_false - 1].vertices):
                fault(path.name, f"plane {number} does not part {on_true} from {on_false}")
            counts[(on_false if eye_true else on_true) - 1] += 1
    print(f"{path.name:24} {len(pairs)} pairs, counts {counts}")
    if len(pairs) != math.comb(len(solids), 2) or counts != published:
        fault(path.name, f"should have all pairs and the counts {published}")


def main():
    for path in sorted(HERE.glob("*.json")):
        solids = check_scene(path)
        if path.name == "fuchs-overlap.json":
            check_fuchs(solids)
        if path.name == "stump-not-listable.json":
            check_table(path, solids, [0, 2, 2, 2])
        if path.name == "stump-reassigned.json":
            check_table(path, solids, [0, 1, 2, 3])
    for path in sorted(HERE.glob("*.deck")):
        check_deck(path)
    for problem in problems:
        print("WRONG", problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
