// Decodes the pictures of a proposal and draws parts of them: cut out, turned, one over another, by
// nearest neighbour. Each picture is decoded once, and only if a part needs it. Whatever a file
// claims, at most a little more than its size says is ever unpacked.
//
//     const pictures = openPictures(proposal.pictures, notes);
//     const image = pictures.draw(kind.parts, 16, 16, null);      // null: nothing to draw
//     const bytes = pngOf(image);

import { Unzlib } from 'fflate';
import { convertIndexedToRgb, decode, encode } from 'fast-png';

import { kMostAllPictureTexels, kMostPictureSide, kMostPictureTexels } from './import-limits.js';

const kSignature = [137, 80, 78, 71, 13, 10, 26, 10];
const kNeeded = ['IHDR', 'PLTE', 'tRNS', 'IDAT', 'IEND']; // others may unpack to anything
const kPiece = 4096; // bytes to unpack at a time
const kMostDrawn = 2 ** 28; // texels in all, each part counted: some seconds

export function openPictures(list, notes) {
  const decoded = new Map();
  let texels = 0;
  let drawn = 0;
  let isFull = false;

  function imageOf(index) {
    if (!decoded.has(index)) decoded.set(index, decodeNumber(index));
    return decoded.get(index);
  }

  function decodeNumber(index) {
    const { file, bytes, transparent } = list[index] ?? {};
    if (!(bytes instanceof Uint8Array)) return null;
    try {
      const small = smallPng(bytes);
      texels += small.width * small.height;
      if (texels > kMostAllPictureTexels)
        throw new Error(`more than ${kMostAllPictureTexels} texels in all pictures`);
      return rgbaOf(small, transparent);
    } catch (error) {
      notes.add(`picture "${file}"`, `${error.message}; its tiles get plain colours`);
      return null;
    }
  }

  return {
    draw(parts, width, height, background) {
      const images = parts.map(({ picture }) => imageOf(picture));
      if (images.every((image) => image === null)) return null;
      drawn += width * height * parts.length;
      if (drawn > kMostDrawn) {
        if (!isFull) notes.add('the tiles', 'too many texels in all: some get plain colours');
        isFull = true;
        return null;
      }
      const data = new Uint8Array(4 * width * height);
      if (background !== null) fill(data, background);
      parts.forEach((part, index) => {
        if (images[index] !== null) drawPart(data, width, height, images[index], part);
      });
      return { width, height, data };
    },
  };
}

export function pngOf({ width, height, data }) {
  return encode({ width, height, data, channels: 4, depth: 8 });
}

export function rgbOf(colour) {
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
}

function fill(data, colour) {
  const rgba = [...rgbOf(colour), 255];
  for (let at = 0; at < data.length; ++at) data[at] = rgba[at % 4];
}

// What lies outside of the picture is see-through.
function drawPart(data, width, height, image, { x, y, width: across, height: down, flip }) {
  for (let row = 0; row < height; ++row)
    for (let column = 0; column < width; ++column) {
      let u = (column + 0.5) / width;
      let v = (row + 0.5) / height;
      if (flip & 1) u = 1 - u;
      if (flip & 2) v = 1 - v;
      if (flip & 4) [u, v] = [v, u];
      const fromX = Math.floor(x + u * across);
      const fromY = Math.floor(y + v * down);
      if (fromX < 0 || fromY < 0 || fromX >= image.width || fromY >= image.height) continue;
      blend(data, 4 * (row * width + column), image.data, 4 * (fromY * image.width + fromX));
    }
}

function blend(data, to, source, from) {
  const alpha = source[from + 3] / 255;
  const below = (data[to + 3] / 255) * (1 - alpha);
  const whole = alpha + below;
  if (whole === 0) return;
  for (let channel = 0; channel < 3; ++channel)
    data[to + channel] = Math.round(
      (source[from + channel] * alpha + data[to + channel] * below) / whole,
    );
  data[to + 3] = Math.round(255 * whole);
}

