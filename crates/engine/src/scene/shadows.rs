//! The shadows of a light: if there are any, and how they are found.

/// The way in which the shadows of a light are found: by a shadow map, the depths that the light sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shadows {
    /// False if the light goes through everything. The other fields then mean nothing.
    pub cast: bool,
    /// Side of the map, texels. For a lamp, that of each of the six maps around it.
    pub map: u32,
    /// The amount by which a point must lie deeper than the map to be in the shadow, in steps of the map. A step is the
    /// length of a texel, and the depth by which the surface itself sinks within one.
    pub bias: f64,
    /// Width of the soft edge, texels. With 0 a texel hides completely or not at all.
    pub softness: f64,
}

impl Shadows {
    /// The sizes of a map that are allowed: 4096² depths are 64 MiB.
    pub const MAPS: [u32; 2] = [64, 4096];
    /// The biases that are allowed.
    pub const BIASES: [f64; 2] = [0.0, 100.0];
    /// The widths of the soft edge that are allowed.
    pub const SOFTNESSES: [f64; 2] = [0.0, 8.0];

    /// No shadows. Those that are switched on have the defaults.
    pub const NONE: Self = Self { cast: false, map: 1024, bias: 1.0, softness: 1.0 };
    /// Shadows with the defaults.
    pub const CAST: Self = Self { cast: true, ..Self::NONE };

    /// The same with numbers that are allowed: the nearest ones.
    #[must_use]
    pub fn held(self) -> Self {
        let held = |value: f64, [least, most]: [f64; 2], usual: f64| {
            if value.is_nan() { usual } else { value.clamp(least, most) }
        };
        Self {
            map: self.map.clamp(Self::MAPS[0], Self::MAPS[1]),
            bias: held(self.bias, Self::BIASES, Self::NONE.bias),
            softness: held(self.softness, Self::SOFTNESSES, Self::NONE.softness),
            ..self
        }
    }
}

impl Default for Shadows {
    fn default() -> Self {
        Self::NONE
    }
}
