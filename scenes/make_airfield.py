#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes airfield.json and airfield-approach.csv beside this script. Nothing is random.

The runway, 18/36, runs north along x = 0 from y = 0. Buildings stand to the west of it, a village
to the east, hills beyond the far end. An airliner takes off while the eye of airfield-approach.csv
flies a three-degree approach to the same runway. One frame stands for a quarter of a second.
"""

import csv
import math
from pathlib import Path

from scene_tools import (Frame, GRID, Model, along_x, along_y, box, ground_face, mirrored,
                         paint_top, ring, scaled, snap, taper, upright, write_scene)

FRAMES = 300
SUN = {"azimuth": 150, "elevation": 38}

SKY = [126, 178, 226]
HAZE = [122, 160, 132]
GRASS = [84, 148, 62]
LAWN = [102, 166, 70]
CROPS = [[150, 160, 66], [188, 170, 92], [66, 124, 54], [140, 112, 70], [112, 152, 60],
         [206, 186, 104], [92, 136, 74]]
WATER = [54, 104, 168]
ROAD = [108, 106, 104]
RUNWAY = [70, 72, 76]
TAXIWAY = [100, 102, 106]
APRON = [146, 148, 148]
WHITE = [240, 240, 236]
YELLOW = [240, 200, 40]
SHADOW = [52, 84, 48]
APRON_SHADOW = [88, 90, 94]
GLASS = [52, 84, 116]
CONCRETE = [206, 204, 196]
ROOF_GREY = [120, 124, 130]
RED = [206, 52, 40]
BARK = [104, 76, 48]


# --- Ground ------------------------------------------------------------------------------------

def rectangle(x0, x1, y0, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


WEST_FIELD = [(-420, -520), (-30, -480), (-6, -262), (-400, -256)]
EAST_FIELD = [(-24, -480), (330, -520), (300, -268), (0, -262)]


def countryside():
    """The land, far to near: haze, grass, fields, water and roads."""
    ground = [ground_face(rectangle(-24000, 24000, -9000, 36000), HAZE),
              ground_face(ring(8, 6000, step=1), GRASS)]
    fields = [
        [(-1500, -1100), (-700, -1200), (-620, -560), (-1400, -480)],
        [(-620, -1150), (-180, -1150), (-160, -560), (-560, -560)],
        [(220, -1200), (760, -1100), (700, -500), (200, -540)],
        [(-1600, 560), (-760, 620), (-720, 1240), (-1700, 1300)],
        [(-640, 760), (-240, 760), (-240, 1500), (-700, 1420)],
        WEST_FIELD,
        EAST_FIELD,
        [(300, -230), (1300, -460), (1500, 240), (480, 160)],
        [(300, 1360), (900, 1500), (1000, 2300), (240, 2200)],
        [(-1100, 1560), (-260, 1660), (-300, 2600), (-1400, 2500)],
        [(1150, 1200), (2100, 1000), (2400, 2100), (1200, 2200)],
        [(-2900, 1400), (-1800, 1500), (-1700, 2700), (-3100, 2900)],
        [(-800, 2800), (300, 2500), (500, 3500), (-700, 3700)],
        [(700, 2600), (1900, 2500), (2300, 3700), (900, 3700)],
    ]
    ground += [ground_face(plan, CROPS[i % len(CROPS)]) for i, plan in enumerate(fields)]
    ground += tramlines(WEST_FIELD, (0.8, 0.86, 0.92), [164, 146, 72])
    ground += tramlines(EAST_FIELD, (0.1, 0.17, 0.24, 0.31), [104, 140, 72])
    river = [(-2600, -1480), (-900, -1330), (300, -1420), (1400, -1250), (3200, -1500)]
    ground += [ground_face([(ax, ay), (bx, by), (bx, by + 70), (ax, ay + 70)], WATER)
               for (ax, ay), (bx, by) in zip(river, river[1:])]
    lake = [(620, 700), (780, 620), (980, 660), (1120, 800), (1060, 980), (860, 1060), (680, 940)]
    ground.append(ground_face(lake, WATER))
    road = [(-2400, -300), (-330, -240), (190, -250), (300, 60), (330, 1150)]
    ground += [ground_face(strip(a, b, 9), ROAD) for a, b in zip(road, road[1:])]
    return ground


def tramlines(field, places, colour):
    """Wheel tracks from the field's near edge to its far edge, at parts of its width."""
    near_left, near_right, far_right, far_left = field
    return [ground_face(strip(along(near_left, near_right, t), along(far_left, far_right, t), 3),
                        colour) for t in places]


