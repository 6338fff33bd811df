// What the figures of this chapter share: the view, and a pixel's things in words.

export const kEye = '3.2,4.9,0.5,190,0,hall';
export const kOptions = { fov: 50 };

// The slopes of the picked pixel's ray.
export function slopesOf({ column, row, width, slice }) {
  return {
    sideways: (column + 0.5 - width / 2) / slice.projectionDistance,
    upward: (slice.horizonRow - (row + 0.5)) / slice.projectionDistance,
  };
}

// What a ray meets in the picked row, from front to back: [{name, run}]. Faces that are holes all
// over are left out.
export function thingsIn({ slice, row, pick }) {
  const things = slice.runs
    .filter(({ first, last, texture }) => first <= row && row <= last && texture !== 'nothing')
    .sort((a, b) => Number(b.layer) - Number(a.layer) || depthIn(a, row) - depthIn(b, row))
    .map((run) => ({ name: nameOf(run), run }));
  const reflected = pick.reflection;
  if (reflected) things.push({ name: `the mirror image of ${nameOf(reflected)}`, run: null });
  return things;
}

// "a, b and c", or with another word between all of them.
export function listed(words, between = undefined) {
  if (between !== undefined || words.length < 2) return words.join(between ?? '');
  return `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`;
}

// The depth of a run's things in a row, for their order: between those of its first and last row.
function depthIn({ first, last, texels }, row) {
  if (texels.length === 0) return Infinity;
  const [a, b] = [texels[0].depth, texels.at(-1).depth];
  return first === last ? a : a + ((b - a) * (row - first)) / (last - first);
}

function nameOf({ what, face, texture }) {
  if (what === 'sky' || what === 'haze') return `the ${what}`;
  const side =
    what === 'side' ? `a${'aeiou'.includes(face[0]) ? 'n' : ''} ${face}ern face` : `the ${what}`;
  return `${side} (${texture})`;
}
