//! From the visual field to the cortex and back.

mod chain;
mod figure;
mod recovery;
