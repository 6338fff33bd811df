export default {
  srcDir: './astro/src',
  outDir: process.env.SLICECAST_OUT,
  devToolbar: { enabled: false },
};
