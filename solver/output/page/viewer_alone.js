'use strict';
// A page, or what a notebook shows of it: the bodies and nothing else, where <html> has the class `viewer_alone`
// (python/pinball/viewer.py).

function makePage(parts, bodies) {
  const alone = document.documentElement.classList.contains('viewer_alone');
  for (const part of alone ? [bodies] : parts) part();
  if (!alone) contents();
  drawCharts();
}
