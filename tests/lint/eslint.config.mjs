// What ESLint asks of the JavaScript: no mistakes, and lines of at most 100 characters. The shape
// of the code is prettier's.
import js from '@eslint/js';
import globals from 'globals';

export default [
  js.configs.recommended,
  {
    languageOptions: { ecmaVersion: 2022, sourceType: 'module' },
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      eqeqeq: ['error', 'always', { null: 'ignore' }],
      'max-len': [
        'error',
        { code: 100, ignoreUrls: true, ignoreStrings: true, ignoreTemplateLiterals: true },
      ],
      'no-unused-vars': [
        'error',
        { args: 'after-used', caughtErrors: 'none', varsIgnorePattern: '^_$' },
      ],
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': ['error', { destructuring: 'all' }],
    },
  },
  {
    files: ['web/**/*.js', 'tests/browser/pages/*.js', 'tests/hosts/**/*.js'],
    languageOptions: { globals: globals.browser },
  },
  {
    files: [
      '**/*.mjs',
      '**/*.config.js',
      '**/config.js',
      'web/node/**/*.js',
      'web/bundlers/**/*.js',
    ],
    languageOptions: { globals: globals.node },
  },
  // Some of their functions run in the page.
  {
    files: ['tests/browser/**/*.mjs', 'tests/hosts/*.mjs'],
    languageOptions: { globals: { ...globals.browser, axe: 'readonly', slicecast: 'readonly' } },
  },
  // Runs in old browsers too, to tell them that they are too old.
  { files: ['web/play/before-start.js'], rules: { 'no-var': 'off', 'object-shorthand': 'off' } },
];
