export default {
  title: 'A site built by VitePress',
  cacheDir: process.env.SLICECAST_CACHE,
  vue: { template: { compilerOptions: { isCustomElement: (tag) => tag === 'ray-caster' } } },
  vite: { publicDir: process.env.SLICECAST_PUBLIC, optimizeDeps: { exclude: ['slicecast'] } },
};
