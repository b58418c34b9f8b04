#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints a scene that fills the asupt1975 machine nearly to its capacities (2,500 edges, 256
crossings a line) on every line: six rows of 57 posts before an eye that looks north. Of most posts
two sides and an end are seen."""

import json

ROWS, POSTS = 6, 57
ROW_PITCH, POST_PITCH = 19.25, 128 / 64
WIDTH, HEIGHT, DEPTH, DISTANCE = 50 / 64, 18.75, 48 / 64, 100

FACES = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def post(row, column):
    x = (column - POSTS / 2) * POST_PITCH + (POST_PITCH - WIDTH) / 2
    z = (row - ROWS / 2) * ROW_PITCH + (ROW_PITCH - HEIGHT) / 2
    vertices = [[x + a * WIDTH, DISTANCE + b * DEPTH, z + c * HEIGHT]
                for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    colour = [80 + 2 * column, 210 - 20 * row, 120]
    return {"name": f"post {row + 1}.{column + 1}", "colour": colour, "vertices": vertices,
            "faces": FACES}


print(json.dumps({
    "cigsim": 1, "name": "full load", "background": [36, 44, 64],
    "view": {"eye": [0, 0, 0], "look_at": [0, DISTANCE, 0], "fov": 60},
    "objects": [post(row, column) for row in range(ROWS) for column in range(POSTS)]}))
