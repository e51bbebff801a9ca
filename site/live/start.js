// Puts the live parts where the pages have a place for them.
'use strict';
document.addEventListener('DOMContentLoaded', () => {
  for (const root of document.querySelectorAll('.tps-equation')) root.live = new tpsLive.Equation(root);
  for (const root of document.querySelectorAll('.tps-experiment')) root.live = new tpsLive.experiments[root.dataset.experiment](root);
  for (const root of document.querySelectorAll('.tps-search')) root.live = new tpsLive.Search(root);
});
