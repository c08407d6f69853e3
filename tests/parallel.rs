//! The feature `parallel`: `cargo test --features parallel --test parallel`.
#![cfg(not(target_arch = "wasm32"))]
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use conformal_warp::{
    Complex64, Curve, Direction, Error, FormulaMap, Frame, Jet, Light, Moebius, ParallelWarp, PlaneMap, Quality,
    Region, RegionMap, RiemannMap, SolveOptions, Texture, TriangleMesh, Warp, WarpOptions, Wrap, par_points,
};

const QUALITIES: [Quality; 4] = [Quality::Nearest, Quality::Bilinear, Quality::Trilinear, Quality::Best];
const DIRECTIONS: [Direction; 2] = [Direction::PullBack, Direction::PushForward];

fn in_threads<T: Send>(count: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap().install(work)
}

/// Bytes without a pattern.
fn noise(count: usize) -> Vec<u8> {
    let mut state = 1_u32;
    std::iter::repeat_with(|| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    })
    .take(count)
    .collect()
}

fn picture(wrap: Wrap) -> Texture {
    Texture::new(&noise(4 * 150 * 101), 150, 101, wrap, Light::Linear).unwrap()
}

fn setting(direction: Direction, quality: Quality) -> WarpOptions {
    let texture = Frame::new(Complex64::new(0.0, 0.0), 2.5, [150, 101]).unwrap();
    let view = Frame::new(Complex64::new(0.1, -0.05), 2.4, [131, 203]).unwrap();
    WarpOptions { direction, quality, ..WarpOptions::new(texture, view) }
}

/// An L, with its map to the disk.
fn solved() -> RiemannMap {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 0.1), (0.1, 0.1), (0.1, 1.0), (-1.0, 1.0)];
    let corners = corners.map(|(x, y)| Complex64::new(x, y));
    let region = Region::new(&corners, Curve::Polygon, Complex64::new(-0.3, -0.3), corners[1]).unwrap();
    RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true).unwrap()
}

#[track_caller]
fn assert_same_bits(name: &str, map: &(impl Warp + Sync), options: &WarpOptions, wrap: Wrap) {
    let alone = map.warp(&picture(wrap), options).unwrap();
    assert!(alone.iter().any(|&byte| byte > 0), "{name} shows something");
    for threads in [1, 3, 8] {
        // A texture of its own: its light is not made yet.
        let together = in_threads(threads, || map.par_warp(&picture(wrap), options).unwrap());
        assert!(alone == together, "{name}, {threads} threads, {options:?}");
    }
}

#[test]
fn pictures_have_the_bits_of_one_thread() {
    // Solved anew for each: nothing of an evaluator is there when the threads begin.
    for quality in QUALITIES {
        for direction in DIRECTIONS {
            let options = setting(direction, quality);
            assert_same_bits("formula", &FormulaMap::new("z + 0.3z^2").unwrap(), &options, Wrap::Mirror);
            assert_same_bits("moebius", &Moebius::cayley(), &options, Wrap::Transparent);
            assert_same_bits("riemann", &solved(), &options, Wrap::Clamp);
        }
    }
}

#[test]
fn meshes_have_the_bits_of_one_thread() {
    let source = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
    let target = source.map(|z| z * Complex64::cis(0.4));
    let mesh = TriangleMesh { source: &source, target: &target, triangles: &[[0, 1, 2], [0, 2, 3]], stretch: None };
    for direction in DIRECTIONS {
        assert_same_bits("mesh", &mesh, &setting(direction, Quality::Best), Wrap::Clamp);
    }
}

#[test]
fn some_rows_are_those_of_the_whole() {
    let map = FormulaMap::new("1/z").unwrap();
    for rows in [0..1, 31..33, 5..200, 64..128, 203..203] {
        let options = WarpOptions { rows: Some(rows.clone()), ..setting(Direction::PullBack, Quality::Trilinear) };
        let texture = picture(Wrap::Repeat);
        let together = in_threads(4, || map.par_warp(&texture, &options)).unwrap();
        assert!(together == map.warp(&texture, &options).unwrap(), "{rows:?}");
    }
}

#[test]
fn errors_are_those_of_one_thread() {
    let (map, texture) = (Moebius::cayley(), picture(Wrap::Clamp));
    let mut options = setting(Direction::PullBack, Quality::Best);
    let mut short = vec![0; 7];
    assert_eq!(map.par_warp_into(&texture, &options, &mut short), map.warp_into(&texture, &options, &mut short));
    options.rows = Some(9..300);
    assert!(matches!(map.par_warp(&texture, &options), Err(Error::InvalidRows { .. })));
    let nodes = [Complex64::new(0.0, 0.0); 3];
    let mesh = TriangleMesh { source: &nodes, target: &nodes, triangles: &[[0, 1, 3]], stretch: None };
    options.rows = None;
    assert_eq!(mesh.par_warp(&texture, &options), mesh.warp(&texture, &options));
}

#[test]
fn points_have_the_bits_of_one_thread() {
    let bits = |points: &[Complex64]| points.iter().map(|z| [z.re.to_bits(), z.im.to_bits()]).collect::<Vec<_>>();
    // Some beyond the region, some beyond the disk.
    let points: Vec<_> = (0..10_007).map(|k| Complex64::cis(f64::from(k)) * (0.000_11 * f64::from(k))).collect();
    let alone = solved();
    let pair = RegionMap::between(&solved(), &solved());
    let formula = FormulaMap::new("gamma(z) + z^0.3").unwrap();
    let values = |z: &[Complex64]| {
        let mut jets = vec![Jet::UNDEFINED; z.len()];
        formula.jets(z, &mut jets);
        jets.iter().flat_map(|jet| [jet.value, jet.dz]).collect::<Vec<_>>()
    };
    for threads in [1, 3, 8] {
        in_threads(threads, || {
            let map = solved();
            assert!(bits(&par_points(&points, |z| map.to_disk(z))) == bits(&alone.to_disk(&points)));
            assert!(bits(&par_points(&points, |z| map.from_disk(z))) == bits(&alone.from_disk(&points)));
            assert!(bits(&par_points(&points, |z| map.derivative(z))) == bits(&alone.derivative(&points)));
            assert!(bits(&par_points(&points, |z| pair.forward(z))) == bits(&pair.forward(&points)));
            assert!(bits(&par_points(&points, values)) == bits(&values(&points)));
            assert!(par_points(&[], |z| map.to_disk(z)).is_empty());
        });
    }
}
