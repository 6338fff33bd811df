/** A plugin for esbuild: copies the engine, and the pictures of imported scenes, into the build. */
export default function slicecast(): { name: string; setup(build: any): void };
