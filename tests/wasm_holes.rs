//! Regions with holes as JavaScript sees them. Runs in Node.
#![cfg(target_arch = "wasm32")]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::wasm::annulus::AnnulusMap;
use conformal_warp::wasm::circles::CircleMap;
use conformal_warp::wasm::electrostatics::{ConductorOptions, Electrostatics};
use conformal_warp::wasm::exterior::{BodyOptions, ExteriorMap};
use conformal_warp::wasm::flow::{FlowOptions, PotentialFlow};
use conformal_warp::wasm::half_plane::{HalfPlaneMap, HalfPlaneOptions};
use conformal_warp::wasm::rectangle::{RectangleMap, RectangleOptions};
use conformal_warp::wasm::region::{ExteriorOptions, Region, RegionOptions};
use conformal_warp::wasm::riemann::{RiemannMap, RiemannOptions};
use conformal_warp::wasm::slits::{SlitMap, SlitOptions};
use conformal_warp::wasm::strip::{StripMap, StripOptions};
use js_sys::Reflect;
use tsify::Ts;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

fn object(fields: &str) -> JsValue {
    js_sys::eval(&format!("({{ {fields} }})")).unwrap()
}

fn region(fields: &str) -> Result<Region, JsValue> {
    Region::new(Ts::<RegionOptions>::new_unchecked(object(fields))).map_err(JsValue::from)
}

fn exterior(fields: &str) -> Region {
    Region::exterior(Ts::<ExteriorOptions>::new_unchecked(object(fields))).unwrap()
}

fn code(error: &JsValue) -> String {
    Reflect::get(error, &"code".into()).unwrap().as_string().unwrap()
}

fn fine() -> Option<Ts<RiemannOptions>> {
    Some(Ts::<RiemannOptions>::new_unchecked(object("tolerance: 1e-12")))
}

const FRAME: &str = "boundary: new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]), holes: [new Float64Array([-0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5])]";

#[wasm_bindgen_test]
fn a_region_knows_its_holes() {
    let frame = region(FRAME).unwrap();
    assert_eq!(frame.contains(&[0.75, 0.0, 0.0, 0.0, 0.5, 0.0, 2.0, 0.0]).unwrap(), [1, 0, 1, 0]);
    let hole: js_sys::Float64Array = frame.holes().get(0).dyn_into().unwrap();
    assert_eq!(hole.to_vec(), [-0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5]);
    let thrown =
        region("boundary: new Float64Array([0, 0, 1, 0, 0, 1]), holes: [new Float64Array([2, 2, 3, 2, 2, 3])]");
    assert_eq!(code(&thrown.unwrap_err()), "hole-outside");
    let thrown =
        region("boundary: new Float64Array([0, 0, 1, 0, 0, 1]), holes: [new Float64Array([0.1, 0.1, 3, 2, 2, 3])]");
    assert_eq!(code(&thrown.unwrap_err()), "holes-meet");
    assert_eq!(
        code(&region("boundary: new Float64Array([0, 0, 1, 0, 0, 1]), holes: [3]").unwrap_err()),
        "invalid-option"
    );
    assert_eq!(code(&JsValue::from(RiemannMap::solve(&frame, None).unwrap_err())), "wrong-region");
}

/// The numbers of a path.
fn numbers(path: &str) -> Vec<f64> {
    path.split(|c: char| c.is_ascii_alphabetic() && c != 'e' || c == ' ').filter_map(|text| text.parse().ok()).collect()
}

