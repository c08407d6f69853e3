//! Joint triangulations.

mod curves;
mod disk;
mod pairs;
mod regions;
mod shapes;
