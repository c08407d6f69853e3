//! Pictures through maps and meshes.

mod maps;
mod mesh;
mod presets;
mod quality;