def along(a, b, t):
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))


def strip(a, b, width):
    """The rectangle of a width about the segment from a to b, a little longer at its ends."""
    length = math.dist(a, b)
    ux, uy = (b[0] - a[0]) / length * width / 2, (b[1] - a[1]) / length * width / 2
    (ax, ay), (bx, by) = (a[0] - ux, a[1] - uy), (b[0] + ux, b[1] + uy)
    return [(ax + uy, ay - ux), (bx + uy, by - ux), (bx - uy, by + ux), (ax - uy, ay + ux)]


def runway():
    ground = [ground_face(rectangle(-300, 160, -120, 1500), LAWN),
              ground_face(rectangle(-22, 22, -50, 1450), RUNWAY)]
    ground += [ground_face(rectangle(x, x + 0.75, 0, 1400), WHITE) for x in (-20.5, 19.75)]
    ground += [ground_face(rectangle(-0.5, 0.5, y, y + 40), WHITE) for y in range(130, 1290, 90)]
    for mark in near_end_marks():
        ground.append(ground_face(mark, WHITE))
    for mark in far_end_marks():
        ground.append(ground_face([(-x, 1400 - y) for x, y in mark], WHITE))
    return ground


def threshold_bars(count):
    """Bars of 2 m, in two groups, that mark where the runway begins."""
    lanes = [3.25 + 4 * i for i in range(count)]
    return [rectangle(x, x + 2.25, 6, 36) for lane in lanes for x in (lane, -lane - 2.25)]


def near_end_marks():
    marks = threshold_bars(4) + digits("36", 48)
    marks += [rectangle(x, x + 7, 300, 350) for x in (7, -14)]
    marks += [rectangle(x, x + 2, y, y + 24) for y in (170, 240) for x in (8, 12, -10, -14)]
    return marks


def far_end_marks():
    return threshold_bars(2) + [rectangle(x, x + 7, 300, 350) for x in (7, -14)]


STROKES = {  # x0, x1, y0, y1 of each bar in a cell 5 wide and 14 high
    "3": [(0, 4, 0, 2), (0, 4, 6, 8), (0, 4, 12, 14), (4, 5, 0, 14)],
    "6": [(0, 1, 0, 14), (1, 5, 0, 2), (1, 5, 6, 8), (1, 5, 12, 14), (4, 5, 2, 6)],
}


def digits(text, y):
    """The designator, read from the approach; each digit is made of level bars."""
    marks = []
    for place, digit in enumerate(text):
        left = -7 + 8 * place
        marks += [rectangle(left + 1.25 * x0, left + 1.25 * x1, y + 2 * y0, y + 2 * y1)
                  for x0, x1, y0, y1 in STROKES[digit]]
    return marks


def taxiways():
    ways = [rectangle(-82, -66, 10, 1390), rectangle(-66, -22, 10, 34),
            rectangle(-66, -22, 640, 660), rectangle(-66, -22, 1366, 1390)]
    lines = [rectangle(-74.5, -73.5, 22, 1378), rectangle(-73.5, -10, 21.5, 22.5),
             rectangle(-73.5, -10, 649.5, 650.5), rectangle(-73.5, -10, 1377.5, 1378.5)]
    ground = [ground_face(rectangle(-200, -82, 40, 480), APRON)]
    ground += [ground_face(plan, TAXIWAY) for plan in ways]
    ground.append(ground_face(rectangle(-140, -74.5, 239.5, 240.5), YELLOW))
    ground += [ground_face(rectangle(-140.5, -139.5, 70, 450), YELLOW)]
    ground += [ground_face(plan, YELLOW) for plan in lines]
    return ground


def shadow(body, colour):
    """What a body's shadow covers of the ground."""
    length = 1 / math.tan(math.radians(SUN["elevation"]))
    azimuth = math.radians(SUN["azimuth"])
    dx, dy = -length * math.sin(azimuth), -length * math.cos(azimuth)
    return ground_face([((x + dx * z) / GRID, (y + dy * z) / GRID) for x, y, z in body.vertices],
                       colour)


