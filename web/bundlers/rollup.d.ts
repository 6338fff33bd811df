/** A plugin for Rollup: copies the engine, and the pictures of imported scenes, into the build. */
export default function slicecast(): {
  name: string;
  transform(this: any, code: string, id: string): Promise<{ code: string; map: null } | null>;
};
