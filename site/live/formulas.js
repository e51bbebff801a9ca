// Formulas that the Markdown holds as TeX.
'use strict';
document.addEventListener('DOMContentLoaded', () => {
  for (const element of document.querySelectorAll('.arithmatex')) {
    const text = element.textContent.trim();
    const display = text.startsWith('\\[');
    katex.render(text.slice(2, -2), element, { displayMode: display, throwOnError: false });
  }
});
