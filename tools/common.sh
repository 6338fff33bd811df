# Shell functions that the commands in this folder share. Sourced by bash, never run.

repo="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
cacheHome="${XDG_CACHE_HOME:-${HOME:-/var/tmp}/.cache}/slicecast"

# The compiler's cache serves every clone on the machine: paths inside a clone count from its root.
export CCACHE_BASEDIR="$repo" CCACHE_NOHASHDIR=1
# It refuses precompiled headers unless it is told that no clock is in them.
export CCACHE_SLOPPINESS=pch_defines,time_macros

# One line about what happens now.
say() { printf '%s\n' "$*" >&2; }

# A fault that ends the command.
fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# The exit status after Ctrl-C.
interruptStatus=130

# The last line of a log that says something.
newestLine() { tail -c 1000 "$1" | tr '\r' '\n' | tr -cd '[:print:]\n' | awk 'NF { line = $0 } END { print line }'; }

# progress TITLE COMMAND...: runs the command with its output in a log. On a terminal the newest
# line of the log stands beside the title; elsewhere a line appears every 15 seconds. A failure
# shows the whole log, a success the compiler's warnings.
progress() {
  local title="$1" log begin pid status=0 newest lastSaid=0
  shift
  log="$(mktemp "${TMPDIR:-/tmp}/slicecast-log.XXXXXX")"
  begin=$SECONDS
  if [[ -t 2 ]]; then printf '%s ...' "$title" >&2; else say "$title ..."; fi
  # A process group of its own, so that Ctrl-C ends all that the command has started.
  set -m
  "$@" >"$log" 2>&1 </dev/null &
  pid=$!
  set +m
  trap 'trap - INT TERM; kill -INT -- "-$pid" 2>/dev/null || true; wait "$pid" 2>/dev/null || true; rm -f "$log"; printf "\n" >&2; exit "$interruptStatus"' INT TERM
  while kill -0 "$pid" 2>/dev/null; do
    sleep 0.1
    if [[ -t 2 ]]; then
      newest="$(newestLine "$log")"
      printf '\r\033[K%s (%d s) %s' "$title" $((SECONDS - begin)) "${newest:0:$((${COLUMNS:-100} - ${#title} - 12))}" >&2
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

# oneAtATime LOCK COMMAND...: two builds in one folder would spoil it; the second one waits, where
# the system has flock.
oneAtATime() {
  if command -v flock >/dev/null; then flock "$@"; else "${@:2}"; fi
}

# buildPreset PRESET TARGET...: configures the preset where needed and builds the targets ("all" for
# every one). Warnings are errors where SLICECAST_WERROR=ON is in the environment, as in .ci/run.
buildPreset() {
  local preset="$1" folder="$repo/build/$1" stamp="$repo/build/$1/.slicecast-configured" wanted options=()
  shift
  wanted="$(cksum <"$repo/CMakePresets.json") ${SLICECAST_WERROR:-OFF}"
  options+=(-DSLICECAST_WERROR="${SLICECAST_WERROR:-OFF}")
  if [[ "$preset" == wasm-* ]]; then
    wanted+=" $(command -v emcc) ${SLICECAST_SDL2_WASM:-}"
    options+=(-DSLICECAST_SDL2_WASM="${SLICECAST_SDL2_WASM:-}")
  fi
  if [[ ! -f "$folder/build.ninja" || ! -f "$stamp" || "$(cat "$stamp")" != "$wanted" ]]; then
    # Another compiler or SDL than last time: nothing that was found with the old one holds.
    rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles"
    (cd "$repo" && progress "Configuring $preset" cmake --preset "$preset" ${options[@]+"${options[@]}"}) || return 1
    printf '%s' "$wanted" >"$stamp"
  fi
  progress "Building $preset" oneAtATime "$folder/.slicecast-lock" \
    cmake --build "$folder" -j "$(getconf _NPROCESSORS_ONLN)" --target "$@"
}
