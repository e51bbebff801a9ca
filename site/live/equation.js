// An equation of the paper on numbers of the reader: every value comes from the reference.
'use strict';

/** Where the numbers start, and what they are called. */
tpsLive.defaults = {
  u_A: ['0', '0'], u_B: ['3', '1'], v_A: ['1', '0.25'], v_B: ['-0.5', '0'], m_A: ['1'], m_B: ['2'], L: ['1'], dt: ['1'], c: ['0.8'], c_retract: ['0.5'],
  c_revolve: ['0.5'], theta_revolve_deg: ['45'], dp: ['-1', '0.5'],
};
/** For operations whose pair is at its limit: just touching, or taut. */
tpsLive.starts = {
  tether_time: { u_B: ['1', '0.5'], v_B: ['0.5', '0.75'], L: ['3'] },
  collision_impulse: { u_B: ['1', '0.25'] },
  tether_response: { u_B: ['1', '0'], v_A: ['0', '0'], v_B: ['0.25', '1'] },
  revolution_impulse: { u_B: ['1', '0'], v_A: ['0', '0'], v_B: ['0', '1'] },
};

/** What is shorter has no length in a figure: its inverse would be infinite. */
tpsLive.smallest = 1e-290;

tpsLive.Equation = class {
  constructor(root) {
    this.root = root;
    this.ops = root.dataset.ops.split(' ');
    this.figure = new tpsLive.Figure((key, numbers) => this.set(key, numbers.map((x) => String(Number(x.toPrecision(6))))));
    this.build();
    this.restore() || this.choose(this.ops[0]);
  }

  build() {
    const { element } = tpsLive;
    this.inputs = element('div', { className: 'tps-inputs' });
    this.answers = element('table', { className: 'tps-answers' });
    this.says = element('p', { className: 'tps-says' });
    this.lawList = element('ul', { className: 'tps-says' });
    this.code = element('div', { className: 'tps-code', tabIndex: 0 });
    this.operation = element('select', { 'aria-label': 'Operation' }, ...this.ops.map((op) => element('option', { value: op }, op)));
    this.operation.addEventListener('change', () => this.choose(this.operation.value, this.answersSame(this.operation.value) ? this.values : {}));
    const button = (text, action) => {
      const b = element('button', { type: 'button' }, text);
      b.addEventListener('click', action);
      return b;
    };
    this.copied = element('span', { role: 'status' });
    this.root.replaceChildren(
      element('div', { className: 'tps-live-row' }, element('label', {}, 'operation ', this.operation), button('a hard case', () => this.hardCase()), button('start again', () => { this.figure.scale = undefined; this.choose(this.operation.value); }),
        button('copy as tps eval …', () => this.copy(this.command())), button('copy as a request', () => this.copy(JSON.stringify({ seq: 1, op: this.op, in: this.request() }))),
        button('copy as known answer', () => this.copyKnownAnswer()), button('copy a link', () => this.copy(location.href.split('#')[0] + this.fragment())), this.copied),
      element('div', { className: 'tps-columns' }, element('div', {}, this.figure.element), element('div', {}, this.inputs)),
      this.says, element('div', { className: 'tps-scroll' }, this.answers), this.lawList, element('details', {}, element('summary', {}, 'The code that computes it'), this.code));
  }

  /** Whether an operation asks about the same pair, so that its answer can be read beside this one's: (2) as printed beside (2) without cancellation. */
  answersSame(op) {
    return [this.op, op].every((each) => ['block_time', 'paper_time'].includes(each));
  }

  async choose(op, values) {
    this.ask = await tpsLive.reference();
    this.copied.textContent = '';
    this.op = op;
    this.operation.value = op;
    if (!tpsLive.operations) tpsLive.operations = this.ask({ do: 'operations' }).operations;
    this.keys = tpsLive.operations.find((o) => o.name === op).keys;
    const start = { ...tpsLive.defaults, ...tpsLive.starts[op], ...values };
    this.values = Object.fromEntries(this.keys.map((key) => [key, start[key].slice()]));
    if (!window.tpsCases) await tpsLive.script('cases.js');
    this.showCode();
    this.showInputs();
    this.answer();
  }

  showInputs() {
    const { element } = tpsLive;
    this.fields = new Map();
    this.inputs.replaceChildren(...this.keys.flatMap((key) => {
      const fields = this.values[key].map((text, n) => {
        const field = element('input', { value: text, spellcheck: false, 'aria-label': this.values[key].length > 1 ? `${key}, ${'xyz'[n]}` : key });
        field.addEventListener('input', () => { this.values[key][n] = field.value; this.copied.textContent = ''; this.answer(); });
        return field;
      });
      this.fields.set(key, fields);
      return [element('span', {}, key), element('span', { className: fields.length > 1 ? 'tps-pair' : '' }, ...fields)];
    }));
  }

  set(key, texts) {
    this.values[key] = texts;
    this.fields.get(key).forEach((field, n) => { field.value = texts[n]; });
    this.answer();
  }

  request(values = this.values) {
    return Object.fromEntries(Object.entries(values).map(([key, texts]) => {
      const numbers = texts.map(tpsLive.asRequested);
      return [key, numbers.length > 1 ? numbers : numbers[0]];
    }));
  }

  answer() {
    let wrong = false;
    for (const [key, fields] of this.fields) {
      fields.forEach((field, n) => {
        const bad = Number.isNaN(tpsLive.numberOf(this.values[key][n]));
        field.setAttribute('aria-invalid', String(bad));
        wrong ||= bad;
      });
    }
    try {
      if (wrong) throw new Error('A number is a decimal, a hexadecimal float such as 0x1.8p+1, or inf.');
      this.report = this.ask({ do: 'eval', op: this.op, scalar: 'double', in: this.request() });
      this.says.classList.remove('tps-error');
      this.says.replaceChildren(...this.verdictWords());
      this.showAnswers();
      this.showLaws();
      this.markTables();
    } catch (error) {
      this.says.classList.add('tps-error');
      this.says.textContent = error.message;
      this.report = null;
      this.answers.replaceChildren();
    }
    this.drawFigure();
  }

  /** What the answer in double is worth: beside the certified one. */
  verdictWords() {
    const result = (report, key) => report.results.find((q) => q.key === key);
    if (this.op === 'block_time' || this.op === 'tether_time') {
      const sure = this.ask({ do: 'certified', op: this.op, in: this.request() });
      const mine = { verdict: result(this.report, 'verdict').word, t: result(this.report, 't').hex[0] };
      if (mine.verdict !== sure.verdict) return [`The certified verdict is ${sure.verdict}${sure.t ? ` at ${tpsLive.short(tpsLive.numberOf(sure.t))}` : ''}: in double this is a wrong one, ${mine.verdict}.`];
      if (!sure.t) return [`Certified: ${sure.verdict}, no event.`];
      const ulps = tpsLive.ulpsApart(tpsLive.numberOf(mine.t), tpsLive.numberOf(sure.t));
      return [`Certified: ${sure.verdict}, Δt = ${sure.t}; the answer in double is ${ulps === 0n ? 'the nearest one' : `${ulps} ulp off`}.`];
    }
    const approaches = this.op === 'tether_response' && Number(result(this.report, 'v_n')?.decimal?.[0] ?? this.report.steps.find((q) => q.key === 'v_n')?.decimal?.[0]) < 0;
    if (approaches) return ['v_n < 0: this pair comes together, and a taut tether does not pull it. No event of a run asks this question; the answer is what the formulas give.'];
    const known = this.knownAnswer();
    if (!known) return this.besideFiftyDigits();
    const one = known.case;
    if (one.kind && one.kind !== result(this.report, 'kind').word) {
      return [one.also ? `Rounding decides between ${one.kind} and ${one.also[0].kind} here, and either is right.` : `The certified response is to ${one.kind}: in double this is another one.`];
    }
    const off = Object.entries(one.out).map(([key, enclosures]) => {
      const q = result(this.report, key);
      return `${q.symbol} ${tpsLive.ulpsWords(q.hex.map((x, n) => tpsLive.place(tpsLive.numberOf(x)) - tpsLive.nearestPlace(enclosures[n], one.nearest[key][n])))}`;
    });
    return [`Against the certified enclosures: ${off.join(', ')}. A component that nearly cancels is many of its own ulps off.`];
  }

  /** Of eq. (1), which has no certified answers here. */
  besideFiftyDigits() {
    const wide = this.ask({ do: 'eval', op: this.op, scalar: 'mp50', in: this.request() });
    const off = this.report.results.filter((q) => q.hex.length).map((q) => {
      const other = wide.results.find((o) => o.key === q.key).decimal.map(Number);
      return `${q.symbol} ${tpsLive.ulpsWords(q.hex.map((x, n) => tpsLive.place(tpsLive.numberOf(x)) - tpsLive.place(other[n])))}`;
    });
    return [`Against the same in 50 digits, rounded: ${off.join(', ')}.`];
  }

  /** Header and case of the present question, as `tps vectors verify` reads them; null where it has no single known answer. */
  knownAnswer() {
    try {
      return this.ask({ do: 'known_answer', op: this.op, in: this.request() });
    } catch {
      return null;
    }
  }
  copyKnownAnswer() {
    const known = this.knownAnswer();
    if (known) this.copy(`${JSON.stringify(known.header)}\n${JSON.stringify(known.case)}\n`);
    else this.copied.textContent = 'not copied: known answers are of certified operations, and this is none';
  }

  showAnswers() {
    const { element } = tpsLive;
    const row = (q, isResult) => {
      const shown = q.word || (q.decimal.length ? (q.vector ? `(${q.decimal.map(tpsLive.short).join(', ')})` : tpsLive.short(q.decimal[0])) : 'none');
      const tr = element('tr', { className: isResult ? 'tps-result' : '', tabIndex: 0 }, element('td', {}, q.symbol), element('td', {}, q.formula), element('td', {}, shown),
        element('td', { className: 'tps-hex' }, q.hex.join(' ')));
      tr.dataset.quantity = q.key;
      tr.title = q.decimal.join(', ');
      for (const [on, lit] of [['mouseenter', true], ['mouseleave', false], ['focus', true], ['blur', false]]) tr.addEventListener(on, () => this.light(q.key, lit));
      return tr;
    };
    this.answers.replaceChildren(element('tr', {}, ...['symbol', 'formula', 'value', 'bits'].map((h) => element('th', {}, h))),
      ...this.report.steps.map((q) => row(q, false)), ...this.report.results.map((q) => row(q, true)));
  }

  /** Symbol, value and the lines of code that name it, together. */
  light(key, lit) {
    for (const e of this.root.querySelectorAll(`[data-quantity="${key}"], [data-names~="${key}"]`)) e.classList.toggle('tps-lit', lit);
    const line = lit && this.code.querySelector('.tps-lit');
    if (line) this.code.scrollTop = line.offsetTop - this.code.offsetTop - 40;
  }

  showCode() {
    const { element } = tpsLive;
    this.code.replaceChildren(...window.tpsHeaders[this.op].split('\n').map((line) => {
      const span = element('span', {}, line + '\n');
      span.dataset.names = line.replace(/\/\/.*$/, '').replace(/\bD\b/g, line.includes('int D') || line.includes(', D>') ? '' : 'D').split(/\W+/).filter(Boolean).join(' ');
      span.addEventListener('mouseenter', () => this.lightLine(span, true));
      span.addEventListener('mouseleave', () => this.lightLine(span, false));
      return span;
    }));
  }
  lightLine(span, lit) {
    for (const name of span.dataset.names.split(' ')) {
      for (const row of this.answers.querySelectorAll(`[data-quantity="${CSS.escape(name)}"]`)) row.classList.toggle('tps-lit', lit);
    }
  }

  showLaws() {
    const ask = (values) => this.ask({ do: 'eval', op: this.op, scalar: 'double', in: this.request(values) });
    this.lawList.replaceChildren(...tpsLive.judgeLaws(this.op, this.values, this.report, ask).map(({ name, holds }) => (
      holds === undefined ? tpsLive.element('li', {}, `${name}: cannot be asked here`) : tpsLive.element('li', { className: holds ? 'tps-law' : 'tps-law tps-broken' }, name))));
  }

  /** In the page's decision tables the row whose verdict it is and whose conditions hold. */
  markTables() {
    const word = this.report.results.find((q) => q.key === 'verdict')?.word;
    const signs = Object.fromEntries(this.report.steps.filter((q) => q.decimal.length).map((q) => [q.key, q.vector ? (q.decimal.every((x) => Number(x) === 0) ? 0 : 1) : Math.sign(Number(q.decimal[0]))]));
    const holds = { '=': (s) => s === 0, '<': (s) => s < 0, '>': (s) => s > 0, '≥': (s) => s >= 0, '≤': (s) => s <= 0 };
    const tables = [...document.querySelectorAll('.md-typeset table')].filter((t) => t.rows[0]?.cells[1]?.textContent === 'verdict');
    tables.forEach((table, n) => {
      for (const row of [...table.rows].slice(1)) {
        const conditions = row.cells[0].textContent.split(',').map((c) => /^\s*(\w) (\S) 0/.exec(c)).filter(Boolean);
        const mine = word && (this.op === 'block_time') === (n === 0) && row.cells[1].textContent === word &&
          conditions.every(([, name, relation]) => !(name in signs) || holds[relation](signs[name]));
        row.classList.toggle('tps-here', Boolean(mine));
      }
    });
  }

  drawFigure() {
    const v = Object.fromEntries(Object.entries(this.values).map(([key, texts]) => [key, texts.map(tpsLive.numberOf)]));
    const places = Object.entries(v).filter(([key]) => !/^[mc]/.test(key)).flatMap(([, x]) => x);
    if (Object.values(v).flat().some((x) => Number.isNaN(x)) || places.some((x) => !Number.isFinite(x)) || Object.values(v).some((x) => x.length > 2)) return;
    const placed = Boolean(v.u_A);
    const place = { A: placed ? v.u_A : [-2, 0], B: placed ? v.u_B : [2, 0] };
    const shown = { bodies: [], arrows: [], circles: [] };
    for (const label of ['A', 'B']) shown.bodies.push({ key: placed ? `u_${label}` : '', label, place: place[label], name: `Place of ${label}` });
    const speeds = [v.v_A, v.v_B].map((x) => Math.hypot(...x));
    if (!this.figure.dragging) this.unit = 1.8 / (Math.max(...speeds, tpsLive.smallest) || 1);
    for (const label of ['A', 'B']) shown.arrows.push({ key: `v_${label}`, from: place[label], vector: v[`v_${label}`], unit: this.unit, kind: 'velocity', name: `Velocity of ${label}` });
    if (v.L) shown.circles.push({ centre: place.A, radius: v.L[0], kind: 'limit' });
    if (this.report) this.addResults(shown, place);
    this.figure.draw(shown);
  }

  addResults(shown, place) {
    const result = Object.fromEntries(this.report.results.map((q) => [q.key, q.hex.map(tpsLive.numberOf)]));
    const impulse = result.dp || result.dp_AB;
    if (impulse) {
      const unit = 1.5 / Math.max(Math.hypot(...impulse), tpsLive.smallest);
      shown.arrows.push({ from: place.A, vector: impulse, unit, kind: 'impulse' }, { from: place.B, vector: impulse.map((x) => -x), unit, kind: 'impulse' });
    }
    for (const [key, label] of [['v_A', 'A'], ['v_B', 'B']]) if (result[key]) shown.arrows.push({ from: place[label], vector: result[key], unit: this.unit, kind: 'after' });
    if (result.v_load) for (const label of ['A', 'B']) shown.arrows.push({ from: place[label], vector: result.v_load, unit: this.unit, kind: 'after' });
    const time = result.t && result.t.length ? this.report.results.find((q) => q.key === 't').hex[0] : this.op === 'distance' ? this.request().dt : null;
    if (time && Number.isFinite(tpsLive.numberOf(String(time)))) {
      const { u_A, u_B, v_A, v_B } = this.request();
      const there = this.ask({ do: 'flight', in: { u_A, u_B, v_A, v_B, dt: time } });
      for (const label of ['A', 'B']) shown.circles.push({ centre: there[label].map(tpsLive.numberOf), radius: 0.26 / this.figure.scale || 0.1, kind: 'ghost' });
    }
  }

  hardCase() {
    const cases = window.tpsCases[this.op] || [];
    if (!cases.length) { this.copied.textContent = 'there are none of this operation'; return; }
    this.caseNumber = ((this.caseNumber ?? -1) + 1) % cases.length;
    const one = cases[this.caseNumber];
    this.figure.scale = undefined;
    this.choose(this.op, Object.fromEntries(Object.entries(one.in).map(([key, x]) => [key, [].concat(x).map(String)]))).then(() => {
      this.copied.textContent = `case ${this.caseNumber + 1} of ${cases.length}, ${one.id}: ${one.why}`;
    });
  }

  command() {
    return `tps eval ${this.op} ` + this.keys.map((key) => `${key}=${this.values[key].join(',')}`).join(' ');
  }
  fragment() {
    return '#' + new URLSearchParams({ op: this.op, ...Object.fromEntries(this.keys.map((key) => [key, this.values[key].join(',')])) });
  }
  restore() {
    const asked = new URLSearchParams(location.hash.slice(1));
    if (!this.ops.includes(asked.get('op'))) return false;
    this.choose(asked.get('op'), Object.fromEntries([...asked].filter(([key]) => key !== 'op').map(([key, text]) => [key, text.split(',')])));
    return true;
  }
  async copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      this.copied.textContent = 'copied';
    } catch {
      this.copied.textContent = text; // a page that was opened as a file may not use the clipboard everywhere
    }
  }
};
