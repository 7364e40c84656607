# shellcheck shell=bash disable=SC2034 # what is set here is used in the scripts that source this
# Shared by ./dev and the scripts beside this file: places, versions, and how progress is shown.

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$ROOT" || exit 1

# Installed tools live outside the repository, one folder per version, so that a fresh checkout finds them again.
TOOLS=${ROBOVAC_TOOLS:-${XDG_CACHE_HOME:-$HOME/.cache}/robovac-playground}

# Links to Pythons with packages: the independent drivers of the tests, and what builds and tests the Python package.
DRIVERS=$ROOT/target/drivers
VENV=$ROOT/target/python
# The Python package, installed.
WHEEL=$ROOT/target/wheel

# The native program as tests build it.
ROBOVAC=$(realpath -m "${CARGO_TARGET_DIR:-$ROOT/target}")/debug/robovac

# What tests build beyond an ordinary build: nodes of ROS 2. In every step alike, so that nothing is compiled twice.
WITH_NODE=robovac-cli/ros2

WASM_TARGET=wasm32-unknown-unknown
# Such as an ESP32-C3.
BARE_METAL_TARGET=riscv32imc-unknown-none-elf
TRUNK_VERSION=0.22.1
# The command-line tool must equal the crate exactly, so the lock file decides.
WASM_BINDGEN_VERSION=$(awk '/^name = "wasm-bindgen"$/ { getline; gsub(/[^0-9.]/, ""); print; exit }' Cargo.lock)

export PATH="$TOOLS/wasm-bindgen-cli-$WASM_BINDGEN_VERSION/bin:$TOOLS/trunk-$TRUNK_VERSION/bin:$ROOT/node_modules/.bin:$PATH"

say() { printf '%s\n' "$*"; }
die() {
    printf 'error: %s\n' "$*" >&2
    exit 1
}
have() { command -v "$1" >/dev/null 2>&1; }

# step HEADING COMMAND...: shows what runs and how long it took; a failure ends the script.
step() {
    local heading=$1 start=$SECONDS status
    shift
    printf '\n==> %s\n' "$heading"
    # Not `"$@" || status=$?`: that would switch off `set -e` inside of the command.
    set +e
    (set -e && "$@")
    status=$?
    set -e
    ((status == 0)) || die "\"$heading\" failed after $((SECONDS - start)) s (exit code $status): $*"
    printf '    done in %d s\n' $((SECONDS - start))
}

# aside NAME COMMAND...: runs beside the steps that follow; `step ... joined NAME` waits for it. It ends with this script.
aside() {
    local name=$1
    shift
    mkdir -p target
    rm -f "target/$name.status"
    # In a process group of its own, to be ended with all that it started.
    set -m
    (
        set +e
        (set -e && "$@") >"target/$name.log" 2>&1
        echo $? >"target/$name.status"
    ) &
    set +m
    ASIDE+=("-$!")
    trap 'kill -- "${ASIDE[@]}" 2>/dev/null || true' EXIT
}
joined() {
    until [[ -e target/$1.status ]]; do sleep 0.2; done
    cat "target/$1.log"
    return "$(cat "target/$1.status")"
}

# The browser for tests: $CHROMIUM if set, else the first known name on PATH.
find_chromium() {
    local name names=(chromium chromium-browser google-chrome google-chrome-stable)
    [[ -z ${CHROMIUM:-} ]] || names=("$CHROMIUM")
    for name in "${names[@]}"; do
        command -v "$name" && return
    done
    return 1
}
# The browser for end-to-end tests: Chromium without windows needs two thirds of the time. It has no serial ports.
find_page_browser() {
    if [[ -z ${CHROMIUM:-} ]] && command -v chromium-headless-shell; then return; fi
    find_chromium
}
find_chromedriver() { command -v "${CHROMEDRIVER:-chromedriver}"; }
# Firefox for tests: $FIREFOX if set.
find_firefox() {
    local name names=(firefox-esr firefox)
    [[ -z ${FIREFOX:-} ]] || names=("$FIREFOX")
    for name in "${names[@]}"; do
        command -v "$name" && return
    done
    return 1
}
