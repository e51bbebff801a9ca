// Search without a server: the sections of all pages are a script, and all of the words have to stand in one.
'use strict';
tpsLive.Search = class {
  constructor(root) {
    const { element } = tpsLive;
    this.input = element('input', { type: 'search', 'aria-label': 'Words to look for', placeholder: 'words, e.g. revolve energy', size: 40 });
    this.list = element('div', { 'aria-live': 'polite' });
    root.replaceChildren(element('div', { className: 'tps-live-row' }, element('label', {}, 'look for ', this.input)), this.list);
    this.input.value = new URLSearchParams(location.hash.slice(1)).get('q') || '';
    this.input.addEventListener('input', () => this.look());
    tpsLive.script('sections.js').then(() => this.look());
    this.input.focus();
  }
  look() {
    const words = this.input.value.toLowerCase().split(/\s+/).filter(Boolean);
    if (!words.length) { this.list.replaceChildren(); return; }
    const found = [];
    for (const [page, title, anchor, text] of window.tpsSections) {
      const inTitle = words.filter((w) => title.toLowerCase().includes(w)).length;
      const times = words.reduce((sum, w) => sum + text.toLowerCase().split(w).length - 1, 0);
      // Headings first, then where terms are explained, then where most of a section is about them.
      const weight = 10 * inTitle + (page === 'glossary.html' && times > 0 ? 5 : 0) + times / (20 + text.length / 200);
      if (words.every((w) => title.toLowerCase().includes(w) || text.toLowerCase().includes(w))) found.push({ page, title, anchor, text, weight });
    }
    found.sort((a, b) => b.weight - a.weight);
    this.list.replaceChildren(tpsLive.element('p', { className: 'tps-found' }, `${found.length} sections`), ...found.slice(0, 40).map((f) => this.entry(f, words[0])));
  }
  entry({ page, title, anchor, text }, word) {
    const { element } = tpsLive;
    const at = Math.max(0, text.toLowerCase().indexOf(word));
    const begin = Math.max(0, at - 60);
    return element('p', { className: 'tps-found' }, element('a', { href: page + (anchor ? `#${anchor}` : '') }, `${title} (${page.replace('.html', '')})`), element('br'), begin > 0 ? '… ' : '', text.slice(begin, at),
      element('mark', {}, text.slice(at, at + word.length)), text.slice(at + word.length, at + 120), ' …');
  }
};
