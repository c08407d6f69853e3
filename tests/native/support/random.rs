//! Random numbers and random simple polygons for property tests.

use conformal_warp::{Complex64, Curve, Polygon, Region};

/// A small, fast generator with a fixed sequence for each seed (SplitMix64).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678_9abc_def0)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.between(0.0, 1.0)
    }

    /// In 0..n.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// One of them.
    pub fn pick<'a>(&mut self, from: &[&'a str]) -> &'a str {
        from[self.below(from.len())]
    }
}

/// A simple polygon with 5 to 60 vertices: a star with spikes and dents, a round shape with thin spikes and slots,
/// or a tangle of random points with its crossings undone; scaled, turned and shifted.
pub fn polygon(random: &mut Random) -> Polygon {
    let n = 5 + random.below(56);
    loop {
        let shape = match random.below(3) {
            0 => star(random, n),
            1 => spiked(random, n),
            _ => untangled(random, n.min(40)),
        };
        let turn = Complex64::from_polar(random.between(0.1, 10.0), random.between(0.0, std::f64::consts::TAU));
        let shift = Complex64::new(random.between(-5.0, 5.0), random.between(-5.0, 5.0));
        let corners: Vec<_> = shape.iter().map(|z| z * turn + shift).collect();
        if let Ok(polygon) = Polygon::new(&corners) {
            return polygon;
        }
    }
}

/// A region with a random polygon, a center well inside it and a random direction.
pub fn region(random: &mut Random) -> Region {
    loop {
        let polygon = polygon(random);
        let (low, high) = polygon.bounds();
        let candidates =
            (0..40).map(|_| Complex64::new(random.between(low.re, high.re), random.between(low.im, high.im)));
        let depth = |z: &Complex64| (polygon.nearest(*z).point - z).norm();
        let inside: Vec<_> = candidates.filter(|z| polygon.contains_strictly(*z)).collect();
        let Some(center) = inside.into_iter().max_by(|p, q| depth(p).total_cmp(&depth(q))) else { continue };
        let (a, b) = polygon.edge(random.below(polygon.len()));
        let toward = if random.below(2) == 0 { a } else { a + (b - a) * random.between(0.1, 0.9) };
        return Region::new(polygon.vertices(), Curve::Polygon, center, toward).unwrap();
    }
}

/// Random radii at rising angles.
fn star(random: &mut Random, n: usize) -> Vec<Complex64> {
    let deepest = random.between(0.1, 0.8);
    let step = std::f64::consts::TAU / n as f64;
    (0..n)
        .map(|k| Complex64::from_polar(random.between(deepest, 1.0), step * (k as f64 + random.between(0.1, 0.9))))
        .collect()
}

/// A round shape, some of whose vertices are drawn out into thin spikes or pushed in to thin slots.
fn spiked(random: &mut Random, n: usize) -> Vec<Complex64> {
    let sides = (n / 2).max(4);
    let step = std::f64::consts::TAU / sides as f64;
    let mut corners = Vec::new();
    let mut left = n.saturating_sub(sides) / 2;
    for k in 0..sides {
        let angle = step * k as f64;
        let radius = random.between(0.8, 1.0);
        if left > 0 && random.below(2) == 0 {
            left -= 1;
            let half = step * random.between(0.02, 0.3);
            let tip = if random.below(2) == 0 { random.between(1.2, 2.5) } else { random.between(0.3, 0.7) };
            corners.push(Complex64::from_polar(radius, angle - half));
            corners.push(Complex64::from_polar(tip, angle));
            corners.push(Complex64::from_polar(radius, angle + half));
        } else {
            corners.push(Complex64::from_polar(radius, angle));
        }
    }
    corners
}

/// Random points in random order, two crossing edges exchanged until none cross.
fn untangled(random: &mut Random, n: usize) -> Vec<Complex64> {
    let mut points: Vec<_> =
        (0..n).map(|_| Complex64::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0))).collect();
    let side = |a: Complex64, b: Complex64, c: Complex64| ((b - a).conj() * (c - a)).im > 0.0;
    let cross = |a, b, c, d| side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
    let mut changed = true;
    while changed {
        changed = false;
        for i in 0..n {
            for j in i + 2..n {
                let (a, b, c, d) = (points[i], points[i + 1], points[j], points[(j + 1) % n]);
                if (j + 1) % n != i && cross(a, b, c, d) {
                    points[i + 1..=j].reverse();
                    changed = true;
                }
            }
        }
    }
    points
}
