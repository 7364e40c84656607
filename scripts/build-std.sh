#!/usr/bin/env bash
# Builds the standard library of the active rustc for another target, for machines where rustup cannot fetch it:
# build-std.sh TARGET CRATES
# Debian packages the exact library source of each rustc (rust-src). The result goes to where rustup would have put it.
set -euo pipefail
# shellcheck source=scripts/lib.sh
. "$(dirname "$0")/lib.sh"

target=$1
crates=$2

sysroot=$(rustc --print sysroot)
version=$(rustc --version | cut -d' ' -f2)
lib=$(rustc --print target-libdir --target "$target")
source=$sysroot/lib/rustlib/src/rust/library

# A folder with parts of both rustup's and this build does not link.
[[ -z $(ls -A "$lib" 2>/dev/null) ]] || die "$lib is not empty: remove it (or run rustup target remove $target) and try again"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# apt with a sources list, index and cache of its own: nothing on this machine changes.
private_apt() {
    "$1" -q -o Dir::Etc::sourcelist="$work/sources.list" -o Dir::Etc::sourceparts=/dev/null -o Dir::State::lists="$work/lists" \
        -o Dir::Cache="$work/cache" -o APT::Sandbox::User=root "${@:2}"
}

fetch_source() {
    local mirror suite package
    # shellcheck disable=SC2016 # apt-get fills in $(REPO_URI)
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep '/debian/*$' | head -n 1) ||
        die "this machine has no Debian mirror to take rust-src from: install the $target target of rustc $version by hand"
    mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
    for suite in trixie-backports sid; do
        echo "deb $mirror $suite main" >"$work/sources.list"
        private_apt apt-get update
        package=$(private_apt apt-cache madison rust-src | awk -v v="$version" 'index($3, v "+") == 1 { print $3; exit }')
        [[ -z $package ]] || break
    done
    [[ -n $package ]] || die "Debian has no rust-src for rustc $version: install its $target target by hand"
    say "using rust-src $package"
    (cd "$work" && private_apt apt-get download "rust-src=$package" && dpkg-deb -x rust-src_*.deb deb)
    mkdir -p "$(dirname "$source")"
    trap 'rm -rf "$work" "$source"' EXIT
    cp -r "$(dirname "$(find "$work/deb" -path '*/library/Cargo.lock')")" "$source"
}

[[ -e $source/Cargo.lock ]] || fetch_source

# An empty crate, so that only the standard library is built. Without bitcode in it, `lto = true` fails.
mkdir -p "$work/crate/src"
echo "#![no_std]" >"$work/crate/src/lib.rs"
printf '[package]\nname = "empty"\nversion = "0.0.0"\nedition = "2021"\n' >"$work/crate/Cargo.toml"
(cd "$work/crate" && PATH="$sysroot/bin:$PATH" RUSTC_BOOTSTRAP=1 CARGO_ENCODED_RUSTFLAGS=-Cembed-bitcode=yes CARGO_TARGET_DIR="$work/target" \
    "$sysroot/bin/cargo" build --release --target "$target" -Zbuild-std="$crates")

rm "$work/target/$target/release/deps/libempty"-*
mkdir -p "$lib.new"
cp "$work/target/$target/release/deps/"*.rlib "$lib.new/"
rm -rf "$lib"
mv "$lib.new" "$lib"
say "installed into $lib"
