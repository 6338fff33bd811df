// Whether elements are near the window or in it. One pair of observers serves the whole page.
//
//     const stop = watchVisibility(element, {near() {...}, seen(isSeen) {...}});
//
// near() is called once, when the element is in the window or close to it; seen() whenever it
// enters or leaves the window.

// jsdom and its like, in which people test their pages, have elements, but nobody sees them.
export const canBeSeen = () => globalThis.visualViewport !== undefined;

const kMargin = '50% 25%'; // of the window's size, around the window

const watched = new Map(); // element -> actions
let nearObserver = null;
let seenObserver = null;

export function watchVisibility(element, actions) {
  nearObserver ??= new IntersectionObserver(tellNear, { rootMargin: kMargin });
  seenObserver ??= new IntersectionObserver(tellSeen);
  watched.set(element, actions);
  nearObserver.observe(element);
  seenObserver.observe(element);
  return () => {
    watched.delete(element);
    nearObserver.unobserve(element);
    seenObserver.unobserve(element);
  };
}

function tellNear(entries) {
  for (const { target, isIntersecting } of entries) {
    if (!isIntersecting) continue;
    nearObserver.unobserve(target);
    watched.get(target)?.near();
  }
}

function tellSeen(entries) {
  for (const { target, isIntersecting } of entries) watched.get(target)?.seen(isIntersecting);
}
