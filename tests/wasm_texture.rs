//! `Texture` and the options of `warp` as JavaScript sees them. Runs in Node.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::wasm::texture::{Texture, TextureOptions};
use conformal_warp::wasm::warp::{DrawOptions, warp};
use conformal_warp::{Complex64, Direction, TriangleMesh};
use js_sys::{Reflect, Uint8Array, Uint8ClampedArray};
use tsify::Ts;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

const FRAMES: &str =
    "texture: { center: [0, 0], width: 2, pixels: [2, 2] }, view: { center: [0, 0], width: 2, pixels: [4, 4] }";

fn object(fields: &str) -> JsValue {
    js_sys::eval(&format!("({{ {fields} }})")).unwrap()
}

/// Red over green, wrapped as the options say.
fn texture(options: &str) -> Result<Texture, JsValue> {
    let rgba = [[255, 0, 0, 255], [255, 0, 0, 255], [0, 255, 0, 255], [0, 255, 0, 255]].concat();
    let options = Ts::<TextureOptions>::new_unchecked(object(options));
    Texture::new(&Uint8Array::from(&rgba[..]), 2, 2, Some(options)).map_err(JsValue::from)
}

/// The texture through the identity of the square [−1, 1]².
fn identity(options: &JsValue) -> Result<Uint8ClampedArray, JsValue> {
    let nodes = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
    let mesh = TriangleMesh { source: &nodes, target: &nodes, triangles: &[[0, 1, 2], [0, 2, 3]], stretch: None };
    let options = Ts::<DrawOptions>::new_unchecked(options.clone());
    warp(&mesh, Direction::PushForward, &texture("wrap: 'clamp'").unwrap(), &options).map_err(JsValue::from)
}

fn property(thrown: &JsValue, name: &str) -> String {
    Reflect::get(thrown, &name.into()).unwrap().as_string().unwrap_or_default()
}

#[wasm_bindgen_test]
fn a_warp_returns_bytes_or_fills_out() {
    let pixels = identity(&object(&format!("{FRAMES}, quality: 'nearest'"))).unwrap().to_vec();
    assert_eq!(pixels[..4], [255, 0, 0, 255]);
    assert_eq!(pixels[60..], [0, 255, 0, 255]);

    let options = object(&format!("{FRAMES}, quality: 'nearest', rows: [1, 3], out: new Uint8ClampedArray(32)"));
    let filled = identity(&options).unwrap();
    let out: Uint8ClampedArray = Reflect::get(&options, &"out".into()).unwrap().unchecked_into();
    assert!(js_sys::Object::is(&filled, &out), "the array that was given comes back");
    assert_eq!(out.to_vec(), pixels[16..48]);
}

#[wasm_bindgen_test]
fn wrong_options_are_named() {
    let cases = [
        (format!("{FRAMES}, quality: 'superb'"), "invalid-option"),
        (format!("{FRAMES}, direction: 'sideways'"), "invalid-option"),
        (format!("{FRAMES}, rows: [3, 9]"), "invalid-rows"),
        (format!("{FRAMES}, out: new Uint8ClampedArray(3)"), "wrong-length"),
        (format!("{FRAMES}, out: [1, 2]"), "invalid-option"),
        (FRAMES.replace("width: 2", "width: 0"), "invalid-frame"),
    ];
    for (options, code) in cases {
        let thrown = identity(&object(&options)).unwrap_err();
        assert_eq!(property(&thrown, "code"), code, "{options}: {}", property(&thrown, "message"));
    }
    assert_eq!(property(&texture("wrap: 'around'").unwrap_err(), "code"), "invalid-option");
}
