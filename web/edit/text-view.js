// The text as a view of the document: what is typed is an edit, what other views do appears here.
// Takes a document; gives edits to it. Loads CodeMirror.
//
//     const view = new TextView(parent, scene);
//     view.show(faults);              // marks them
//     view.goTo(pointer, text);       // '/maps/0/start'

import { defaultKeymap, indentWithTab } from '@codemirror/commands';
import {
  bracketMatching,
  HighlightStyle,
  StreamLanguage,
  syntaxHighlighting,
} from '@codemirror/language';
import { linter, lintGutter, setDiagnostics } from '@codemirror/lint';
import { Annotation, EditorState } from '@codemirror/state';
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';

const fromScene = Annotation.define();

const kColours = HighlightStyle.define([
  { tag: tags.propertyName, color: '#ecc862' },
  { tag: tags.string, color: '#c8dba8' },
  { tag: tags.number, color: '#8fc7e8' },
  { tag: tags.keyword, color: '#e3835f' },
  { tag: tags.punctuation, color: '#b5a58d' },
]);

const json = StreamLanguage.define({
  token(stream) {
    if (stream.eatSpace()) return null;
    if (stream.match(/^"(?:[^"\\]|\\.)*"/))
      return stream.match(/^\s*:/, false) ? 'propertyName' : 'string';
    if (stream.match(/^-?\d+(\.\d+)?([eE][+-]?\d+)?/)) return 'number';
    if (stream.match(/^(true|false|null)/)) return 'keyword';
    stream.next();
    return 'punctuation';
  },
});

export class TextView {
  #view;
  #scene;
  #isTyping = false;

  constructor(parent, scene) {
    this.#scene = scene;
    this.#view = new EditorView({
      parent,
      state: EditorState.create({
        doc: scene.text,
        extensions: [
          ...(scene.text.includes('\r\n') ? [EditorState.lineSeparator.of('\r\n')] : []),
          lineNumbers(),
          drawSelection(),
          highlightActiveLine(),
          bracketMatching(),
          lintGutter(),
          linter(null),
          json,
          syntaxHighlighting(kColours),
          keymap.of([...defaultKeymap, indentWithTab]),
          EditorView.contentAttributes.of({ 'aria-label': 'Text of the scene' }),
          EditorView.theme(
            {
              '&': { height: '100%', fontSize: '13px' },
              '.cm-scroller': {
                fontFamily: "'Cascadia Mono', Consolas, 'DejaVu Sans Mono', monospace",
              },
              '.cm-gutters': { background: '#221b20', color: '#b5a58d', border: '0' },
              '.cm-activeLine': { background: 'rgb(255 255 255 / 0.04)' },
              '.cm-cursor': { borderLeftColor: '#f7f1e1' },
            },
            { dark: true },
          ),
          EditorView.updateListener.of((update) => this.#typed(update)),
        ],
      }),
    });
    this.#view.scrollDOM.tabIndex = 0; // it is scrolled by keys, too
    scene.listen(({ edits }) => this.#isTyping || this.#follow(edits));
  }

  focus() {
    this.#view.focus();
  }

  show(faults) {
    const { doc } = this.#view.state;
    const diagnostics = faults
      .filter(({ line }) => line > 0 && line <= doc.lines)
      .map(({ line, column, found, expected }) => {
        const from = Math.min(doc.line(line).from + Math.max(0, column - 1), doc.length);
        return {
          from,
          to: Math.min(from + 1, doc.length),
          severity: 'error',
          message: expected === '' ? found : `Found ${found}, expected ${expected}`,
        };
      });
    this.#view.dispatch(setDiagnostics(this.#view.state, diagnostics));
  }

  goTo({ line, column }) {
    const { doc } = this.#view.state;
    if (line < 1 || line > doc.lines) return;
    const anchor = Math.min(doc.line(line).from + Math.max(0, column - 1), doc.length);
    this.#view.dispatch({
      selection: { anchor },
      effects: EditorView.scrollIntoView(anchor, { y: 'center' }),
    });
    this.focus();
  }

  #typed({ changes, docChanged, transactions }) {
    if (!docChanged || transactions.some((one) => one.annotation(fromScene))) return;
    const edits = [];
    if (this.#scene.text.includes('\r')) {
      // Here a line break is one character, in the scene it is two.
      const { from, to, insert } = difference(this.#scene.text, this.#view.state.sliceDoc());
      edits.push({ offset: from, length: to - from, content: insert });
    } else {
      changes.iterChanges((from, to, _, __, inserted) =>
        edits.push({ offset: from, length: to - from, content: inserted.toString() }),
      );
    }
    this.#isTyping = true;
    this.#scene.apply(edits);
    this.#isTyping = false;
  }

  // Where a line break is two characters in the scene, by comparing.
  #follow(edits) {
    const { text } = this.#scene;
    const changes = text.includes('\r')
      ? difference(this.#view.state.doc.toString(), text.replaceAll('\r\n', '\n'))
      : edits.map(({ offset, length, content }) => ({
          from: offset,
          to: offset + length,
          insert: content,
        }));
    this.#view.dispatch({ changes, annotations: fromScene.of(true) });
  }
}

// The one change that makes a text of another.
function difference(before, after) {
  const most = Math.min(before.length, after.length);
  let from = 0;
  while (from < most && before[from] === after[from]) ++from;
  let back = 0;
  while (back < most - from && before.at(-1 - back) === after.at(-1 - back)) ++back;
  return { from, to: before.length - back, insert: after.slice(from, after.length - back) };
}
