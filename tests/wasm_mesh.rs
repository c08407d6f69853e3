//! `JointTriangulation` as JavaScript sees it: made, proved, drawn, painted. Runs in Node.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::wasm::mesh::{JointTriangulation, SamplingOptions};
use conformal_warp::wasm::region::{Region, RegionOptions};
use conformal_warp::wasm::riemann::RiemannMap;
use conformal_warp::wasm::texture::Texture;
use conformal_warp::wasm::warp::{DrawOptions, PaintContext};
use js_sys::{Reflect, Uint8Array};
use tsify::Ts;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

const FRAMES: &str =
    "texture: { center: [0, 0], width: 4, pixels: [2, 2] }, view: { center: [0, 0], width: 2, pixels: [64, 64] }";

fn object(fields: &str) -> JsValue {
    js_sys::eval(&format!("({{ {fields} }})")).unwrap()
}

fn property(value: &JsValue, name: &str) -> JsValue {
    Reflect::get(value, &name.into()).unwrap()
}

fn square_map() -> RiemannMap {
    let options = "boundary: new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]), center: [0, 0], toward: [1, 0]";
    let region = Region::new(Ts::<RegionOptions>::new_unchecked(object(options))).unwrap();
    RiemannMap::solve(&region, None).unwrap()
}

fn mesh(options: &str) -> Result<JointTriangulation, JsValue> {
    JointTriangulation::region_to_disk(&square_map(), Ts::<SamplingOptions>::new_unchecked(object(options)))
        .map_err(JsValue::from)
}

/// Red everywhere.
fn red() -> Texture {
    Texture::new(&Uint8Array::from(&[255, 0, 0, 255].repeat(4)[..]), 2, 2, None).unwrap()
}

#[wasm_bindgen_test]
fn a_mesh_is_two_copies_of_its_nodes() {
    for options in ["spacing: 0.2", "maxErrorPixels: 0.5, frame: { center: [0, 0], width: 2, pixels: [100, 100] }"] {
        let mesh = mesh(options).unwrap();
        let (source, target, triangles) = (mesh.source(), mesh.target(), mesh.triangles());
        assert!(source.len() == target.len() && triangles.len() % 3 == 0 && triangles.len() > 30);
        assert!(triangles.iter().all(|&node| (node as usize) < source.len() / 2));
        assert!(target.chunks(2).all(|w| w[0].hypot(w[1]) < 1.0 + 1e-12));
        assert_eq!(mesh.flipped(), 0);
        mesh.validate().unwrap();
        let evidence = mesh.evidence().unwrap().js_value();
        assert!(property(&evidence, "largestError").as_f64().unwrap() > 0.0);
        assert_eq!(property(&evidence, "stop").as_string().unwrap(), "density");

        let copy = JointTriangulation::from_parts(&source, &target, &triangles, Some(mesh.magnification())).unwrap();
        assert_eq!(copy.triangles(), triangles);
        assert_eq!(copy.magnification(), mesh.magnification());
    }
}

/// A progress function that goes on for so many calls, and the list of what it was told.
fn going_on_for(calls: u32) -> (JsValue, js_sys::Array) {
    let told = js_sys::Array::new();
    let text = format!("(told => (stage, fraction) => told.push([stage, fraction]) <= {calls})");
    let make = js_sys::eval(&text).unwrap().unchecked_into::<js_sys::Function>();
    (make.call1(&JsValue::UNDEFINED, &told).unwrap(), told)
}

