//! Named formulas with frames that show them well: the report's figures 1 and 2, and the classics.

use crate::Result;
use crate::formula::FormulaMap;
use crate::plane::{Complex64, Frame};
use crate::warp::{Direction, Wrap};
use std::f64::consts::{PI, TAU};

/// A formula and how to look at it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preset {
    /// A short stable name: letters and hyphens.
    pub name: &'static str,
    /// A heading.
    pub title: &'static str,
    /// What the picture shows, in a sentence.
    pub shows: &'static str,
    /// The formula, as [`FormulaMap`] reads it.
    pub formula: &'static str,
    /// Its parameters and their first values.
    pub params: &'static [(&'static str, Complex64)],
    /// Which way the formula is used.
    pub direction: Direction,
    /// The place of the picture in the plane.
    pub texture: Placement,
    /// What part of the plane to look at.
    pub view: Placement,
    /// The wrap mode: how the picture continues beyond its edges.
    pub wrap: Wrap,
    /// The kind of picture that shows it best.
    pub picture: Picture,
}

/// A frame without pixel counts: a center and a width, in plane units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// The middle.
    pub center: Complex64,
    /// Width in plane units.
    pub width: f64,
}

impl Placement {
    /// The frame of that place with so many columns and rows.
    ///
    /// # Errors
    /// [`crate::Error::InvalidFrame`] for pixel counts that a frame cannot have.
    pub fn frame(&self, pixels: [usize; 2]) -> Result<Frame> {
        Frame::new(self.center, self.width, pixels)
    }
}

/// Kinds of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Picture {
    /// Any photo.
    Photo,
    /// A lattice of lines, which shows right angles staying right.
    Lattice,
}

impl Preset {
    /// The preset of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.name == name)
    }

    /// Its formula, compiled.
    ///
    /// ```
    /// use conformal_warp::presets::Preset;
    /// let droste = Preset::named("droste").unwrap();
    /// assert_eq!(droste.map()?.text(), "(n - m i) log(z) / pi");
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// There are none: the tests compile every preset.
    pub fn map(&self) -> Result<FormulaMap> {
        FormulaMap::with_params(self.formula, self.params)
    }
}

const fn place(x: f64, y: f64, width: f64) -> Placement {
    Placement { center: Complex64::new(x, y), width }
}

/// A photo two units wide around 0, pulled back and repeated: what the presets below start from.
const PHOTO: Preset = Preset {
    name: "",
    title: "",
    shows: "",
    formula: "z",
    params: &[],
    direction: Direction::PullBack,
    texture: place(0.0, 0.0, 2.0),
    view: place(0.0, 0.0, 4.0),
    wrap: Wrap::Repeat,
    picture: Picture::Photo,
};

