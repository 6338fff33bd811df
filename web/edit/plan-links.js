// Draws the links of a map over the plan, and says in a small legend what its colours mean.
// Takes a canvas' context and lists of links. Changes nothing else.
//
//     const links = new PlanLinks(list);               // an empty <ul> in the plan's corner
//     links.draw(context, editor, scale);

import { isOfThing } from './link-marks.js';
import { kLinkLooks } from './link-looks.js';
import { handlesOf } from './handles.js';

const kHead = 9; // of an arrow, CSS pixels
const kStub = 30; // of an arrow to another map
const kPale = 0.5; // what is on other levels
const kLabelsApart = 56; // CSS pixels between equal labels

export class PlanLinks {
  #list;
  #shown = '';

  constructor(list) {
    this.#list = list;
  }

  draw(context, editor, scale) {
    const { links, map, level, edited, target } = editor;
    const all = links.of(map);
    this.#legend(all);
    const labels = [];
    for (const link of all) {
      const isChosen =
        isOfThing(link, edited) || (target?.thing ? isOfThing(link, target.thing) : false);
      context.globalAlpha = isChosen || isOnLevel(link, level) ? 1 : kPale;
      const { colour } = kLinkLooks[link.kind];
      const pen = new Pen(context, scale, isChosen ? '#ffffff' : colour, isChosen, labels);
      drawings[link.kind](pen, link, editor);
    }
    context.globalAlpha = 1;
    if (edited !== null) this.#handles(context, editor, scale);
  }

  // Of what is edited: its heading, its radius, its corner.
  #handles(context, { scene, map, edited, pending }, scale) {
    const handles = handlesOf(scene, map, edited);
    const middle = handles.find(({ path }) => String(path) === String(edited));
    for (const { path, kind, x, y } of handles) {
      const last = path.at(-1);
      const isOwn = isOfThing({ path }, edited) || isOfThing({ path }, pending?.path ?? null);
      if (!isOwn) continue;
      const pen = new Pen(context, scale, '#ffffff', false, []);
      if (kind === 'radius' && middle) {
        pen.ring([middle.x, middle.y], x - middle.x);
        pen.knob([x, y]);
      } else if (kind === 'heading' && middle) {
        pen.arrow([middle.x, middle.y], [x, y]);
        pen.knob([x, y]);
      } else if (last === 'width' || kind === 'way') pen.knob([x, y]);
    }
  }

  #legend(all) {
    const kinds = Object.keys(kLinkLooks).filter((kind) => all.some((link) => link.kind === kind));
    if (this.#list === null || String(kinds) === this.#shown) return;
    this.#shown = String(kinds);
    this.#list.hidden = kinds.length === 0;
    this.#list.replaceChildren(
      ...kinds.map((kind) => {
        const { colour, label } = kLinkLooks[kind];
        const line = document.createElement('li');
        const swatch = document.createElement('i');
        swatch.style.background = colour;
        line.append(swatch, label);
        return line;
      }),
    );
  }
}

function isOnLevel({ area, areas, points }, level) {
  const boxes = (areas ?? [area]).filter(Boolean);
  if (boxes.length > 0) return boxes.some(({ low, high }) => low < level + 1 && high >= level);
  return points.length === 0 || points.some(([, , z]) => Math.floor(z) === level);
}

const isElsewhere = (end, map) => end.map !== map;

const drawings = {
  portal(pen, { areas, ends: [from, to], map, isBack, away }) {
    for (const area of areas) pen.box(area);
    const [here, there] = from.map === map ? [from, to] : [to, from];
    if (!isElsewhere(there, map)) {
      pen.arrow(flat(from), flat(to), isBack);
      return;
    }
    const isOut = from.map === map;
    pen.stub(flat(here), away, isOut, isBack, there.mapName ?? '');
  },

  gate(pen, { area, points, radius, ends, map }) {
    pen.box(area);
    if (radius !== null) pen.ring(points[0], radius, true);
    for (const end of ends) if (!isElsewhere(end, map)) pen.arrow(flat(end), points[0]);
    const others = new Set(ends.filter((end) => isElsewhere(end, map)).map((end) => end.mapName));
    if (others.size > 0) pen.label(points[0], `opened from ${[...others].join(', ')}`);
  },

  mover(pen, { area, points }) {
    pen.box(area);
    pen.arrow(points[0], points[1], true);
  },

  way(pen, { points, isClosed, isBack, closesAt = 0, radius, ends }) {
    if (radius !== null) pen.ring(points[0], radius, true);
    const isRing = ends.length === 0 && points.length > 2;
    points.slice(1).forEach((to, index) => {
      if (isRing) pen.line(points[index], to);
      else pen.arrow(points[index], to, isBack && index >= closesAt);
    });
    if (isClosed && points.length > 1)
      pen[isRing ? 'line' : 'arrow'](points.at(-1), points[closesAt]);
    if (!isRing) for (const point of points.slice(1)) pen.dot(point);
  },

  message(pen, { area, points, radius }) {
    if (area !== null) pen.area(area);
    else pen.ring(points[0], radius, true);
  },

  find(pen, { points }) {
    for (const point of points) pen.diamond(point);
  },

  goal(pen, { area, ends, map }) {
    pen.area(area);
    const middle = [(area.west + area.east) / 2, (area.north + area.south) / 2];
    for (const end of ends) if (!isElsewhere(end, map)) pen.line(flat(end), middle, true);
    pen.label([area.west, area.north], 'goal');
  },
};

