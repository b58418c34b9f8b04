#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the scenes of the literature beside this script: Levine 1975 (cubes, city), Fuchs 1980
(three overlapping polygons) and Stump 1986 (three card decks, a table that is not listable).
Nothing is random."""

from pathlib import Path

from scene_tools import Body, Frame, along_y, box, metres, to_grid, upright, write_scene

PALETTE = [[214, 84, 62], [232, 164, 60], [214, 206, 84], [104, 172, 88], [76, 164, 168],
           [84, 120, 200], [150, 100, 184], [206, 110, 156]]


def scene(name, view, objects):
    return {"cigsim": 1, "name": name, "background": [36, 44, 64], "view": view,
            "sun": {"azimuth": 215, "elevation": 50}, "objects": objects}


# --- Levine 1975 -------------------------------------------------------------------------------

LEVINE_SETS = {  # cubes along x, y and z (fig. 6.9 and the list of locations below it)
    4: (2, 1, 2), 8: (2, 2, 2), 16: (4, 2, 2), 24: (4, 2, 3), 32: (4, 2, 4), 48: (4, 4, 3)}
PITCH = 3


def levine_cubes(count):
    """Unit cubes two units apart, centred on the points of a grid of pitch 3."""
    nx, ny, nz = LEVINE_SETS[count]
    cells = [(x, y, z) for z in range(nz) for y in range(ny) for x in range(nx)]
    objects = []
    for number, (i, j, k) in enumerate(cells, start=1):
        x, y, z = PITCH * i, PITCH * j, PITCH * k
        points = box(x - 0.5, x + 0.5, y - 0.5, y + 0.5, z - 0.5, z + 0.5)
        objects.append(Body(f"cube {number}", points, PALETTE[(i + 3 * j + 5 * k) % 8]).to_json())
    centre = [PITCH * (n - 1) / 2 for n in (nx, ny, nz)]
    size = PITCH * max(nx, ny, nz)
    eye = [centre[0] - 0.8 * size, centre[1] - 1.6 * size, centre[2] + 0.9 * size]
    view = {"eye": [round(c * 64) / 64 for c in eye], "look_at": centre, "fov": 45}
    return scene(f"levine cubes {count}", view, objects)


CITY_HEIGHTS = [[3, 5, 4, 2], [6, 11, 8, 4], [4, 9, 14, 6], [2, 5, 7, 3]]
CITY_SIZES = [[(3, 3), (2, 3), (3, 2), (3, 3)], [(2, 3), (2, 2), (3, 3), (2, 3)],
              [(3, 2), (3, 3), (2, 2), (3, 3)], [(3, 3), (3, 2), (2, 3), (3, 2)]]


def levine_city():
    """Sixteen rectangular prisms on four by four blocks. Levine's own sizes are not published."""
    objects = []
    for row in range(4):
        for column in range(4):
            x, y = 5 * column, 5 * row
            wide, deep = CITY_SIZES[row][column]
            points = box(x, x + wide, y, y + deep, 0, CITY_HEIGHTS[row][column])
            colour = PALETTE[(2 * column + 3 * row) % 8]
            objects.append(Body(f"building {len(objects) + 1}", points, colour).to_json())
    view = {"eye": [-14, -22, 20], "look_at": [9, 9, 3], "fov": 45}
    return scene("levine city", view, objects)


# --- Fuchs, Kedem, Naylor 1980 -----------------------------------------------------------------

def plank(start, end, width):
    """A flat strip that climbs from z = -2 at its start to z = 2 at its end."""
    (sx, sy), (ex, ey), (wx, wy) = start, end, width
    corners = [(sx, sy, -2), (ex, ey, 2), (ex + wx, ey + wy, 2), (sx + wx, sy + wy, -2)]
    return [metres([to_grid(c) for c in corner]) for corner in corners]


def fuchs_overlap():
    """Each polygon's end lies on the next one's start, all the way round (fig. 6)."""
    planks = [plank((-9, -5), (9, -5), (0, 2)), plank((7, -7), (-2, 8), (-2, -1)),
              plank((2, 8), (-7, -7), (2, -1))]
    objects = [{"name": name, "colour": colour, "vertices": vertices, "faces": [[0, 1, 2, 3]]}
               for name, colour, vertices in zip("ABC", PALETTE[0:6:2], planks)]
    view = {"eye": [-3, -16, 20], "look_at": [0, -1, 0], "fov": 50}
    return scene("fuchs overlap", view, objects)


