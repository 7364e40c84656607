# shellcheck shell=bash
# Keeps compiled dependencies beside the tools, so that a fresh checkout doesn't compile four hundred crates again.
# Sourced by ./dev after lib.sh. cargo itself checks what it finds: what doesn't fit, it compiles.

DEPENDENCIES=$TOOLS/dependencies

# What compiled dependencies depend on, and what few of them do: features and profiles.
dependencies_key() { printf '%s-%s' "$({ rustc -vV && cat Cargo.lock; } | short_digest)" "$(short_digest <Cargo.toml)"; }
short_digest() { sha256sum | cut -c 1-16; }

# Lines such as wasm32-unknown-unknown/debug/deps/libserde-1234.rlib: what is in target/, but not of this workspace.
list_dependencies() {
    local ours
    ours=$(cargo metadata --offline --locked --no-deps --format-version 1 | node -e '
        const { packages } = JSON.parse(require("fs").readFileSync(0, "utf8"));
        const names = packages.flatMap(({ name, targets }) => [name, ...targets.map((target) => target.name)]);
        console.log([...new Set(names.map((name) => name.replaceAll(/[-_]/g, "[-_]")))].join("|"));')
    find . -regextype posix-extended -regex '\./([^/]+/)?(debug|release)/(deps|build|\.fingerprint)/.*' -type f |
        grep -vE "/(lib)?($ours)-[0-9a-f]{16}"
}

# For a checkout in which nothing was compiled yet.
restore_dependencies() {
    local kept
    [[ ! -e target/debug && ! -e target/release ]] || return 0
    BEGAN_COLD=yes
    kept=$DEPENDENCIES/$(dependencies_key)
    [[ -d $kept ]] || kept=$(find "$DEPENDENCIES" -maxdepth 1 -name "$(basename "${kept%-*}")-*" ! -name '*.part' 2>/dev/null | head -n 1)
    [[ -n $kept ]] || return 0
    mkdir -p target
    cp -a --reflink=auto "$kept/." target/
}

# After everything was compiled in such a checkout: others also have what earlier versions needed. Those of another version go.
keep_dependencies() {
    local kept
    kept=$DEPENDENCIES/$(dependencies_key)
    [[ ${BEGAN_COLD:-} == yes && ! -d $kept ]] || return 0
    rm -rf "$DEPENDENCIES" &&
        mkdir -p "$kept.part" &&
        (cd target && list_dependencies | tar -cf - -T -) | tar -xf - -C "$kept.part" &&
        mv "$kept.part" "$kept"
}