// The file without the parts that a picture does not need, and its size, which is checked.
function smallPng(bytes) {
  if (!kSignature.every((byte, index) => bytes[index] === byte))
    throw new Error('it is no PNG file; save it as one');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const kept = [bytes.subarray(0, 8)];
  const packed = [];
  let header = null;
  for (let at = 8; at + 12 <= bytes.length;) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    const chunk = bytes.subarray(at, at + 12 + length);
    if (type === 'IHDR') header = headerOf(view, at + 8);
    if (type === 'IDAT') packed.push(bytes.subarray(at + 8, at + 8 + length));
    const isPalette = type === 'PLTE' || type === 'tRNS';
    if (kNeeded.includes(type) && (!isPalette || type === 'tRNS' || header?.colours === 3))
      kept.push(chunk);
    at += 12 + length;
    if (type === 'IEND') break;
  }
  if (header === null) throw new Error('it is a PNG file without a header');
  checkUnpacked(packed, header);
  return { ...header, bytes: joined(kept) };
}

function headerOf(view, at) {
  const width = view.getUint32(at);
  const height = view.getUint32(at + 4);
  const isFit = Math.max(width, height) <= kMostPictureSide && width * height <= kMostPictureTexels;
  if (!isFit || width * height === 0)
    throw new Error(
      `it is ${width} x ${height}; at most ${kMostPictureSide} a side and ${kMostPictureTexels} in all`,
    );
  return { width, height, depth: view.getUint8(at + 8), colours: view.getUint8(at + 9) };
}

function checkUnpacked(pieces, { width, height, depth, colours }) {
  const channels = [1, 0, 3, 1, 2, 0, 4][colours] ?? 0;
  const row = Math.ceil((width * channels * depth) / 8) + 1;
  const most = 2 * (row * height + 64); // interlaced rows have a byte more each
  let length = 0;
  const stream = new Unzlib((piece) => {
    length += piece.length;
    if (length > most) throw new Error('it holds more data than its size says');
  });
  for (const piece of pieces)
    for (let at = 0; at < piece.length; at += kPiece) stream.push(piece.subarray(at, at + kPiece));
}

function joined(pieces) {
  const bytes = new Uint8Array(pieces.reduce((sum, { length }) => sum + length, 0));
  pieces.reduce((at, piece) => (bytes.set(piece, at), at + piece.length), 0);
  return bytes;
}

function rgbaOf({ bytes }, transparent) {
  const image = decode(bytes);
  const { width, height } = image;
  const { at, channels, largest } = samplesOf(image);
  const key = image.palette === undefined ? [...(image.transparency ?? [])] : [];
  const hole = transparent ? rgbOf(transparent) : null;
  const data = new Uint8Array(4 * width * height);
  for (let texel = 0; texel < width * height; ++texel) {
    const to = 4 * texel;
    let isKey = key.length > 0;
    let isHole = hole !== null;
    for (let channel = 0; channel < 3; ++channel) {
      const sample = at(texel, channels < 3 ? 0 : channel);
      data[to + channel] = Math.round((sample * 255) / largest);
      if (isKey && key[channels < 3 ? 0 : channel] !== sample) isKey = false;
      if (isHole && hole[channel] !== data[to + channel]) isHole = false;
    }
    const alpha = channels % 2 === 0 ? (at(texel, channels - 1) * 255) / largest : 255;
    data[to + 3] = isKey || isHole ? 0 : Math.round(alpha);
  }
  return { width, height, data };
}

// at(texel, channel) of any kind of PNG; grey of less than 8 bits is packed.
function samplesOf(image) {
  const { width, depth, channels, data } = image;
  if (image.palette !== undefined) {
    const all = convertIndexedToRgb(image);
    const count = image.palette[0].length;
    return { at: (texel, channel) => all[texel * count + channel], channels: count, largest: 255 };
  }
  if (depth >= 8)
    return {
      at: (texel, channel) => data[texel * channels + channel],
      channels,
      largest: 2 ** depth - 1,
    };
  const row = Math.ceil((width * depth) / 8);
  const largest = 2 ** depth - 1;
  const at = (texel) => {
    const bit = (texel % width) * depth;
    const byte = data[Math.floor(texel / width) * row + (bit >> 3)];
    return (byte >> (8 - depth - (bit & 7))) & largest;
  };
  return { at, channels: 1, largest };
}
