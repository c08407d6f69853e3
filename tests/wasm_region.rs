//! `Region` as JavaScript sees it, and how options and errors cross the border. Runs in Node.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::wasm::region::{Region, RegionOptions};
use js_sys::Reflect;
use tsify::Ts;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

const SQUARE: &str = "boundary: new Float64Array([-1, -1, -1, 1, 1, 1, 1, -1])";

/// `new Region({ … })`, the options written in JavaScript.
fn region(options: &str) -> Result<Region, JsValue> {
    let options = js_sys::eval(&format!("({{ {options} }})")).unwrap();
    Region::new(Ts::<RegionOptions>::new_unchecked(options)).map_err(JsValue::from)
}

/// What `new Region({ … })` throws: code, option and message.
fn refusal(options: &str) -> (String, Option<String>, String) {
    let thrown = region(options).unwrap_err();
    assert!(thrown.is_instance_of::<js_sys::Error>(), "not an Error: {thrown:?}");
    let get = |name: &str| Reflect::get(&thrown, &name.into()).unwrap().as_string();
    (get("code").unwrap(), get("option"), get("message").unwrap())
}

fn numbers(value: &JsValue) -> Vec<f64> {
    js_sys::Array::from(value).iter().map(|x| x.as_f64().unwrap()).collect()
}

#[wasm_bindgen_test]
fn a_region_answers_what_it_was_given() {
    let region = region(&format!("{SQUARE}, curve: 'polygon', center: [0, 0.5], toward: [3, 0.25]")).unwrap();
    assert_eq!(region.boundary(), [-1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0]);
    assert_eq!(numbers(&region.center()), [0.0, 0.5]);
    assert_eq!(numbers(&region.toward()), [1.0, 0.25]);
    assert_eq!(region.contains(&[0.0, 0.0, 1.0, 1.0, 1.5, 0.0, f64::NAN, 0.0]).unwrap(), [1, 1, 0, 0]);
}

#[wasm_bindgen_test]
fn an_odd_count_of_numbers_is_refused() {
    let region = region(&format!("{SQUARE}, center: [0, 0], toward: [1, 0]")).unwrap();
    let thrown = JsValue::from(region.contains(&[0.0, 0.0, 1.0]).unwrap_err());
    assert_eq!(Reflect::get(&thrown, &"code".into()).unwrap(), "wrong-length");
}

#[wasm_bindgen_test]
fn errors_of_the_region_carry_a_code_and_a_place() {
    let thrown =
        region("boundary: new Float64Array([0, 0, 1, 1, 1, 0, 0, 1]), center: [0.2, 0.5], toward: [0, 0]").unwrap_err();
    let get = |name: &str| Reflect::get(&thrown, &name.into()).unwrap();
    assert_eq!(get("code"), "self-intersecting");
    assert_eq!(numbers(&get("edges")), [0.0, 2.0]);
    assert_eq!(numbers(&get("at")), [0.5, 0.5]);

    let (code, _, message) = refusal(&format!("{SQUARE}, center: [5, 0], toward: [1, 0]"));
    assert_eq!(code, "center-outside");
    assert!(message.contains("(5.000000, 0.000000)"), "{message}");
}

#[wasm_bindgen_test]
fn wrong_options_are_named_in_words() {
    let cases = [
        (format!("{SQUARE}, center: [0, 0]"), "toward", "The option \"toward\" is missing."),
        (format!("{SQUARE}, center: [0, 0, 0], toward: [1, 0]"), "center", "expected two numbers [x, y]"),
        (format!("{SQUARE}, center: 'middle', toward: [1, 0]"), "center", "expected two numbers [x, y]"),
        (format!("{SQUARE}, center: [0, '0'], toward: [1, 0]"), "center", "expected two numbers [x, y]"),
        ("boundary: [0, 0, 1, 0, 1, 1], center: [0.5, 0.1], toward: [1, 0]".into(), "boundary", "a Float64Array"),
        (format!("{SQUARE}, curve: 'round', center: [0, 0], toward: [1, 0]"), "curve", "`polygon`"),
        (format!("{SQUARE}, centre: [0, 0], toward: [1, 0]"), "centre", "There is no option \"centre\""),
    ];
    for (options, option, words) in cases {
        let (code, named, message) = refusal(&options);
        assert_eq!((code.as_str(), named.as_deref()), ("invalid-option", Some(option)), "{message}");
        assert!(message.contains(words), "{options}: {message}");
    }
}
