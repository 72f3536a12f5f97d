//! What one run of a study is made with.

/// One point of a study: everything that may differ between its runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Case {
    /// Which scene of the plan, from 0; where the study makes its own, which mesh.
    pub subject: usize,
    /// Threads of the render.
    pub threads: u32,
    /// Triangles of the scene.
    pub triangles: u64,
    /// Rays through each pixel.
    pub rays_per_pixel: u32,
    /// Side of the tiles in pixels.
    pub tile_size: u32,
}
