//! What the masses at a panel's nodes become on its parts: the matrices that a [`PanelRule`](super::rule::PanelRule) is made of.
//!
//! Each block is m × p, row-major: row i is the mass on node i of the part's own Gauss rule (or Legendre coefficient i)
//! that a unit mass at each of the panel's p nodes gives. The panel is scaled to [0, 1], its corner at 0.

use super::legendre::GaussRule;
use super::order::Order;
use super::rows::add_scaled;

/// Blocks of a regular panel: masses on its m nodes, and its Legendre coefficients (padded to m rows).
#[must_use]
pub fn regular_blocks(order: &Order) -> Vec<f64> {
    let (p, m) = (order.p(), order.piece.len());
    let mut blocks = vec![0.0; 2 * m * p];
    let mut basis = vec![0.0; p];
    for i in 0..m {
        order.panel.lagrange(order.piece.nodes[i], &mut basis);
        for j in 0..p {
            blocks[i * p + j] = order.piece.weights[i] * basis[j] / order.panel.weights[j];
        }
    }
    for k in 0..p {
        for j in 0..p {
            blocks[(m + k) * p + j] = order.panel.coefficient_row(k)[j] / order.panel.weights[j];
        }
    }
    blocks
}

/// m/2 × p: the masses on far nodes with the same first m/2 moments as the m × p masses of the whole panel.
#[must_use]
pub fn far_block(order: &Order, union: &[f64]) -> Vec<f64> {
    let p = order.p();
    let mut block = vec![0.0; order.far.len() * p];
    let mut basis = vec![0.0; order.far.len()];
    for (t, masses) in order.piece.nodes.iter().zip(union.chunks_exact(p)) {
        order.far.lagrange(*t, &mut basis);
        for (row, b) in block.chunks_exact_mut(p).zip(&basis) {
            add_scaled(row, *b, masses);
        }
    }
    block
}

/// Blocks of a panel with a corner variable: unions 0 … levels, pieces 0 … levels−1, and the pieces' coefficients.
#[must_use]
pub fn graded_blocks(order: &Order, exponent: f64, levels: usize) -> Vec<f64> {
    let (p, m) = (order.p(), order.piece.len());
    let size = m * p;
    let mut blocks = vec![0.0; (3 * levels + 1) * size];
    let (unions, rest) = blocks.split_at_mut((levels + 1) * size);
    let (pieces, moments) = rest.split_at_mut(levels * size);
    fill_pieces(order, exponent, pieces);
    fill_innermost_union(order, exponent, levels, &mut unions[levels * size..]);
    for l in (0..levels).rev() {
        let piece = &pieces[l * size..][..size];
        let (outer, inner) = unions.split_at_mut((l + 1) * size);
        let union = &mut outer[l * size..];
        add_product(&order.to_inner_half, &inner[..size], p, union);
        add_product(&order.to_outer_half, piece, p, union);
        add_product(&order.to_piece_coefficients, piece, p, &mut moments[l * size..][..size]);
    }
    blocks
}

/// Piece by piece the mass on the Gauss nodes of [2^(−l−1), 2^(−l)].
fn fill_pieces(order: &Order, exponent: f64, pieces: &mut [f64]) {
    let p = order.p();
    // s = τ^a: half the distance is a fixed share of τ.
    let share = (-1.0 / exponent).exp2();
    let outermost: Vec<f64> = order.piece.nodes.iter().map(|t| 0.75 + 0.25 * t).collect();
    let mut taus: Vec<f64> = outermost.iter().map(|s| s.powf(1.0 / exponent)).collect();
    let mut basis = vec![0.0; p];
    for piece in pieces.chunks_exact_mut(outermost.len() * p) {
        for (i, row) in piece.chunks_exact_mut(p).enumerate() {
            // dμ = g dτ with dτ/ds = τ/(a s); a unit mass at node j is g = basis_j · 2/w_j.
            let jacobian = taus[i] / (exponent * outermost[i]) * 0.25 * order.piece.weights[i];
            order.panel.lagrange(2.0 * taus[i] - 1.0, &mut basis);
            for j in 0..p {
                row[j] = jacobian * basis[j] * 2.0 / order.panel.weights[j];
            }
        }
        taus.iter_mut().for_each(|tau| *tau *= share);
    }
}

/// The masses on the nodes of [0, 2^(−levels)] that have the first m moments of what lies there.
///
/// With s = Rx and τ = T·x^(1/a) at x ∈ [0, 1], the density is a sum of τⁱ dτ, and
/// ∫ Pₙ(2x−1) xᵇ dx = b(b−1)…(b−n+1) / ((b+1)(b+2)…(b+n+1)) at b = (i+1)/a − 1.
fn fill_innermost_union(order: &Order, exponent: f64, levels: usize, union: &mut [f64]) {
    let (p, m) = (order.p(), order.piece.len());
    let end = (-(levels as f64) / exponent).exp2();
    let mut power = 1.0;
    for (i, densities) in powers_of_tau(&order.panel).chunks_exact(p).enumerate() {
        power *= end;
        let b = (i + 1) as f64 / exponent - 1.0;
        let mut moment = power / (i + 1) as f64;
        for n in 0..m {
            for (row, to_mass) in union.chunks_exact_mut(p).zip(order.piece.coefficient_row(n)) {
                row.iter_mut().zip(densities).for_each(|(mass, density)| *mass += to_mass * moment * density);
            }
            let n = n as f64;
            moment *= (b - n) / (b + n + 2.0);
        }
    }
}

/// p × p: row i holds the coefficients of τⁱ in the densities (in τ ∈ [0, 1]) of a unit mass at each node. Good where τ is
/// small: further out they cancel.
fn powers_of_tau(panel: &GaussRule) -> Vec<f64> {
    let p = panel.len();
    let mut rows = vec![0.0; p * p];
    for k in 0..p {
        // Pₖ(2τ−1) = Σᵢ (−1)^(k+i) C(k,i) C(k+i,i) τⁱ.
        let mut legendre = if k % 2 == 0 { 1.0 } else { -1.0 };
        for i in 0..=k {
            for j in 0..p {
                rows[i * p + j] += legendre * panel.coefficient_row(k)[j] * 2.0 / panel.weights[j];
            }
            legendre *= -(((k - i) * (k + i + 1)) as f64) / ((i + 1) * (i + 1)) as f64;
        }
    }
    rows
}

/// result (m × p) += left (m × m) · right (m × p).
fn add_product(left: &[f64], right: &[f64], p: usize, result: &mut [f64]) {
    let m = right.len() / p;
    for (row, factors) in result.chunks_exact_mut(p).zip(left.chunks_exact(m)) {
        for (factor, from) in factors.iter().zip(right.chunks_exact(p)) {
            add_scaled(row, *factor, from);
        }
    }
}
