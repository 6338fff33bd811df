export default {
  base: './',
  optimizeDeps: { exclude: ['slicecast'] },
};
