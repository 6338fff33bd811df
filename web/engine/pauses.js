// Long work in slices, between which the page can draw and hear its visitor.
//
//     const pauses = new Pauses();
//     while (there is more) {
//       doALittle();
//       await pauses.mayCome();       // goes on at once, unless the slice is over
//     }

const kSliceMilliseconds = 4; // and the little that was begun

export class Pauses {
  #begin = performance.now();

  get isDue() {
    return performance.now() - this.#begin >= kSliceMilliseconds;
  }

  async mayCome() {
    if (!this.isDue) return;
    await nextTask();
    this.#begin = performance.now();
  }
}

// Timers would wait longer and longer, and a second each in a page out of sight.
function nextTask() {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
