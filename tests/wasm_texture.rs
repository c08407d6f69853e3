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

/// What a warp with these options throws: the option's path and the message.
fn refusal(options: &JsValue) -> (String, String) {
    let thrown = identity(options).unwrap_err();
    assert_eq!(property(&thrown, "code"), "invalid-option");
    (property(&thrown, "option"), property(&thrown, "message"))
}

#[wasm_bindgen_test]
fn what_is_wrong_inside_is_named_by_its_path() {
    let texture = "texture: { center: [0, 0], width: 2, pixels: [2, 2] }";
    let cases = [
        ("view: { center: [0, 0], pixels: [4, 4] }", "view.width", "The option \"view.width\" is missing."),
        (
            "view: { center: [0, 0], width: 'a', pixels: [4, 4] }",
            "view.width",
            "The option \"view.width\" cannot be used: invalid type: string \"a\", expected a number.",
        ),
        (
            "view: { center: [0, 0], width: 2, pixels: [4, 0.5] }",
            "view.pixels",
            "The option \"view.pixels\" cannot be used: expected two whole numbers [columns, rows].",
        ),
        (
            "view: { center: [0, 0], width: 2, pixels: [4, 4], heigth: 2 }",
            "view.heigth",
            "There is no option \"view.heigth\"; there are center, width, pixels.",
        ),
        (
            "view: { center: [0, 0], width: 2, pixels: [4, 4] }, rows: [0, 1.5]",
            "rows[1]",
            "The option \"rows[1]\" cannot be used: invalid type: number `1.5`, expected a whole number, 0 or more.",
        ),
        (
            "view: { center: [0, 0], width: 2, pixels: [4, 4] }, rows: [0, 1, 2]",
            "rows",
            "The option \"rows\" cannot be used: invalid length 3, expected an array of length 2.",
        ),
        (
            "view: { center: [0, 0], width: 2, pixels: [4, 4] }, quality: 'fine'",
            "quality",
            "The option \"quality\" cannot be used: unknown variant `fine`, expected one of `nearest`, `bilinear`, `trilinear`, `best`.",
        ),
        (
            "view: 5",
            "view",
            "The option \"view\" cannot be used: expected an object with keys of center, width, pixels.",
        ),
    ];
    for (more, path, message) in cases {
        assert_eq!(refusal(&object(&format!("{texture}, {more}"))), (path.to_string(), message.to_string()));
    }
}

#[wasm_bindgen_test]
fn options_are_an_objects_own_keys_each_read_once() {
    let reads = js_sys::eval("globalThis.reads = []").unwrap();
    let counted = format!("get quality() {{ reads.push('quality'); return 'nearest'; }}, {FRAMES}");
    assert!(identity(&object(&counted)).is_ok());
    assert_eq!(js_sys::Array::from(&reads).length(), 1);

    let thrown =
        identity(&object(&format!("{FRAMES}, get rows() {{ throw new RangeError('not today'); }}"))).unwrap_err();
    assert_eq!(property(&thrown, "name"), "RangeError");

    // Neither belongs to the object's own names.
    assert!(identity(&object(&format!("{FRAMES}, __proto__: {{ oops: 1 }}, [Symbol('oops')]: 1"))).is_ok());
}
