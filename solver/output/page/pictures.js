'use strict';
// Frames that `pinball view` has put here become a film: one frame at a time, a slider and a button.

function player(frames) {
  const images = [...frames.querySelectorAll('img:not(.surround)')];
  if (images.length === 0) return;
  const titles = JSON.parse(frames.dataset.titles ?? '[]');
  const slider = make('input', {type: 'range', min: 0, max: images.length - 1, value: 0, 'aria-label': 'time of the picture'});
  const label = make('output', {'aria-live': 'off'});
  const play = make('button', {type: 'button', text: 'Play'});
  let timer = null;
  const show = () => {
    images.forEach((image, i) => { image.hidden = i !== Number(slider.value); });
    label.textContent = titles[slider.value] ?? `${Number(slider.value) + 1} of ${images.length}`;
    slider.setAttribute('aria-valuetext', label.textContent);
  };
  const pause = () => {
    clearInterval(timer);
    timer = null;
    play.textContent = 'Play';
  };
  play.addEventListener('click', () => {
    if (timer) return pause();
    play.textContent = 'Pause';
    if (Number(slider.value) === images.length - 1) slider.value = -1;
    timer = setInterval(() => {
      slider.value = Number(slider.value) + 1;
      show();
      if (Number(slider.value) === images.length - 1) pause();
    }, 150);
  });
  slider.addEventListener('input', () => { pause(); show(); });
  images.forEach((image) => { image.loading = 'eager'; });  // hidden ones would never be loaded otherwise
  frames.append(make('div', {class: 'player'}, play, slider, label));
  show();
}

document.querySelectorAll('.frames').forEach(player);