# --- Buildings ---------------------------------------------------------------------------------

def terminal():
    """Two wings of wall, glass and roof, and a taller hall between them."""
    model = Model("terminal")
    for name, y0, y1 in (("south wing", 60, 104), ("north wing", 132, 176)):
        model.add(f"{name} wall", box(-236, -206, y0, y1, 0, 4), CONCRETE)
        model.add(f"{name} glass", box(-236, -206, y0, y1, 4, 8), GLASS)
        model.add(f"{name} roof", box(-238, -203, y0, y1, 8, 9.5), ROOF_GREY)
    model.add("hall", box(-242, -202, 104, 132, 0, 14), CONCRETE)
    model.add("hall glass", box(-202, -201.5, 108, 128, 2, 12), GLASS)
    hall_roof = [(-242, 104), (-202, 104), (-202, 132), (-242, 132)]
    model.add("hall roof", upright(hall_roof, 14, 14) + [(-222, 118, 20)], [176, 74, 54])
    return model


def tower():
    model = Model("tower")
    at = Frame(-226, 222)
    cab = ring(8, 8, step=1)
    model.add("base", box(-12, 12, -10, 10, 0, 8), CONCRETE, at, paint_top(ROOF_GREY))
    model.add("shaft", upright(ring(4, 5.5, step=1), 8, 30), [222, 214, 198], at)
    model.add("gallery", upright(ring(8, 8.5, step=1), 30, 31.5), ROOF_GREY, at)
    model.add("cab", upright(scaled(cab, 12), 31.5, 31.5) + upright(cab, 36, 36), GLASS, at)
    model.add("cab roof", taper(cab, 36, 8, 38), RED, at)
    model.add("mast", box(-0.25, 0.25, -0.25, 0.25, 38, 46), WHITE, at)
    return model


def hangar(model, name, y, wall, roof, door):
    """A hall with a faceted arch for a roof and a door towards the apron."""
    arch = [(-25, 9), (25, 9), (21, 14), (12, 18), (-12, 18), (-21, 14)]
    at = Frame(-236, y)
    model.add(f"{name} hall", box(-30, 30, -25, 25, 0, 9), wall, at)
    model.add(f"{name} roof", along_x(arch, -30, 30), roof, at, paint_sloping(roof, wall))
    model.add(f"{name} door", box(30, 30.5, -19, 19, 0, 8), door, at)


def paint_sloping(slope, wall):
    return lambda normal: slope if normal[2] > 0 else wall


def hangars():
    model = Model("hangars")
    hangar(model, "hangar 1", 284, [196, 190, 172], [96, 128, 152], [72, 96, 120])
    hangar(model, "hangar 2", 344, [196, 190, 172], [164, 84, 60], [130, 66, 48])
    hangar(model, "hangar 3", 404, [196, 190, 172], [104, 138, 96], [76, 104, 72])
    return model


def fuel_farm():
    model = Model("fuel farm")
    for i, (x, y) in enumerate(((-230, 462), (-206, 462)), start=1):
        at, plan = Frame(x, y), ring(8, 8, step=1)
        model.add(f"tank {i}", upright(plan, 0, 10), WHITE, at)
        model.add(f"tank {i} roof", upright(plan, 10, 10) + [(0, 0, 12)], [190, 196, 200], at)
    return model


def vehicles():
    model = Model("vehicles")
    model.add("fuel truck tank", along_y([(-1.5, 1), (1.5, 1), (1.5, 3), (0.75, 4), (-0.75, 4),
                                          (-1.5, 3)], -5, 2), YELLOW, Frame(-112, 118))
    model.add("fuel truck cab", box(-1.5, 1.5, 2, 4.5, 0.5, 3.5), RED, Frame(-112, 118))
    at = Frame(-190, 224)
    model.add("fire engine", box(-4.5, 3, -1.5, 1.5, 0.5, 4), RED, at)
    model.add("fire engine cab", box(3, 5.5, -1.5, 1.5, 0.5, 3.5), WHITE, at)
    return model


