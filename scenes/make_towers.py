#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes levine-towers.json beside this script: an avenue of towers with levels of detail, after
Levine 1975 (ch. II.G), who describes such a tree but no scene. Nothing is random."""

from pathlib import Path

from scene_tools import Body, Frame, box, ring, scaled, taper, upright, write_scene

COLOURS = [[214, 84, 62], [232, 164, 60], [104, 172, 88], [84, 120, 200], [150, 100, 184]]
ROWS = 8              # of two towers each
PITCH = 120
TOWER_UP_TO = [12, 40]  # elements: the box, then the prism
MAST_UP_TO = [5]


def choice(name, thresholds, descriptions):
    return {"name": name, "descriptions": [
        {"up_to": up_to, "objects": objects}
        for up_to, objects in zip(thresholds, descriptions)] + [{"objects": descriptions[-1]}]}


def tower(number, x, y):
    """A tower with three descriptions: a box, a prism on a podium, and one with storeys, fins and a
    mast, which is a choice of its own (Levine's fig. 2.12 nests choices too)."""
    frame, colour = Frame(x, y), COLOURS[number % 5]
    light = [min(255, c + 36) for c in colour]
    plan = ring(8, 5)

    def body(name, points, paint):
        return Body(f"tower {number} {name}", points, paint, frame).to_json()

    plain = [body("box", box(-4.5, 4.5, -4.5, 4.5, 0, 36), colour)]
    prism = [body("podium", box(-6, 6, -6, 6, 0, 4), light),
             body("prism", upright(plan, 4, 36), colour)]
    storeys = [body(f"storey {k + 1}", upright(scaled(plan, 14 if k % 2 else 16), z, z + 4),
                    light if k % 2 else colour) for k, z in enumerate(range(4, 32, 4))]
    fins = [body(f"fin {k + 1}", box(*extent, 4, 30), light) for k, extent in enumerate(
        [(5, 6, -1, 1), (-6, -5, -1, 1), (-1, 1, 5, 6), (-1, 1, -6, -5)])]
    pole = [body("pole", box(-0.5, 0.5, -0.5, 0.5, 36, 44), light)]
    parts = [body(f"mast {k + 1}", box(-w, w, -w, w, z, z + 2), light)
             for k, (w, z) in enumerate([(0.75, 36), (0.5, 38), (0.375, 40), (0.25, 42)])]
    full = [body("podium in full", box(-6, 6, -6, 6, 0, 4), light), *storeys, *fins,
            body("roof", taper(plan, 32, 8, 36), colour),
            choice(f"tower {number} mast", MAST_UP_TO, [pole, parts])]
    return choice(f"tower {number}", TOWER_UP_TO, [plain, prism, full])


def main():
    objects = [tower(2 * row + side + 1, 40 * side - 20, PITCH * row)
               for row in range(ROWS) for side in range(2)]
    ground = [{"vertices": [[-90, -80, 0], [90, -80, 0], [90, 960, 0], [-90, 960, 0]],
               "colour": [78, 92, 80]}]
    scene = {"cigsim": 1, "name": "levine towers", "background": [36, 44, 64],
             "view": {"eye": [0, -60, 14], "look_at": [0, 105, 18], "fov": 50},
             "sun": {"azimuth": 215, "elevation": 50}, "objects": objects, "ground": ground}
    write_scene(Path(__file__).resolve().parent / "levine-towers.json", scene)


if __name__ == "__main__":
    main()
