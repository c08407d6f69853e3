//! Meshes and pictures.

#[path = "../../tests/native/support/mod.rs"]
#[allow(dead_code, clippy::unwrap_used, reason = "what the tests share, of which a benchmark uses a part")]
mod support;

use conformal_warp::{
    Complex64, Direction, FormulaMap, Frame, JointTriangulation, Light, MeshOptions, Quality, Texture, Warp,
    WarpOptions, Wrap,
};
use criterion::{Criterion, criterion_group};
use std::hint::black_box;
use support::{case, solve};

const SIZE: usize = 1024;

fn checkerboard() -> Texture {
    let pixel = |k: usize| if ((k % SIZE) ^ (k / SIZE)) & 16 == 0 { [40, 80, 160, 255] } else { [250, 220, 120, 255] };
    let rgba: Vec<u8> = (0..SIZE * SIZE).flat_map(pixel).collect();
    Texture::new(&rgba, SIZE, SIZE, Wrap::Repeat, Light::Linear).expect("a picture")
}

fn frame(width: f64) -> Frame {
    Frame::new(Complex64::ZERO, width, [SIZE, SIZE]).expect("a frame")
}

fn pictures(criterion: &mut Criterion) {
    let texture = checkerboard();
    let mut out = vec![0; 4 * SIZE * SIZE];
    let map = solve(&case("blob100").region(), 1e-8);
    let mesh = JointTriangulation::region_to_disk(&map, &MeshOptions::quarter_pixel(frame(2.0))).expect("a mesh");
    let formula = FormulaMap::new("z^2").expect("a formula");

    let mut group = criterion.benchmark_group(format!("{SIZE} x {SIZE}"));
    group.sample_size(20);
    for quality in [Quality::Bilinear, Quality::Trilinear, Quality::Best] {
        let pull = WarpOptions { quality, ..WarpOptions::new(frame(4.0), frame(4.0)) };
        group.bench_function(format!("z^2, {quality:?}"), |bencher| {
            bencher.iter(|| formula.warp_into(black_box(&texture), &pull, &mut out).expect("a picture"));
        });
        let push =
            WarpOptions { quality, direction: Direction::PushForward, ..WarpOptions::new(frame(3.0), frame(2.0)) };
        group.bench_function(format!("mesh of blob100, {quality:?}"), |bencher| {
            bencher.iter(|| mesh.warp_into(black_box(&texture), &push, &mut out).expect("a picture"));
        });
    }
    group.finish();
}

fn meshes(criterion: &mut Criterion) {
    let map = solve(&case("blob100").region(), 1e-8);
    let mut group = criterion.benchmark_group("region to disk, blob100");
    group.sample_size(10);
    for spacing in [0.1, 0.05] {
        let options = MeshOptions::with_spacing(spacing);
        group.bench_function(format!("spacing {spacing}"), |bencher| {
            bencher.iter(|| JointTriangulation::region_to_disk(black_box(&map), &options).expect("a mesh"));
        });
    }
    group.finish();
}

criterion_group!(benches, pictures, meshes);
