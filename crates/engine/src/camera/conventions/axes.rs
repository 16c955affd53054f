//! The axes of other programs, one row each: how their cameras and their worlds lie.

use glam::{DMat4, DVec3, DVec4};

use crate::camera::Camera;

/// A direction, as the viewer of the image sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Toward {
    /// Along **u**.
    Right,
    /// Against **u**.
    Left,
    /// Along **v**.
    Up,
    /// Against **v**.
    Down,
    /// Along **n**.
    Viewer,
    /// Along DOP.
    Scene,
}

/// The axis that points up in a world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WorldUp {
    /// y.
    Y,
    /// z.
    Z,
    /// The program has no rule. It may be y, z or −y.
    Open,
}

/// The axes of a program. A further program is a further row of [`Axes::ALL`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Axes {
    /// The name on the command line.
    pub name: &'static str,
    /// The programs that have these axes.
    pub title: &'static str,
    /// The directions of x, y and z of the camera.
    pub camera: [Toward; 3],
    /// The axis that points up in the world.
    pub up: WorldUp,
    /// The world is left-handed.
    pub left_handed: bool,
    /// Tenths of a point against this row before any number speaks, because fewer matrices come from these programs.
    pub(crate) rarity: u8,
}

impl Axes {
    /// OpenGL, glTF, three.js, and `[0]`: x right, y up, z towards the viewer; y is up in the world.
    pub const OPENGL: Self = Self {
        name: "opengl",
        title: "OpenGL, glTF, three.js, Godot",
        camera: [Toward::Right, Toward::Up, Toward::Viewer],
        up: WorldUp::Y,
        left_handed: false,
        rarity: 0,
    };
    /// Blender and nerfstudio: the camera as in OpenGL; z is up in the world.
    pub const BLENDER: Self =
        Self { name: "blender", title: "Blender, nerfstudio", up: WorldUp::Z, rarity: 5, ..Self::OPENGL };
    /// `OpenCV`, COLMAP, `Open3D`: x right, y down, z into the scene; the world is taken as it is.
    pub const OPENCV: Self = Self {
        name: "opencv",
        title: "OpenCV, COLMAP, Open3D",
        camera: [Toward::Right, Toward::Down, Toward::Scene],
        up: WorldUp::Open,
        left_handed: false,
        rarity: 5,
    };
    /// Direct3D, Babylon.js, and a Transform of Unity: camera and world are left-handed, z into the scene.
    pub const DIRECT3D: Self = Self {
        name: "direct3d",
        title: "Direct3D, Babylon.js, Unity (Transform)",
        camera: [Toward::Right, Toward::Up, Toward::Scene],
        up: WorldUp::Y,
        left_handed: true,
        rarity: 20,
    };
    /// `worldToCameraMatrix` of Unity: the camera as in OpenGL, in a left-handed world.
    pub const UNITY: Self =
        Self { name: "unity", title: "Unity (worldToCameraMatrix)", left_handed: true, rarity: 25, ..Self::OPENGL };
    /// `[3]`: a left-handed camera in a right-handed world.
    pub const VRC: Self = Self {
        name: "left-handed-view",
        title: "[3]",
        camera: [Toward::Right, Toward::Up, Toward::Scene],
        rarity: 20,
        ..Self::OPENGL
    };
    /// Unreal: x into the scene, y right, z up, left-handed.
    pub const UNREAL: Self = Self {
        name: "unreal",
        title: "Unreal",
        camera: [Toward::Scene, Toward::Right, Toward::Up],
        up: WorldUp::Z,
        left_handed: true,
        rarity: 30,
    };
    /// `PyTorch3D`: x left, y up, z into the scene.
    pub const PYTORCH3D: Self = Self {
        name: "pytorch3d",
        title: "PyTorch3D",
        camera: [Toward::Left, Toward::Up, Toward::Scene],
        rarity: 30,
        ..Self::OPENGL
    };
    /// ROS: x into the scene, y left, z up.
    pub const ROS: Self = Self {
        name: "ros",
        title: "ROS",
        camera: [Toward::Scene, Toward::Left, Toward::Up],
        up: WorldUp::Z,
        left_handed: false,
        rarity: 40,
    };