#[wasm_bindgen_test]
fn holes_may_be_paths_and_edges() {
    let outer = "M2 0 A2 2 0 0 1 -2 0 A2 2 0 0 1 2 0 Z";
    let inner = "M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z";
    let arc = "{ arc: { center: [0, 0], radii: [1, 1], start: 0, sweep: 2 * Math.PI } }";
    let given = [
        format!("path: '{outer} {inner}'"),
        format!("path: '{outer}', holes: ['{inner}']"),
        format!("path: '{outer}', holes: [[{arc}]]"),
    ];
    for fields in given {
        let ring = region(&fields).unwrap();
        assert_eq!(ring.contains(&[1.0, 0.0, 0.9, 0.1, 1.5, 1.0, 2.1, 0.0]).unwrap(), [1, 0, 1, 0]);
        // A path says arcs by their ends: their middles are found again up to rounding.
        let again = region(&format!("path: '{}'", ring.path().unwrap())).unwrap();
        let (first, second) = (numbers(&ring.path().unwrap()), numbers(&again.path().unwrap()));
        assert_eq!(first.len(), second.len());
        assert!(first.iter().zip(&second).all(|(a, b)| (a - b).abs() < 4e-15), "{first:?} {second:?}");
        let map = AnnulusMap::solve(&ring, fine()).unwrap();
        assert!((map.inner_radius() - 0.5).abs() < 1e-12, "{fields}: {}", map.inner_radius());
    }
    let mixed = region(&format!("path: '{outer}', holes: [new Float64Array([0, 0, 1, 0, 0, 1])]")).unwrap();
    assert!(AnnulusMap::solve(&mixed, fine()).unwrap().error_estimate() < 1e-11);
    let outside = exterior(&format!("holes: ['{inner}']"));
    assert_eq!(outside.contains(&[2.0, 0.0, 0.5, 0.0]).unwrap(), [1, 0]);
    assert_eq!(
        code(&region(&format!("path: '{outer}', holes: ['{inner}'], curve: 'smooth'")).unwrap_err()),
        "invalid-option"
    );
    assert_eq!(code(&region(&format!("path: '{outer}', holes: ['M5 5 L6 5 L6 6 Z']")).unwrap_err()), "hole-outside");
    assert_eq!(code(&region(&format!("path: '{outer}', holes: ['M5']")).unwrap_err()), "invalid-outline");
}

#[wasm_bindgen_test]
fn a_frame_goes_to_a_ring_and_back() {
    let map = AnnulusMap::solve(&region(FRAME).unwrap(), fine()).unwrap();
    assert!((map.inner_radius() - 0.541_210_760_957_991).abs() < 1e-12, "{}", map.inner_radius());
    assert!((map.modulus() - 1.847_709_011_236_05).abs() < 1e-12);
    assert!((map.capacity() - 10.234_092_569_368_05).abs() < 1e-11);
    assert!(map.error_estimate() <= 1e-12 && map.residual() < 1e-12 && map.unknowns() > 100);
    assert_eq!(map.stop(), "tolerance");
    let images = map.to_annulus(&[-1.0, -1.0, 0.7, 0.1, 0.0, 0.0]).unwrap();
    assert!((images[0] - 1.0).abs() < 1e-12 && images[1].abs() < 1e-12 && images[4].is_nan(), "{images:?}");
    let back = map.from_annulus(&images[2..4]).unwrap();
    assert!((back[0] - 0.7).abs() < 1e-10 && (back[1] - 0.1).abs() < 1e-10, "{back:?}");
}

