// SPDX-License-Identifier: MIT
// The page of a report. Its data: {cigsim, title, run or null, experiments: {experiments: [{file,
// figures}], drawings: [{file, uri}], notes}}. The run is stats.json without its frames, with
// object_names, notes, `table` (a row a frame) and `shown` (sim/report/run_section.hpp).

function notesView(notes) {
  return notes.map(words => h('p', {class: 'note', role: 'note'}, words));
}

const kOverFrames = [['host_ms', 'host time, ms'], ['transport_delay', 'transport delay, cycles'],
  ['crossings', 'crossings'], ['worst_line_crossings', 'crossings of the worst line'],
  ['dropped_faces', 'faces dropped'], ['late_lines', 'lines late']];

/** All frames of the run: graphs and a table, in which those in the page can be chosen. */
function allFrames(run, choose) {
  const graphs = h('div', {class: 'graphs'});
  const draw = frame => graphs.replaceChildren(...kOverFrames.map(([key, label]) =>
    overFrames(run.table, key, label, frame.frame)).filter(node => node));
  const shown = new Set(run.shown.map(frame => frame.frame));
  const rows = run.table.map(row => ({...row, frame: shown.has(row.frame) ?
    h('button', {type: 'button', class: 'link', click: () => choose(row.frame)},
      String(row.frame)) : row.frame}));
  return {node: section('all-frames', 'All frames', graphs, recordTable(rows, 'All frames')), draw};
}

function machineSection(machine) {
  if (!machine)
    return section('machine', 'Machine', h('p', {}, 'The run was not on machine words: it has no ' +
      'capacities, no clock and no machine description.'));
  const rows = machine.figures.map(figure => ({...figure,
    standing: h('span', {class: 'tag ' + figure.standing}, figure.standing)}));
  return section('machine', 'Machine',
    h('p', {}, h('strong', {}, machine.name), `: ${machine.title}`),
    notesView(machine.notices),
    h('p', {class: 'hint'}, 'Standing: published (by the source), recalled, derived (by the ' +
      'arithmetic in the source column), reconstruction (ours).'),
    recordTable(rows, 'Figures of the machine'));
}

/** Whether the run's numbers were within what they take without a wrong decision. */
function envelopeSection(envelope) {
  if (!envelope) return null;
  const outside = envelope.known && !envelope.inside;
  return section('envelope', 'Envelope', outside ? notesView([`Scene or viewpoints lie outside ` +
    `what ${envelope.format} numbers take without a wrong decision` +
    (envelope.will_do ? `; ${envelope.will_do} will do.` : '.')]) : null,
  dataView(envelope, 'Envelope'));
}

function budgetSection(budget) {
  return budget ? section('budget', 'Error budget', dataView(budget, 'Error budget')) : null;
}

function settingsSection(run) {
  const {level, options, seed, versions, interrupted, ids_saturate: saturate} = run;
  return section('settings', 'Options and versions', h('div', {class: 'columns'},
    h('div', {}, h('h3', {}, 'Options'), pairTable([['scene', run.scene], ['level', level],
      ...Object.entries(flat(options)), ['seed', seed], ['interrupted', interrupted],
      ['object numbers beyond 65535', saturate]], 'Options')),
    h('div', {}, h('h3', {}, 'Versions'), pairTable(Object.entries(flat(versions)), 'Versions'))));
}

function runSections(run) {
  const [width, height] = run.options.raster;
  const state = {index: 0, kind: 'picture', column: Math.floor(width / 2),
    line: Math.floor(height / 2)};
  if (run.shown.length === 0)
    return [...notesView(run.notes), h('p', {}, 'The run has no frame.'),
      machineSection(run.machine), settingsSection(run)];
  let frames = null;
  const all = allFrames(run, number => frames.choose(number));
  frames = frameSection(run, state, frame => all.draw(frame));
  frames.draw();
  return [...notesView(run.notes), frames.node, run.table.length > 1 ? all.node : null,
    budgetSection(run.budget), envelopeSection(run.envelope), machineSection(run.machine),
    settingsSection(run), section('preparation', 'Preparation', dataView(run.preparation, 'Preparation'))];
}

function drawingView({file, uri}) {
  return h('figure', {class: 'drawing'}, h('img', {src: uri, alt: file, loading: 'lazy'}),
    h('figcaption', {}, file));
}

function experimentSections({experiments, drawings, notes}) {
  const out = [...notesView(notes)];
  if (drawings.length > 0)
    out.push(section('drawings', 'Drawings', h('div', {class: 'drawings'},
      drawings.map(drawingView))));
  experiments.forEach(({file, figures}, i) => out.push(section(`experiment-${i}`,
    `Experiment ${figures.experiment}`, h('p', {class: 'hint'}, file), dataView(figures))));
  return out;
}

function headerView(data) {
  const {run} = data, facts = [];
  if (run) {
    facts.push(`level ${run.level}`, `${run.options.number} numbers`,
      `${run.options.raster.join(' × ')} elements`, count(run.table.length, 'frame'));
    if (run.machine) facts.push(`machine ${run.machine.name}`);
    if (run.interrupted) facts.push('interrupted');
  }
  const {experiments, drawings} = data.experiments;
  if (experiments.length > 0) facts.push(count(experiments.length, 'experiment'));
  if (drawings.length > 0) facts.push(count(drawings.length, 'drawing'));
  return [h('p', {class: 'kind'}, 'cigsim report'), h('h1', {}, data.title),
    h('p', {class: 'facts'}, facts.join(' · ')), h('p', {class: 'hint'},
      `Made by cigsim ${data.cigsim}.`)];
}

function contents(sections) {
  return h('nav', {'aria-label': 'Sections'}, sections.filter(node => node.id).map(node =>
    h('a', {href: '#' + node.id}, node.querySelector('h2').textContent)));
}

const data = JSON.parse(document.getElementById('data').textContent);
const sections = [...(data.run ? runSections(data.run) : []),
  ...experimentSections(data.experiments)].filter(node => node);
document.getElementById('header').append(...headerView(data), contents(sections));
document.getElementById('content').replaceChildren(...sections);
