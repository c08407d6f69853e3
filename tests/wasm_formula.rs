//! `FormulaMap` as JavaScript sees it. Runs in Node.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::wasm::formula::{FormulaMap, FormulaOptions};
use conformal_warp::wasm::options::Point;
use js_sys::Reflect;
use tsify::Ts;
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

fn eval(code: &str) -> JsValue {
    js_sys::eval(&format!("({code})")).unwrap()
}

fn formula(text: &str, options: &str) -> Result<FormulaMap, JsValue> {
    FormulaMap::new(text, Some(Ts::<FormulaOptions>::new_unchecked(eval(options)))).map_err(JsValue::from)
}

fn property(value: &JsValue, name: &str) -> JsValue {
    Reflect::get(value, &name.into()).unwrap()
}

#[wasm_bindgen_test]
fn a_formula_gives_values_and_derivatives() {
    let map = FormulaMap::new("z^2 + 1/z", None).unwrap();
    assert_eq!(map.eval(&[0.0, 1.0, 2.0, 0.0]).unwrap(), [-1.0, -1.0, 4.5, 0.0]);
    assert_eq!(map.derivative(&[2.0, 0.0]).unwrap(), [3.75, 0.0]);
    assert!(map.eval(&[0.0, 0.0]).unwrap()[0].is_nan());
    assert!(map.is_analytic() && map.text() == "z^2 + 1/z");
    assert!(!FormulaMap::new("conj(z)", None).unwrap().is_analytic());
}

#[wasm_bindgen_test]
fn parameters_are_named_and_can_change() {
    let mut map = formula("t z", "{ params: { t: [0, 1] } }").unwrap();
    assert_eq!(map.eval(&[1.0, 0.0]).unwrap(), [0.0, 1.0]);
    map.set_param("t", Ts::<Point>::new_unchecked(eval("[2, 0]"))).unwrap();
    assert_eq!(map.eval(&[1.0, 0.0]).unwrap(), [2.0, 0.0]);
    let t = js_sys::Array::from(&property(&map.params().unwrap(), "t"));
    assert_eq!((t.get(0).as_f64(), t.get(1).as_f64()), (Some(2.0), Some(0.0)));

    let mut set = |name: &str, value: &str| {
        let value = Ts::<Point>::new_unchecked(eval(value));
        property(&map.set_param(name, value).unwrap_err().into(), "code")
    };
    assert_eq!(set("u", "[1, 0]"), "unknown-parameter");
    assert_eq!(set("t", "[NaN, 0]"), "not-finite");
    assert_eq!(set("t", "7"), "invalid-option");
    let thrown = formula("t z", "{ params: { t: 1 } }").unwrap_err();
    assert_eq!((property(&thrown, "code"), property(&thrown, "option")), ("invalid-option".into(), "params.t".into()));
}

#[wasm_bindgen_test]
fn a_syntax_error_has_its_position_in_javascript_units() {
    let thrown = formula("π + )", "{}").unwrap_err();
    assert_eq!((property(&thrown, "code"), property(&thrown, "position")), ("syntax".into(), 4.into()));
    assert!(property(&thrown, "message").as_string().unwrap().contains("expected"));
}
