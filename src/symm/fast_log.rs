//! Natural logarithms of whole slices, branch-free so that the compiler vectorises them.

const LN2_HIGH: f64 = 6.931_471_803_691_238_2e-1;
const LN2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// Coefficients of (log(1+s) − log(1−s))/s − 2 in s², for |s| ≤ 0.1716 (fdlibm's e_log.c).
const SERIES: [f64; 7] = [
    6.666_666_666_666_735e-1,
    3.999_999_999_940_942e-1,
    2.857_142_874_366_239e-1,
    2.222_219_843_214_978_4e-1,
    1.818_357_216_161_805e-1,
    1.531_383_769_920_937_3e-1,
    1.479_819_860_511_658_6e-1,
];
/// Bits of √½: subtracting them puts the mantissa into [√½, √2).
const SQRT_HALF_BITS: u64 = 0x3fe6_a09e_667f_3bcd;
/// 2⁵², whose bits plus a small integer are the double 2⁵² + that integer.
const TWO_52_BITS: u64 = 0x4330_0000_0000_0000;
const EXPONENT_BIAS: u64 = 2048;

/// Replaces each x by ½ ln x: the logarithm of a distance from its square. Positive normal numbers only; 1 ulp.
pub fn half_ln(values: &mut [f64]) {
    for x in values {
        let shifted = x.to_bits().wrapping_sub(SQRT_HALF_BITS).wrapping_add(EXPONENT_BIAS << 52);
        let biased_exponent = shifted >> 52;
        let mantissa = f64::from_bits((shifted & 0x000f_ffff_ffff_ffff) + SQRT_HALF_BITS);
        let exponent = f64::from_bits(TWO_52_BITS | biased_exponent) - (4_503_599_627_370_496.0 + EXPONENT_BIAS as f64);
        let f = mantissa - 1.0;
        let s = f / (2.0 + f);
        let z = s * s;
        let w = z * z;
        let even = w * (SERIES[1] + w * (SERIES[3] + w * SERIES[5]));
        let odd = z * (SERIES[0] + w * (SERIES[2] + w * (SERIES[4] + w * SERIES[6])));
        let half_square = 0.5 * f * f;
        let correction = s * (half_square + even + odd) + exponent * LN2_LOW;
        *x = 0.5 * (exponent * LN2_HIGH - ((half_square - correction) - f));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_standard_logarithm() {
        let mut x: f64 = 1e-290;
        while x < 1e290 {
            for y in [x, 1.0 + x.min(1.0) * 1e-3, 1.0 - x.min(0.5) * 1e-2] {
                let mut value = [y];
                half_ln(&mut value);
                let exact = 0.5 * y.ln();
                assert!(
                    (value[0] - exact).abs() <= 2.0 * f64::EPSILON * exact.abs(),
                    "½ ln {y:e}: {} not {exact}",
                    value[0]
                );
            }
            x *= 1.37;
        }
    }
}
