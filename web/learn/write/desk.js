// Whose program is in the panel, what is kept of it, and when it runs. It knows no document.
//
//     const desk = new Desk(shelf, 4);                  // a Shelf of storage.js, and the chapter
//     desk.open({ text, isOwn: true, mayRun: true });
//     desk.press();                                     // the reader presses Run
//     for (let text; (text = desk.begin()) !== null; desk.end({ isStopped })) ...   // runs it
//
// A program is ours, the reader's or from a link. The rule:
//
//     ours       runs at once, and is not kept
//     reader     runs at once and after each change, and is kept before each run; but what did not
//                come to its end last time waits for the reader
//     link       waits until the reader presses Run, and whatever waited to run is given up when it
//                comes. The reader's own program stays what is kept. Once it has run, a change
//                makes it the reader's; the program that was kept goes to the earlier ones
//
// An edit or a button puts the reader's program in place of ours.

export class Desk {
  #shelf;
  #chapter;
  // What is shown. Of a link's program: whether the reader has pressed Run since it came, whether
  // it has been changed, and what was shown before.
  #shown = { text: '', whose: 'ours' };
  #kept = null; // the reader's text as it was read or saved last
  #isDue = false; // a run is wanted
  #running = null; // what runs, as #shown

  constructor(shelf, chapter) {
    this.#shelf = shelf;
    this.#chapter = chapter;
  }

  get text() {
    return this.#shown.text;
  }

  // 'ours', 'reader' or 'link'.
  get whose() {
    return this.#shown.whose;
  }

  // Whether a link's program is shown that has not been released by a click on Run.
  get isWaiting() {
    return this.whose === 'link' && !this.#shown.isReleased;
  }

  get isRunning() {
    return this.#running !== null;
  }

  // The page opens, with our program or the reader's.
  open({ text, isOwn, mayRun }) {
    this.#shown = { text: plain(text), whose: isOwn ? 'reader' : 'ours' };
    this.#kept = isOwn ? this.text : null;
    this.#isDue = mayRun;
  }

  // A program came with the address.
  bring(text) {
    this.leave();
    const behind = this.whose === 'link' ? this.#shown.behind : this.#shown;
    this.#shown = { text: plain(text), whose: 'link', behind };
    this.#isDue = false;
  }

  // From a link's program back to what was shown before, which runs.
  back() {
    this.#shown = this.#shown.behind ?? this.#shown;
    this.#isDue = true;
  }

  // The reader's editor has this text now.
  type(text) {
    if (text === this.text) return;
    const isLink = this.whose === 'link';
    this.#shown = { ...this.#shown, text, whose: isLink ? 'link' : 'reader', isChanged: true };
    this.#adopt();
  }

  // Typing rests. What is not a program yet is only kept.
  rest(isProgram) {
    if (this.isWaiting) return;
    if (isProgram) this.#isDue = true;
    else this.leave();
  }

  // Another text in place of the shown one. Returns a function that undoes it.
  put(text, why) {
    const before = this.#shown;
    this.#keep(why);
    const next = { text: plain(text), whose: 'reader' };
    this.#shown = next;
    this.#isDue = true;
    return () => {
      if ((this.#shown.behind ?? this.#shown) !== next) this.#keep('Before Undo');
      this.#shown = before;
      this.#isDue = !this.isWaiting;
    };
  }

  // The reader presses Run.
  press() {
    if (this.whose === 'link') this.#shown = { ...this.#shown, isReleased: true };
    this.#adopt();
    this.#isDue = true;
  }

  // Wants a run without the reader.
  ask() {
    this.#isDue ||= !this.isWaiting;
  }

  // The text to run now, or null. One runs at a time.
  begin() {
    if (!this.#isDue || this.#running !== null) return null;
    this.#isDue = false;
    this.#running = this.#shown;
    if (this.whose === 'reader') this.#save(true);
    return this.text;
  }

  // What ran has ended, or was stopped: then it does not run unasked at the next visit.
  end({ isStopped }) {
    const { whose } = this.#running;
    this.#running = null;
    if (whose === 'reader' && !isStopped) this.#shelf.finish(this.#chapter);
  }

  // Keeps what the reader has changed.
  leave() {
    if (this.whose === 'reader' && this.text !== this.#kept) this.#save(false);
  }

  // The reader's program, shown or behind a link's, goes to the earlier ones.
  #keep(why) {
    const { whose, text } = this.#shown.behind ?? this.#shown;
    if (whose === 'reader') this.#shelf.keep(this.#chapter, text, why);
  }

  #save(isRunning) {
    this.#kept = this.text;
    this.#shelf.save(this.#chapter, this.text, isRunning);
  }

  // A link's program that has run and was changed is the reader's.
  #adopt() {
    const { text, isReleased, isChanged } = this.#shown;
    if (this.whose !== 'link' || !isReleased || !isChanged) return;
    this.#keep('Before the link');
    this.#shown = { text, whose: 'reader' };
  }
}

// As the editor has it.
const plain = (text) => text.replace(/\r\n?/g, '\n');
