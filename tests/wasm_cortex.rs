//! `RetinoCorticalMap` as JavaScript sees it. Runs in Node.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::wasm::cortex::{
    CorticalModelOptions, GazeOptions, LandmarkOptions, RecoverOptions, RetinoCorticalMap,
};
use conformal_warp::wasm::foveated::{FoveatedOptions, FoveatedTexture};
use conformal_warp::wasm::region::{OutlineOptions, Region, RegionOptions};
use conformal_warp::wasm::riemann::{RiemannMap, RiemannOptions};
use conformal_warp::wasm::texture::{Texture, TextureOptions};
use conformal_warp::wasm::warp::DrawOptions;
use js_sys::{Reflect, Uint8Array};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

fn object<T: Tsify>(fields: &str) -> Ts<T> {
    Ts::new_unchecked(js_sys::eval(&format!("({{ {fields} }})")).unwrap())
}

fn model(fields: &str) -> Result<RetinoCorticalMap, JsValue> {
    RetinoCorticalMap::model(object::<CorticalModelOptions>(fields)).map_err(JsValue::from)
}

#[wasm_bindgen_test]
fn models_map_both_ways() {
    let map = model("k: 15, a: 0.69, b: 80, hemisphere: 'right'").unwrap();
    let cortex = map.to_cortex(&[-10.0, 3.0, 10.0, 3.0]).unwrap();
    assert!(cortex[0] < -30.0 && cortex[1] > 0.0 && cortex[2].is_nan());
    let field = map.to_field(&cortex[..2]).unwrap();
    assert!((field[0] + 10.0).abs() < 1e-12 && (field[1] - 3.0).abs() < 1e-12, "{field:?}");
    let expected = 15.0 / 10.69 - 15.0 / 90.0;
    assert!((map.magnification(&[-10.0, 0.0]).unwrap()[0] - expected).abs() < 1e-12);
    let code = |fields: &str| Reflect::get(&model(fields).unwrap_err(), &"code".into()).unwrap();
    assert_eq!((code("k: 15, a: 80, b: 1"), code("k: 15")), ("invalid-map".into(), "invalid-option".into()));
    assert!(model("k: 1, a: 0.8, extent: 60, area: 1000, shear: 0.9").is_ok());
}

#[wasm_bindgen_test]
fn a_picture_is_warped_onto_the_cortex() {
    let map = model("k: 15, a: 0.69, b: 80").unwrap();
    let frame = "{ center: [0, 0], width: 2, pixels: [8, 8] }";
    let gaze = object::<GazeOptions>(&format!("picture: {frame}, fieldOfView: 60, fixation: [0, 0]"));
    let image = map.seeing(gaze).unwrap();
    let mut texture =
        Texture::new(&Uint8Array::from(&[90, 120, 150, 255].repeat(64)[..]), 8, 8, None::<Ts<TextureOptions>>).unwrap();
    let view = "{ center: [30, 0], width: 90, pixels: [90, 90] }";
    let options = object::<DrawOptions>(&format!("texture: {frame}, view: {view}"));
    let rgba = image.warp(&texture, options).unwrap().to_vec();
    // 30° to the right the picture ends; the fovea lies at 0.
    let at = |x: usize| rgba[4 * (45 * 90 + x) + 3];
    assert_eq!((at(5), at(20), at(60), at(85)), (0, 255, 255, 0));
    let foveated = object::<FoveatedOptions>(&format!("picture: {frame}, fixation: [0, 0], side: 16"));
    let foveated = FoveatedTexture::new(&Uint8Array::from(&[90, 120, 150, 255].repeat(64)[..]), foveated).unwrap();
    let options = object::<DrawOptions>(&format!("texture: {frame}, view: {view}"));
    let again = image.warp_foveated(&foveated, options).unwrap().to_vec();
    assert_eq!((foveated.levels(), again[4 * (45 * 90 + 20)]), (1, 90));

    let options = object::<DrawOptions>(&format!("texture: {frame}, view: {view}"));
    let mut prepared = image.prepare_warp(&texture, options).unwrap();
    assert!(prepared.warp(&texture, None).unwrap().to_vec() == rgba);
    texture.replace(&Uint8Array::from(&[200, 10, 10, 255].repeat(64)[..])).unwrap();
    let out = js_sys::Uint8ClampedArray::new_with_length(4 * 90 * 90);
    let filled = prepared.warp(&texture, Some(out.clone())).unwrap();
    assert!(js_sys::Object::is(&filled, &out) && out.get_index(4 * (45 * 90 + 20)) == 200);
    let short = prepared.warp(&texture, Some(js_sys::Uint8ClampedArray::new_with_length(4))).unwrap_err();
    assert_eq!(Reflect::get(&JsValue::from(short), &"code".into()).unwrap(), "wrong-length");
    let options = object::<DrawOptions>(&format!("texture: {frame}, view: {view}"));
    let mut prepared = image.prepare_foveated(&foveated, options).unwrap();
    assert!(prepared.warp_foveated(&foveated, None).unwrap().to_vec() == again);

    let seen = image.to_picture(&map.to_cortex(&[30.0, 0.0]).unwrap()).unwrap();
    assert!((seen[0] - 1.0).abs() < 1e-12 && seen[1].abs() < 1e-12, "{seen:?}");
}

