// What can be wrong with the page as it is laid out: one line for each. Its argument: names of figures.
const found = [];
const root = document.documentElement;
const named = element => element.tagName.toLowerCase() + (element.className.baseVal ?? "." + element.className);

if (root.scrollWidth > root.clientWidth) found.push(`is ${root.scrollWidth} px wide in ${root.clientWidth}`);

for (const name of arguments[0]) {
  const svg = document.querySelector(`figure#${name} svg`);
  const views = [...document.querySelectorAll(`figure#${name} svg`)].filter(view => view.getBoundingClientRect().width);
  const box = views[0]?.getBoundingClientRect();
  if (!(box?.width > 200 && box.height > 100)) { found.push(`${name}: nothing to see`); continue; }
  const scales = views.map(view => view.getBoundingClientRect().width / view.viewBox.baseVal.width);
  const size = Math.min(...scales) * Math.min(...[...svg.querySelectorAll("text")].map(text => parseFloat(getComputedStyle(text).fontSize)));
  if (size < 8) found.push(`${name}: letters of ${size.toFixed(1)} px`);
  const panels = [...document.querySelectorAll(`figure#${name} .panels svg`)].map(view => view.viewBox.baseVal);
  const shown = panels.reduce((sum, panel) => sum + panel.width, 0), width = svg.viewBox.baseVal.width;
  if (panels.length && Math.abs(shown - width) > 1) found.push(`${name}: panels show ${shown} of ${width} px`);
  if (views[0] !== svg) continue;  // on a phone the panels show what the hidden figure has
  for (const { x: cut } of panels) {
    const scale = box.width / width;
    for (const text of svg.querySelectorAll("text")) {
      const { left, right } = text.getBoundingClientRect();
      const [from, to] = [left, right].map(x => (x - box.left) / scale);
      if (from < cut && cut < to) found.push(`${name}: cut through "${text.textContent}"`);
      const isTic = text.parentElement.getAttribute("text-anchor") === "end" && text.textContent.trim();
      if (isTic && to < cut && cut < to + 12) found.push(`${name}: "${text.textContent}" is cut off its axis`);
    }
  }
  const drawn = [...svg.querySelectorAll("path, use, text, polygon")].filter(element => {
    const { width, height } = element.getBoundingClientRect();
    return width + height > 0;
  });
  if (drawn.length < 10) found.push(`${name}: ${drawn.length} marks`);
  for (const use of svg.querySelectorAll("use")) {
    const mark = document.querySelector(use.getAttribute("href"));
    if (!mark || !svg.contains(mark)) found.push(`${name}: no mark ${use.getAttribute("href")}`);
  }
}

for (const link of document.querySelectorAll("a")) {
  if (!document.querySelector(link.getAttribute("href"))) found.push(`${link.getAttribute("href")} leads nowhere`);
}

// Contrast of WCAG 2: at least 4.5 for text.
const rgb = colour => colour.match(/[\d.]+/g).map(Number);
const luminance = ([r, g, b]) => {
  const [x, y, z] = [r, g, b].map(c => c / 255).map(c => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  return 0.2126 * x + 0.7152 * y + 0.0722 * z;
};
const backgrounds = new Map();  // by element, as many texts have the same ancestors
const background = element => {
  if (!element) return [255, 255, 255];
  if (!backgrounds.has(element)) {
    const colour = rgb(getComputedStyle(element).backgroundColor);
    backgrounds.set(element, colour[3] !== 0 ? colour : background(element.parentElement));
  }
  return backgrounds.get(element);
};
const seen = new Set();
const texts = "h1, h2, h4, p, a, td, th, dt, dd, b, figcaption, code, .verdict, svg text";
for (const element of document.querySelectorAll(texts)) {
  const empty = !element.textContent.trim() || element.matches(".count:has(i)");
  if (empty || !element.getBoundingClientRect().width) continue;
  const style = getComputedStyle(element);
  const colour = element.closest("svg") ? style.fill : style.color;
  const behind = background(element);
  if (seen.has(colour + behind)) continue;
  seen.add(colour + behind);
  const [low, high] = [luminance(rgb(colour)), luminance(behind)].sort((a, b) => a - b);
  const contrast = (high + 0.05) / (low + 0.05);
  if (contrast < 4.5) found.push(`${named(element)}: contrast ${contrast.toFixed(1)} of ${colour}`);
}
return found;
