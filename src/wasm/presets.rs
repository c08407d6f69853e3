//! The presets in JavaScript.

use super::error::Failure;
use super::options;
use crate::plane::Complex64;
use crate::presets::{self, Picture, Placement};
use crate::warp::{Direction, Wrap};
use serde::Serialize;
use std::collections::BTreeMap;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPESCRIPT: &str = r"
/** A frame without pixel counts, as presets hold it. */
export type PlacementOptions = Placement;
";

/// A formula and how to look at it: `new FormulaMap(preset.formula, { params: preset.params })`.
#[derive(Debug, Serialize, Tsify)]
pub struct Preset {
    /// A short stable name: letters and hyphens.
    pub name: &'static str,
    /// A heading.
    pub title: &'static str,
    /// What the picture shows, in a sentence.
    pub shows: &'static str,
    /// The formula.
    pub formula: &'static str,
    /// Its parameters and their first values.
    #[tsify(type = "Record<string, [re: number, im: number]>")]
    pub params: BTreeMap<&'static str, [f64; 2]>,
    /// Which way the formula is used.
    pub direction: Direction,
    /// Where the picture lies.
    pub texture: PlacementOptions,
    /// What part of the plane to look at.
    pub view: PlacementOptions,
    /// How the picture continues.
    pub wrap: Wrap,
    /// The kind of picture that shows it best.
    pub picture: Picture,
}

/// A frame without pixel counts.
#[derive(Debug, Serialize, Tsify)]
#[tsify(rename = "Placement")]
pub struct PlacementOptions {
    /// The middle, in the plane.
    #[tsify(type = "[x: number, y: number]")]
    pub center: [f64; 2],
    /// Width in plane units.
    pub width: f64,
}

/// All presets.
#[derive(Debug, Serialize, Tsify)]
#[serde(transparent)]
#[tsify(hashmap_as_object)]
pub struct Presets(Vec<Preset>);

fn pair(z: Complex64) -> [f64; 2] {
    [z.re, z.im]
}

impl From<Placement> for PlacementOptions {
    fn from(Placement { center, width }: Placement) -> Self {
        Self { center: pair(center), width }
    }
}

impl From<&presets::Preset> for Preset {
    fn from(preset: &presets::Preset) -> Self {
        Self {
            name: preset.name,
            title: preset.title,
            shows: preset.shows,
            formula: preset.formula,
            // Not collected: that would compile one more sort.
            params: preset.params.iter().fold(BTreeMap::new(), |mut params, &(name, value)| {
                params.insert(name, pair(value));
                params
            }),
            direction: preset.direction,
            texture: preset.texture.into(),
            view: preset.view.into(),
            wrap: preset.wrap,
            picture: preset.picture,
        }
    }
}

/// Named formulas with frames that show them well: the report's figures 1 and 2, and the classics.
#[wasm_bindgen(js_name = presets)]
pub fn all() -> Result<Ts<Presets>, Failure> {
    options::write(&Presets(presets::PRESETS.iter().map(Preset::from).collect()))
}