#[wasm_bindgen_test]
fn an_outline_is_mapped_from_its_landmark() {
    let dipole = "k: 15, a: 0.69, b: 80";
    let boundary = RetinoCorticalMap::model_outline(object(dipole), 90).unwrap();
    assert_eq!(boundary.len(), 180);
    let place = model(dipole).unwrap().to_cortex(&[15.0, -1.5]).unwrap();
    let boundary: Vec<String> = boundary.iter().map(f64::to_string).collect();
    let fields = format!(
        "boundary: new Float64Array([{}]), center: [{}, {}], toward: [0, 0]",
        boundary.join(","),
        place[0],
        place[1]
    );
    let region = Region::new(object::<RegionOptions>(&fields)).unwrap();
    let solved = RiemannMap::solve(&region, None::<Ts<RiemannOptions>>).unwrap();
    for (hemisphere, side) in [("left", 1.0), ("right", -1.0)] {
        let options = object::<LandmarkOptions>(&format!("direction: 0.1, hemisphere: '{hemisphere}'"));
        let map = RetinoCorticalMap::outline(&solved, options).unwrap();
        let found = map.to_cortex(&[side * 15.0, -1.5]).unwrap();
        let missed = map.landmark_error().unwrap();
        assert!(missed.get(0).as_f64().unwrap() < 1e-6 && missed.get(1).as_f64().unwrap() < 1e-6);
        assert!((map.area() / 2253.0 - 1.0).abs() < 0.01 && map.boundary().len() == 180, "{} mm²", map.area());
        assert!((found[0] - side * place[0]).abs() < 1e-3 && (found[1] - place[1]).abs() < 1e-3, "{found:?} {place:?}");
        let back = map.to_field(&found).unwrap();
        assert!((back[0] - side * 15.0).abs() < 1e-6 && (back[1] + 1.5).abs() < 1e-6, "{back:?}");
        let beyond = map.to_cortex(&[side * 15.01, -1.5]).unwrap();
        let direction = (beyond[1] - found[1]).atan2(side * (beyond[0] - found[0]));
        assert!((direction - 0.1).abs() < 0.01, "the meridian runs at {direction}");
    }
}

