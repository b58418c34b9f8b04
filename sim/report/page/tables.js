// SPDX-License-Identifier: MIT
// Data as tables, whatever their shape: what an experiment writes is shown without knowing it.

const kOpenRows = 60;    // a longer table waits until it is opened
const kInlineValues = 8;  // a longer list of values too
const kLongWords = 16;    // they get a wide column
const kAside = ['versions', 'host'];

const isScalar = value => value === null || typeof value !== 'object';
const isRecord = value => !isScalar(value) && !Array.isArray(value);

/** A cell; `numeric` ones stand to the right. */
function cell(value, numeric = false, name = 'td') {
  const style = {class: numeric && 'number'};
  if (typeof value === 'number') return h(name, {...style, title: String(value)}, number(value));
  if (typeof value === 'boolean') return h(name, style, value ? 'yes' : 'no');
  if (value instanceof Node) return h(name, style, value);
  if (typeof value === 'string' && value.length > kLongWords) style.class = 'words';
  return h(name, style, value === null || value === undefined ? '–' : String(value));
}

/** Rows [{column: value}] under the names of their columns. */
function recordTable(rows, label) {
  const all = [...new Set(rows.flatMap(row => Object.keys(row)))];
  // A record that is missing in some rows leaves an empty column of its own name behind.
  const columns = all.filter(name => !all.some(other => other.startsWith(name + ' ')) ||
    rows.some(row => row[name] !== null && row[name] !== undefined));
  const numeric = new Set(columns.filter(name =>
    rows.some(row => typeof row[name] === 'number')));
  return scrolling(label, h('table', {},
    h('thead', {}, h('tr', {}, columns.map(name =>
      h('th', {scope: 'col', class: numeric.has(name) && 'number'}, words(name))))),
    h('tbody', {}, rows.map(row => h('tr', {}, columns.map(name =>
      cell(row[name], numeric.has(name))))))));
}

/** Names and values, a line each. */
function pairTable(pairs, label) {
  return scrolling(label, h('table', {class: 'pairs'}, h('tbody', {}, pairs.map(([name, value]) =>
    h('tr', {}, h('th', {scope: 'row'}, words(name)), cell(value))))));
}

/** Details whose content is made when they are first opened. */
function folded(summary, make, open = false) {
  const details = h('details', {}, h('summary', {}, summary));
  let made = false;
  const build = () => {
    if (!made && details.open) {
      made = true;
      details.append(make());
    }
  };
  details.addEventListener('toggle', build);
  if (open) {
    details.open = true;
    build();
  }
  return details;
}

/** A record's values on one level: {a: {b: 1}} -> {'a b': 1}. */
function flat(record, prefix = '', out = {}) {
  for (const [key, value] of Object.entries(record))
    if (isRecord(value)) flat(value, prefix + key + ' ', out);
    else out[prefix + key] = isScalar(value) ? value : listCell(value);
  return out;
}

/** A list within a cell. */
function listCell(list) {
  if (list.every(isScalar) && list.length <= kInlineValues)
    return list.map(value => number(value)).join(', ');
  return folded(count(list.length, 'entry', 'entries'), () => dataView(list));
}

const isLong = value => Array.isArray(value) &&
  (value.length > kInlineValues || !value.every(isScalar));
const values = value => isRecord(value) ? Object.values(value).flatMap(values) : [value];

/** What of a record fits into a row. */
function withoutLong(record) {
  return Object.fromEntries(Object.entries(record).filter(([, value]) => !isLong(value)).map(
    ([key, value]) => [key, isRecord(value) ? withoutLong(value) : value]));
}

/** A record without long lists within. */
const isRow = value => isRecord(value) && !values(value).some(isLong);

/** What a record of a list may be called: its first words, else its number. */
function nameOf(record, i) {
  const words = Object.values(record).find(value => typeof value === 'string');
  return words === undefined ? String(i) : words;
}

function listView(list, label) {
  if (list.length === 0) return h('p', {}, 'none');
  if (list.every(isRow)) return recordTable(list.map(row => flat(row)), label);
  if (list.every(isRecord)) {
    const rows = list.map(record => flat(withoutLong(record)));
    return h('div', {class: 'data'},
      rows.some(row => Object.keys(row).length > 1) ? recordTable(rows, label) : null,
      list.map((record, i) => folded(words(nameOf(record, i)), () => dataView(record))));
  }
  if (list.every(isScalar))
    return h('p', {class: 'values'}, list.map(value => number(value)).join(', '));
  return recordTable(list.map((row, i) => {
    const values = {'': i};
    if (Array.isArray(row)) row.forEach((value, k) => values[k] = isScalar(value) ? value :
      listCell([value].flat()));
    else Object.assign(values, isScalar(row) ? {value: row} : flat(row));
    return values;
  }), label);
}

/** What says where figures were made comes after the figures. */
const inOrder = entries => [...entries.filter(([key]) => !kAside.includes(key)),
  ...entries.filter(([key]) => kAside.includes(key))];

/** Anything. */
function dataView(value, label = 'Figures') {
  if (isScalar(value)) return h('p', {}, cell(value, false, 'span'));
  if (Array.isArray(value)) return listView(value, label);
  const rows = Object.entries(value);
  if (rows.length > 1 && rows.every(([, row]) => isRow(row)))
    return recordTable(rows.map(([name, row]) => ({'': words(name), ...flat(row)})), label);
  const pairs = [], rest = [];
  for (const [key, entry] of Object.entries(value)) {
    const short = Array.isArray(entry) && !isLong(entry);
    if (isScalar(entry) || short) pairs.push([key, short ? listCell(entry) : entry]);
    else rest.push([key, entry]);
  }
  return h('div', {class: 'data'}, pairs.length > 0 ? pairTable(pairs, label) : null,
    inOrder(rest).map(([key, entry]) => {
      const size = Array.isArray(entry) ? ` (${number(entry.length)})` : '';
      const open = Array.isArray(entry) ? entry.length <= kOpenRows && entry.some(isRecord) :
        values(entry).length <= kOpenRows && !kAside.includes(key);
      return folded(words(key) + size, () => dataView(entry, words(key)), open);
    }));
}
