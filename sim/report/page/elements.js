// SPDX-License-Identifier: MIT
// Making elements of the page. Words always go in as text: no name of a scene is taken for HTML.
'use strict';

const kSvg = 'http://www.w3.org/2000/svg';

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes || {})) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === 'function') node.addEventListener(name, value);
    else if (name === 'style') node.style.cssText = value;
    else node.setAttribute(name, value === true ? '' : value);
  }
  for (const child of children.flat(Infinity))
    if (child !== null && child !== undefined) node.append(child);
  return node;
}

/** An element of HTML. A function as attribute listens to the event of that name. */
function h(name, attributes, ...children) {
  return fill(document.createElement(name), attributes, children);
}

/** An element of SVG. */
function svg(name, attributes, ...children) {
  return fill(document.createElementNS(kSvg, name), attributes, children);
}

/** A number to be read: digits in groups, at most `digits` significant ones of a fraction. */
function number(value, digits = 4) {
  if (value === null || value === undefined) return '–';
  if (typeof value !== 'number') return String(value);
  if (Number.isInteger(value) && Math.abs(value) < 1e15)
    return String(value).replace(/\B(?=(\d{3})+$)/g, '\u202f');
  const short = Number(value.toPrecision(digits));
  return Number.isInteger(short) && Math.abs(short) < 1e15 ? number(short) : String(short);
}

/** A word of a file's for a reader: worst_line -> worst line. */
function words(key) {
  return String(key).replace(/_/g, ' ');
}

function count(amount, one, many = one + 's') {
  return number(amount) + ' ' + (amount === 1 ? one : many);
}

/** A share as per cent. */
function percent(share) {
  return share === 0 ? '0 %' : number(share * 100, 3) + ' %';
}

/** What may be wider than the page, in a box that scrolls by itself. */
function scrolling(label, ...children) {
  return h('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': label}, children);
}

function section(id, title, ...children) {
  return h('section', {id, 'aria-labelledby': id + '-title'},
    h('h2', {id: id + '-title'}, title), children);
}
