// Node may crash by SIGSEGV when it begins to run WebAssembly, which is not the project's fault
// (https://github.com/nodejs/node/issues/64500). `tools/test` runs such a test file once more, but
// sees only the file's own process.
//
//     await run(process.execPath, words).catch(crashToo);

export function crashToo(error) {
  if (error.signal === 'SIGSEGV') process.kill(process.pid, 'SIGSEGV');
  throw error;
}
