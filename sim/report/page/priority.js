// SPDX-License-Identifier: MIT
// Which faces pierce an element, by the machine's rule: a face is there from the first element at
// or right of its left edge up to the first one at or right of its right edge. The same as
// sim/report/shown_faces.cpp; the data are those of faces_json.hpp.

/** The first element at or right of an edge on a line. */
function elementOf(edge, line, width) {
  const others = edge[5] || [];
  for (let i = 0; i < others.length; i += 2)
    if (others[i] === line) return others[i + 1];
  return Math.min(width, Math.max(0, Math.ceil(edge[3] + edge[4] * (line - edge[0]))));
}

/** True when the face covers the element. Right edges come first at an element; see PR1. */
function covers(face, column, line, width) {
  const passed = [];
  for (const edge of face[2]) {
    if (line < edge[0] || line >= edge[1]) continue;
    const at = elementOf(edge, line, width);
    if (at <= column) passed.push([at, edge[2]]);
  }
  passed.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  let state = 0;
  for (const [, left] of passed) state = left ? Math.min(1, state + 1) : Math.max(-1, state - 1);
  return state === 1;
}

/**
 * Faces at an element, from the highest priority down: [{priority, object, colour, dropped}].
 * `dropped`: the line had more crossings than the machine holds, and lost this face.
 */
function facesAt(frame, column, line, width) {
  const limit = frame.limits.find(entry => entry[0] === line) || [line, null, null];
  const found = [];
  frame.faces.forEach((face, priority) => {
    if (!covers(face, column, line, width)) return;
    const dropped = (limit[1] !== null && priority >= limit[1]) ||
      (limit[2] !== null && column >= limit[2]);
    found.push({priority, object: face[0], colour: face[1], dropped});
  });
  return found;
}
