//! Riemann maps both ways, and maps between regions, as JavaScript sees them. Runs in Node.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::wasm::annulus::AnnulusMap;
use conformal_warp::wasm::canonical::Joinable;
use conformal_warp::wasm::region::{Region, RegionOptions};
use conformal_warp::wasm::region_map::{JoinOptions, RegionMap};
use conformal_warp::wasm::riemann::RiemannMap;
use conformal_warp::wasm::texture::Texture;
use conformal_warp::wasm::warp::DrawOptions;
use js_sys::Uint8Array;
use tsify::Ts;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

fn object(fields: &str) -> JsValue {
    js_sys::eval(&format!("({{ {fields} }})")).unwrap()
}

/// The map of a square around 0, its half side and its first corner given.
fn square(half: f64, toward: &str) -> RiemannMap {
    let h = half;
    let corners = format!("[{}, {}, {h}, {}, {h}, {h}, {}, {h}]", -h, -h, -h, -h);
    let fields = format!("boundary: new Float64Array({corners}), center: [0, 0], toward: {toward}");
    let region = Region::new(Ts::<RegionOptions>::new_unchecked(object(&fields))).unwrap();
    RiemannMap::solve(&region, None).unwrap()
}

/// As JavaScript passes it.
fn joinable(map: impl Into<JsValue>) -> Joinable {
    map.into().unchecked_into()
}

fn between(a: RiemannMap, b: RiemannMap) -> RegionMap {
    RegionMap::between(&joinable(a), &joinable(b), None).unwrap()
}

fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance, "{found:?} against {expected:?}");
    }
}

#[wasm_bindgen_test]
fn a_riemann_map_goes_both_ways() {
    let map = square(1.0, "[-1, -1]");
    let points = [0.5, -0.25, 0.999, 0.3, 1.0, 1.0, -1.0, 0.2];
    assert_close(&map.from_disk(&map.to_disk(&points).unwrap()).unwrap(), &points, 1e-7);
    assert!(map.from_disk(&[1.5, 0.0]).unwrap()[0].is_nan());
    let slope = map.derivative(&[0.0, 0.0]).unwrap();
    assert!((slope[0].hypot(slope[1]) - 1.0 / map.conformal_radius()).abs() < 1e-7, "{slope:?}");
    assert!(map.evaluator_bytes() > 0);
}

#[wasm_bindgen_test]
fn squares_are_mapped_by_turning_and_scaling() {
    let map = between(square(1.0, "[1, 1]"), square(2.0, "[-2, 2]"));
    let (points, images) = ([0.5, 0.25, 0.9, -0.9], [-0.5, 1.0, 1.8, 1.8]);
    assert_close(&map.forward(&points).unwrap(), &images, 1e-6);
    assert_close(&map.inverse(&images).unwrap(), &points, 1e-6);
    assert_close(&map.derivative(&points).unwrap(), &[0.0, 2.0, 0.0, 2.0], 1e-5);
}

/// The right half of the texture is red, the left half green: turned by a quarter, the upper half is red.
#[wasm_bindgen_test]
fn a_picture_follows_the_map() {
    let row = [[0, 255, 0, 255], [0, 255, 0, 255], [255, 0, 0, 255], [255, 0, 0, 255]].concat();
    let texture = Texture::new(&Uint8Array::from(&row.repeat(4)[..]), 4, 4, None).unwrap();
    let options =
        "texture: { center: [0, 0], width: 2, pixels: [4, 4] }, view: { center: [0, 0], width: 4, pixels: [16, 16] }";
    let options = Ts::<DrawOptions>::new_unchecked(object(options));
    let map = between(square(1.0, "[1, 1]"), square(2.0, "[-2, 2]"));
    let pixels = map.warp(&texture, options).map_err(JsValue::from).unwrap().to_vec();
    let at = |column: usize, row: usize| &pixels[4 * (16 * row + column)..][..4];
    assert_eq!((at(8, 3), at(8, 12)), (&[255, 0, 0, 255][..], &[0, 255, 0, 255][..]));

    let view =
        "texture: { center: [0, 0], width: 2, pixels: [4, 4] }, view: { center: [0, 0], width: 2, pixels: [16, 16] }";
    let disk = square(1.0, "[1, 0]").warp(&texture, Ts::<DrawOptions>::new_unchecked(object(view)));
    let disk = disk.map_err(JsValue::from).unwrap().to_vec();
    assert_eq!((&disk[..4], &disk[4 * (16 * 8 + 12)..][..4]), (&[0; 4][..], &[255, 0, 0, 255][..]));
}

fn frame(half: f64) -> AnnulusMap {
    let square = |h: f64| format!("new Float64Array([{0}, {0}, {h}, {0}, {h}, {h}, {0}, {h}])", -h);
    let fields = format!("boundary: {}, holes: [{}]", square(1.0), square(half));
    let region = Region::new(Ts::<RegionOptions>::new_unchecked(object(&fields))).unwrap();
    AnnulusMap::solve(&region, None).unwrap()
}

#[wasm_bindgen_test]
fn rings_are_joined_or_stretched() {
    let join = |options: Option<&str>| {
        let options = options.map(|fields| Ts::<JoinOptions>::new_unchecked(object(fields)));
        RegionMap::between(&joinable(frame(0.5)), &joinable(frame(0.25)), options).map_err(JsValue::from)
    };
    let code = |error: JsValue| js_sys::Reflect::get(&error, &"code".into()).unwrap().as_string().unwrap();
    assert_eq!(code(join(None).unwrap_err()), "different-moduli");
    let map = join(Some("stretch: true")).unwrap();
    assert!(!map.is_analytic());
    assert_close(&map.forward(&[0.5, 0.5, -1.0, 1.0]).unwrap(), &[0.25, 0.25, -1.0, 1.0], 1e-6);
    assert_close(&map.inverse(&[0.25, 0.25]).unwrap(), &[0.5, 0.5], 1e-6);
    let mixed = RegionMap::between(&joinable(frame(0.5)), &joinable(square(1.0, "[1, 1]")), None);
    assert_eq!(code(mixed.map_err(JsValue::from).unwrap_err()), "invalid-map");
    let same = RegionMap::between(&joinable(frame(0.5)), &joinable(frame(0.5)), None).unwrap();
    assert!(same.is_analytic());
    assert_close(&same.forward(&[0.7, 0.2]).unwrap(), &[0.7, 0.2], 1e-7);
}
