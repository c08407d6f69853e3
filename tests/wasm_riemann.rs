//! `RiemannMap` as JavaScript sees it. Runs in Node.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::wasm::canonical::Joinable;
use conformal_warp::wasm::region::{Region, RegionOptions};
use conformal_warp::wasm::region_map::RegionMap;
use conformal_warp::wasm::riemann::{CenterOptions, RiemannMap, RiemannOptions};
use js_sys::Reflect;
use std::f64::consts::FRAC_PI_2;
use tsify::Ts;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

fn object(fields: &str) -> JsValue {
    js_sys::eval(&format!("({{ {fields} }})")).unwrap()
}

fn square() -> Region {
    let options = "boundary: new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]), center: [0, 0], toward: [-1, -1]";
    Region::new(Ts::<RegionOptions>::new_unchecked(object(options))).unwrap()
}

fn solve(options: &JsValue) -> Result<RiemannMap, JsValue> {
    RiemannMap::solve(&square(), Some(Ts::<RiemannOptions>::new_unchecked(options.clone()))).map_err(JsValue::from)
}

fn function(text: &str) -> js_sys::Function {
    js_sys::eval(&format!("({text})")).unwrap().into()
}

/// A progress function that goes on for so many calls, and the list of what it was told.
fn going_on_for(calls: u32) -> (js_sys::Function, js_sys::Array) {
    let told = js_sys::Array::new();
    let make = function(&format!("told => (stage, fraction) => told.push([stage, fraction]) <= {calls}"));
    (make.call1(&JsValue::UNDEFINED, &told).unwrap().into(), told)
}

fn property(value: &JsValue, name: &str) -> JsValue {
    Reflect::get(value, &name.into()).unwrap()
}

#[wasm_bindgen_test]
fn the_square_is_mapped_with_its_evidence() {
    let map = solve(&object("tolerance: 1e-12, maxUnknowns: 2000")).unwrap();
    for (k, angle) in map.angles().iter().enumerate() {
        assert!((angle - k as f64 * FRAC_PI_2).abs() < 1e-12, "vertex {k}: {angle}");
    }
    assert!((map.conformal_radius() - 1.078_705_202_376_758_7).abs() < 1e-12);
    assert!(map.error_estimate() > 0.0 && map.error_estimate() <= 1e-12);
    assert!(map.residual() <= map.error_estimate() && map.unknowns() > 16);
    assert_eq!(map.stop(), "tolerance");

    let images = map.to_disk(&[0.0, 0.0, -1.0, -1.0, 5.0, 5.0]).unwrap();
    assert!(images[..2].iter().all(|x| x.abs() < 1e-12) && (images[2] - 1.0).abs() < 1e-12, "{images:?}");
    assert!(images[4].is_nan() && images[5].is_nan());
}

#[wasm_bindgen_test]
fn another_center_needs_no_new_solve() {
    let map = solve(&object("tolerance: 1e-10")).unwrap();
    let moved = |fields| map.with_center(Ts::<CenterOptions>::new_unchecked(object(fields))).map_err(JsValue::from);
    let images = moved("center: [0.25, 0.5], toward: [1, 1]").unwrap().to_disk(&[0.25, 0.5, 1.0, 1.0]).unwrap();
    assert!(images.iter().zip([0.0, 0.0, 1.0, 0.0]).all(|(a, b)| (a - b).abs() < 1e-9), "{images:?}");
    assert_eq!(property(&moved("center: [2, 0], toward: [1, 1]").unwrap_err(), "code"), "center-outside");
}

#[wasm_bindgen_test]
fn options_may_be_left_out() {
    let map = RiemannMap::solve(&square(), None).unwrap();
    assert!(map.error_estimate() <= 1e-8);
    assert!(solve(&object("onProgress: undefined")).is_ok());
}

#[wasm_bindgen_test]
fn progress_is_told_and_can_cancel() {
    let heard = object("stages: []");
    let watching = "onProgress(stage, fraction) { globalThis.heard.stages.push([stage, fraction]) }";
    Reflect::set(&js_sys::global(), &"heard".into(), &heard).unwrap();
    solve(&object(watching)).unwrap();
    let stages = js_sys::Array::from(&property(&heard, "stages"));
    assert!(stages.length() > 0);
    for told in stages.iter().map(|told| js_sys::Array::from(&told)) {
        assert!(told.get(0).is_string() && (0.0..=1.0).contains(&told.get(1).as_f64().unwrap()), "{told:?}");
    }

    let cancelled = solve(&object("onProgress: () => false")).unwrap_err();
    assert_eq!(property(&cancelled, "code"), "cancelled");
    let thrown = solve(&object("onProgress() { throw new RangeError('enough') }")).unwrap_err();
    assert_eq!((property(&thrown, "name"), property(&thrown, "message")), ("RangeError".into(), "enough".into()));
}

