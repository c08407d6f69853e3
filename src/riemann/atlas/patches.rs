//! Patches, made when they are first needed.

use super::accuracy::Accuracy;
use super::charts::Atlas;
use super::fit::Fit;
use super::patch::Patch;
use crate::plane::sort_by;
use crate::symm::panel::Boundary;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Patches made so far, by chart and zone.
#[derive(Clone, Debug)]
pub struct Patches {
    boundary: Arc<Boundary>,
    fit: Arc<Fit>,
    numbers: FxHashMap<(usize, usize), u32>,
    /// The patches.
    pub list: Vec<Patch>,
}

impl Patches {
    /// A list without patches yet.
    #[must_use]
    pub fn new(boundary: &Arc<Boundary>, accuracy: Accuracy) -> Self {
        Self {
            boundary: Arc::clone(boundary),
            fit: Arc::new(Fit::new(accuracy.patch_degree(), accuracy.tolerance)),
            numbers: FxHashMap::default(),
            list: Vec::new(),
        }
    }

    /// Those of one chart, to be added to.
    #[must_use]
    pub fn of_chart(&self, chart: usize) -> Self {
        let mut zones: Vec<_> = self.numbers.iter().filter(|((of, _), _)| *of == chart).collect();
        sort_by(&mut zones, Ord::cmp);
        Self {
            boundary: Arc::clone(&self.boundary),
            fit: Arc::clone(&self.fit),
            numbers: zones.iter().zip(0..).map(|((key, _), own)| (**key, own)).collect(),
            list: zones.iter().map(|(_, index)| self.list[**index as usize].clone()).collect(),
        }
    }

    /// Bytes of memory.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.list.iter().map(Patch::bytes).sum()
    }

    /// A chart's patch in one of its zones, if it was made.
    #[must_use]
    pub fn known(&self, chart: usize, zone: usize) -> Option<&Patch> {
        self.numbers.get(&(chart, zone)).map(|index| &self.list[*index as usize])
    }

    /// The number of a chart's patch in one of its zones.
    pub fn get(&mut self, atlas: &Atlas, chart: usize, zone: usize) -> u32 {
        *self.numbers.entry((chart, zone)).or_insert_with(|| {
            let map = &atlas.charts[chart];
            self.list.push(Patch::new(&self.boundary, map, chart, map.zones.list[zone], &self.fit));
            self.list.len() as u32 - 1
        })
    }
}
