//! Textures and warps: from a map and a picture to pixels.
