// Searches the scene for a view in which the old way of drawing that is set shows.
//
//     const found = await findOldWay(caster, signal);     {isHere, view}, or null

const kSlice = 12; // milliseconds of search between two pictures of the game
const kPlain = 0.04; // of the pixels: nobody overlooks it, so the search ends
const kLeast = 0.008; // below, it is hard to find in the picture

const pause = () => new Promise((resolve) => setTimeout(resolve));

// Takes the first view in which it is plain, or else the one that shows most of it. Also null if
// the signal aborts, or the scene ends.
export async function findOldWay(caster, signal) {
  let best = null;
  let end = performance.now() + kSlice;
  for (let number = 0; ; ++number) {
    const tried = caster.tryOldWay(number);
    if (tried === null) break;
    if (tried.share > (best?.share ?? kLeast)) best = { ...tried, isHere: number === 0 };
    if (best !== null && best.share >= kPlain) break;
    if (performance.now() < end) continue;
    await pause();
    if (signal.aborted || caster.world === null) return null;
    end = performance.now() + kSlice;
  }
  return best;
}
