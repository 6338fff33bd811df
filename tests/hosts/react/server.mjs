// A program under Node: writes the page that the server sends on its output.

import { createElement } from 'react';
import { renderToString } from 'react-dom/server';
import App from './app.js';

process.stdout.write(`<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>An app rendered by React</title>
<link rel="icon" href="data:,">
<script type="module" src="main.js"></script>
</head>
<body><div id="root">${renderToString(createElement(App))}</div><div id="more"></div></body>
</html>
`);
