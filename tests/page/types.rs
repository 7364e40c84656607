//! The TypeScript declarations of what crosses to JavaScript.

use robovac_app::types::declarations;
use std::fs;

#[test]
fn types_of_the_page_are_those_of_rust() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/www/types.d.ts");
    let (new, old) = (declarations(), fs::read_to_string(path).unwrap_or_default());
    if new != old {
        fs::write(path, new).unwrap();
        panic!("www/types.d.ts was out of date and has been written again: run `tsc --project .`, and commit it");
    }
}
