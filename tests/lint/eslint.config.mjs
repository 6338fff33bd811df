// ESLint's rules: no mistakes, and lines of at most 100 characters. Prettier formats the code.
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
        {
          code: 100,
          ignoreUrls: true,
          ignoreStrings: true,
          ignoreTemplateLiterals: true,
          ignoreRegExpLiterals: true,
        },
      ],
      'no-unused-vars': [
        'error',
        { args: 'after-used', caughtErrors: 'none', varsIgnorePattern: '^_$' },
      ],
      'no-restricted-syntax': [
        'error',
        {
          selector: "BinaryExpression[operator='in'][left.type!='Literal']",
          message:
            'A key from elsewhere may be `constructor`: use Object.hasOwn, a Map or, for what an object inherits too, Reflect.has.',
        },
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
  // Some functions in these files run in the page.
  {
    files: ['tests/browser/**/*.mjs', 'tests/hosts/*.mjs'],
    languageOptions: { globals: { ...globals.browser, axe: 'readonly', slicecast: 'readonly' } },
  },
  // Runs in old browsers too, to tell visitors that the browser is too old.
  { files: ['web/play/before-start.js'], rules: { 'no-var': 'off', 'object-shorthand': 'off' } },
];
