// A list of what was not taken, or not as it was, each with its place. It has an end: further ones
// are counted, and the last line says how many they are.
//
//     const notes = listNotes(1000);
//     notes.add('layer "Deco", tile 3,4', 'it lies under a tile of "Walls"');
//     notes.list()                            // [{ place, reason }]
//     counted(1, 'tile')                      // '1 tile'

export const counted = (count, one, many = `${one}s`) => `${count} ${count === 1 ? one : many}`;

export function listNotes(most) {
  const list = [];
  let more = 0;
  return {
    add(place, reason) {
      if (list.length < most) list.push({ place, reason });
      else more += 1;
    },
    list: () => (more === 0 ? list : [...list, { place: 'elsewhere', reason: `${more} more` }]),
  };
}
