// Reads a figure's lines back from its own drawing under the pointer; without script the page lacks only this.
for (const svg of document.querySelectorAll("svg.lines")) {
  const panels = JSON.parse(svg.dataset.curves), box = svg.viewBox.baseVal, mark = svg.querySelector("title").id.slice(1);
  const rule = svg.appendChild(document.createElementNS(svg.namespaceURI, "line"));
  const out = svg.parentNode.insertBefore(document.createElement("output"), svg.nextSibling);
  const points = (path) => [...path.getAttribute("d").matchAll(/[ML] ?(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [+x, +y]);
  for (const [row, panel] of panels.entries())
    panel.paths = panel.lines.map((_, k) => svg.querySelector(`#line-${panel.row}-${k}-${mark} path`)).map((p) => p ? points(p) : []);
  const hide = () => { rule.setAttribute("class", "hidden"); out.textContent = ""; };
  const short = (value) => Number(value.toPrecision(3)).toString().replace("-", "−");
  const at = ([low, high], log, part) => log ? low * (high / low) ** part : low + part * (high - low);
  const { left, right, x: ends, logx } = panels[0];
  svg.addEventListener("pointerleave", hide);
  svg.addEventListener("pointermove", (event) => {
    const area = svg.getBoundingClientRect();
    const x = (event.clientX - area.left) / area.width * box.width;
    if (x < left || x > right) return hide();
    const values = [];
    for (const panel of panels) for (const [k, line] of panel.paths.entries()) {
      const i = line.findIndex((point) => point[0] >= x);
      if (i < 0 || line[0][0] > x + 1) continue;
      const part = (panel.bottom - line[i][1]) / (panel.bottom - panel.top);
      const value = part > -0.01 && part < 1.01 ? short(at(panel.y, panel.logy, part)) : "beyond the frame";
      values.push(`${panels.length > 1 ? `${panel.label}, ` : ""}${panel.lines[k]}: ${value}`);
    }
    const ends_y = { y1: panels[0].top, y2: panels[panels.length - 1].bottom };
    for (const [key, value] of Object.entries({ class: "rule", x1: x, x2: x, ...ends_y })) rule.setAttribute(key, value);
    out.textContent = [`${panels[0].unit} ${short(at(ends, logx, (x - left) / (right - left)))}`, ...values].join("   ");
  });
}