#[wasm_bindgen_test]
fn halves_recover_a_picture_together() {
    let frame = "{ center: [0, 0], width: 2, pixels: [20, 20] }";
    let texture =
        Texture::new(&Uint8Array::from(&[90, 120, 150, 255].repeat(400)[..]), 20, 20, None::<Ts<TextureOptions>>)
            .unwrap();
    let mut sum = None;
    for hemisphere in ["left", "right"] {
        let map = model(&format!("k: 15, a: 0.69, b: 80, hemisphere: '{hemisphere}'")).unwrap();
        let gaze = object::<GazeOptions>(&format!("picture: {frame}, fieldOfView: 60, fixation: [0.3, 0]"));
        let dots = map.frame(2.0).unwrap().js_value();
        let options: js_sys::Object = js_sys::eval(&format!("({{ texture: {frame}, view: {frame} }})")).unwrap().into();
        Reflect::set(&options, &"cortex".into(), &dots).unwrap();
        if let Some(sum) = sum {
            Reflect::set(&options, &"out".into(), &sum).unwrap();
        }
        let half =
            map.seeing(gaze).unwrap().recover(&texture, Ts::<RecoverOptions>::new_unchecked(options.into())).unwrap();
        sum = Some(JsValue::from(half));
    }
    let sum = js_sys::Uint8ClampedArray::from(sum.unwrap()).to_vec();
    // At its edges, which the periphery sees, the picture fades.
    let row: Vec<&[u8]> = (1..18).map(|x| &sum[4 * (10 * 20 + x)..][..4]).collect();
    assert!(row.iter().all(|pixel| pixel[..3] == [90, 120, 150] && pixel[3] >= 253), "{row:?}");
    assert!(model("k: 15, a: 0.69").unwrap().frame(f64::NAN).is_err());
}

#[wasm_bindgen_test]
fn outlines_are_read_from_text() {
    let read = |text: &str, fields: &str| Region::parse_outline(text, Some(object::<OutlineOptions>(fields)));
    assert_eq!(read("[[0, 0], [1, 0], [0, 2]]", "scale: 2").unwrap(), [0.0, 0.0, 2.0, 0.0, 0.0, 4.0]);
    assert_eq!(read("M0 0h1v-2z", "").unwrap(), [0.0, 0.0, 1.0, 0.0, 1.0, 2.0]);
    let refused = JsValue::from(read("M0 0h", "tolerance: 0.1").unwrap_err());
    assert_eq!(Reflect::get(&refused, &"code".into()).unwrap(), "invalid-outline");
}

#[wasm_bindgen_test]
fn crops_of_a_large_picture_are_put_together() {
    // A hundred megapixels, of which no pixel is held.
    let options = "picture: { center: [0, 0], width: 3, pixels: [12000, 8400] }, fixation: [0.4, 0.3], side: 64";
    let crops = FoveatedTexture::crops(object::<FoveatedOptions>(options)).unwrap();
    assert_eq!(crops.len(), 9);
    let level = |shade: u8| {
        Texture::new(&Uint8Array::from(&[shade, 0, 0, 255].repeat(64 * 64)[..]), 64, 64, None::<Ts<TextureOptions>>)
            .unwrap()
    };
    let frame = |crop: &Ts<_>| Ts::new_unchecked(crop.js_value());
    let mut stack = FoveatedTexture::of(&level(10), frame(&crops[0])).unwrap();
    for (k, crop) in crops.iter().enumerate().skip(1) {
        stack.add(&level(10 + 20 * k as u8), frame(crop)).unwrap();
    }
    assert!(stack.levels() == 9 && stack.bytes() < 9 * 64 * 64 * 11, "{} bytes", stack.bytes());
    // Around the gaze the finest is seen, and far away the widest.
    let map = model("k: 15, a: 0.69, b: 80").unwrap();
    let gaze = "picture: { center: [0, 0], width: 3, pixels: [12000, 8400] }, fieldOfView: 100, fixation: [0.4, 0.3]";
    let image = map.seeing(object::<GazeOptions>(gaze)).unwrap();
    let view = "{ center: [0.8, 0], width: 0.4, pixels: [3, 1] }";
    let draw = |view: &str| {
        let options = object::<DrawOptions>(&format!("texture: {view}, view: {view}"));
        image.warp_foveated(&stack, options).unwrap().to_vec()
    };
    assert_eq!(draw(view)[4..8], [170, 0, 0, 255]);
    assert_eq!(draw("{ center: [53.3, 0], width: 0.3, pixels: [3, 1] }")[4..8], [10, 0, 0, 255]);
}
