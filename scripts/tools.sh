# shellcheck shell=bash
# Installs whatever is missing, from package registries alone. Every function returns at once when there is nothing to do.
# Sourced by ./dev after lib.sh.

# have_std TARGET: whether its library is there, or that part of it that targets without an operating system have.
have_std() { [[ -n $(find "$(rustc --print target-libdir --target "$1")" -name 'libcore-*.rlib' 2>/dev/null) ]]; }

need_rust() {
    have rustup || have cargo || die "Rust is missing: install rustup, or rustc and cargo $(sed -n 's/^channel = //p' rust-toolchain.toml)"
    rustc --version >/dev/null 2>&1 || step "Installing the Rust tool chain" rustup toolchain install
    cargo fmt --version >/dev/null 2>&1 || step "Installing rustfmt" rustup component add rustfmt
    cargo clippy --version >/dev/null 2>&1 || step "Installing clippy" rustup component add clippy
    need_std "$WASM_TARGET" std,panic_abort,panic_unwind,test
}

# For the check that the bridge's rules need no operating system.
need_bare_metal() { need_std "$BARE_METAL_TARGET" core; }

# need_std TARGET CRATES
need_std() { have_std "$1" || step "Installing the standard library for $1" install_std "$@"; }

install_std() {
    if [[ -z ${ROBOVAC_STD_FROM_DEBIAN:-} ]] && have rustup && rustup target add "$1"; then
        return
    fi
    say "rustup could not fetch it; building it from Debian's copy of the library source instead"
    bash scripts/build-std.sh "$@"
}

# cargo_tool CRATE VERSION OPTION...: into its own folder. Quick to build beats quick to run for tools that take a second.
cargo_tool() {
    local crate=$1 version=$2 dir=$TOOLS/$1-$2
    shift 2
    [[ -e $dir/.complete ]] && return
    mkdir -p "$TOOLS"
    step "Installing $crate $version (minutes, once; kept in $dir)" install_cargo_tool "$crate" "$version" "$dir" "$@"
    touch "$dir/.complete"
}

install_cargo_tool() {
    local crate=$1 version=$2 dir=$3
    shift 3
    if cargo binstall -V >/dev/null 2>&1 &&
        cargo binstall --no-confirm --disable-strategies compile --root "$dir" "$crate@$version"; then
        return
    fi
    # The build folder is shared: the tools have many dependencies in common.
    CARGO_TARGET_DIR=$TOOLS/build \
        CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 CARGO_PROFILE_RELEASE_OPT_LEVEL=0 \
        cargo install --root "$dir" --version "$version" "$@" "$crate"
}

need_cargo_tools() {
    cargo_tool wasm-bindgen-cli "$WASM_BINDGEN_VERSION"
    cargo_tool trunk "$TRUNK_VERSION" --ignore-rust-version --no-default-features --features rustls
    rm -rf "$TOOLS/build"
}

need_compiler() { have cc || step "Installing a C compiler" apt_install build-essential; }

need_node() {
    { have node && have npm; } || step "Installing Node.js" apt_install nodejs npm
    cmp -s package-lock.json node_modules/.installed-lock.json && return
    step "Installing the npm packages of package-lock.json" npm ci --no-audit --no-fund
    cp package-lock.json node_modules/.installed-lock.json
}

# Walls around programs of strangers; tests hold them where the system allows them.
need_walls() { [[ $(uname) != Linux ]] || have bwrap || step "Installing bubblewrap" apt_install bubblewrap; }

# A Python with the drivers of tests/drivers/requirements.txt.
need_drivers() { need_packages tests/drivers/requirements.txt "$DRIVERS"; }

# One with what builds and tests the Python package.
need_python() { need_packages python/requirements.txt "$VENV"; }

# need_packages LIST LINK: a Python with the packages of LIST, which LINK leads to.
need_packages() {
    local place
    place=$TOOLS/python-$(sha256sum "$1" | cut -c 1-16)
    if [[ ! -e $place/.complete ]]; then
        { have python3 && python3 -c 'import ensurepip, venv'; } 2>/dev/null ||
            step "Installing Python" apt_install python3 python3-venv
        step "Installing the Python packages of $1" install_packages "$1" "$place"
    fi
    mkdir -p "${2%/*}"
    # Earlier versions had the packages themselves there.
    [[ -L $2 ]] || rm -rf "$2"
    ln -sfn "$place" "$2"
}

install_packages() {
    rm -rf "$2"
    python3 -m venv "$2"
    "$2/bin/pip" install --quiet --disable-pip-version-check --requirement "$1"
    touch "$2/.complete"
}

# Chromium for all tests; Firefox and WebKit, the engine of Safari, for those of what must work everywhere.
need_browsers() {
    local name missing=()
    for name in CHROMIUM CHROMEDRIVER FIREFOX; do
        [[ -z ${!name:-} ]] || have "${!name}" || die "$name=${!name} names a program that does not exist"
    done
    # Without a font the page's text is invisible in screenshots. The shell is Chromium without windows.
    { find_chromium && find_chromedriver; } >/dev/null ||
        missing+=(chromium chromium-driver chromium-headless-shell fonts-liberation)
    find_firefox >/dev/null || missing+=(firefox-esr)
    { have WebKitWebDriver && have Xvfb; } || missing+=(webkit2gtk-driver xvfb)
    # For a page over https.
    have openssl || missing+=(openssl)
    ((${#missing[@]})) || return 0
    step "Installing browsers: ${missing[*]}" apt_install "${missing[@]}"
    { find_chromium && find_chromedriver; } >/dev/null ||
        die "no Chromium for the tests: install Chromium and the chromedriver of the same version, or set CHROMIUM and CHROMEDRIVER to their paths"
    find_firefox >/dev/null || die "no Firefox for the tests: install Firefox 151 or later, or set FIREFOX to its path"
    { have WebKitWebDriver && have Xvfb; } || die "no WebKit for the tests: install WebKitWebDriver (webkit2gtk-driver) and Xvfb"
}

apt_install() {
    have apt-get || die "please install by hand: $* (there is no apt-get here)"
    local root=(env DEBIAN_FRONTEND=noninteractive)
    if ((EUID != 0)); then
        have sudo || die "please install as root: apt-get install $*"
        root=(sudo "${root[@]}")
    fi
    "${root[@]}" apt-get -q update &&
        "${root[@]}" apt-get -q -o DPkg::Lock::Timeout=300 install -y --no-install-recommends "$@"
}
