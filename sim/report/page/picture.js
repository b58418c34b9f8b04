// SPDX-License-Identifier: MIT
// A frame's picture with a cross-hair, crossings by line beside it, and what pierces the element
// under the cross-hair.

function objectName(run, object) {
  return run.object_names[object] || '';
}

/** The faces at an element as a list, the shown one first. */
function priorityList(run, frame, column, line) {
  const [width] = run.options.raster;
  const found = facesAt(frame, column, line, width);
  const shown = found.find(face => !face.dropped);
  const entry = (face, standing) => h('li', {'data-object': face.object, class: standing},
    h('i', {class: 'swatch', style: `background:${face.colour}`}),
    h('span', {class: 'object'}, `object ${face.object}`),
    h('span', {class: 'name'}, objectName(run, face.object)),
    h('span', {class: 'standing'}, standing, h('small', {}, ` face ${face.priority}`)));
  const standing = face =>
    face.dropped ? 'dropped on this line' : face === shown ? 'shown' : 'hidden';
  const background = h('li', {'data-object': 0, class: shown ? 'hidden' : 'shown'},
    h('i', {class: 'swatch', style: `background:${run.background}`}),
    h('span', {class: 'object'}, 'object 0'),
    h('span', {class: 'name'}, 'background'),
    h('span', {class: 'standing'}, shown ? 'hidden' : 'shown'));
  const kept = found.filter(face => !face.dropped), dropped = found.filter(face => face.dropped);
  return h('ol', {class: 'priority'}, kept.map(face => entry(face, standing(face))), background,
    dropped.map(face => entry(face, standing(face))));
}

function coordinate(label, limit, change) {
  const input = h('input', {type: 'number', min: 0, max: limit - 1, step: 1, inputmode: 'numeric',
    change: () => change(Number(input.value))});
  return {node: h('label', {}, label, ' ', input), input};
}

/** Where a cross-hair stands: {column, line} in `place`, told to all who listen. */
class CrossHair {
  constructor(place, width, height) {
    this.place = place;
    this.width = width;
    this.height = height;
    this.listeners = [];
  }

  listen(listener) {
    this.listeners.push(listener);
    listener(this.place.column, this.place.line);
  }

  move(column, line) {
    const inside = (value, size) => Math.min(size - 1, Math.max(0, Math.floor(value) || 0));
    this.place.column = inside(column, this.width);
    this.place.line = inside(line, this.height);
    for (const listener of this.listeners) listener(this.place.column, this.place.line);
  }

  key(event) {
    const step = event.shiftKey ? 16 : 1;
    const moves = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step],
      ArrowDown: [0, step]};
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    this.move(this.place.column + move[0], this.place.line + move[1]);
  }
}

/** The picture itself; a click moves the cross-hair. */
function pictureBox(source, words, hair) {
  const {width, height} = hair;
  const across = svg('line', {x1: 0, x2: width}), down = svg('line', {y1: 0, y2: height});
  const box = h('div', {class: 'picture', tabindex: '0', role: 'group', 'aria-label':
      'The picture. Arrow keys move the cross-hair, with Shift by 16 elements.',
    keydown: event => hair.key(event),
    click: event => {
      const area = box.getBoundingClientRect();
      hair.move(width * (event.clientX - area.left) / area.width,
        height * (event.clientY - area.top) / area.height);
    }},
  h('img', {src: source, alt: words, width, height}),
  svg('svg', {class: 'hair', viewBox: `0 0 ${width} ${height}`, 'aria-hidden': 'true'}, across,
    down));
  box.style.aspectRatio = `${width} / ${height}`;
  hair.listen((column, line) => {
    across.setAttribute('y1', line + .5);
    across.setAttribute('y2', line + .5);
    down.setAttribute('x1', column + .5);
    down.setAttribute('x2', column + .5);
  });
  return box;
}

/** The elements around the cross-hair, large. */
function lens(image, hair) {
  const around = 7, size = 2 * around + 1, scale = 12;
  const canvas = h('canvas', {class: 'lens', width: size * scale, height: size * scale,
    role: 'img', 'aria-label': `The ${size} by ${size} elements around the cross-hair`});
  const context = canvas.getContext('2d');
  const draw = () => {
    const {column, line} = hair.place;
    context.imageSmoothingEnabled = false;
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(image, column - around, line - around, size, size, 0, 0, canvas.width,
      canvas.height);
    context.strokeStyle = '#ff2bd6';
    context.lineWidth = 2;
    context.strokeRect(around * scale - 1, around * scale - 1, scale + 2, scale + 2);
  };
  hair.listen(() => image.complete ? draw() : image.addEventListener('load', draw, {once: true}));
  return canvas;
}

/** What stands at the cross-hair: its place, the line's crossings, the priority list. */
function hairPanel(run, frame, hair, magnified) {
  const column = coordinate('column', hair.width, value => hair.move(value, hair.place.line));
  const line = coordinate('line', hair.height, value => hair.move(hair.place.column, value));
  const crossings = h('p', {class: 'line-crossings'}), list = h('div', {'aria-live': 'polite'});
  hair.listen((c, r) => {
    column.input.value = c;
    line.input.value = r;
    crossings.textContent = frame.crossings ?
      `Line ${r}: ${count(frame.crossings[r], 'crossing')}` : '';
    list.replaceChildren(frame.faces ? priorityList(run, frame, c, r) :
      h('p', {}, 'There is no priority list of this frame; the notes above say why.'));
  });
  return h('aside', {class: 'panel', 'aria-label': 'At the cross-hair'},
    h('h3', {}, 'At the cross-hair'),
    h('div', {class: 'coordinates'}, column.node, line.node), crossings, magnified,
    h('p', {class: 'hint'}, 'Faces that pierce this element, from the highest priority down. ' +
      'Click the picture, or use the arrow keys on it.'), list);
}

/** A picture with its cross-hair; `marks` are places to be ringed. */
function pictureView(run, frame, source, words, place, marks) {
  const [width, height] = run.options.raster;
  const hair = new CrossHair(place, width, height);
  hair.move(place.column, place.line);
  const box = pictureBox(source, words, hair);
  for (const [column, line] of marks)
    box.querySelector('svg').append(
      svg('circle', {cx: column + .5, cy: line + .5, r: Math.max(width, height) / 80}));
  const raster = h('div', {class: 'raster'}, box);
  let caption = null;
  if (frame.crossings) {
    const capacity = run.machine ? run.machine.crossing_capacity : 0;
    const {graph, show, worst} = crossingsGraph(frame, capacity);
    hair.listen((column, line) => show(line));
    raster.append(h('div', {class: 'beside'}, graph));
    caption = h('p', {class: 'hint'}, `Right of the picture: crossings by line, at most ` +
      `${number(frame.crossings[worst])}, on line ${worst}` +
      (capacity > 0 ? `; a line holds ${number(capacity)}.` : '.'));
  }
  return h('div', {class: 'view'}, h('div', {class: 'main'}, raster, caption),
    hairPanel(run, frame, hair, lens(box.querySelector('img'), hair)));
}
