// Draws the figures of the page: their data (plot.hpp) become Vega specifications. Vega interprets these (ast), so that a policy without
// unsafe-eval is enough. Colours are variables of the style sheet: they follow the reader's setting without a new drawing.
const { expressionInterpreter } = vegaParts['vega-interpreter'];
Object.assign(vegaParts['vega-dataflow'].transforms, vegaParts['vega-transforms'], vegaParts['vega-view-transforms'], vegaParts['vega-encode'],
  { label: vegaParts['vega-label'].label });

const powerOf = (base, n) => base + String(n).replace(/./g, (c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c]));
const tickLabels = (axis) => Object.fromEntries(axis.ticks.map((n) => [n, axis.base ? powerOf(axis.base, n) : String(n)]));
const strokes = {
  front: { stroke: 'var(--soft)', width: 1.2, dash: [3, 3] },
  'front right': { stroke: 'var(--ink)', width: 1.6, dash: [] },
  envelope: { stroke: 'var(--faint)', width: 1.2, dash: [5, 3] },
};
const strokeOf = (style) => strokes[style] ?? { stroke: `var(--${style})`, width: 1.2, dash: [] };
const dot = (colour) => ({ fill: colour, stroke: null, size: 41, shape: 'circle' });
const cross = (colour) => ({ fill: null, stroke: colour, size: 49, shape: 'M-1,-1L1,1M1,-1L-1,1' });

/** The Vega specification of a figure, whose marks say `tips`. */
function specification({ x, y, lines, points }, tips) {
  const axisOf = (axis, scale, orient) => ({
    scale, orient, title: axis.title, values: axis.ticks, grid: true, domain: false, ticks: false, gridColor: 'var(--faint)', gridWidth: 0.5,
    labelColor: 'var(--ink)', labelFontSize: 11, labelPadding: 6, titleColor: 'var(--ink)', titleFontSize: 11, titleFontWeight: 'normal',
    encode: { labels: { update: { text: { signal: `${scale}_labels[datum.value]` } } } },
  });
  const at = { x: { scale: 'x', field: 'x' }, y: { scale: 'y', field: 'y' } };
  const symbols = (data, name, enter) => ({ type: 'symbol', name, from: { data }, interactive: false, aria: false, encode: { enter: { ...at, ...enter } } });
  return {
    width: 390, height: 242, autosize: 'none', padding: { left: 58, right: 12, top: 24, bottom: 44 },
    signals: [{ name: 'x_labels', value: tickLabels(x) }, { name: 'y_labels', value: tickLabels(y) }],
    data: [
      { name: 'lines', values: lines.flatMap((line, k) => line.at.map(([px, py]) => ({ line: k, x: px, y: py, ...strokeOf(line.style) }))) },
      { name: 'points', values: points.map(([px, py, style, label, wrong], k) => ({ x: px, y: py, label, tip: tips[k], ...(wrong ? cross : dot)(`var(--${style})`) })) },
      { name: 'labelled', source: 'points', transform: [{ type: 'filter', expr: 'datum.label' }] },
    ],
    scales: [
      { name: 'x', type: 'linear', domain: [x.low, x.high], range: 'width', zero: false },
      { name: 'y', type: 'linear', domain: [y.low, y.high], range: 'height', zero: false },
    ],
    axes: [axisOf(x, 'x', 'bottom'), axisOf(y, 'y', 'left')],
    marks: [
      { type: 'group', from: { facet: { name: 'line', data: 'lines', groupby: 'line' } }, interactive: false, aria: false,
        marks: [{ type: 'line', from: { data: 'line' }, interactive: false, aria: false,
          encode: { enter: { ...at, stroke: { field: 'stroke' }, strokeWidth: { field: 'width' }, strokeDash: { field: 'dash' } } } }] },
      symbols('points', 'shapes', { fill: { field: 'fill' }, stroke: { field: 'stroke' }, strokeWidth: { value: 2 }, size: { field: 'size' }, shape: { field: 'shape' } }),
      symbols('labelled', 'anchors', { fill: { value: 'transparent' }, size: { value: 41 } }),
      { type: 'text', from: { data: 'anchors' }, interactive: false, aria: false,
        encode: { enter: { text: { field: 'datum.label' }, fontSize: { value: 8 }, fill: { value: 'var(--soft)' } } },
        transform: [{ type: 'label', size: [460, 310], anchor: ['top-right', 'top', 'right', 'bottom-right', 'left'], offset: [2], avoidMarks: ['shapes'] }] },
      { ...symbols('points', 'reach', { size: { value: 200 }, fill: { value: 'transparent' }, description: { field: 'tip' }, tooltip: { field: 'tip' }, ariaRole: { value: 'img' } }),
        interactive: true, aria: true },
    ],
  };
}

/** One mark of a plot is a stop of the tabulator key; arrows, Home and End go on from it. The mark in focus tells its figures. */
function makeReachable(plot, show) {
  const marks = [...plot.querySelectorAll('.reach path')];
  marks.forEach((mark, k) => { mark.tabIndex = k ? -1 : 0; });
  plot.addEventListener('focusin', (event) => show(event.target.getAttribute('aria-label')));
  plot.addEventListener('focusout', () => show(''));
  plot.addEventListener('keydown', (event) => {
    const from = marks.indexOf(event.target);
    const to = { ArrowRight: from + 1, ArrowDown: from + 1, ArrowLeft: from - 1, ArrowUp: from - 1, Home: 0, End: marks.length - 1 }[event.key];
    if (from < 0 || !marks[to]) return;
    event.preventDefault();
    marks[from].tabIndex = -1;
    marks[to].tabIndex = 0;
    marks[to].focus();
  });
}

async function draw(figure) {
  const plot = figure.querySelector('.plot'), tip = figure.querySelector('.tip');
  const show = (text) => { tip.textContent = text; tip.classList.toggle('shown', text !== ''); };
  const tips = [...figure.querySelectorAll('details li')].map((item) => item.textContent);
  const drawing = specification(JSON.parse(figure.querySelector('script').textContent), tips);
  const runtime = vegaParts['vega-parser'].parse(drawing, null, { ast: true });
  const view = new vegaParts['vega-view'].View(runtime, { expr: expressionInterpreter, renderer: 'svg', container: plot });
  view.description(figure.querySelector('figcaption').textContent);
  view.tooltip((handler, event, item, value) => show(value ?? ''));
  await view.runAsync();
  makeReachable(plot, show);
}

Promise.all([...document.querySelectorAll('figure')].map(draw)).then(() => { document.body.dataset.drawn = 'all'; });