def fuchs_house():
    """Eleven polygons that no plane of theirs cuts: a body of six and a roof of five (fig. 4)."""
    walls = box(0, 8, 0, 12, 0, 6)
    roof = along_y([(-1, 6), (9, 6), (4, 10)], -1, 13)
    objects = [Body("walls", walls, PALETTE[0]).to_json(), Body("roof", roof, PALETTE[4]).to_json()]
    return scene("fuchs house", {"eye": [-16, -20, 14], "look_at": [4, 6, 4], "fov": 45}, objects)


# A block's faces over its corners (x fastest, then y, then z), anticlockwise from outside.
BLOCK_FACES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
# The same for corners that run round the plan.
TOWER_FACES = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def bar(start, end, width):
    """A plank of some thickness."""
    low = plank(start, end, width)
    corners = [low[0], low[1], low[3], low[2]]
    return corners + [[x, y, z + 7 / 16] for x, y, z in corners]


TURNS = [(16, 0), (15, 6), (13, 9), (9, 13), (6, 15), (11, 11)]  # sixteenths, as in Frame
TOWERS = [  # x, y, half width, half depth, height, turn
    (-14, -14, 4, 2, 5, 2), (0, -16, 4, 2, 6, 5), (14, -14, 2, 2, 11, 5), (16, 0, 3, 2, 5, 2),
    (14, 14, 4, 4, 7, 2), (0, 16, 4, 2, 9, 0), (-14, 14, 4, 4, 5, 2), (-16, 0, 2, 2, 10, 5),
    (28, 0, 2, 2, 10, 2)]


def fuchs_blocks():
    """Seventy-two polygons that become a hundred by rule 1 (Table 1, fig. 5): three bars that
    overlap in a ring, among nine towers. The figure's own scene is not published."""
    solids = [("bar " + name, bar(*ends), BLOCK_FACES) for name, ends in zip("ABC", [
        ((-9, -5), (9, -5), (0, 2)), ((7, -7), (-2, 8), (-2, -1)), ((2, 8), (-7, -7), (2, -1))])]
    for number, (x, y, wide, deep, high, turn) in enumerate(TOWERS, start=1):
        frame = Frame(x, y, -3, TURNS[turn])
        plan = [(-wide, -deep), (wide, -deep), (wide, deep), (-wide, deep)]
        points = [metres(frame.place(p)) for p in upright(plan, 0, high)]
        solids.append((f"tower {number}", points, TOWER_FACES))
    objects = [{"name": name, "colour": PALETTE[n % 8], "vertices": vertices, "faces": faces}
               for n, (name, vertices, faces) in enumerate(solids)]
    return scene("fuchs blocks", {"eye": [-18, -44, 40], "look_at": [2, -2, 0], "fov": 50}, objects)


# --- Stump 1986 --------------------------------------------------------------------------------

# Faces of a cube by vertex numbers, clockwise from outside as his program expects: it takes
# (first - second) x (third - second) for the outward normal.
CUBE_FACES = [(1, 2, 3, 4), (5, 8, 7, 6), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 8, 4), (4, 8, 5, 1)]


