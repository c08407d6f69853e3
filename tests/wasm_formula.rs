//! `FormulaMap` as JavaScript sees it. Runs in Node.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::wasm::formula::{FormulaMap, FormulaOptions};
use conformal_warp::wasm::options::Point;
use conformal_warp::wasm::overlay::OverlayOptions;
use conformal_warp::wasm::presets;
use js_sys::{Array, Reflect, Uint8ClampedArray};
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
    let t = Array::from(&property(&map.params().unwrap(), "t"));
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

fn overlay(map: &FormulaMap, options: &str) -> Result<Uint8ClampedArray, JsValue> {
    map.overlay(Ts::<OverlayOptions>::new_unchecked(eval(options))).map_err(JsValue::from)
}

#[wasm_bindgen_test]
fn overlays_are_new_pixels_or_go_over_given_ones() {
    let map = FormulaMap::new("z^2", None).unwrap();
    let view = "view: { center: [0, 0], width: 4, pixels: [32, 32] }";
    for kind in ["cartesian", "polar", "circle", "stretch", "argument"] {
        let rgba = overlay(&map, &format!("{{ kind: '{kind}', {view} }}")).unwrap().to_vec();
        assert_eq!(rgba.len(), 4 * 32 * 32);
        assert!(rgba.as_chunks::<4>().0.iter().any(|pixel| pixel[3] > 100), "{kind} draws nothing");
    }
    let band =
        format!("{{ kind: 'stretch', opacity: 0, {view}, rows: [3, 5], out: new Uint8ClampedArray(256).fill(9) }}");
    assert_eq!(overlay(&map, &band).unwrap().to_vec(), [9; 256]);
    let code = |options: &str| property(&overlay(&map, options).unwrap_err(), "code");
    assert_eq!(code(&format!("{{ kind: 'contour', {view} }}")), "invalid-option");
    assert_eq!(code(&format!("{{ kind: 'polar', spokes: 0, {view} }}")), "invalid-option");
    assert_eq!(code(&format!("{{ kind: 'polar', {view}, rows: [0, 1000000000] }}")), "invalid-rows");
}

#[wasm_bindgen_test]
fn every_preset_can_be_made_into_a_map() {
    let all = Array::from(&presets::all().js_value());
    assert!(all.length() >= 12);
    for preset in all {
        let [formula, params] = ["formula", "params"].map(|name| property(&preset, name));
        let options = js_sys::Object::new();
        Reflect::set(&options, &"params".into(), &params).unwrap();
        let options = Ts::<FormulaOptions>::new_unchecked(options.into());
        assert!(FormulaMap::new(&formula.as_string().unwrap(), Some(options)).is_ok());
        if property(&preset, "name") == "droste" {
            assert_eq!(Array::from(&property(&params, "n")).get(0), 3);
        }
        let direction = property(&preset, "direction").as_string().unwrap();
        assert!(["pull-back", "push-forward"].contains(&direction.as_str()), "{direction}");
        assert!(property(&property(&preset, "view"), "width").as_f64().unwrap() > 0.0);
    }
}
