export default {
  publicDir: process.env.SLICECAST_PUBLIC,
  cacheDir: process.env.SLICECAST_CACHE,
  optimizeDeps: { exclude: ['slicecast'] },
};
