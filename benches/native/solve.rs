//! Whole solves and evaluation.

#[path = "../../tests/native/support/mod.rs"]
#[allow(dead_code, clippy::unwrap_used, reason = "what the tests share, of which a benchmark uses a part")]
mod support;

use conformal_warp::Complex64;
use criterion::{Criterion, criterion_group};
use std::hint::black_box;
use support::{case, solve};

fn solves(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("solve");
    group.sample_size(10);
    for (name, tolerance) in [("sc_4_101", 1e-10), ("sc_24_105", 1e-10), ("blob100", 1e-7), ("blob300", 1e-6)] {
        let region = case(name).region();
        group.bench_function(name, |bencher| bencher.iter(|| solve(black_box(&region), tolerance)));
    }
    group.finish();
}

fn evaluation(criterion: &mut Criterion) {
    let region = case("blob100").region();
    let map = solve(&region, 1e-8);
    // Rings between the center and the boundary: near and far.
    let points: Vec<Complex64> = (1..=10)
        .flat_map(|ring| region.boundary().iter().map(move |v| 0.0999 * f64::from(ring) * v))
        .filter(|&z| region.contains(z))
        .collect();
    criterion.bench_function(&format!("to disk, blob100, {} points", points.len()), |bencher| {
        bencher.iter(|| map.to_disk(black_box(&points)));
    });
}

criterion_group!(benches, solves, evaluation);