def windsock():
    model = Model("windsock")
    at = Frame(60, 180)
    model.add("pole", box(-0.25, 0.25, -0.25, 0.25, 0, 9), WHITE, at)
    sock = [(0, 1), (0.875, 0.5), (0.875, -0.5), (0, -1), (-0.875, -0.5), (-0.875, 0.5)]
    wide = [(0.25, y, 8.0 + z) for y, z in sock]
    narrow = [(6.25, y / 2, 7.5 + z / 2) for y, z in sock]
    model.add("sock", wide + narrow, [250, 120, 30], at)
    return model


def approach_lights():
    """Posts on the centre line before the threshold, each with a bar."""
    model = Model("approach lights")
    for i in range(5):
        at = Frame(0, -70 - 30 * i)
        half_width = 12 if i == 3 else 2.5
        model.add(f"post {i + 1}", box(-0.25, 0.25, -0.25, 0.25, 0, 3), [220, 120, 40], at)
        model.add(f"bar {i + 1}", box(-half_width, half_width, -0.25, 0.25, 3, 3.75), WHITE, at)
    return model


def slope_indicators():
    """Boxes beside the touchdown zone that look white from above the glide path, red from below."""
    model = Model("slope indicators")
    for i, x in enumerate((-45, -39, -33, -27), start=1):
        colour = RED if i > 2 else WHITE
        model.add(f"box {i}", box(x - 1.5, x + 1.5, 290, 292, 0, 1.25), colour)
    return model


# --- Aircraft ----------------------------------------------------------------------------------

def round_profile(sides):
    """Cross-sections (x, z) with upright flanks; halves of them lie on the grid."""
    if sides == 6:
        return [(2, -1), (2, 1), (0, 2), (-2, 1), (-2, -1), (0, -2)]
    return [(2, -0.75), (2, 0.75), (1, 1.75), (-1, 1.75), (-2, 0.75), (-2, -0.75), (-1, -1.75),
            (1, -1.75)]


def fuselage_end(profile, y_full, y_half, lift):
    """From the full profile to one of half the size, lifted."""
    return ([(x, y_full, z) for x, z in profile] +
            [(x / 2, y_half, z / 2 + lift) for x, z in profile])


def airliner(model, name, frame, livery, sides=6, wheels=True):
    """28 m long, 28 m of span, nose along y; the wheels stand 3.5 m below the origin."""
    profile = round_profile(sides)
    top = max(z for _, z in profile)

    def add(part, points, colour=WHITE, paint=None):
        model.add(f"{name} {part}", points, colour, frame, paint)

    add("nose", fuselage_end(profile, 10, 14, -0.5), WHITE, paint_flanks(livery, top=GLASS))
    add("body", along_y(profile, -6, 10), WHITE, paint_flanks(livery))
    add("tail", fuselage_end(profile, -6, -14, top / 2), WHITE, paint_flanks(livery))
    wing = upright([(2, -3), (14, -5), (14, -3), (2, 3)], -0.75, -0.375)
    engine = box(4.5, 6.5, -1, 3.5, -2.5, -0.75)
    tailplane = upright([(1.5, -13.5), (6, -15), (6, -13.5), (1.5, -10)], 1, 1.25)
    for side, points in (("right", lambda p: p), ("left", mirrored)):
        add(f"{side} wing", points(wing), [200, 204, 210])
        add(f"{side} engine", points(engine), livery)
        add(f"{side} tailplane", points(tailplane), [200, 204, 210])
    add("fin", along_x([(-8, top), (-14, top), (-15, top + 6), (-12.5, top + 6)], -0.25, 0.25),
        livery)
    if wheels:
        add("nose wheel", box(-0.25, 0.25, 8, 9, -3.5, -top), RUNWAY)
        add("right wheels", box(2.5, 3.5, -2, -0.75, -3.5, -0.75), RUNWAY)
        add("left wheels", box(-3.5, -2.5, -2, -0.75, -3.5, -0.75), RUNWAY)


def paint_flanks(stripe, top=None):
    """A stripe on level normals (the flanks); perhaps another colour above."""
    def paint(normal):
        if normal[2] == 0 or 4 * abs(normal[2]) < abs(normal[0]):
            return stripe
        return top if normal[2] > 0 else None
    return paint