#[wasm_bindgen_test]
fn quadrilaterals_strips_and_half_planes() {
    let rectangle = "boundary: new Float64Array([0, 0, 2, 0, 2, 1, 0, 1]), center: [1, 0.5], toward: [2, 0.5]";
    let rectangle = region(rectangle).unwrap();
    let corners = |text: &str| Ts::<RectangleOptions>::new_unchecked(object(&format!("corners: {text}")));
    let map = RectangleMap::solve(&rectangle, corners("[[0, 0], [2, 0], [2, 1], [0, 1]]"), fine()).unwrap();
    assert!((map.aspect() - 2.0).abs() < 1e-12, "{}", map.aspect());
    let there = map.to_rectangle(&[0.3, 0.8, 3.0, 0.0]).unwrap();
    assert!((there[0] - 0.3).abs() < 1e-11 && (there[1] - 0.8).abs() < 1e-11 && there[2].is_nan(), "{there:?}");
    let wrong = RectangleMap::solve(&rectangle, corners("[[0, 0], [0, 1], [2, 1], [2, 0]]"), None);
    assert_eq!(code(&JsValue::from(wrong.err().unwrap())), "invalid-map");
    let wrong = RectangleMap::solve(&rectangle, corners("[[0, 0], [0, 1], [2, 1]]"), None);
    assert_eq!(code(&JsValue::from(wrong.err().unwrap())), "invalid-option");

    let ends = Ts::<StripOptions>::new_unchecked(object("ends: [[0, 0.5], [2, 0.5]]"));
    let map = StripMap::solve(&rectangle, ends, fine()).unwrap();
    let there = map.to_strip(&[1.0, 0.5, 1.0, 0.0]).unwrap();
    assert!(there.iter().zip([0.0, 0.5, 0.0, 0.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{there:?}");
    let pole = Ts::<HalfPlaneOptions>::new_unchecked(object("pole: [2, 0.5]"));
    let map = HalfPlaneMap::solve(&rectangle, pole, fine()).unwrap();
    let back = map.from_half_plane(&[0.0, 1.0, 0.0, 0.0]).unwrap();
    assert!(back.iter().zip([1.0, 0.5, 0.0, 0.5]).all(|(a, b)| (a - b).abs() < 1e-11), "{back:?}");
}

#[wasm_bindgen_test]
fn slits_fields_and_flows() {
    let frame = region(&format!("{FRAME}, center: [0.75, 0], toward: [1, 0]")).unwrap();
    let kind = Ts::<SlitOptions>::new_unchecked(object("kind: 'disk'"));
    let slits = SlitMap::solve(&frame, kind, fine()).unwrap();
    assert!(
        slits
            .to_slits(&[0.75, 0.0, 1.0, 0.0])
            .unwrap()
            .iter()
            .zip([0.0, 0.0, 1.0, 0.0])
            .all(|(a, b)| (a - b).abs() < 1e-12)
    );
    let ends = slits.slits();
    assert!((ends[0].hypot(ends[1]) - ends[2].hypot(ends[3])).abs() < 1e-12);
    let pole = Ts::<SlitOptions>::new_unchecked(object("kind: 'radial'"));
    assert_eq!(code(&JsValue::from(SlitMap::solve(&frame, pole, None).err().unwrap())), "invalid-option");

    // A hole across the center stays there, and the map is the same both ways.
    let centered = region("boundary: new Float64Array([-1, -1, 1, -1, 1, 1, -1, 1]), holes: [new Float64Array([0.3, -0.2, 0.7, -0.2, 0.7, 0.2, 0.3, 0.2])], center: [-0.4, 0], toward: [-1, 0]").unwrap();
    let round = CircleMap::solve(&centered, None).unwrap();
    let (centers, radii) = (round.centers(), round.radii());
    assert!(centers.len() == 2 && radii.len() == 1 && radii[0] > 0.1 && centers[0] < -0.2 && centers[1].abs() < 1e-7);
    let on_hole = round.to_circles(&[0.3, 0.1]).unwrap();
    assert!(((on_hole[0] - centers[0]).hypot(on_hole[1] - centers[1]) - radii[0]).abs() < 1e-7);
    let back = round.from_circles(&round.to_circles(&[0.1, 0.4]).unwrap()).unwrap();
    assert!((back[0] - 0.1).hypot(back[1] - 0.4) < 1e-6);

    let given = Ts::<ConductorOptions>::new_unchecked(object("potentials: [0, 1]"));
    let field = Electrostatics::solve(&frame, given, fine()).unwrap();
    assert!((field.impedance().unwrap() - 36.811_306_020_4).abs() < 1e-9);
    assert!((field.potential(&[0.5, 0.2]).unwrap()[0] - 1.0).abs() < 1e-12);

    let square = "new Float64Array([0, 0, 1, 0, 1, 1, 0, 1])";
    let body = Ts::<BodyOptions>::new_unchecked(object(&format!("boundary: {square}")));
    assert!((ExteriorMap::solve(body, fine()).unwrap().capacity() - 0.590_170_299_508_048_1).abs() < 1e-12);
    // A disk of radius 2 has the capacity 2; splines through some of its points leave it by little.
    let points =
        "Float64Array.from({ length: 128 }, (_, k) => 2 * (k % 2 ? Math.sin : Math.cos)(Math.PI / 32 * (k >> 1)))";
    for (given, tolerance) in [
        ("path: 'M2 0A2 2 0 0 1 -2 0A2 2 0 0 1 2 0Z'", 1e-12),
        ("edges: [{ arc: { center: [0, 0], radii: [2, 2], start: 0, sweep: 2 * Math.PI } }]", 1e-12),
        (&format!("through: {points}"), 1e-5),
    ] {
        let body = Ts::<BodyOptions>::new_unchecked(object(given));
        let capacity = ExteriorMap::solve(body, fine()).unwrap().capacity();
        assert!((capacity - 2.0).abs() < tolerance, "{given}: {capacity}");
    }

    let wing = exterior("holes: [new Float64Array([1, 0, 0, 0.05, -1, 0, 0, -0.05])]");
    let wind = Ts::<FlowOptions>::new_unchecked(object("angle: 0.1, circulation: 'kutta'"));
    let flow = PotentialFlow::past(&wing, Some(wind), fine()).unwrap();
    let lift = |density| flow.lift(density).unwrap();
    assert!((lift(None) - 0.64).abs() < 0.03 && lift(Some(2.0)) == 2.0 * lift(None));
    assert!(flow.stream(&[0.0, 0.0]).unwrap()[0].is_nan());
    let odd = Ts::<FlowOptions>::new_unchecked(object("circulation: 'euler'"));
    assert_eq!(code(&JsValue::from(PotentialFlow::past(&wing, Some(odd), None).unwrap_err())), "invalid-option");
}
