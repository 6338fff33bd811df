// The version of Slicecast. Only CMakeLists.txt has it: tools/bundle.mjs puts it in here.
export const version = '';
