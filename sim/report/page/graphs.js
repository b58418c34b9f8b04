// SPDX-License-Identifier: MIT
// Graphs that the page draws itself: crossings by line, and figures over the frames of a run.

/** Crossings of each line, beside the picture and as high as it. */
function crossingsGraph(frame, capacity) {
  const counts = frame.crossings, most = Math.max(1, capacity, ...counts);
  let path = 'M0 0';
  counts.forEach((crossings, line) => {
    const x = (100 * crossings / most).toFixed(2);
    path += `L${x} ${line}L${x} ${line + 1}`;
  });
  const worst = counts.indexOf(Math.max(...counts));
  const graph = svg('svg', {class: 'crossings', viewBox: `0 0 100 ${counts.length}`,
    preserveAspectRatio: 'none', role: 'img', 'aria-label':
      `Crossings by line: at most ${counts[worst]}, on line ${worst}`},
  svg('path', {class: 'area', d: `${path}L0 ${counts.length}Z`}),
  svg('line', {class: 'worst', x1: 0, x2: 100, y1: worst + .5, y2: worst + .5}));
  if (capacity > 0) {
    const x = 100 * capacity / most;
    graph.append(svg('line', {class: 'capacity', x1: x, x2: x, y1: 0, y2: counts.length}));
  }
  const mark = svg('line', {class: 'mark', x1: 0, x2: 100});
  graph.append(mark);
  const show = line => {
    mark.setAttribute('y1', line + .5);
    mark.setAttribute('y2', line + .5);
  };
  return {graph, show, worst};
}

/** A figure over all frames, with the shown frame marked. */
function overFrames(rows, key, label, shown) {
  const points = rows.filter(row => typeof row[key] === 'number');
  if (points.length < 2) return null;
  const most = points.reduce((largest, row) => Math.max(largest, row[key]), 0);
  const last = rows[rows.length - 1].frame || 1;
  const x = frame => 10 + 280 * frame / last, y = value => 80 - 66 * value / (most || 1);
  const path = points.map((row, i) =>
    `${i ? 'L' : 'M'}${x(row.frame).toFixed(1)} ${y(row[key]).toFixed(1)}`).join('');
  const graph = svg('svg', {class: 'over', viewBox: '0 0 300 96', role: 'img',
    'aria-label': `${label}: up to ${number(most)}`},
  svg('line', {class: 'grid', x1: 10, x2: 290, y1: 80, y2: 80}), svg('path', {d: path}));
  const at = rows[shown];
  if (at && typeof at[key] === 'number')
    graph.append(svg('circle', {cx: x(at.frame), cy: y(at[key]), r: 4}));
  graph.append(svg('text', {x: 10, y: 93}, 'frame 0'),
    svg('text', {x: 290, y: 93, 'text-anchor': 'end'}, String(last)));
  return h('figure', {}, h('figcaption', {}, `${label}, up to ${number(most)}`), graph);
}
