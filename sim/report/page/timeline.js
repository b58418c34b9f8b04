// SPDX-License-Identifier: MIT
// The stages on a time axis: when each worked on a picture, and what it did meanwhile.

const kStages = ['frame_calculator', 'priority_processor', 'geometry_processor', 'edge_orderer',
  'priority_resolver', 'video_processor'];
const kDoings = ['busy', 'stalled', 'idle'];
const kLeft = 150, kRight = 960, kTop = 34, kRow = 34, kBar = 20;

/** About `most` round steps from 0 to `end`. */
function ticks(end, most) {
  const raw = end / most || 1, ten = Math.pow(10, Math.floor(Math.log10(raw)));
  const step = ten * [1, 2, 5, 10].find(k => k * ten >= raw);
  const out = [];
  for (let i = 0; i * step <= end; ++i) out.push(Number((i * step).toPrecision(12)));
  return out;
}

/** The frame of the chart: names of the stages and an axis. `end` in `unit`. */
function stageChart(label, end, unit, row) {
  const height = kTop + kStages.length * kRow, x = at => kLeft + (kRight - kLeft) * at / end;
  const chart = svg('svg', {viewBox: `0 0 980 ${height + 40}`, class: 'timeline',
    role: 'group', 'aria-label': label});
  for (const at of ticks(end, 8))
    chart.append(
      svg('line', {class: 'grid', x1: x(at), x2: x(at), y1: kTop - 6, y2: height}),
      svg('text', {x: x(at), y: height + 16, 'text-anchor': 'middle'}, String(at)));
  chart.append(svg('text', {x: kRight, y: height + 34, 'text-anchor': 'end'}, unit));
  kStages.forEach((stage, i) => {
    const y = kTop + i * kRow;
    chart.append(
      svg('text', {x: kLeft - 10, y: y + kBar / 2 + 4, 'text-anchor': 'end'}, words(stage)));
    chart.append(row(stage, y, x));
  });
  return chart;
}

/** Words under the chart that follow the pointer and the focus. */
function readout(start) {
  const line = h('p', {class: 'readout', role: 'status'}, start);
  const tells = text => ({mouseenter: () => line.textContent = text,
    focus: () => line.textContent = text, tabindex: '0', role: 'img', 'aria-label': text});
  return [line, tells];
}

function bar(x, from, to, y, height, attributes, title) {
  const width = Math.max(1, x(to) - x(from));
  return svg('rect', {x: x(from), y, width, height, ...attributes}, svg('title', {}, title));
}

/** Cycles: a picture between its viewpoint and its last element, with its neighbours behind. */
function cycleTimeline(frame, machine) {
  const timing = frame.figures.timing, ms = cycles => cycles * machine.clock_ns * 1e-6;
  const at = cycle => ms(cycle - timing.input);
  const end = at(timing.last_element + 1);
  const [line, tells] = readout('Point at a stage, or reach it by Tab, for its cycles.');
  const chart = stageChart('Stages over time', end, 'ms', (stage, y, x) => {
    const group = svg('g', {});
    for (const other of frame.neighbours) {
      const a = other.timing.stages[stage];
      const from = Math.max(0, at(a.start)), to = Math.min(end, at(a.finish + 1));
      if (from < to)
        group.append(bar(x, from, to, y, kBar, {class: 'other'}, `picture ${other.frame}`));
    }
    const a = timing.stages[stage], whole = a.finish - a.start + 1;
    const text = `${words(stage)}: cycles ${number(a.start)} to ${number(a.finish)}; ` +
      `${number(a.busy)} busy, ${number(a.idle)} idle, ${number(a.stalled)} stalled; ` +
      `busy for ${percent(a.utilisation)} of the frame`;
    const own = svg('g', {class: 'stage', 'data-stage': stage, ...tells(text)});
    let from = a.start;
    for (const doing of kDoings) {
      if (a[doing] === 0) continue;
      own.append(bar(x, at(from), at(from + a[doing]), y, kBar, {class: doing}, text));
      from += a[doing];
    }
    if (whole > 0)
      own.append(bar(x, at(a.start), at(a.finish + 1), y, kBar, {class: 'outline'}, text));
    group.append(own);
    return group;
  });
  let begin = 0;
  ['computer', 'geometry', 'display'].forEach((name, i) => {
    const x = kLeft + (kRight - kLeft) * ms(begin) / end;
    chart.append(
      svg('line', {class: 'boundary', x1: x, x2: x, y1: 8, y2: kTop + kStages.length * kRow}),
      svg('text', {x: x + 5, y: 18}, `frame ${i + 1}: ${name}`));
    begin += timing.frame_periods[i];
  });
  const legend = h('p', {class: 'legend'}, kDoings.map(doing =>
    h('span', {}, h('i', {class: doing}), doing === 'idle' ? 'idle (waits for a word)' :
      doing === 'stalled' ? 'stalled (waits for its word to be taken)' : 'busy')),
    h('span', {}, h('i', {class: 'other'}), 'other pictures'));
  const rows = kStages.map(stage => {
    const a = timing.stages[stage];
    return {stage: words(stage), start: a.start, finish: a.finish, busy: a.busy, idle: a.idle,
      stalled: a.stalled, 'busy share of its frame': percent(a.utilisation)};
  });
  return [
    h('p', {}, `From the viewpoint to the last element: ${number(timing.transport_delay)} cycles ` +
      `of ${number(machine.clock_ns)} ns = ${number(ms(timing.transport_delay))} ms. A bar ` +
      'reaches from the first cycle on this picture to the last; its colours tell how many of ' +
      'these the stage was busy, not when.'),
    scrolling('Time line', chart), line, legend,
    h('details', {}, h('summary', {}, 'Cycles of the stages'), recordTable(rows, 'Cycles')),
  ];
}

/** Without cycles: the time of this computer. */
function hostTimeline(frame) {
  const stages = frame.figures.stages, end = Math.max(...kStages.map(s => stages[s]), 1e-6);
  const [line, tells] = readout('Point at a stage, or reach it by Tab, for its time.');
  const chart = stageChart('Host time of the stages', end, 'ms', (stage, y, x) => {
    const text = `${words(stage)}: ${number(stages[stage])} ms`;
    return svg('g', {class: 'stage', 'data-stage': stage, ...tells(text)},
      bar(x, 0, stages[stage], y, kBar, {class: 'busy'}, text));
  });
  return [
    h('p', {}, 'The functional level knows no cycles: this is the time of the computer that the ' +
      `run was made on, ${number(frame.figures.host_ms)} ms in all. A stage without time has left ` +
      'its work to another: the painter does that of the edge orderer and the resolver.'),
    scrolling('Host time', chart), line,
  ];
}

function timeline(frame, machine) {
  return frame.figures.timing && machine ? cycleTimeline(frame, machine) : hostTimeline(frame);
}
