# Shell functions shared by the commands in this folder. To be sourced by bash.

repo="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
# What all clones on the machine share: pictures, and sources that are compiled. So nobody else may
# write there; without a home folder each clone has its own.
cacheHome="${XDG_CACHE_HOME:-${HOME:+$HOME/.cache}}"
cacheHome="${cacheHome:-$repo/build/cache}/slicecast"

# All clones on the machine share ccache's cache, so paths are relative to the clone's root.
export CCACHE_BASEDIR="$repo" CCACHE_NOHASHDIR=1
# Without this, ccache does not cache precompiled headers.
export CCACHE_SLOPPINESS=pch_defines,time_macros

# say TEXT: prints a line to stderr.
say() { printf '%s\n' "$*" >&2; }

# fail TEXT: prints an error and exits.
fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# The exit status after Ctrl-C.
interruptStatus=130

# The last non-empty line of a log.
newestLine() {
  tail -c 1000 "$1" | tr '\r' '\n' | tr -cd '[:print:]\n' |
    awk 'NF { line = $0 } END { print line }'
}

# steadyNode ARGUMENT...: runs Node, and once more if Node itself crashes, as it may when it begins to
# run WebAssembly (https://github.com/nodejs/node/issues/64500).
steadyNode() {
  local status=0
  node "$@" || status=$?
  if ((status != 139)); then return "$status"; fi
  say "  Node crashed; it runs again."
  node "$@"
}

# progress TITLE COMMAND...: runs the command with its output in a log. On a terminal it shows the
# log's newest line beside the title; elsewhere it prints a line every 15 seconds. After a failure
# it prints the whole log, else the compiler's warnings.
progress() {
  local title="$1" log begin pid status=0 newest lastSaid=0
  shift
  log="$(mktemp "${TMPDIR:-/tmp}/slicecast-log.XXXXXX")"
  begin=$SECONDS
  if [[ -t 2 ]]; then printf '%s ...' "$title" >&2; else say "$title ..."; fi
  # A process group of its own, so that Ctrl-C also ends the command's children.
  set -m
  "$@" >"$log" 2>&1 </dev/null &
  pid=$!
  set +m
  trap 'trap - INT TERM
    kill -INT -- "-$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || true
    rm -f "$log"
    printf "\n" >&2
    exit "$interruptStatus"' INT TERM
  while kill -0 "$pid" 2>/dev/null; do
    sleep 0.1
    if [[ -t 2 ]]; then
      newest="$(newestLine "$log")"
      printf '\r\033[K%s (%d s) %s' "$title" $((SECONDS - begin)) \
        "${newest:0:$((${COLUMNS:-100} - ${#title} - 12))}" >&2
    elif ((SECONDS - begin - lastSaid >= 15)); then
      lastSaid=$((SECONDS - begin))
      newest="$(newestLine "$log")"
      say "  $lastSaid s: ${newest:0:100}"
    fi
  done
  wait "$pid" || status=$?
  trap - INT TERM
  [[ -t 2 ]] && printf '\r\033[K' >&2
  if ((status != 0)); then
    say "$title: failed after $((SECONDS - begin)) s. Its output:"
    cat "$log" >&2
  else
    grep -A 3 -E ': warning: ' "$log" >&2 || true
    say "$title: done in $((SECONDS - begin)) s"
  fi
  rm -f "$log"
  return "$status"
}

# oneAtATime LOCK COMMAND...: waits for another build in the same folder, if the system has flock.
oneAtATime() {
  if command -v flock >/dev/null; then flock "$@"; else "${@:2}"; fi
}

# configurePreset PRESET: configures the preset if needed. Warnings are errors if the environment has
# SLICECAST_WERROR=ON, as in .ci/run.
configurePreset() {
  local preset="$1" folder="$repo/build/$1" wanted options=()
  local stamp="$folder/.slicecast-configured"
  wanted="$(cksum <"$repo/CMakePresets.json") ${SLICECAST_WERROR:-OFF}"
  options+=(-DSLICECAST_WERROR="${SLICECAST_WERROR:-OFF}")
  if [[ "$preset" == wasm-* ]]; then
    wanted+=" $(command -v emcc) ${SLICECAST_SDL2_WASM:-}"
    options+=(-DSLICECAST_SDL2_WASM="${SLICECAST_SDL2_WASM:-}")
  fi
  if [[ -f "$folder/build.ninja" && -f "$stamp" && "$(cat "$stamp")" == "$wanted" ]]; then
    return 0
  fi
  # Another compiler or SDL than last time: nothing that was found with the old one holds.
  rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles"
  (cd "$repo" && progress "Configuring $preset" \
    cmake --preset "$preset" ${options[@]+"${options[@]}"}) || return 1
  printf '%s' "$wanted" >"$stamp"
}

# startBuild PRESET JOBS TARGET...: builds targets of a configured preset.
startBuild() {
  oneAtATime "$repo/build/$1/.slicecast-lock" cmake --build "$repo/build/$1" -j "$2" --target "${@:3}"
}

# buildPreset PRESET TARGET...: configures the preset if needed, and builds the targets.
buildPreset() {
  configurePreset "$1" || return 1
  progress "Building $1" startBuild "$1" "$(getconf _NPROCESSORS_ONLN)" "${@:2}"
}
