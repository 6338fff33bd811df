// As Vite is by itself, but for where it builds.
export default { base: './' };