def light_aircraft(model, name, frame, livery):
    """A high-wing single, 8 m long; its wheels stand 1.5 m below the origin."""
    def add(part, points, colour=WHITE):
        model.add(f"{name} {part}", points, colour, frame)

    add("cowl", box(-0.75, 0.75, 1.5, 1.5, -0.75, 0.5) +
        box(-0.5, 0.5, 3.25, 3.25, -0.5, 0.25), livery)
    add("cabin", box(-0.75, 0.75, -1, 1.5, -0.75, 1), WHITE)
    add("tail", box(-0.75, 0.75, -1, -1, -0.75, 0.75) + box(-0.25, 0.25, -5, -5, 0, 0.5), WHITE)
    add("wing", box(-5.5, 5.5, -0.5, 1.25, 1, 1.25), livery)
    add("tailplane", box(-2, 2, -5.75, -5, 0.25, 0.5), livery)
    add("fin", along_x([(-5, 0.5), (-5.75, 0.5), (-5.75, 2.25), (-5.25, 2.25)], -0.25, 0.25),
        livery)
    add("wheels", box(-1, 1, 0.5, 1, -1.5, -0.75), RUNWAY)


def parked_airliner():
    model = Model("parked airliner")
    airliner(model, "blue airliner", Frame(-158, 92, 3.5, (0, 16)), [40, 84, 170])
    return model


def parked_light_aircraft():
    model = Model("parked light aircraft")
    light_aircraft(model, "red single", Frame(-160, 300, 1.5, (-11, 12)), RED)
    return model


# --- Village and trees -------------------------------------------------------------------------

TURNS = [(16, 0), (15, 6), (14, -8), (0, 16), (16, -3), (12, 11)]
WALLS = [[232, 222, 200], [244, 240, 230], [214, 190, 160]]
ROOFS = [[172, 70, 48], [142, 62, 50], [120, 92, 80], [188, 98, 60]]


def house(model, name, x, y, index):
    at = Frame(x, y, 0, TURNS[index % len(TURNS)])
    wall, roof = WALLS[index % len(WALLS)], ROOFS[index % len(ROOFS)]
    model.add(f"{name} walls", box(-6, 6, -4.5, 4.5, 0, 5.5), wall, at)
    model.add(f"{name} roof", along_x([(-4.5, 5.5), (4.5, 5.5), (0, 9.5)], -6, 6), roof, at,
              paint_sloping_or(wall))


def paint_sloping_or(wall):
    return lambda normal: None if normal[2] > 0 else wall


def village():
    model = Model("village")
    places = [(150, 130), (186, 164), (226, 120), (246, 190), (214, 236), (176, 290), (250, 310)]
    for i, (x, y) in enumerate(places):
        house(model, f"house {i + 1}", x, y, i)
    church(model, Frame(166, 220))
    plant(model, broadleaf, [(134, 84, 14), (206, 92, 12), (140, 330, 16), (206, 350, 14)])
    return model


def farm():
    model = Model("farm")
    house(model, "farmhouse", -84, -206, 0)
    at = Frame(-98, -178)
    model.add("barn", box(-10, 10, -6, 6, 0, 7), [150, 60, 46], at)
    model.add("barn roof", along_x([(-6, 7), (6, 7), (0, 12)], -10, 10), [96, 92, 92], at,
              paint_sloping_or([150, 60, 46]))
    plant(model, broadleaf, [(-66, -180, 13), (-112, -214, 14), (-136, -196, 12)])
    return model


def church(model, at):
    wall, roof = [216, 208, 190], [104, 96, 104]
    model.add("church nave", box(-6, 6, -12, 10, 0, 9), wall, at)
    model.add("church roof", along_y([(-6, 9), (6, 9), (0, 15)], -12, 10), roof, at,
              paint_sloping_or(wall))
    model.add("church tower", box(-4, 4, -20, -12, 0, 20), wall, at)
    model.add("church spire", upright([(-4, -20), (4, -20), (4, -12), (-4, -12)], 20, 20) +
              [(0, -16, 36)], [88, 110, 116], at)


def conifer(model, name, x, y, height):
    trunk = [(-0.5, -0.5), (0.5, -0.5), (0, 0.5)]
    radius = height / 4
    crown = [(radius, 0), (0, radius), (-radius, 0), (0, -radius)]
    model.add(f"{name} trunk", upright(trunk, 0, 2), BARK, Frame(x, y))
    model.add(f"{name} crown", upright(crown, 2, 2) + [(0, 0, height)], [34, 92, 52], Frame(x, y))


