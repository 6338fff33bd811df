// The editor of the reader's program: CodeMirror, loaded when somebody goes into the program.
//
//     const editor = makeEditor(host, { text, label, onChange, onRun });
//     editor.text; editor.replace(text); editor.parses; editor.goTo(line, column);
//     editor.mark([{ line, column, says, severity }]); editor.focus(); editor.destroy();
//
// The editor stands in a shadow root, because of the policy `style-src 'self'`. Tried under it with
// @codemirror/view 6.43 and style-mod 4.1, in Chromium 156, Firefox 153 and WebKitGTK 2.50: in a
// document style-mod writes a <style> element, which the policy forbids, and the editor has no
// styles at all; in a shadow root it uses adoptedStyleSheets, which the policy allows, as it does
// attributes `style` that are set by `style.cssText`. The marks of @codemirror/lint are pictures at
// data: addresses, which the policy forbids too: the theme below replaces them. And when a
// selection is typed over, Chromium itself writes attributes `style`: see `beforeinput`.

import { defaultKeymap, history, historyKeymap, redo, undo } from '@codemirror/commands';
import { javascript } from '@codemirror/lang-javascript';
import {
  bracketMatching,
  ensureSyntaxTree,
  indentOnInput,
  indentUnit,
  syntaxHighlighting,
  syntaxTree,
} from '@codemirror/language';
import { lintGutter, setDiagnostics } from '@codemirror/lint';
import { EditorState } from '@codemirror/state';
import {
  EditorView,
  drawSelection,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import { classHighlighter } from '@lezer/highlight';

const kParseMilliseconds = 100;

const theme = EditorView.theme({
  '&': { height: '100%', color: 'var(--ink)', backgroundColor: 'var(--sheet)' },
  '&.cm-focused': { outline: 'none' }, // its host has the ring
  '.cm-scroller': { font: '14px/1.6 var(--mono)', overflow: 'auto' },
  '.cm-content': { padding: '12px 0', caretColor: 'var(--ink)' },
  '.cm-line': { padding: '0 12px 0 4px' },
  '.cm-gutters': {
    color: 'var(--soft)',
    backgroundColor: 'var(--sheet)',
    border: '0',
    fontSize: '13px',
  },
  '.cm-lineNumbers .cm-gutterElement': { padding: '0 4px 0 8px' },
  '.cm-activeLine': { backgroundColor: 'color-mix(in srgb, var(--block) 28%, transparent)' },
  '.cm-activeLineGutter': { color: 'var(--ink)', backgroundColor: 'transparent' },
  '.cm-cursor': { borderLeft: '2px solid var(--ink)' },
  '.cm-selectionBackground, &.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground':
    { background: 'color-mix(in srgb, var(--lit) 40%, transparent)' },
  '&.cm-focused .cm-matchingBracket': {
    backgroundColor: 'color-mix(in srgb, var(--lit) 35%, transparent)',
  },
  '&.cm-focused .cm-nonmatchingBracket': { color: 'var(--along)', backgroundColor: 'transparent' },
  '.tok-keyword': { color: 'var(--along)' },
  '.tok-comment': { color: 'var(--soft)', fontStyle: 'italic' },
  '.tok-number, .tok-bool, .tok-string, .tok-string2, .tok-literal': { color: 'var(--across)' },
  '.tok-definition': { fontWeight: '650' },
  // The marks of errors, without pictures.
  '.cm-gutter-lint': { width: '20px' },
  '.cm-lint-marker': { width: 'auto', height: 'auto', textAlign: 'center' },
  '.cm-lint-marker-error, .cm-lint-marker-warning': { content: 'normal', color: 'var(--ray)' },
  '.cm-lint-marker-error::before': { content: "'✗'", fontWeight: '700' },
  '.cm-lint-marker-warning::before': { content: "'!'", fontWeight: '700' },
  '.cm-lintRange-error, .cm-lintRange-warning, .cm-lintRange-active': { backgroundImage: 'none' },
  '.cm-lintRange-error, .cm-lintRange-warning': {
    textDecoration: 'underline wavy var(--ray)',
    textUnderlineOffset: '3px',
    paddingBottom: '0',
  },
  '.cm-tooltip': {
    color: 'var(--ink)',
    backgroundColor: 'var(--paper)',
    border: '1px solid var(--soft)',
    fontSize: '15px',
    maxWidth: 'min(420px, 90vw)',
  },
  '.cm-diagnostic': { padding: '6px 12px', whiteSpace: 'pre-wrap' },
  '.cm-diagnostic-error, .cm-diagnostic-warning': { borderLeft: '4px solid var(--ray)' },
});

export function makeEditor(host, { text, label, describedBy, onChange, onRun }) {
  const root = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
  const stateOf = (doc) =>
    EditorState.create({
      doc,
      extensions: [
        lintGutter(),
        lineNumbers(),
        highlightActiveLineGutter(),
        history(),
        drawSelection(),
        EditorState.tabSize.of(2),
        indentUnit.of('  '),
        indentOnInput(),
        bracketMatching(),
        highlightActiveLine(),
        javascript(),
        syntaxHighlighting(classHighlighter),
        // Tab is not among these keys: it leaves the editor. Mod-] and Mod-[ indent.
        keymap.of([
          { key: 'Mod-Enter', run: () => (onRun(), true) },
          ...defaultKeymap.filter(({ key }) => key !== 'Mod-Enter'),
          ...historyKeymap,
        ]),
        EditorView.contentAttributes.of({
          'aria-label': label,
          'aria-description': describedBy,
          tabindex: '0',
          autocapitalize: 'off',
          autocorrect: 'off',
          spellcheck: 'false',
        }),
        // Typing over a selection: Chromium would keep its colours in an attribute `style`.
        EditorView.domEventHandlers({
          beforeinput(event, view) {
            const { inputType, data } = event;
            if (inputType !== 'insertText' || data === null || view.composing) return false;
            if (view.state.selection.main.empty) return false;
            event.preventDefault();
            const change = view.state.replaceSelection(data);
            view.dispatch(change, { userEvent: 'input.type', scrollIntoView: true });
            return true;
          },
        }),
        EditorView.updateListener.of((update) => update.docChanged && onChange()),
        theme,
      ],
    });
  const view = new EditorView({ root, parent: root, state: stateOf(text) });

  const positionOf = (line, column) => {
    const { doc } = view.state;
    const { from, to } = doc.line(Math.min(Math.max(line, 1), doc.lines));
    return Math.min(from + Math.max(column - 1, 0), to);
  };

  return {
    get text() {
      return view.state.doc.toString();
    },

    // Whether the text is a program, as far as its grammar goes.
    get parses() {
      const tree = ensureSyntaxTree(view.state, view.state.doc.length, kParseMilliseconds);
      const cursor = (tree ?? syntaxTree(view.state)).cursor();
      do if (cursor.type.isError) return false;
      while (cursor.next());
      return true;
    },

    // Another program: undoing does not lead back to the one before.
    replace(newText) {
      view.setState(stateOf(newText));
    },
    undo: () => undo(view),
    redo: () => redo(view),

    mark(places) {
      const diagnostics = places
        .filter(({ line }) => line > 0 && line <= view.state.doc.lines)
        .map(({ line, column, says, severity = 'error' }) => {
          const from = positionOf(line, column);
          const word = view.state.wordAt(from) ?? { from, to: from };
          return { from: word.from, to: word.to, severity, message: says };
        });
      view.dispatch(setDiagnostics(view.state, diagnostics));
    },

    goTo(line, column = 1) {
      const at = positionOf(line, column);
      const effects = EditorView.scrollIntoView(at, { y: 'center' });
      view.dispatch({ selection: { anchor: at }, effects });
      view.focus();
    },

    // Puts the cursor where the pointer is, in pixels of the window.
    goToPoint(x, y) {
      const at = view.posAtCoords({ x, y });
      if (at !== null) view.dispatch({ selection: { anchor: at } });
      view.focus();
    },

    get scrollTop() {
      return view.scrollDOM.scrollTop;
    },
    set scrollTop(top) {
      view.scrollDOM.scrollTop = top;
    },
    focus: () => view.focus(),
    destroy: () => view.destroy(),
  };
}
