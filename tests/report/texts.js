// Texts of figures that cannot be read as they are laid out: one line for each. A figure is a <figure> with an id; the
// first <svg> in it is the whole figure, and others are its panels, which a phone shows one below the other.
const found = [];
const INSIDE = 1;  // pixels of the figure between a text and the border of its picture
const GAP = 3;  // pixels between two texts of a line
const ABOVE = 0.17, BELOW = 0.03;  // of the size of the font: what the box of a line has beyond its letters
const SWATCH = 40;  // pixels; a filled area that is no larger is a sample of a colour

const figures = [...document.querySelectorAll("figure[id]")].map(figure => {
  const [whole, ...panels] = figure.querySelectorAll("svg");
  return { figure, whole, panels, hidden: !whole.getBoundingClientRect().width };
});
const displayHidden = value => figures.filter(({ hidden }) => hidden).forEach(({ whole }) => { whole.style.display = value; });

displayHidden("block");  // panels show parts of it, at another scale; all at once, as each change lays out the page anew
for (const { figure, whole, panels, hidden } of figures) {
  const frame = whole.getBoundingClientRect(), size = whole.viewBox.baseVal;
  const scale = frame.width / size.width;
  const scaled = ({ left, right, top, bottom }) =>
    ({ left: (left - frame.left) / scale, right: (right - frame.left) / scale,
       top: (top - frame.top) / scale, bottom: (bottom - frame.top) / scale });
  const texts = [...whole.querySelectorAll("text")].filter(text => text.textContent.trim()).map(text => {
    const box = scaled(text.getBoundingClientRect());
    const letter = parseFloat(getComputedStyle(text).fontSize), matrix = text.getCTM();
    const [x, y] = [matrix.c, matrix.d].map(part => part / Math.hypot(matrix.c, matrix.d));  // down the letters
    if (y > 0.9) { box.top += ABOVE * letter; box.bottom -= BELOW * letter; }
    if (x > 0.9) { box.left += ABOVE * letter; box.right -= BELOW * letter; }
    if (x < -0.9) { box.right -= ABOVE * letter; box.left += BELOW * letter; }
    return { text, box, said: text.textContent.trim() };
  });
  if (!texts.length) found.push(`${figure.id}: no texts`);
  const common = (a, b) => Math.min(Math.min(a.right, b.right) - Math.max(a.left, b.left),
                                    Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));
  const cuts = panels.slice(1).map(panel => panel.viewBox.baseVal.x);
  const swatches = [...whole.querySelectorAll("polygon, rect")].map(area => ({ area, box: scaled(area.getBoundingClientRect()) }))
    .filter(({ area, box }) => getComputedStyle(area).fill !== "none" && box.right - box.left < SWATCH &&
                               box.bottom - box.top < SWATCH && box.right - box.left > 8 && box.bottom - box.top > 8);
  texts.forEach(({ text, box, said }, i) => {
    const beyond = Math.max(-box.left, -box.top, box.right - size.width, box.bottom - size.height);
    if (beyond > -INSIDE) found.push(`${figure.id}: "${said}" is ${beyond.toFixed(1)} px out of the picture`);
    if (text.getNumberOfChars() < said.length) found.push(`${figure.id}: "${said}" has lost a blank`);
    for (const cut of cuts) {
      if (box.left < cut && cut < box.right) found.push(`${figure.id}: "${said}" is cut into panels`);
    }
    for (const other of texts.slice(i + 1)) {
      const isLine = Math.abs(box.bottom - other.box.bottom) < 4;  // next to one another
      const by = common(isLine ? { ...box, left: box.left - GAP, right: box.right + GAP } : box, other.box);
      if (by > 0) found.push(`${figure.id}: "${said}" and "${other.said}" overlap by ${by.toFixed(1)} px`);
    }
    if (swatches.some(swatch => common(box, swatch.box) > 0)) found.push(`${figure.id}: "${said}" is on a sample of a colour`);
  });
  const caption = figure.querySelector("figcaption")?.innerText ?? "";
  const sides = /\bleft\b|\(right\)|\bRight\b|[,;] right\b/.exec(caption);
  if (hidden && sides) found.push(`${figure.id}: the caption says "${sides[0]}" of panels one below the other`);
  if (!hidden && panels.length && !sides && figure.querySelector(".beside")) found.push(`${figure.id}: the caption names no side`);
}
displayHidden("");
for (const name of document.querySelectorAll(".summary td:first-child a")) {
  if (name.getClientRects().length > 1) found.push(`the study ${name.textContent} is broken`);
}
return found;
