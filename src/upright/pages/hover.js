// Reads a figure's lines back from its own drawing under the pointer, also within a shadow tree; without script a page
// lacks only this.
{
  const known = new WeakMap(); // of a drawing: its panels with their lines' points, the rule, and where it is said
  let hide = () => {};

  const points = (path) => [...path.getAttribute("d").matchAll(/[ML] ?(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [+x, +y]);

  const read = (svg) => {
    const panels = JSON.parse(svg.dataset.curves);
    for (const panel of panels) {
      const paths = panel.lines.map((_, k) => svg.querySelector(`[id^=line-${panel.row}-${k}-] path`));
      panel.paths = paths.map((path) => (path ? points(path) : []));
    }
    const rule = svg.appendChild(document.createElementNS(svg.namespaceURI, "line"));
    known.set(svg, { panels, rule, out: svg.nextElementSibling });
    return known.get(svg);
  };

  const at = ([low, high], log, part) => (log ? low * (high / low) ** part : low + part * (high - low));

  const show = (svg, event) => {
    const { panels, rule, out } = known.get(svg) ?? read(svg);
    const number = new Intl.NumberFormat(svg.closest("[lang]")?.lang ?? document.documentElement.lang, { maximumSignificantDigits: 3, useGrouping: false });
    const short = (value) => number.format(value).replace("-", "−");
    const area = svg.getBoundingClientRect();
    const x = ((event.clientX - area.left) / area.width) * svg.viewBox.baseVal.width;
    const { left, right, top, x: ends, logx, unit } = panels[0];
    if (x < left || x > right) return;
    const values = [];
    for (const { label, lines, paths, y, logy, top, bottom } of panels) for (const [k, line] of paths.entries()) {
      const i = line.findIndex((point) => point[0] >= x);
      if (i < 0 || line[0][0] > x + 1) continue;
      const [[x0, y0], [x1, y1]] = [line[Math.max(i - 1, 0)], line[i]];
      const height = x1 > x0 ? y0 + ((x - x0) / (x1 - x0)) * (y1 - y0) : y1;
      const part = (bottom - height) / (bottom - top);
      const sign = part > 1.01 ? "> " : part < -0.01 ? "< " : ""; // beyond the frame
      const value = sign + short(at(y, logy, Math.min(Math.max(part, 0), 1)));
      values.push(`${panels.length > 1 ? `${label}, ` : ""}${lines[k]}: ${value}`);
    }
    const place = { class: "rule", x1: x, x2: x, y1: top, y2: panels[panels.length - 1].bottom };
    for (const [key, value] of Object.entries(place)) rule.setAttribute(key, value);
    out.textContent = [`${unit} ${short(at(ends, logx, (x - left) / (right - left)))}`, ...values].join("   ");
    hide = () => {
      rule.setAttribute("class", "hidden");
      out.textContent = "";
    };
  };

  const follow = (event) => {
    hide();
    hide = () => {};
    const svg = event.composedPath()[0].closest?.("svg.lines");
    if (svg) show(svg, event);
  };
  for (const kind of ["pointerdown", "pointermove"]) document.addEventListener(kind, follow);
  document.documentElement.addEventListener("pointerleave", follow);
}
