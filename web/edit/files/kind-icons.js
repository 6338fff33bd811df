// Draws the kinds of tiles of a proposal, and its layers from above.
// Takes a proposal; paints canvases. Changes nothing.
//
//     const icons = new KindIcons(proposal, () => ...);     // told when another picture has come
//     icons.paint(canvas, 3);                    // the kind of that number in proposal.kinds
//     icons.paintLayer(canvas, 1);               // of the first map
//     icons.meanOf(3)                            // '#a0887c'

import { kHome } from '../../engine/home.js';

const kUnseen = '#3a3231';
const kUnknown = '#9a8f80'; // of a tile whose picture is missing
const kLeftOut = 0.3; // of a tile that is left out
const kIcon = 16; // texels
const kMostLayer = 96; // pixels a side, of a layer's picture

export class KindIcons {
  #proposal;
  #pictures; // ImageBitmap by number
  #shipped = new Map(); // name -> ImageBitmap
  #means = new Map(); // what a kind shows -> its colour
  #pen = new OffscreenCanvas(kIcon, kIcon).getContext('2d', { willReadFrequently: true });
  #isCome;

  constructor(proposal, isCome) {
    this.#proposal = proposal;
    this.#isCome = isCome;
    this.#pictures = proposal.pictures.map(() => null);
    proposal.pictures.forEach(({ bytes }, index) => {
      if (bytes !== null)
        this.#bring(new Blob([bytes]), (image) => (this.#pictures[index] = image));
    });
  }

  // What is no picture stays without one: the list of what was not taken says so.
  async #bring(blob, take) {
    try {
      take(await createImageBitmap(await blob));
      this.#means.clear();
      this.#isCome();
    } catch {
      // plain colours
    }
  }

  paint(canvas, number) {
    const context = canvas.getContext('2d');
    context.imageSmoothingEnabled = false;
    context.clearRect(0, 0, canvas.width, canvas.height);
    const kind = this.#proposal.kinds[number];
    const isSeen = kind.use !== 'empty' || kind.parts.length > 0;
    context.globalAlpha = kind.use === 'empty' ? kLeftOut : 1;
    if (isSeen) this.#draw(context, canvas.width, kind);
  }

  paintLayer(canvas, layer) {
    const [{ width, depth, cells }] = this.#proposal.maps;
    const step = Math.max(1, Math.ceil(Math.max(width, depth) / kMostLayer));
    canvas.width = Math.ceil(width / step);
    canvas.height = Math.ceil(depth / step);
    const context = canvas.getContext('2d');
    context.fillStyle = kUnseen;
    context.fillRect(0, 0, canvas.width, canvas.height);
    const list = cells[layer];
    if (!list) return;
    for (let y = 0; y < canvas.height; ++y)
      for (let x = 0; x < canvas.width; ++x) {
        const kind = list[y * step * width + x * step];
        if (kind === 0 || this.#proposal.kinds[kind - 1].use === 'empty') continue;
        context.fillStyle = this.meanOf(kind - 1);
        context.fillRect(x, y, 1, 1);
      }
  }

  meanOf(number) {
    const kind = this.#proposal.kinds[number];
    if (kind.show.startsWith('#')) return kind.show;
    const key = kind.show === 'picture' ? number : kind.show;
    if (!this.#means.has(key)) {
      this.#pen.clearRect(0, 0, kIcon, kIcon);
      this.#draw(this.#pen, kIcon, kind);
      this.#means.set(key, meanOf(this.#pen.getImageData(0, 0, kIcon, kIcon).data));
    }
    return this.#means.get(key);
  }

  #draw(context, side, kind) {
    const { show, parts } = kind;
    if (show.startsWith('#')) {
      context.fillStyle = show;
      context.fillRect(0, 0, side, side);
    } else if (show !== 'picture') {
      const image = this.#shippedImage(show);
      if (image !== null) context.drawImage(image, 0, 0, side, side);
    } else {
      for (const part of parts) drawPart(context, side, part, this.#pictures[part.picture]);
    }
  }

  #shippedImage(name) {
    if (!this.#shipped.has(name)) {
      this.#shipped.set(name, null);
      const file = fetch(new URL(`textures/${name}.png`, kHome)).then((answer) => answer.blob());
      this.#bring(file, (image) => this.#shipped.set(name, image));
    }
    return this.#shipped.get(name);
  }
}

// Turned as import/foreign-pictures.js turns it: 1 and 2 mirror, 4 swaps the axes.
function drawPart(context, side, { x, y, width, height, flip }, image) {
  if (image === null || image === undefined) {
    context.fillStyle = kUnknown;
    context.fillRect(0, 0, side, side);
    return;
  }
  context.save();
  context.scale(side, side);
  if (flip & 1) context.transform(-1, 0, 0, 1, 1, 0);
  if (flip & 2) context.transform(1, 0, 0, -1, 0, 1);
  if (flip & 4) context.transform(0, 1, 1, 0, 0, 0);
  context.drawImage(image, x, y, width, height, 0, 0, 1, 1);
  context.restore();
}

function meanOf(data) {
  const sum = [0, 0, 0];
  let weight = 0;
  for (let at = 0; at < data.length; at += 4) {
    const alpha = data[at + 3];
    for (let channel = 0; channel < 3; ++channel) sum[channel] += alpha * data[at + channel];
    weight += alpha;
  }
  if (weight === 0) return kUnknown;
  const part = (one) =>
    Math.round(one / weight)
      .toString(16)
      .padStart(2, '0');
  return `#${sum.map(part).join('')}`;
}
