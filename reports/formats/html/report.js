'use strict';
(() => {
  const data = JSON.parse(document.getElementById('run-data').textContent);
  const byId = (id) => document.getElementById(id);
  const make = (tag, properties = {}, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };
  const words = (text) => text.toLowerCase().split(/\s+/).filter(Boolean);
  const remember = (key, value) => {
    try {
      if (value === undefined) return localStorage.getItem('lightbench-' + key);
      localStorage.setItem('lightbench-' + key, value);
    } catch (error) { /* some browsers have no storage for files */ }
    return null;
  };

  const filterRows = (rows, textOf, query, output, noun) => {
    const wanted = words(query);
    let shown = 0;
    for (const row of rows) {
      const text = textOf(row);
      row.hidden = !wanted.every((word) => text.includes(word));
      shown += !row.hidden;
    }
    output.textContent = shown === rows.length ? '' : `${shown} of ${rows.length} ${noun}`;
  };

  // Pictures: filter, order, what is shown, and how large.
  const pictureTable = byId('picture-table');
  const pictureRows = [...pictureTable.tBodies[0].rows];
  const pictureTools = byId('picture-tools');
  const nameOf = (row) => row.dataset.name.toLowerCase();

  const sortPictures = (key) => {
    const number = (row, missing) => (key in row.dataset ? Number(row.dataset[key]) : missing);
    const order = {
      name: (a, b) => nameOf(a).localeCompare(nameOf(b), undefined, {numeric: true}),
      gain: (a, b) => number(a, Infinity) - number(b, Infinity),
      error: (a, b) => number(b, -Infinity) - number(a, -Infinity),
    }[key];
    pictureTable.tBodies[0].append(...(order ? [...pictureRows].sort((a, b) => order(a, b) || 0) : pictureRows));
  };
  const showKind = (kind) => {
    for (const img of pictureTable.querySelectorAll('.picture img')) {
      const source = img.dataset[kind] || img.dataset.image;
      if (img.getAttribute('src') !== source) img.src = source;
    }
  };
  const setSize = (size) => document.documentElement.style.setProperty('--thumb', `${size}px`);

  const fittingSize = () => {
    const columns = pictureTable.tHead.rows[0].cells.length;
    const room = (pictureTable.parentElement.clientWidth - 20) / columns - 18;
    return Math.round(Math.min(420, Math.max(180, room)));
  };

  if (pictureTools) {
    pictureTools.hidden = false;
    pictureTools.addEventListener('submit', (event) => event.preventDefault());
    byId('picture-filter').addEventListener('input', (event) =>
      filterRows(pictureRows, nameOf, event.target.value, byId('picture-count'), 'rows'));
    byId('picture-sort').addEventListener('change', (event) => sortPictures(event.target.value));
    for (const radio of pictureTools.elements.show)
      radio.addEventListener('change', () => showKind(radio.value));
    const size = byId('picture-size');
    size.value = remember('size') || fittingSize();
    setSize(size.value);
    size.addEventListener('input', () => { setSize(size.value); remember('size', size.value); });
  }

  // Scores: filter and sort by column; rows without a value stay at the end.
  const scoreTable = byId('score-table');
  if (scoreTable) {
    const rows = [...scoreTable.tBodies[0].rows];
    const textOf = (row) => [...row.cells].slice(0, 3).map((cell) => cell.textContent.toLowerCase()).join(' ');
    const tools = byId('score-tools');
    tools.hidden = false;
    tools.addEventListener('submit', (event) => event.preventDefault());
    byId('score-filter').addEventListener('input', (event) =>
      filterRows(rows, textOf, event.target.value, byId('score-count'), 'scores'));
    const heads = [...scoreTable.tHead.rows[0].cells];
    heads.forEach((head, column) => head.querySelector('button').addEventListener('click', () => {
      const descending = head.getAttribute('aria-sort') === 'ascending';
      heads.forEach((other) => other.removeAttribute('aria-sort'));
      head.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
      const numeric = head.classList.contains('number');
      const valueOf = (row) => row.cells[column]?.dataset.v;
      rows.sort((a, b) => {
        const x = valueOf(a), y = valueOf(b);
        if (x === undefined || y === undefined) return (x === undefined) - (y === undefined);
        const order = numeric ? x - y : x.localeCompare(y, undefined, {numeric: true});
        return descending ? -order : order;
      });
      scoreTable.tBodies[0].append(...rows);
    }));
  }

  // Films: the pictures of a sequence, frame by frame.
  for (const film of document.querySelectorAll('.film')) {
    const {rate, frames} = data.sequences[film.dataset.sequence];
    const tools = film.querySelector('form');
    const [play, slider, heat, output] = tools.querySelectorAll('button, input, output');
    const images = [...film.querySelectorAll('img')];
    const pictureOf = (view, source, kind) => view.pictures.find((picture) => picture.of === source
      && picture.kind === kind && (!picture.against || picture.against === data.reference));
    const show = () => {
      const view = data.views[frames[slider.value]];
      for (const image of images) {
        const source = image.dataset.source;
        const picture = (heat.checked && pictureOf(view, source, 'heat'))
          || pictureOf(view, source, 'variant') || pictureOf(view, source, 'reference');
        if (picture) image.src = picture.src; else image.removeAttribute('src');
      }
      output.textContent = view.name;
    };
    let timer = 0;
    const stop = () => { clearInterval(timer); timer = 0; play.textContent = 'Play'; };
    play.addEventListener('click', () => {
      if (timer) { stop(); return; }
      play.textContent = 'Stop';
      timer = setInterval(() => { slider.value = (Number(slider.value) + 1) % frames.length; show(); }, 1000 / (rate || 12));
    });
    slider.addEventListener('input', () => { stop(); show(); });
    heat.addEventListener('change', show);
    tools.addEventListener('submit', (event) => event.preventDefault());
    tools.hidden = false;
    show();
  }

  // The viewer: two pictures of one view, slid, flipped or side by side, with one zoom for both.
  const modes = [['slide', 'Slide', 's'], ['flip', 'Flip', 'f'], ['side', 'Side by side', 'd']];
  const state = {view: 0, a: 0, b: 0, mode: 'slide', split: .5, front: 'b', zoom: 0, x: 0, y: 0};
  const viewer = make('dialog', {id: 'viewer'});
  const title = make('b');
  const chooseA = make('select', {title: 'Left picture'}), chooseB = make('select', {title: 'Right picture'});
  const modeButtons = modes.map(([mode, text, key]) => make('button', {
    type: 'button', textContent: text, title: `Key ${key}`, onclick: () => { state.mode = mode; draw(); },
  }));
  const button = (text, hint, action) => make('button', {type: 'button', textContent: text, title: hint, onclick: action});
  const zoomText = make('span');
  const imageA = make('img', {alt: '', draggable: false}), imageB = make('img', {alt: '', draggable: false});
  const paneA = make('div', {className: 'pane'}, imageA), paneB = make('div', {className: 'pane'}, imageB);
  const labelA = make('span', {className: 'label a'}), labelB = make('span', {className: 'label b'});
  const handle = make('div', {className: 'handle'});
  const stage = make('div', {className: 'stage'}, paneA, paneB, handle, labelA, labelB);
  const numbers = make('div', {className: 'numbers'});

  viewer.append(
    make('div', {className: 'bar'},
      button('‹', 'Previous view, key ←', () => step(-1)), button('›', 'Next view, key →', () => step(1)), title,
      make('span', {className: 'spacer'}),
      make('label', {}, 'A ', chooseA), make('label', {}, 'B ', chooseB), ...modeButtons,
      button('−', 'Zoom out, key -', () => zoomBy(1 / 1.5)), zoomText, button('+', 'Zoom in, key +', () => zoomBy(1.5)),
      button('Fit', 'Key 0', () => { state.zoom = 0; draw(); }), button('Close', 'Key Esc', () => viewer.close())),
    stage, numbers);
  document.body.append(viewer);

  const view = () => data.views[state.view];
  const paneWidth = () => stage.clientWidth / (state.mode === 'side' ? 2 : 1);
  const fit = () => Math.min(paneWidth() / data.width, stage.clientHeight / data.height) || 1;
  const scale = () => (state.zoom ? state.zoom : fit());

  const place = (image, offset) => {
    const z = scale();
    if (!state.zoom) {
      state.x = (paneWidth() - data.width * z) / 2;
      state.y = (stage.clientHeight - data.height * z) / 2;
    }
    image.style.width = `${data.width}px`;
    image.style.transform = `translate(${state.x + offset}px, ${state.y}px) scale(${z})`;
    image.classList.toggle('pixels', z >= 2);
  };

  const drawNumbers = (pictureA, pictureB) => {
    const reference = [pictureA, pictureB].find((picture) => picture?.kind === 'reference')?.of
      || pictureB?.against || pictureA?.against || data.reference;
    numbers.replaceChildren();
    const seen = new Set();
    for (const picture of [pictureA, pictureB]) {
      const values = picture && view().scores[picture.of]?.[reference];
      if (!values || seen.has(picture.of)) continue;
      seen.add(picture.of);
      numbers.append(make('b', {textContent: `${picture.of} against ${reference}`}));
      for (const [name, value] of values) numbers.append(make('span', {}, make('i', {textContent: name}), ` ${value}`));
    }
    numbers.append(make('span', {
      className: 'hint', textContent: '← → view · 1–9 picture B · space flips · wheel zooms · drag moves',
    }));
  };

  const setSource = (image, picture) => {
    if (!picture) { image.removeAttribute('src'); return; }
    if (image.getAttribute('src') !== picture.src) image.src = picture.src;
  };

  function draw() {
    const pictures = view().pictures;
    const pictureA = pictures[state.a], pictureB = pictures[state.b];
    title.textContent = `${view().name}  (${state.view + 1}/${data.views.length})`;
    for (const [select, index] of [[chooseA, state.a], [chooseB, state.b]]) {
      select.replaceChildren(...pictures.map((picture, i) =>
        make('option', {value: i, textContent: picture.label, selected: i === index})));
    }
    modeButtons.forEach((element, i) => element.setAttribute('aria-pressed', modes[i][0] === state.mode));
    setSource(imageA, pictureA);
    setSource(imageB, pictureB);
    place(imageA, 0);
    const width = stage.clientWidth, side = state.mode === 'side';
    const split = side ? width / 2 : width * state.split;
    place(imageB, side ? split : 0);
    paneA.style.clipPath = side ? `inset(0 ${width - split}px 0 0)` : 'none';
    paneB.style.clipPath = state.mode === 'flip' ? 'none' : `inset(0 0 0 ${split}px)`;
    const flip = state.mode === 'flip';
    paneB.style.visibility = flip && state.front === 'a' ? 'hidden' : 'visible';
    paneA.style.visibility = flip && state.front === 'b' ? 'hidden' : 'visible';
    labelA.textContent = pictureA?.label || '';
    labelB.textContent = pictureB?.label || '';
    labelA.style.visibility = paneA.style.visibility;
    labelB.style.visibility = paneB.style.visibility;
    handle.hidden = state.mode !== 'slide';
    handle.style.left = `${split}px`;
    zoomText.textContent = `${Math.round(scale() * 100)} %`;
    drawNumbers(pictureA, pictureB);
    writeHash();
  }

  const writeHash = () => {
    const pictures = view().pictures;
    const parts = {v: view().name, a: pictures[state.a]?.label, b: pictures[state.b]?.label, m: state.mode};
    const hash = '#' + Object.entries(parts).filter(([, value]) => value)
      .map(([key, value]) => `${key}=${encodeURIComponent(value)}`).join('&');
    try { history.replaceState(null, '', hash); } catch (error) { /* not every browser allows it for files */ }
  };

  const find = (pictures, test) => Math.max(0, pictures.findIndex(test));
  const labelled = (label, kind) => (picture) => picture.label === label || (!label && picture.kind === kind);

  function open(index, labelOfA, labelOfB, mode) {
    state.view = index;
    const pictures = view().pictures;
    state.a = find(pictures, labelled(labelOfA, 'reference'));
    state.b = find(pictures, labelled(labelOfB, 'variant'));
    if (mode) state.mode = mode;
    state.zoom = 0;
    state.front = 'b';
    if (!viewer.open) viewer.showModal();
    draw();
  }

  function step(by) {
    const pictures = view().pictures;
    const labelA = pictures[state.a]?.label, labelB = pictures[state.b]?.label;
    state.view = (state.view + by + data.views.length) % data.views.length;
    state.a = find(view().pictures, labelled(labelA));
    state.b = find(view().pictures, labelled(labelB));
    draw();
  }

  function zoomBy(factor, atX = paneWidth() / 2, atY = stage.clientHeight / 2) {
    const before = scale();
    const after = Math.min(32, Math.max(fit(), before * factor));
    if (after <= fit()) { state.zoom = 0; draw(); return; }
    state.x = atX - (atX - state.x) * after / before;
    state.y = atY - (atY - state.y) * after / before;
    state.zoom = after;
    draw();
  }

  const drag = (target, move, end) => target.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    event.stopPropagation();
    target.setPointerCapture(event.pointerId);
    let last = event, moved = false;
    const onMove = (next) => { moved = true; move(next, next.clientX - last.clientX, next.clientY - last.clientY); last = next; };
    const onEnd = () => {
      target.removeEventListener('pointermove', onMove);
      if (end) end(moved);
    };
    target.addEventListener('pointermove', onMove);
    target.addEventListener('pointerup', onEnd, {once: true});
  });
  drag(handle, (event) => {
    const box = stage.getBoundingClientRect();
    state.split = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
    draw();
  });
  drag(stage, (event, dx, dy) => {
    if (!state.zoom) return;
    state.x += dx;
    state.y += dy;
    draw();
  }, (moved) => { if (!moved && state.mode === 'flip') flip(); });
  stage.addEventListener('wheel', (event) => {
    event.preventDefault();
    const box = stage.getBoundingClientRect();
    zoomBy(event.deltaY < 0 ? 1.25 : 0.8, (event.clientX - box.left) % paneWidth(), event.clientY - box.top);
  }, {passive: false});

  function flip() {
    state.mode = 'flip';
    state.front = state.front === 'a' ? 'b' : 'a';
    draw();
  }

  chooseA.addEventListener('change', () => { state.a = Number(chooseA.value); draw(); });
  chooseB.addEventListener('change', () => { state.b = Number(chooseB.value); draw(); });
  viewer.addEventListener('close', () => {
    try { history.replaceState(null, '', '#v' + state.view); } catch (error) { /* as above */ }
  });
  window.addEventListener('resize', () => { if (viewer.open) draw(); });

  document.addEventListener('keydown', (event) => {
    if (!viewer.open || event.ctrlKey || event.metaKey || event.altKey) return;
    const select = event.target instanceof HTMLSelectElement;
    const mode = modes.find(([, , key]) => key === event.key);
    const digit = Number(event.key);
    if (event.key === 'ArrowRight' && !select) step(1);
    else if (event.key === 'ArrowLeft' && !select) step(-1);
    else if (event.key === ' ') flip();
    else if (event.key === '+' || event.key === '=') zoomBy(1.5);
    else if (event.key === '-') zoomBy(1 / 1.5);
    else if (event.key === '0') { state.zoom = 0; draw(); }
    else if (mode && !select) { state.mode = mode[0]; draw(); }
    else if (digit >= 1 && digit <= view().pictures.length && !select) { state.b = digit - 1; draw(); }
    else return;
    event.preventDefault();
  });

  document.addEventListener('click', (event) => {
    if (event.button !== 0 || event.ctrlKey || event.metaKey || event.shiftKey) return;
    const link = event.target.closest?.('a.picture');
    if (!link) return;
    event.preventDefault();
    const row = link.closest('tr');
    const index = Number(row.dataset.view);
    const pictures = data.views[index].pictures;
    const kind = pictureTools?.elements.show.value || 'image';
    const wanted = pictures.find((picture) => picture.kind === kind && picture.of === link.dataset.source
      && (!picture.against || picture.against === row.dataset.reference));
    const isReference = link.dataset.source === row.dataset.reference;
    open(index, row.dataset.reference, isReference ? undefined : wanted?.label || link.dataset.source);
  });

  const openFromHash = () => {
    const fields = new URLSearchParams(location.hash.slice(1));
    const index = data.views.findIndex((candidate) => candidate.name === fields.get('v'));
    if (index >= 0) open(index, fields.get('a') || undefined, fields.get('b') || undefined, fields.get('m') || undefined);
  };
  window.addEventListener('hashchange', openFromHash);
  openFromHash();
})();
