//! A walk's cost and proven bound, if any, passed to the page and back.

use coverage_planners::Proof;
use {js_sys::Float64Array, wasm_bindgen::JsValue};

/// `[cost, bound]`, or `undefined`.
pub fn proof_to_js(proof: Option<Proof>) -> JsValue {
    // Far below the limit of exact whole numbers.
    proof.map_or(JsValue::UNDEFINED, |Proof { cost, bound }| {
        Float64Array::from([cost as f64, bound as f64].as_slice()).into()
    })
}

/// The proof of an array made by [`proof_to_js`].
pub fn proof_from_js(numbers: Option<Vec<f64>>) -> Option<Proof> {
    let [cost, bound]: [f64; 2] = numbers?.try_into().ok()?;
    Some(Proof { cost: cost as u64, bound: bound as u64 })
}
