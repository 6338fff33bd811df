export default {
  title: 'A site built by VitePress',
  vue: { template: { compilerOptions: { isCustomElement: (tag) => tag === 'ray-caster' } } },
  vite: { optimizeDeps: { exclude: ['slicecast'] }, ssr: { noExternal: ['slicecast'] } },
};
