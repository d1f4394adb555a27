'use strict';
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const tip = document.getElementById('tip');
  const charts = [...document.querySelectorAll('.chart')].map(box => {
    const svg = box.querySelector('svg');
    const marks = [...box.querySelectorAll('.p')].map(node => ({
      node, x: +node.dataset.x, y: +node.dataset.y, run: data.runs[+node.dataset.i],
      failed: node.classList.contains('failed'), shown: true,
    }));
    return { svg, marks, fronts: [...box.querySelectorAll('.front')] };
  });

  // The front of what is shown. Pixels will do: both axes are monotonic, and errors fall as y grows.
  function redraw(chart) {
    for (const line of chart.fronts) {
      const own = chart.marks.filter(m => m.shown && !m.failed && m.run.engine === line.dataset.e)
        .sort((a, b) => a.x - b.x || b.y - a.y);
      let low = -Infinity, d = '';
      for (const m of own) {
        if (m.y <= low) continue;
        d += d === '' ? `M${m.x} ${m.y}` : `H${m.x}V${m.y}`;
        low = m.y;
      }
      line.setAttribute('d', d || 'M0 0');
    }
  }

  const filters = document.querySelector('.filters');
  function apply() {
    const value = name => filters.querySelector(`[name=${name}]`)?.value ?? '';
    const hidden = new Set([...filters.querySelectorAll('[name=engine]')].filter(b => !b.checked).map(b => b.value));
    const [method, group, precision] = ['method', 'group', 'precision'].map(value);
    for (const chart of charts) {
      for (const m of chart.marks) {
        m.shown = !hidden.has(m.run.engine) && (!method || m.run.method === method)
          && (!precision || m.run.precision === precision);
        m.node.classList.toggle('off', !m.shown);
      }
      redraw(chart);
    }
    for (const node of document.querySelectorAll('[data-e]:not(.p):not(.front)')) {
      node.classList.toggle('off', hidden.has(node.dataset.e));
    }
    for (const node of document.querySelectorAll('[data-group]')) {
      node.classList.toggle('off', group !== '' && node.dataset.group !== group);
    }
  }
  filters?.addEventListener('change', apply);

  let last = null;
  function hide() {
    last?.classList.remove('on');
    last = null;
    tip.hidden = true;
  }
  function say(text, tag) {
    const node = document.createElement(tag);
    node.textContent = text;
    return node;
  }
  function show(mark, x, y) {
    if (last !== mark.node) {
      hide();
      last = mark.node;
      last.classList.add('on');
      const run = mark.run;
      tip.replaceChildren(say(`${run.title}, ${run.method}, ${run.precision}`, 'b'),
        ...[run.setting, ...run.lines].map(line => say(line, 'div')));
      tip.hidden = false;
    }
    const box = tip.getBoundingClientRect();
    const left = Math.min(Math.max(8, x + 14), innerWidth - box.width - 8);
    const top = y + 18 + box.height > innerHeight ? y - box.height - 14 : y + 18;
    tip.style.left = `${left}px`;
    tip.style.top = `${Math.max(8, top)}px`;
  }
  for (const chart of charts) {
    const point = event => {
      const box = chart.svg.getBoundingClientRect();
      const scale = chart.svg.viewBox.baseVal.width / box.width;
      const [x, y] = [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
      let best = null, least = 26 * Math.max(1, scale);
      for (const mark of chart.marks) {
        const far = Math.hypot(mark.x - x, mark.y - y);
        if (mark.shown && far < least) [best, least] = [mark, far];
      }
      if (best) show(best, event.clientX, event.clientY);
      else hide();
    };
    chart.svg.addEventListener('pointermove', point);
    chart.svg.addEventListener('pointerdown', point);
    chart.svg.addEventListener('pointerleave', event => { if (event.pointerType === 'mouse') hide(); });
  }
  addEventListener('scroll', hide, { passive: true });
})();