/// A long region, whose evaluator links the maps of several centers.
fn long_map() -> RiemannMap {
    let options = "boundary: new Float64Array([0, 0, 16, 0, 16, 1, 0, 1]), center: [3, 0.5], toward: [3, 0]";
    let region = Region::new(Ts::<RegionOptions>::new_unchecked(object(options))).unwrap();
    RiemannMap::solve(&region, Some(Ts::<RiemannOptions>::new_unchecked(object("tolerance: 1e-8")))).unwrap()
}

#[wasm_bindgen_test]
fn preparing_tells_how_far_it_is_and_can_be_cancelled() {
    let points = [0.3, 0.8, 3.2, 0.5, 9.0, 0.1, 15.5, 0.75];
    let images = |map: &RiemannMap| {
        let images = map.to_disk(&points).unwrap();
        let back = map.from_disk(&images).unwrap();
        [images, back]
    };
    let expected = images(&long_map());

    let map = long_map();
    let (listener, told) = going_on_for(u32::MAX);
    map.prepare(Some(listener)).unwrap();
    let total = told.length();
    assert!(total > 4, "{told:?}");
    for told in told.iter().map(|told| js_sys::Array::from(&told)) {
        assert!(told.get(0).is_string() && (0.0..=1.0).contains(&told.get(1).as_f64().unwrap()), "{told:?}");
    }
    let bytes = map.evaluator_bytes();
    assert_eq!(images(&map), expected);
    assert_eq!(map.evaluator_bytes(), bytes, "nothing is left to build");

    for calls in [0, 1, total / 2, total - 1] {
        let map = long_map();
        let (listener, told) = going_on_for(calls);
        let cancelled = map.prepare(Some(listener)).map_err(JsValue::from).unwrap_err();
        assert_eq!(property(&cancelled, "code"), "cancelled", "after {calls} of {total}");
        assert_eq!(told.length(), calls + 1, "cancelled means that no more is told");
        assert_eq!(images(&map), expected, "after {calls} of {total}");
        map.prepare(None).unwrap();
        assert_eq!(images(&map), expected, "prepared again after {calls} of {total}");
    }

    let throwing = function("() => { throw new RangeError('enough') }");
    let thrown = long_map().prepare(Some(throwing)).map_err(JsValue::from).unwrap_err();
    assert_eq!(property(&thrown, "name"), "RangeError");
}

#[wasm_bindgen_test]
fn wrong_options_are_refused() {
    for (options, option) in
        [("tolerance: 2", "tolerance"), ("maxUnknowns: 0.5", "maxUnknowns"), ("onProgress: 3", "onProgress")]
    {
        let thrown = solve(&object(options)).unwrap_err();
        let named = (property(&thrown, "code"), property(&thrown, "option"));
        assert_eq!(named, ("invalid-option".into(), option.into()), "{:?}", property(&thrown, "message"));
    }
}

#[wasm_bindgen_test]
fn both_ways_and_between_regions() {
    let map = solve(&object("tolerance: 1e-10")).unwrap();
    assert_eq!(map.evaluator_bytes(), 0);
    let points = [0.3, -0.8, -0.999_999, 0.5];
    let images = map.to_disk(&points).unwrap();
    let back = map.from_disk(&images).unwrap();
    assert!(back.iter().zip(points).all(|(a, b)| (a - b).abs() < 1e-8), "{back:?}");
    assert!(map.evaluator_bytes() > 0);
    assert!(map.from_disk(&[1.5, 0.0]).unwrap()[0].is_nan() && map.to_disk(&[1.0]).is_err());
    // |f'(center)| is the reciprocal of the conformal radius.
    let slope = map.derivative(&[0.0, 0.0]).unwrap();
    assert!((slope[0].hypot(slope[1]) * map.conformal_radius() - 1.0).abs() < 1e-9);

    let map: Joinable = JsValue::from(map).unchecked_into();
    let same = RegionMap::between(&map, &map, None).unwrap();
    let moved = same.forward(&points).unwrap();
    assert!(moved.iter().zip(points).all(|(a, b)| (a - b).abs() < 1e-8), "{moved:?}");
    assert_eq!(same.inverse(&points).unwrap().len(), 4);
    assert!((same.derivative(&[0.1, 0.2]).unwrap()[0] - 1.0).abs() < 1e-8);
}
