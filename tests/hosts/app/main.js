import 'slicecast';
import walk from 'slicecast/scenes/first-walk';

document.querySelector('ray-caster').scene = walk;
