// Reads a place in a world as data-at names it: "x,y,z", then the map's name if it is not the
// start's.
//
//     readPlace('4.5, 2, 0.6, cellar')    // {x: 4.5, y: 2, z: 0.6, map: 'cellar'}; throws an Error

export function readPlace(text) {
  const parts = text.split(',');
  const numbers = parts.slice(0, 3).map((part) => (part.trim() === '' ? NaN : Number(part)));
  if (numbers.length < 3 || !numbers.every(Number.isFinite))
    throw new Error(`Found '${text}', expected x,y,z or x,y,z,map.`);
  const [x, y, z] = numbers;
  return { x, y, z, map: parts.slice(3).join(',').trim() || null };
}