const flat = ({ x, y }) => [x, y];

// Draws places of the map in one colour.
class Pen {
  #context;
  #scale;
  #colour;
  #labels;

  constructor(context, scale, colour, isBold, labels) {
    Object.assign(context, { strokeStyle: colour, fillStyle: colour });
    context.lineWidth = isBold ? 3 : 2;
    this.#context = context;
    this.#scale = scale;
    this.#colour = colour;
    this.#labels = labels;
  }

  box({ west, north, east, south }) {
    const scale = this.#scale;
    this.#context.beginPath();
    this.#context.rect(west * scale, north * scale, (east - west) * scale, (south - north) * scale);
    this.#context.stroke();
  }

  area(area) {
    const { west, north, east, south } = area;
    const scale = this.#scale;
    const context = this.#context;
    context.save();
    context.globalAlpha *= 0.18;
    context.fillRect(west * scale, north * scale, (east - west) * scale, (south - north) * scale);
    context.restore();
    this.box(area);
  }

  line([x, y], [toX, toY], isDashed = false) {
    const context = this.#context;
    context.setLineDash(isDashed ? [4, 4] : []);
    context.beginPath();
    context.moveTo(x * this.#scale, y * this.#scale);
    context.lineTo(toX * this.#scale, toY * this.#scale);
    context.stroke();
    context.setLineDash([]);
  }

  arrow(from, to, isBack = false) {
    const far = Math.hypot(to[0] - from[0], to[1] - from[1]) * this.#scale;
    if (far < 1) return;
    this.line(from, to);
    this.#head(from, to, far);
    if (isBack) this.#head(to, from, far);
  }

  // An arrow to, or from, another map.
  stub([x, y], [east, south], isOut, isBack, name) {
    const far = kStub / this.#scale;
    const end = [x + far * east, y + far * south];
    if (isOut) this.arrow([x, y], end, isBack);
    else this.arrow(end, [x, y], isBack);
    this.label(end, isOut ? name : `from ${name}`);
  }

  ring([x, y], radius, isDashed = false) {
    const context = this.#context;
    context.setLineDash(isDashed ? [4, 4] : []);
    context.beginPath();
    context.arc(x * this.#scale, y * this.#scale, Math.max(0, radius) * this.#scale, 0, 7);
    context.stroke();
    context.setLineDash([]);
  }

  dot([x, y]) {
    this.#context.beginPath();
    this.#context.arc(x * this.#scale, y * this.#scale, 3.5, 0, 7);
    this.#context.fill();
  }

  knob([x, y]) {
    const context = this.#context;
    const [left, top] = [x * this.#scale, y * this.#scale];
    context.fillStyle = '#ffffff';
    context.fillRect(left - 5, top - 5, 10, 10);
    context.lineWidth = 2;
    context.strokeStyle = '#15131c';
    context.strokeRect(left - 5, top - 5, 10, 10);
    context.strokeStyle = this.#colour;
  }

  diamond([x, y]) {
    const context = this.#context;
    const [left, top] = [x * this.#scale, y * this.#scale];
    const size = Math.max(5, Math.min(11, this.#scale * 0.45));
    context.beginPath();
    context.moveTo(left, top - size);
    context.lineTo(left + size, top);
    context.lineTo(left, top + size);
    context.lineTo(left - size, top);
    context.closePath();
    context.stroke();
  }

  label([x, y], text) {
    const [left, top] = [x * this.#scale, y * this.#scale];
    const isThere = this.#labels.some(
      (other) =>
        Math.hypot(other.left - left, other.top - top) <
        (other.text === text ? kLabelsApart * 2 : 14),
    );
    if (isThere || text === '') return;
    this.#labels.push({ left, top, text });
    const context = this.#context;
    context.font = '12px system-ui, sans-serif';
    context.textBaseline = 'middle';
    const { width } = context.measureText(text);
    context.fillStyle = 'rgb(21 19 28 / 0.82)';
    context.fillRect(left - 4, top - 18, width + 8, 18);
    context.fillStyle = this.#colour;
    context.fillText(text, left, top - 9);
  }

  #head([x, y], [toX, toY], far) {
    const angle = Math.atan2(toY - y, toX - x);
    const size = Math.min(kHead, far / 2);
    const context = this.#context;
    context.beginPath();
    for (const side of [-0.5, 0.5]) {
      context.moveTo(toX * this.#scale, toY * this.#scale);
      context.lineTo(
        toX * this.#scale - size * Math.cos(angle + side),
        toY * this.#scale - size * Math.sin(angle + side),
      );
    }
    context.stroke();
  }
}
