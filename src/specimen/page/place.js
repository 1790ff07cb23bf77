
/* ---- the place on the axis ---- */

function showPlace(value) {
  const slider = at('at');
  slider.value = value;
  slider.setAttribute('aria-valuetext', `${slider.value} of 100 from ${nameOf(first)} to ${nameOf(last)}`);
  at('value').value = slider.value;
  for (const element of inSight) element.style.setProperty('--at', slider.value);
}

function movePlace(value) {
  stop();
  showPlace(value);
  writeAddress();
}

/* What is out of sight keeps the place that it was seen at last: so it costs nothing, and pushes nothing about. */
const inSight = new Set(), followers = new Set();
const sight = new IntersectionObserver(entries => {
  for (const {target, isIntersecting} of entries) {
    if (isIntersecting) inSight.add(target);
    else inSight.delete(target);
    if (isIntersecting) target.style.setProperty('--at', at('at').value);
  }
}, {rootMargin: '200px'});

function follow(element) {
  followers.add(element);
  sight.observe(element);
}

function forget(element) {
  followers.delete(element);
  sight.unobserve(element);
  inSight.delete(element);
}

/* On paper everything is in sight. */
function showForPrint() {
  for (const element of followers) element.style.setProperty('--at', at('at').value);
}

/* An arrow key goes by one, or by ten with Shift; the finer steps are the pointer's. */
function moveByKey(event) {
  const up = event.key === 'ArrowRight' || event.key === 'ArrowUp';
  const down = event.key === 'ArrowLeft' || event.key === 'ArrowDown';
  if (event.key === ' ') togglePlay();
  else if (up || down) movePlace(Number(at('at').value) + (up ? 1 : -1) * (event.shiftKey ? 10 : 1));
  else return;
  event.preventDefault();
}

function fillTicks() {
  at('ticks').append(...places.map(place => {
    const tick = make('i', {});
    tick.style.left = `${place}%`;
    return tick;
  }));
}

/* ---- playing ---- */

const SWEEP = 5000; /* milliseconds from end to end */
const REST = 1500;  /* at each place, where motion is unwanted */
const lessMotion = matchMedia('(prefers-reduced-motion: reduce)');
let playing = 0; /* the frame that is asked for */

function togglePlay() {
  if (playing) stop();
  else play();
}

function stop() {
  cancelAnimationFrame(playing);
  if (playing) writeAddress();
  playing = 0;
  showPlaying();
}

function showPlaying() {
  root.classList.toggle('playing', playing !== 0);
  at('play').setAttribute('aria-label', playing ? 'Pause' : 'Play');
}

/* To and fro, slower near the ends, from where the slider stands; or from place to place, with a rest at each. */
function play() {
  const from = Number(at('at').value), phase = Math.acos(1 - from / 50) / Math.PI;
  const round = [...places, ...places.slice(1, -1).reverse()];
  const next = places.filter(place => place <= from).length;
  let start;
  const frame = now => {
    start ??= now;
    const gone = now - start;
    if (lessMotion.matches) showPlace(round[(next + Math.floor(gone / REST)) % round.length]);
    else showPlace(50 - 50 * Math.cos(Math.PI * (phase + gone / SWEEP)));
    playing = requestAnimationFrame(frame);
  };
  playing = requestAnimationFrame(frame);
  showPlaying();
}