#[wasm_bindgen_test]
fn meshing_tells_how_far_it_is_and_can_be_cancelled() {
    let maps = [square_map(), square_map()];
    let failure =
        |made: Result<JointTriangulation, JsValue>| made.map_or_else(|e| property(&e, "code"), |_| "none".into());
    let make = |kind, options| {
        let options = Ts::<SamplingOptions>::new_unchecked(options);
        if kind == "to a region" {
            JointTriangulation::region_to_region(&maps[0], &maps[1], options)
        } else {
            JointTriangulation::region_to_disk(&maps[0], options)
        }
    };
    for kind in ["to the disk", "to a region"] {
        let ask = |calls| {
            let (function, told) = going_on_for(calls);
            let options = object("maxErrorPixels: 0.5, frame: { center: [0, 0], width: 2, pixels: [100, 100] }");
            Reflect::set(&options, &"onProgress".into(), &function).unwrap();
            (make(kind, options).map_err(JsValue::from), told)
        };
        // The first time, the maps' evaluators are built too.
        assert_eq!(failure(ask(1).0), "cancelled", "{kind}, building evaluators");
        ask(u32::MAX).0.unwrap();
        let (mesh, told) = ask(u32::MAX);
        let mesh = mesh.unwrap();
        assert!(told.length() > 1, "{kind}: {told:?}");
        for told in told.iter().map(|told| js_sys::Array::from(&told)) {
            assert!(told.get(0).is_string() && (0.0..=1.0).contains(&told.get(1).as_f64().unwrap()), "{told:?}");
        }
        for calls in [0, 1, told.length() / 2, told.length() - 1] {
            let (cancelled, heard) = ask(calls);
            assert_eq!(failure(cancelled), "cancelled", "{kind}, after {calls}");
            assert_eq!(heard.length(), calls + 1, "{kind}: cancelled means that no more is told");
            // The maps are as good as before.
            let again = ask(u32::MAX).0.unwrap();
            assert_eq!((again.source(), again.target()), (mesh.source(), mesh.target()), "{kind}, after {calls}");
        }
    }
}

#[wasm_bindgen_test]
fn its_arrays_must_fit() {
    let code = |source: &[f64], triangles: &[u32]| {
        let failure =
            JointTriangulation::from_parts(source, &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0], triangles, None).unwrap_err();
        property(&failure.into(), "code").as_string().unwrap()
    };
    assert_eq!(code(&[0.0; 5], &[0, 1, 2]), "wrong-length");
    assert_eq!(code(&[0.0; 6], &[0, 1]), "wrong-length");
    assert_eq!(code(&[0.0, 0.0, 0.0, 1.0, 1.0, 0.0], &[0, 1, 2]), "invalid-mesh");
    assert_eq!(code(&[0.0, 0.0, 1.0, 0.0, 0.0, 1.0], &[0, 1, 3]), "invalid-mesh");
}

#[wasm_bindgen_test]
fn one_kind_of_density_is_needed() {
    for options in
        ["", "maxErrorPixels: 1", "spacing: 0.1, frame: { center: [0, 0], width: 2, pixels: [9, 9] }", "spacing: -1"]
    {
        assert_eq!(property(&mesh(options).unwrap_err(), "code"), "invalid-option", "{options}");
    }
}

/// Pushed forward unless told otherwise: the disk is covered, the corners of its square are not.
#[wasm_bindgen_test]
fn it_draws_the_source_in_the_target() {
    let mesh = mesh("spacing: 0.1").unwrap();
    let draw = |more: &str| {
        let options = Ts::<DrawOptions>::new_unchecked(object(&format!("{FRAMES} {more}")));
        mesh.warp(&red(), options).map_err(JsValue::from).unwrap().to_vec()
    };
    let pixels = draw("");
    assert_eq!(pixels.len(), 4 * 64 * 64);
    assert_eq!(pixels[..4], [0; 4]);
    let middle = 4 * (32 * 64 + 32);
    assert_eq!(pixels[middle..middle + 4], [255, 0, 0, 255]);
    assert_eq!(draw(", rows: [16, 40]"), pixels[4 * 64 * 16..4 * 64 * 40]);
    // Pulled back, the square is covered: its corner too.
    assert_eq!(draw(", direction: 'pull-back'")[..4], [255, 0, 0, 255]);
}

#[wasm_bindgen_test]
fn it_paints_on_a_context() {
    let canvas = "globalThis.ImageData = class { constructor(data, width, height) { Object.assign(this, { data, width, height }) } };
        ({ painted: [], putImageData(image, x, y) { this.painted.push([image.width, image.height, x, y, ...image.data.slice(0, 4)]) } })";
    let context = js_sys::eval(canvas).unwrap();
    let mesh = mesh("spacing: 0.1").unwrap();
    let options = Ts::<DrawOptions>::new_unchecked(object(&format!("{FRAMES}, rows: [8, 24], direction: 'pull-back'")));
    mesh.paint(context.unchecked_ref::<PaintContext>(), &red(), options).map_err(JsValue::from).unwrap();
    let painted = js_sys::Array::from(&js_sys::Array::from(&property(&context, "painted")).get(0));
    let numbers: Vec<_> = painted.iter().map(|x| x.as_f64().unwrap()).collect();
    assert_eq!(numbers, [64.0, 16.0, 0.0, 8.0, 255.0, 0.0, 0.0, 255.0]);
}