/// All presets, the report's figures first.
pub static PRESETS: [Preset; 16] = [
    Preset {
        name: "cosine",
        title: "Complex cosine (figure 1)",
        shows: "Each point z shows the picture, repeated over the plane, at cos z.",
        formula: "cos(z)",
        view: place(0.0, 0.0, TAU),
        ..PHOTO
    },
    Preset {
        name: "logarithm",
        title: "Complex logarithm (figure 1)",
        shows: "w = log z: each point w shows the picture at e^w. One period strip, 2π high, with parts of two others.",
        formula: "exp(z)",
        view: place(-0.8, 0.0, 10.0),
        ..PHOTO
    },
    Preset {
        name: "fractional-linear",
        title: "Fractional linear map, a photo (figure 1)",
        shows: "w = (z − 1)/(z + 1): a hole poked into the plane at −1, turned inside out and flipped over.",
        formula: "(1 + z)/(1 - z)",
        view: place(0.0, 0.0, 6.0),
        ..PHOTO
    },
    Preset {
        name: "fractional-linear-lattice",
        title: "Fractional linear map, a lattice (figure 1)",
        shows: "The same w = (z − 1)/(z + 1) on a lattice: its lines become circles through 1, and stay at right angles.",
        formula: "(1 + z)/(1 - z)",
        view: place(0.0, 0.0, 6.0),
        picture: Picture::Lattice,
        ..PHOTO
    },
    Preset {
        name: "half-disk",
        title: "Unit disk to upper half disk (figure 2)",
        shows: "w = (√u − 1)/(√u + 1), u = i(1 + z)/(1 − z): disk, upper half plane, quadrant, half disk.",
        formula: "((1+z)^2 - i(1-z)^2) / ((1+z)^2 + i(1-z)^2)",
        view: place(0.0, 0.5, 2.6),
        texture: place(0.0, 0.0, 2.6),
        ..PHOTO
    },
    Preset {
        name: "cosine-image",
        title: "The image under the cosine",
        shows: "w = cos z takes the strip 0 < Re z < π, on which the picture lies, to the plane without two rays.",
        formula: "cos(z)",
        direction: Direction::PushForward,
        texture: place(0.5 * PI, 0.0, PI),
        view: place(0.0, 0.0, 5.0),
        wrap: Wrap::Transparent,
        ..PHOTO
    },
    Preset {
        name: "exponential",
        title: "Exponential",
        shows: "w = e^z: the picture, π high, and its mirror image wound around 0. No seam anywhere.",
        formula: "log(z)",
        texture: place(0.0, 0.5 * PI, PI),
        view: place(0.0, 0.0, 8.0),
        wrap: Wrap::Mirror,
        ..PHOTO
    },
    Preset {
        name: "square",
        title: "Square",
        shows: "Each point z shows the picture at z²: twice around 0, angles doubled at 0 and kept elsewhere.",
        formula: "z^2",
        view: place(0.0, 0.0, 2.4),
        wrap: Wrap::Mirror,
        ..PHOTO
    },
    Preset {
        name: "power",
        title: "Power",
        shows: "Each point z shows the picture at z^a. The cut along the negative axis closes where a is a whole number.",
        formula: "z^a",
        params: &[("a", Complex64::new(1.5, 0.0))],
        view: place(0.0, 0.0, 2.4),
        wrap: Wrap::Mirror,
        ..PHOTO
    },
    Preset {
        name: "root",
        title: "Square root",
        shows: "w = z²: each point w shows the picture at √w, so the picture's right half covers the plane.",
        formula: "sqrt(z)",
        view: place(0.0, 0.0, 2.4),
        ..PHOTO
    },
    Preset {
        name: "inversion",
        title: "Inversion",
        shows: "Each point z shows the picture at 1/z: the outside turned in, repeated ever smaller towards 0.",
        formula: "1/z",
        view: place(0.0, 0.0, 3.0),
        ..PHOTO
    },
    Preset {
        name: "tangent",
        title: "Tangent",
        shows: "Each point z shows the picture at tan z; far up and down it settles at ±i.",
        formula: "tan(z)",
        view: place(0.0, 0.0, TAU),
        ..PHOTO
    },
    Preset {
        name: "joukowski",
        title: "Joukowski",
        shows: "Each point z shows a lattice at z + 1/z: outside the unit circle its level lines are the flow around a cylinder.",
        formula: "z + 1/z",
        view: place(0.0, 0.0, 5.0),
        picture: Picture::Lattice,
        ..PHOTO
    },
    Preset {
        name: "cayley",
        title: "Cayley",
        shows: "w = (z − i)/(z + i) takes the upper half plane to the unit disk, i to its center.",
        formula: "i(1 + z)/(1 - z)",
        texture: place(0.0, 1.0, 2.0),
        view: place(0.0, 0.0, 2.4),
        ..PHOTO
    },
    Preset {
        name: "droste",
        title: "Droste",
        shows: "The picture, repeated, on m spirals of n pictures a turn; both whole numbers, and no seam anywhere.",
        formula: "(n - m i) log(z) / pi",
        params: &[("n", Complex64::new(3.0, 0.0)), ("m", Complex64::new(1.0, 0.0))],
        view: place(0.0, 0.0, 3.0),
        ..PHOTO
    },
    Preset {
        name: "julia",
        title: "Iterated square",
        shows: "Each point z shows the picture at the third iterate of w → w² + t: copies of it surround a Julia set.",
        formula: "iterate(w, z, 3, w^2 + t)",
        params: &[("t", Complex64::new(-0.4, 0.6))],
        view: place(0.0, 0.0, 3.0),
        wrap: Wrap::Mirror,
        ..PHOTO
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    fn c(re: f64, im: f64) -> Complex64 {
        Complex64::new(re, im)
    }

    #[test]
    fn every_preset_compiles_and_has_a_name_of_its_own() {
        for (k, preset) in PRESETS.iter().enumerate() {
            let map = preset.map().unwrap_or_else(|error| panic!("{}: {error}", preset.name));
            assert!(map.is_analytic());
            assert!(preset.texture.frame([4, 4]).is_ok() && preset.view.frame([4, 4]).is_ok());
            assert!(PRESETS[..k].iter().all(|other| other.name != preset.name));
            assert!(preset.name.chars().all(|c| c.is_ascii_lowercase() || c == '-') && !preset.shows.is_empty());
        }
        assert_eq!(Preset::named("no-such-thing"), None);
    }

    /// A picture that repeats meets itself on the cut if the formula jumps there by whole periods.
    #[test]
    fn seamless_presets_jump_by_whole_periods() {
        for name in ["exponential", "droste"] {
            let preset = Preset::named(name).unwrap();
            let map = preset.map().unwrap();
            for x in [-0.1, -1.0, -2.3] {
                let [above, below] = [0.0, -1e-300].map(|y| map.eval(&[c(x, y)])[0]);
                let period = if preset.wrap == Wrap::Mirror { 2.0 } else { 1.0 } * preset.texture.width;
                let periods = (above - below) / period;
                let rounded = c(periods.re.round(), periods.im.round());
                assert!((periods - rounded).norm() < 1e-12 && rounded != Complex64::ZERO, "{name}: {periods}");
            }
        }
    }

    #[test]
    fn pulled_back_formulas_are_inverse_to_what_they_show() {
        let pairs = [
            ("logarithm", "log(z)"),
            ("fractional-linear", "(z - 1)/(z + 1)"),
            ("half-disk", "(sqrt(i(1+z)/(1-z)) - 1)/(sqrt(i(1+z)/(1-z)) + 1)"),
            ("exponential", "exp(z)"),
            ("root", "z^2"),
            ("cayley", "(z - i)/(z + i)"),
        ];
        // Inside the unit half disk, where all of the principal branches agree.
        let points = [c(0.1, 0.2), c(-0.6, 0.3), c(0.4, 0.85), c(-0.2, 0.01)];
        for (name, shown) in pairs {
            let back = Preset::named(name).unwrap().map().unwrap().eval(&points);
            let forth = FormulaMap::new(shown).unwrap().eval(&back);
            for (a, b) in points.iter().zip(&forth) {
                assert!((a - b).norm() < 1e-14, "{name}: {a} came back as {b}");
            }
        }
    }

    #[test]
    fn figure_2_takes_the_half_disk_to_the_disk() {
        let map = Preset::named("half-disk").unwrap().map().unwrap();
        let rim: Vec<Complex64> = (1..40)
            .map(|k| 0.025 * f64::from(k))
            .flat_map(|t| [Complex64::cis(PI * t), c(2.0 * t - 1.0, 0.0)])
            .collect();
        for (z, w) in rim.iter().zip(map.eval(&rim)) {
            assert!((w.norm() - 1.0).abs() < 1e-13, "{z} goes to {w}");
        }
        assert!(map.eval(&[c(0.3, 0.4), c(-0.9, 0.1)]).iter().all(|w| w.norm() < 1.0));
        // The half disk's corners go to ±1 and the middle of its diameter to −i.
        assert!((map.eval(&[c(0.0, 0.0)])[0] - c(0.0, -1.0)).norm() < 1e-15);
    }
}
