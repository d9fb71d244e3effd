// Sorting by a click on a heading, filtering by typing, frames one at a time. Without it every table can be read as it stands and
// all frames are seen side by side. Formulas are drawn by KaTeX; without it, or without script, their LaTeX source stays.
(() => {
  'use strict';
  if (window.katex)
    for (const formula of document.querySelectorAll('x-equation'))
      katex.render(formula.textContent, formula,
        {displayMode: formula.getAttribute('type') === 'display', throwOnError: false, strict: 'error'});
  const value = cell => cell === undefined ? '' : cell.dataset.v !== undefined ? Number(cell.dataset.v) : cell.textContent;
  const compare = (a, b) => typeof a === 'number' && typeof b === 'number'
    ? (Number.isNaN(a) ? 1 : 0) - (Number.isNaN(b) ? 1 : 0) || a - b : String(a).localeCompare(String(b), 'en', {numeric: true});
  const sort = (table, heading, column) => {
    const up = heading.getAttribute('aria-sort') !== 'ascending';
    for (const other of table.tHead.rows[0].cells) other.removeAttribute('aria-sort');
    heading.setAttribute('aria-sort', up ? 'ascending' : 'descending');
    const rows = [...table.tBodies[0].rows];
    rows.sort((a, b) => (up ? 1 : -1) * compare(value(a.cells[column]), value(b.cells[column])));
    table.tBodies[0].append(...rows);
  };
  const addFilter = table => {
    const input = document.createElement('input');
    input.className = 'filter';
    input.type = 'search';
    input.placeholder = 'filter rows';
    input.setAttribute('aria-label', 'filter rows');
    input.addEventListener('input', () => {
      const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
      for (const row of table.tBodies[0].rows) {
        const text = row.textContent.toLowerCase();
        row.hidden = !words.every(word => text.includes(word));
      }
    });
    table.parentElement.before(input);
  };
  for (const table of document.querySelectorAll('table.data')) {
    [...table.tHead.rows[0].cells].forEach((heading, column) => {
      const button = document.createElement('button');
      button.append(...heading.childNodes);
      heading.append(button);
      button.addEventListener('click', () => sort(table, heading, column));
    });
    if (table.tBodies[0].rows.length > 6) addFilter(table);
  }
  const animate = box => {
    const frames = [...box.querySelectorAll('.frame')];
    const bar = document.createElement('div');
    const slider = document.createElement('input');
    const button = document.createElement('button');
    let timer = 0;
    const show = k => frames.forEach((frame, n) => frame.classList.toggle('on', n === k));
    const stop = () => { clearInterval(timer); timer = 0; button.textContent = 'play'; };
    bar.className = 'slider';
    slider.type = 'range';
    slider.min = 0;
    slider.max = frames.length - 1;
    slider.value = frames.length - 1;
    slider.setAttribute('aria-label', 'frame');
    slider.addEventListener('input', () => { stop(); show(Number(slider.value)); });
    button.type = 'button';
    button.addEventListener('click', () => {
      if (timer) return stop();
      button.textContent = 'stop';
      timer = setInterval(() => {
        slider.value = (Number(slider.value) + 1) % frames.length;
        show(Number(slider.value));
      }, 250);
    });
    stop();
    bar.append(button, slider);
    box.classList.add('js');
    box.before(bar);
    show(frames.length - 1);
  };
  document.querySelectorAll('.frames').forEach(animate);
  const openTarget = () => {
    const target = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const box = target && target.closest('details');
    if (box) box.open = true;
  };
  addEventListener('hashchange', openTarget);
  openTarget();
  addEventListener('beforeprint', () => document.querySelectorAll('details').forEach(d => { d.open = true; }));
})();
