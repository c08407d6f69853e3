//! Warping by a map of the plane.

use super::options::{Direction, WarpOptions, Wrap};
use super::pull_back::pull_back;
use super::push_forward::push_forward;
use super::strip::Strip;
use super::texture::Texture;
use super::warping::Warp;
use crate::Result;
use crate::map::PlaneMap;

impl<M: PlaneMap + ?Sized> Warp for M {
    fn footprints(&self, texture: &Texture, options: &WarpOptions, each: &mut dyn FnMut(&Strip)) -> Result<()> {
        footprints(&self, texture, options, each)
    }

    fn is_framed(&self, options: &WarpOptions) -> bool {
        options.direction == Direction::PushForward && self.inverse_map().is_some()
    }
}

/// One code for all maps: they are asked for many points at a time.
fn footprints(
    map: &dyn PlaneMap,
    texture: &Texture,
    options: &WarpOptions,
    each: &mut dyn FnMut(&Strip),
) -> Result<()> {
    match options.direction {
        Direction::PullBack => pull_back(map, texture, texture.wrap(), options, each),
        Direction::PushForward => match map.inverse_map() {
            Some(inverse) => pull_back(&*inverse, texture, Wrap::Transparent, options, each),
            None => push_forward(map, texture, options, each),
        },
    }
}