def broadleaf(model, name, x, y, height):
    trunk = [(-0.5, -0.5), (0.5, -0.5), (0, 0.5)]
    crown = [(5, 1), (-1, 5), (-5, -1), (1, -5)]
    model.add(f"{name} trunk", upright(trunk, 0, 3), BARK, Frame(x, y))
    model.add(f"{name} crown", [(0, 0, 3)] + upright(crown, height / 2, height / 2) +
              [(0, 0, height)], [58, 122, 44], Frame(x, y))


def plant(model, kind, places):
    for i, (x, y, height) in enumerate(places, start=1):
        kind(model, f"tree {i}", x, y, height)


def wood(name, kind, places):
    model = Model(name)
    plant(model, kind, places)
    return model


def woods():
    return [
        wood("south wood", conifer, [(74, -214, 16), (88, -196, 20), (104, -212, 18),
                                     (96, -170, 22), (116, -186, 16)]),
        wood("east wood", broadleaf, [(150, 520, 14), (170, 600, 16)]),
        wood("west wood", conifer, [(-290, 60, 24), (-312, 92, 28), (-288, 140, 24)]),
    ]


def hill(model, name, x, y, radius, tops, colour):
    plan = ring(6, radius, phase=0.3 * len(model.bodies), step=1)
    base = [(px, py * 3 / 4, 0) for px, py in plan]
    model.add(name, base + tops, colour, Frame(x, y))


def hills():
    model = Model("hills")
    greens = [[74, 118, 88], [86, 128, 84], [66, 106, 92], [92, 124, 100]]
    rows = [
        (-2900, 5600, 1100, [(-300, 0, 330), (250, 60, 260), (0, -300, 200)]),
        (-1340, 7100, 900, [(-160, 20, 300), (220, -20, 360)]),
        (-620, 5300, 480, [(-80, 0, 150), (100, -30, 120)]),
        (1000, 5500, 640, [(-200, 0, 170), (120, 40, 230), (40, -160, 130)]),
        (2400, 6300, 1000, [(-260, 0, 340), (260, -40, 420), (0, -240, 260)]),
        (4200, 5600, 900, [(-160, -20, 260), (220, 0, 220)]),
        (-4900, 6200, 900, [(0, 0, 300), (300, 30, 240)]),
        (300, 7600, 900, [(-240, 0, 300), (240, 0, 260)]),
    ]
    for i, (x, y, radius, tops) in enumerate(rows):
        hill(model, f"hill {i + 1}", x, y, radius, tops, greens[i % len(greens)])
    return model


# --- Motion ------------------------------------------------------------------------------------

def take_off(frame):
    """Roll of 70 frames, rotation, climb at six degrees and, far out, a turn to the right."""
    seconds, roll_seconds, acceleration = frame / 4, 17.5, 4.0
    rolled = 70 + acceleration / 2 * min(seconds, roll_seconds) ** 2
    airborne = max(0.0, seconds - roll_seconds)
    speed = acceleration * roll_seconds
    along = speed * airborne
    pitch = min(9.0, 3.0 * max(0.0, seconds - roll_seconds + 2))
    climb = along * math.tan(math.radians(6)) * min(1.0, airborne / 4)
    turned = max(0.0, airborne - 22)
    heading = min(30.0, 2.0 * turned)
    roll = min(14.0, 4.0 * turned)
    x = along_turn(turned, speed)
    return {"frame": frame, "position": [snap(x), snap(rolled + along), snap(3.5 + climb)],
            "attitude": [snap(heading), snap(pitch), snap(roll)]}


def taxi(frame):
    """South along the taxiway, a left turn, and a wait before the runway."""
    speed, turn_radius = 2.25, 12
    straight, arc = 300.0, math.pi / 2 * turn_radius
    run = min(speed * frame, straight + arc + 14)
    angle = min(max(run - straight, 0.0), arc) / turn_radius
    beyond = max(0.0, run - straight - arc)
    x = -74 + turn_radius * (1 - math.cos(angle)) + beyond
    y = 334 - min(run, straight) - turn_radius * math.sin(angle)
    return {"frame": frame, "position": [snap(x), snap(y), 3.5],
            "attitude": [snap(180 - math.degrees(angle)), 0, 0]}