def cube_cards(x0, x1, y0, y1, z0, z1):
    corners = [(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    cards = [f"V   {n:3d}{x:8.2f}{y:8.2f}{z:8.2f}" for n, (x, y, z) in enumerate(corners, start=1)]
    return cards + ["F   " + "".join(f"{n:3d}" for n in face) for face in CUBE_FACES]


def plane_card(*points):
    """An operator's plane through three points, with the same rule for its normal."""
    return "S   " + "".join(f"{c:8.2f}" for point in points for c in point)


def deck(cubes, planes=()):
    cards = [card for cube in cubes for card in cube_cards(*cube)]
    return "\n".join(cards + [plane_card(*plane) for plane in planes] + ["E"]) + "\n"


# His figures give extents for cases 1 and 3. Case 2's figure is lost: these four cubes and three
# planes are one arrangement of which everything that he prints about it is true. The first plane
# parts 3, 4 from 1, 2; the second (x + y = 20) parts 2, 4 from 1, 3; the third (x = 3z + 3) has
# 2, 3 above it and 1, 4 below.
DECKS = {
    "stump-case-1": deck([(0, 10, 0, 10, 0, 10), (20, 30, 0, 10, 0, 10)]),
    "stump-case-2": deck([(65, 85, -85, -65, 0, 20), (60, 90, -40, -10, 30, 60),
                          (5, 45, -70, -30, 15, 55), (40, 50, -20, -10, 0, 10)],
                         [((55, 0, 0), (55, 10, 0), (55, 10, 10)),
                          ((0, 20, 0), (20, 0, 0), (20, 0, 10)),
                          ((33, 0, 10), (3, 0, 0), (3, 10, 0))]),
    "stump-case-3": deck([(0, 10, 0, 10, 0, 10), (0, 10, 15, 25, 0, 10), (15, 25, 0, 20, 0, 10),
                          (0, 20, 30, 40, 0, 10), (30, 40, 15, 35, 0, 10)]),
}


# Objects A, B, C, D as arms about a centre, each in an octant of its own, and the pairs of his
# example of a table that is not listable (fig. 7). The eye stands on the FALSE side of all planes.
NOT_LISTABLE = [
    {"normal": [1, 0, 0], "distance": 0, "pairs": [[3, 2], [4, 1]]},
    {"normal": [0, 1, 0], "distance": 0, "pairs": [[2, 4], [3, 1]]},
    {"normal": [0, 0, -1], "distance": 0, "pairs": [[2, 1], [4, 3]]}]


# The pairs of the same figure as he assigns them anew. Planes 1 and 3 stand upright and plane 2
# between them, all through one line: only so is his table listable from everywhere.
REASSIGNED = [
    {"normal": [1, 0, 0], "distance": 0, "pairs": [[3, 1], [3, 2]]},
    {"normal": [1, 1, 0], "distance": 0, "pairs": [[4, 1], [4, 2]]},
    {"normal": [0, 1, 0], "distance": 0, "pairs": [[2, 1], [4, 3]]}]


def stump_reassigned():
    boxes = [(-8, -2, -8, -2, 0, 4), (-8, -5, 1, 3, 0, 4), (1, 8, -8, -2, 0, 4),
             (1, 8, 2, 8, 0, 4)]
    objects = [Body(name, box(*extent), colour).to_json()
               for name, extent, colour in zip("ABCD", boxes, PALETTE[0:8:2])]
    view = {"eye": [-14, -16, 14], "look_at": [0, 0, 0], "fov": 45}
    return scene("stump reassigned", view, objects) | {"separation": REASSIGNED}


def stump_not_listable():
    boxes = [(-3, -1, -3, -1, 1, 3), (-8, -1, 1, 3, -3, -1), (1, 3, 1, 3, 1, 8),
             (1, 3, -8, -1, -3, -1)]
    objects = [Body(name, box(*extent), colour).to_json()
               for name, extent, colour in zip("ABCD", boxes, PALETTE[0:8:2])]
    view = {"eye": [-14, -16, 14], "look_at": [0, 0, 0], "fov": 45}
    return scene("stump not listable", view, objects) | {"separation": NOT_LISTABLE}


def main():
    here = Path(__file__).resolve().parent
    for count in LEVINE_SETS:
        write_scene(here / f"levine-cubes-{count}.json", levine_cubes(count))
    write_scene(here / "levine-city.json", levine_city())
    write_scene(here / "fuchs-overlap.json", fuchs_overlap())
    write_scene(here / "fuchs-house.json", fuchs_house())
    write_scene(here / "fuchs-blocks.json", fuchs_blocks())
    write_scene(here / "stump-not-listable.json", stump_not_listable())
    write_scene(here / "stump-reassigned.json", stump_reassigned())
    for name, cards in DECKS.items():
        (here / f"{name}.deck").write_text(cards, encoding="ascii", newline="\n")


if __name__ == "__main__":
    main()
