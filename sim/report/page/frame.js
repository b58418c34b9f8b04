// SPDX-License-Identifier: MIT
// One frame of the run at a time: the chooser, the picture, time, figures, faults and overload.

/** How the picture differs from the exact one, in words. */
function differenceWords(difference) {
  const {elements, wrong, share, worst_distance: distance, colour} = difference;
  if (wrong === 0 && colour.wrong === 0)
    return `Every one of the ${number(elements)} elements is that of the exact picture.`;
  const place = wrong === 0 ? '' : distance === 0 ? ', at edges of the exact picture' :
    `, at most ${number(distance, 3)} elements from an edge of the exact picture`;
  return `Against the exact picture: ${count(wrong, 'element')} of ${number(elements)} ` +
    `(${percent(share)}) ${wrong === 1 ? 'shows' : 'show'} another object${place}; ` +
    `${count(colour.wrong, 'element')} ${colour.wrong === 1 ? 'has' : 'have'} another colour.`;
}

/** Pictures that there are of a frame: [kind, label, data URI]. */
function pictureKinds(frame) {
  const kinds = [['picture', 'picture', frame.picture]];
  if (frame.difference && frame.difference.picture)
    kinds.push(['difference', 'difference', frame.difference.picture],
      ['exact', 'exact', frame.difference.exact]);
  return kinds;
}

/** Takes the cross-hair from one place that differs to the next. */
function nextDifference(frame, state, redraw) {
  const places = frame.difference ? frame.difference.places : [];
  if (places.length === 0) return null;
  return h('button', {type: 'button', class: 'next-difference', click: () => {
    const after = places.find(([column, line]) =>
      line > state.line || (line === state.line && column > state.column));
    [state.column, state.line] = after || places[0];
    redraw('difference');
  }}, 'next difference →');
}

function kindChooser(kinds, state, redraw) {
  if (kinds.length < 2) return null;
  return h('fieldset', {class: 'kinds'}, h('legend', {}, 'Show'), kinds.map(([kind, label]) =>
    h('label', {}, h('input', {type: 'radio', name: 'kind', value: kind,
      checked: kind === state.kind, change: () => {
        state.kind = kind;
        redraw('kind');
      }}), ' ' + label)));
}

function faultsView(run, figures) {
  if (figures.listability.length === 0)
    return h('p', {}, 'No listability faults: every priority was unique.');
  const name = object => `${object} ${objectName(run, object)}`.trim();
  return recordTable(figures.listability.map(fault => ({group: fault.group,
    'objects in view': fault.objects.map(name).join(', '),
    circuit: fault.circuit.map(name).join(' → ') || '–',
    'pairs that no plane resolves':
      fault.unresolved.map(pair => pair.map(name).join(' and ')).join('; ') || '–'})), 'Faults');
}

function overloadView(figures) {
  const overload = figures.overload;
  if (!overload) return h('p', {}, 'Not on machine words: nothing can overflow.');
  const {overflows, ...rest} = overload;
  return h('div', {}, pairTable(Object.entries(rest), 'Overload'),
    h('p', {}, 'Words that were saturated, by stage:'),
    pairTable(Object.entries(overflows), 'Words saturated'));
}

function figuresView(figures) {
  const apart = ['timing', 'stages', 'overload', 'listability', 'picture', 'ids', 'frame'];
  const pairs = Object.entries(flat(figures)).filter(([name]) =>
    !apart.some(part => name === part || name.startsWith(part + ' ')));
  return pairTable(pairs, 'Figures of the frame');
}

function frameView(run, frame, state, redraw) {
  const kinds = pictureKinds(frame);
  if (!kinds.some(([kind]) => kind === state.kind)) state.kind = 'picture';
  const [, label, source] = kinds.find(([kind]) => kind === state.kind);
  const key = state.kind === 'difference' ? h('p', {class: 'legend'},
    h('span', {}, h('i', {class: 'wrong'}), 'another object'),
    h('span', {}, h('i', {class: 'recoloured'}), 'another colour alone')) : null;
  return [
    kindChooser(kinds, state, redraw),
    frame.difference ? h('p', {class: 'difference'}, differenceWords(frame.difference)) : null,
    nextDifference(frame, state, redraw), key,
    pictureView(run, frame, source, `${label} of frame ${frame.frame}`, state,
      state.kind === 'difference' ? frame.difference.places : []),
    h('h3', {}, 'Time'), timeline(frame, run.machine),
    h('div', {class: 'columns'},
      h('div', {}, h('h3', {}, 'Figures'), figuresView(frame.figures)),
      h('div', {}, h('h3', {}, 'Faults'), faultsView(run, frame.figures),
        h('h3', {}, 'Overload'), overloadView(frame.figures))),
  ];
}

/** The section of the frames; `choose(number)` shows another one. */
function frameSection(run, state, changed) {
  const shown = run.shown, body = h('div', {class: 'frame'});
  const select = h('select', {id: 'frame-select', change: () => go(Number(select.value))},
    shown.map((frame, i) => h('option', {value: i}, `frame ${frame.frame}`)));
  const before = h('button', {type: 'button', click: () => go(state.index - 1)}, '← before');
  const after = h('button', {type: 'button', click: () => go(state.index + 1)}, 'after →');
  const draw = focus => {
    const frame = shown[state.index];
    select.value = state.index;
    before.disabled = state.index === 0;
    after.disabled = state.index === shown.length - 1;
    body.replaceChildren(...frameView(run, frame, state, draw).flat().filter(node => node));
    const again = {kind: `input[value="${state.kind}"]`, difference: '.next-difference'}[focus];
    if (again) body.querySelector(again).focus();
    changed(frame);
  };
  const go = index => {
    if (index < 0 || index >= shown.length) return;
    state.index = index;
    draw();
  };
  const choose = number => {
    go(shown.findIndex(frame => frame.frame === number));
    document.getElementById('frames').scrollIntoView();
  };
  const some = shown.length < run.table.length ?
    `${shown.length} of the run's ${run.table.length} frames` : '';
  const bar = h('div', {class: 'toolbar'}, h('label', {for: 'frame-select'}, 'Frame'), before,
    select, after, h('span', {class: 'hint'}, some));
  return {node: section('frames', 'Frames', shown.length > 1 ? bar : null, body), draw, choose};
}
