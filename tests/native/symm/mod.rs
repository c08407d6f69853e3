//! Symm's map of a region: right, robust, and honest about its error.

mod convergence;
mod curved;
mod estimate;
mod exact;
mod horns;
mod robust;
mod second_method;
mod smooth;
