// The page script of the map of chapters.

import { startProgress } from './progress.js';
import { startSearch } from './search.js';

startProgress();
startSearch();
