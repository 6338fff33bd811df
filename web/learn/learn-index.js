// The page script of the map of chapters: only the search.

import { startSearch } from './search.js';

startSearch();