def along_turn(turned, speed):
    """How far to the east the turn has carried it: the heading grows by two degrees a second."""
    steps = [min(30.0, 2.0 * turned * (i + 0.5) / 16) for i in range(16)]
    return sum(speed * math.sin(math.radians(h)) * turned / 16 for h in steps)


def moving_airliner(name, livery, keys):
    """An airliner in a coordinate system of its own."""
    model = Model(name)
    airliner(model, name, Frame(0, 0), livery)
    return {"name": name, "motion": keys, "models": [model.to_json()]}


def traffic():
    taxi_frames = [0, *range(132, 146, 2), 148]
    return [moving_airliner("departing airliner", RED, [take_off(f) for f in range(0, 300, 13)]),
            moving_airliner("taxiing airliner", [38, 130, 84], [taxi(f) for f in taxi_frames])]


def approach(frame):
    """One row of the landing: x, y, z, heading, pitch, roll of the eye."""
    aim_y, glide, eye_height, speed = 300.0, math.radians(3), 4.0, 9.5
    touchdown = 268
    if frame < touchdown:
        y = aim_y + 60 - speed * (touchdown - frame)
    else:
        rolled = frame - touchdown
        y = aim_y + 60 + speed * rolled - 0.08 * rolled ** 2
    height = eye_height + flare((aim_y - y) * math.tan(glide))
    fade = min(1.0, max(0.0, (touchdown - frame) / 90))
    x = fade * (14 * math.sin(frame / 38) + 5 * math.sin(frame / 15 + 1))
    drift = fade * (14 / 38 * math.cos(frame / 38) + 5 / 15 * math.cos(frame / 15 + 1))
    bend = fade * (-14 / 38 ** 2 * math.sin(frame / 38) - 5 / 15 ** 2 * math.sin(frame / 15 + 1))
    heading = math.degrees(math.atan2(drift, speed))
    roll = math.degrees(math.atan2(bend * 16, 9.81)) * 2
    return [x, y, height, heading, approach_pitch(frame, touchdown), roll]


def flare(height):
    """The glide path, bent smoothly to the ground over its last metres."""
    return 4 * math.log1p(math.exp(height / 4))


def approach_pitch(frame, touchdown):
    """A little below the horizon on the path, up in the flare, down after touchdown."""
    if frame < touchdown - 24:
        return -2.0 + 0.3 * math.sin(frame / 21)
    if frame < touchdown:
        return -2.0 + 4.0 * (frame - touchdown + 24) / 24
    return max(-0.5, 2.0 - 0.25 * (frame - touchdown))


def write_approach(path):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["x", "y", "z", "heading", "pitch", "roll"])
        for frame in range(FRAMES):
            writer.writerow([f"{value:.4f}" for value in approach(frame)])


# --- The scene ---------------------------------------------------------------------------------

SHADOW_PARTS = {"terminal": ("roof",), "tower": ("shaft", "cab"), "hangars": ("roof",),
                "parked airliner": ("body", "wing"), "parked light aircraft": ("cabin", "wing"),
                "farm": ("roof", "crown"), "south wood": ("crown",)}
SHADOW_COLOURS = {name: APRON_SHADOW for name in ("terminal", "hangars", "parked airliner",
                                                  "parked light aircraft")}


def shadows(models):
    """Shadows of the bodies that show them best, on what each stands on."""
    ground = []
    for model in models:
        for body in model.bodies:
            part = body.name.split()[-1]
            if part in SHADOW_PARTS.get(model.name, ()):
                ground.append(shadow(body, SHADOW_COLOURS.get(model.name, SHADOW)))
    return ground


def airfield():
    models = [terminal(), tower(), hangars(), fuel_farm(), vehicles(), windsock(),
              approach_lights(), slope_indicators(), parked_airliner(), parked_light_aircraft(),
              village(), farm(), *woods(), hills()]
    return {
        "cigsim": 1,
        "name": "airfield",
        "background": SKY,
        "view": {"eye": [6, -490, 46], "attitude": [-2, -4, 0], "fov": 40},
        "sun": SUN,
        "models": [model.to_json() for model in models],
        "systems": traffic(),
        "ground": countryside() + runway() + taxiways() + shadows(models),
    }


def main():
    here = Path(__file__).resolve().parent
    write_scene(here / "airfield.json", airfield())
    write_approach(here / "airfield-approach.csv")


if __name__ == "__main__":
    main()