    /// All, in the order in which they are listed.
    pub const ALL: [Self; 9] = [
        Self::OPENGL,
        Self::BLENDER,
        Self::OPENCV,
        Self::DIRECT3D,
        Self::UNITY,
        Self::VRC,
        Self::UNREAL,
        Self::PYTORCH3D,
        Self::ROS,
    ];

    /// A vector of our world in the world of these axes: z is up there, or the other way if it's left-handed.
    pub fn foreign_from_world(self, p: DVec3) -> DVec3 {
        match (self.up, self.left_handed) {
            (WorldUp::Z, true) => DVec3::new(p.x, p.z, p.y),
            (_, true) => DVec3::new(p.x, p.y, -p.z),
            (WorldUp::Z, false) => DVec3::new(p.x, -p.z, p.y),
            (WorldUp::Y | WorldUp::Open, false) => p,
        }
    }

    /// A vector of the world of these axes in ours, the inverse of [`Self::foreign_from_world`].
    pub(crate) fn world_from_foreign(self, p: DVec3) -> DVec3 {
        match (self.up, self.left_handed) {
            // Exchanged as in Unreal's exporter of glTF: up stays up, and the hand changes.
            (WorldUp::Z, true) => DVec3::new(p.x, p.z, p.y),
            // So the image isn't mirrored.
            (_, true) => DVec3::new(p.x, p.y, -p.z),
            // As exporters of glTF turn it.
            (WorldUp::Z, false) => DVec3::new(p.x, p.z, -p.y),
            (WorldUp::Y | WorldUp::Open, false) => p,
        }
    }

    /// M_v in these axes, from their world to their camera; for column vectors.
    ///
    /// ```
    /// # use camera_lab_engine::camera::{Axes, Camera, Parameters};
    /// # use glam::{DVec3, DVec4};
    /// let camera = Camera::new(&Parameters { position: DVec3::new(0.0, 0.0, 5.0), ..Parameters::default() })?;
    /// // OpenCV: y down, z into the scene.
    /// assert_eq!(Axes::OPENCV.view_from_world(&camera).row(2), DVec4::new(0.0, 0.0, -1.0, 5.0));
    /// # Ok::<(), camera_lab_engine::camera::CameraError>(())
    /// ```
    pub fn view_from_world(self, camera: &Camera) -> DMat4 {
        let [x, y, z] = self.view_rows(camera).map(|row| self.foreign_from_world(row.truncate()).extend(row.w));
        DMat4::from_cols(x, y, z, DVec4::W).transpose()
    }

    /// The inverse of M_v in these axes. Its columns are the axes of the camera and C.
    pub fn world_from_view(self, camera: &Camera) -> DMat4 {
        let [x, y, z] = self.view_rows(camera).map(|row| self.foreign_from_world(row.truncate()).extend(0.0));
        DMat4::from_cols(x, y, z, self.foreign_from_world(camera.position()).extend(1.0))
    }

    /// The rows of our M_v that are x, y and z of the camera. Their constants are rounded once, so a zero is a zero.
    fn view_rows(self, camera: &Camera) -> [DVec4; 3] {
        let view_from_world = camera.view_from_world();
        self.camera.map(|toward| match toward {
            Toward::Right => view_from_world.row(0),
            Toward::Left => -view_from_world.row(0),
            Toward::Up => view_from_world.row(1),
            Toward::Down => -view_from_world.row(1),
            Toward::Viewer => view_from_world.row(2),
            Toward::Scene => -view_from_world.row(2),
        })
    }

    /// The signs that turn z of a camera of these axes to look along −z, and y to point up: for M_p, which holds no
    /// other axes.
    pub(crate) fn signs(self) -> [f64; 2] {
        let down = if self.camera[1] == Toward::Down { -1.0 } else { 1.0 };
        let forward = if self.camera[2] == Toward::Scene { -1.0 } else { 1.0 };
        [down, forward]
    }
}

impl Default for Axes {
    fn default() -> Self {
        Self::OPENGL
    }
}
