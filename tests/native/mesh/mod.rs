//! Joint triangulations.

mod disk;
mod pairs;
mod regions;
mod shapes;
