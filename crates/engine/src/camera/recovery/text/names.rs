//! The names of cameras of other programs: one table. Names decide what numbers are, in whatever order they stand;
//! numbers decide only among the readings that a name leaves open.

use std::collections::HashMap;
use std::sync::LazyLock;

/// The meaning of a number, or of several.
#[rustfmt::skip]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Field {
    /// Of a pose. Center is the target beside an eye, else C. Front leads from the target to the camera in `Open3D`,
    /// and ahead elsewhere.
    Eye, Center, Target, Up, Forward, Backward, Front, T,
    /// −C and 1, of `MeshLab`.
    MinusEye,
    /// Euler angles are in radians, about x, y and z in this order. Three numbers named rotation are open.
    Rvec, Euler, Rotation3, Quaternion, Wxyz, Xyzw, AxisAngle, R, R4,
    /// Sixteen numbers, or twelve. A word says which. A chain leads from the camera before.
    Matrix, Pinhole, Chain,
    /// Of a lens. A focal length is in pixels, or in millimetres beside a sensor.
    K, Fx, Fy, Cx, Cy, Focal, FocalMm, SensorWidth, SensorHeight, SensorX, SensorY, PixelWidth, PixelHeight,
    /// The program decides which side Fov spans.
    Fov, AngleX, AngleY, FovAxis, Aspect, Near, Far,
    /// From the target, as in `VisIt`.
    NearOfTarget, FarOfTarget,
    Left, Right, Bottom, Top, Height, Width, HalfHeight, HalfWidth, WindowHeight, OffsetX, OffsetY,
    /// Of the middle: a shift in shares of the height, a center in half windows.
    ShiftX, ShiftY, CenterX, CenterY, Zoom, Pan, FilmOffset, FilmGauge, PixelAspectX, PixelAspectY,
    ImageWidth, ImageHeight, FullWidth, FullHeight, CropX, CropY, CropWidth, CropHeight, Crop, Binning,
    BoundsMin, BoundsMax, Parallel, Perspective, Baseline,
    /// Distortion has any count.
    Distortion, Coefficient,
    /// Words: the model of the lens or the kind of projection, and the name of the camera.
    Model, Name,
    /// A part of the pose that is in a product, and the scale above a camera.
    Part, Scale,
    /// They say nothing of the image: one number, or anything.
    Ignored, Skip,
    /// Other sensors and maps, of any count or of a fixed one.
    NotCamera, Map9, Map12, Map16,
    /// No name of the table.
    Unknown,
}

use Field as F;

impl Field {
    /// The count of its numbers; `None` for any.
    pub(crate) const fn count(self) -> Option<usize> {
        Some(match self {
            Self::Eye | Self::Center | Self::Target | Self::Up | Self::Forward | Self::Backward | Self::Front => 3,
            Self::T | Self::Rvec | Self::Euler | Self::Rotation3 | Self::BoundsMin | Self::BoundsMax | Self::Scale => 3,
            Self::Quaternion | Self::Wxyz | Self::Xyzw | Self::AxisAngle | Self::MinusEye => 4,
            Self::R | Self::K => 9,
            Self::Pinhole | Self::Map12 => 12,
            Self::Chain | Self::R4 => 16,
            Self::Pan => 2,
            Self::Map9 => 9,
            Self::Map16 => 16,
            Self::Distortion | Self::Part | Self::Skip | Self::NotCamera | Self::Model | Self::Name | Self::FovAxis => {
                return None;
            }
            Self::Parallel | Self::Perspective | Self::Crop => return None,
            _ => 1,
        })
    }

    /// True if it's left out with all that is inside.
    pub(crate) const fn is_left_out(self) -> bool {
        matches!(self, Self::NotCamera | Self::Map9 | Self::Map12 | Self::Map16)
    }

    /// A part of a pose.
    pub(crate) fn is_pose(self) -> bool {
        (self as u8) < Self::K as u8
    }

    /// A part without which a lens says nothing.
    pub(crate) fn is_lens(self) -> bool {
        use Field::{AngleX, AngleY, Focal, FocalMm, Fov, Fx, HalfHeight, Height, K, Left, WindowHeight};
        matches!(self, K | Fx | Focal | FocalMm | Fov | AngleX | AngleY | Left | Height | HalfHeight | WindowHeight)
    }

    /// Its symbol, the same in every language.
    pub(crate) const fn symbol(self) -> &'static str {
        match self {
            Self::Eye | Self::Center | Self::MinusEye => "C",
            Self::Target => "PF",
            Self::Up => "VUP",
            Self::Forward | Self::Front => "DOP",
            Self::Backward => "n",
            Self::T => "t",
            Self::Rvec | Self::Euler | Self::Rotation3 | Self::R | Self::R4 | Self::AxisAngle => "R",
            Self::Quaternion | Self::Wxyz | Self::Xyzw => "q",
            Self::K => "K",
            Self::Pinhole => "K [R | t]",
            Self::Matrix | Self::Chain | Self::Part => "M_v",
            Self::Fx => "f_x",
            Self::Fy => "f_y",
            Self::Cx | Self::SensorX => "c_x",
            Self::Cy | Self::SensorY => "c_y",
            Self::Focal | Self::FocalMm => "f",
            Self::Fov | Self::AngleX | Self::AngleY | Self::FovAxis => "theta",
            Self::Aspect | Self::PixelAspectX | Self::PixelAspectY => "A",
            Self::Near | Self::NearOfTarget => "F",
            Self::Far | Self::FarOfTarget => "B",
            Self::Left => "l",
            Self::Right => "r",
            Self::Bottom => "b",
            Self::Top => "t",
            Self::Height | Self::HalfHeight | Self::WindowHeight => "H",
            Self::Width | Self::HalfWidth => "W",
            Self::ImageWidth => "m",
            Self::ImageHeight => "n",
            Self::Parallel | Self::Perspective | Self::Model => "projection",
            Self::Name => "name",
            Self::Baseline => "baseline",
            _ => "window",
        }
    }
}

/// Names without capitals, underscores and blanks, and the meanings of their numbers in order. A name may stand inside
/// another one: `fixed.width`. Names of one letter keep their capital.
#[rustfmt::skip]
const ROWS: &[Row] = &[
    ("eye eyepoint eyeposition position campos camerapos cameraposition pos location origin vrp cameracenter from C", &[F::Eye]),
    ("position.set setposition freecamera fromxyz setpositionandrotation.vector3 setactorlocationandrotation.fvector", &[F::Eye]),
    ("center centre", &[F::Center]),
    ("target focalpoint camerafocalpoint lookat lookatpoint at focus cameratarget to setfocalpoint settarget PF pf interest", &[F::Target]),
    ("up vup viewup cameraup cameraviewup sky upvector up.set setviewup", &[F::Up]),
    ("lookat lookatrh lookatlh glulookat lookatmat4 cameraposition", &[F::Eye, F::Target, F::Up]),
    ("lookat", &[F::Eye, F::Target]),
    ("lookingat", &[F::Target, F::Up]),
    ("lookrotation makefromxz", &[F::Forward, F::Up]),
    ("forward direction dir dop viewdirection lookdirection", &[F::Forward]),
    ("front camerafront", &[F::Front]),
    ("viewnormal normal vpn", &[F::Backward]),
    ("t T tvec tvecs translation translationvector tr trans camtranslation", &[F::T]),
    ("translationvector", &[F::MinusEye]),
    ("rvec rvecs rotationvector om r R", &[F::Rvec]),
    ("rotationeuler", &[F::Euler]),
    ("rotation", &[F::Rotation3]),
    ("rotation quaternion orientation quat q rot", &[F::Quaternion]),
    ("qvec wxyz quaternionwxyz", &[F::Wxyz]),
    ("xyzw quaternionxyzw gltf.rotation", &[F::Xyzw]),
    ("axisangle viewpoint.orientation", &[F::AxisAngle]),
    ("r R rotation rotationmatrix rot", &[F::R]),
    ("rotationmatrix", &[F::R4]),
    ("tcncnm1", &[F::Chain]),
    ("p P prect projectionmatrix", &[F::Pinhole]),
    ("k K cameramatrix intrinsics intrinsic intrinsicmatrix matrix cam m mtx kmatrix newcameramatrix", &[F::K]),
    ("intrinsics intrinsic", &[F::Fx, F::Fy, F::Cx, F::Cy]),
    ("fx flx focallengthx focalx fu", &[F::Fx]),
    ("fy fly focallengthy focaly fv", &[F::Fy]),
    ("cx ppx u0 principalpointx centerx cu", &[F::Cx]),
    ("cy ppy v0 principalpointy centery cv", &[F::Cy]),
    ("f focal focallength focallengthpx", &[F::Focal]),
    ("f focal focallength", &[F::Fx, F::Fy]),
    ("p pp principalpoint centerpx", &[F::Cx, F::Cy]),
    ("lens focalmm focallengthmm", &[F::FocalMm]),
    ("sensorwidth horizontalaperture sensorwidthmm", &[F::SensorWidth]),
    ("sensorheight verticalaperture sensorheightmm", &[F::SensorHeight]),
    ("sensor sensorsize", &[F::SensorWidth, F::SensorHeight]),
    ("horizontalapertureoffset", &[F::SensorX]),
    ("verticalapertureoffset", &[F::SensorY]),
    ("pixelsizemm", &[F::PixelWidth, F::PixelHeight]),
    ("fov fieldofview angle setfieldofview", &[F::Fov]),
    ("yfov fovy vfov viewangle cameraviewangle setviewangle cameraangley fovdegrees verticalfov", &[F::AngleY]),
    ("xfov fovx hfov cameraanglex horizontalfov", &[F::AngleX]),
    ("aspect aspectratio setaspectratio", &[F::Aspect]),
    ("getprojectiontransformmatrix", &[F::Aspect, F::Ignored, F::Ignored]),
    ("near znear nearclip nearclipplane clipstart clipnear minz setorthonearclipplane orthonearclipplane F", &[F::Near]),
    ("far zfar farclip farclipplane clipend clipfar maxz setorthofarclipplane orthofarclipplane B", &[F::Far]),
    ("clippingrange setclippingrange cameraclippingrange nearfar", &[F::Near, F::Far]),
    ("nearplane", &[F::NearOfTarget]),
    ("farplane", &[F::FarOfTarget]),
    ("perspective perspectiverhno perspectiverh gluperspective perspectivecamera", &[F::AngleY, F::Aspect, F::Near, F::Far]),
    ("setperspective", &[F::AngleY, F::Near, F::Far]),
    ("frustum frustumrhno frustumrh glfrustum", &[F::Left, F::Right, F::Bottom, F::Top, F::Near, F::Far]),
    ("makeperspective", &[F::Left, F::Right, F::Top, F::Bottom, F::Near, F::Far]),
    ("ortho orthorhno orthorh glortho orthographic", &[F::Parallel, F::Left, F::Right, F::Bottom, F::Top, F::Near, F::Far]),
    ("orthographiccamera makeorthographic", &[F::Parallel, F::Left, F::Right, F::Top, F::Bottom, F::Near, F::Far]),
    ("fovorthographiccameras.minx ortholeft", &[F::Parallel, F::Left]),
    ("fovorthographiccameras.maxx orthoright", &[F::Parallel, F::Right]),
    ("fovorthographiccameras.miny orthobottom", &[F::Parallel, F::Bottom]),
    ("fovorthographiccameras.maxy orthotop", &[F::Parallel, F::Top]),
    ("left l", &[F::Left]),
    ("right r", &[F::Right]),
    ("bottom b", &[F::Bottom]),
    ("top t", &[F::Top]),
    ("setfrustum", &[F::WindowHeight, F::OffsetX, F::OffsetY, F::Near, F::Far]),
    ("setorthogonal", &[F::Parallel, F::Height, F::Near, F::Far]),
    ("orthoscale fixed.height", &[F::Height]),
    ("setorthowidth orthowidth fixed.width", &[F::Width]),
    ("parallelscale cameraparallelscale setparallelscale orthographicsize ymag", &[F::HalfHeight]),
    ("xmag", &[F::HalfWidth]),
    ("shiftx", &[F::ShiftX]),
    ("shifty", &[F::ShiftY]),
    ("setwindowcenter windowcenter", &[F::CenterX, F::CenterY]),
    ("zoom imagezoom", &[F::Zoom]),
    ("imagepan", &[F::Pan]),
    ("filmoffset", &[F::FilmOffset]),
    ("filmgauge", &[F::FilmGauge]),
    ("pixelaspectx", &[F::PixelAspectX]),
    ("pixelaspecty", &[F::PixelAspectY]),
    ("imagewidth width w resolutionx resx imgwidth xresolution", &[F::ImageWidth]),
    ("imageheight height h resolutiony resy imgheight yresolution", &[F::ImageHeight]),
    ("resolution size imagesize srect s viewportpx imsize imgsize imageresolution", &[F::ImageWidth, F::ImageHeight]),
    ("perspectivecameras.imagesize orthographiccameras.imagesize", &[F::ImageHeight, F::ImageWidth]),
    ("view.fullwidth", &[F::FullWidth]),
    ("view.fullheight", &[F::FullHeight]),
    ("view.offsetx roi.xoffset cropoffsetx", &[F::CropX]),
    ("view.offsety roi.yoffset cropoffsety", &[F::CropY]),
    ("view.width roi.width cropwidth", &[F::CropWidth]),
    ("view.height roi.height cropheight", &[F::CropHeight]),
    ("view.enabled", &[F::Crop]),
    ("binningx binningy", &[F::Binning]),
    ("boundingboxmin", &[F::BoundsMin]),
    ("boundingboxmax", &[F::BoundsMax]),
    ("baseline", &[F::Baseline]),
    ("orthographic parallelprojection cameraparallelprojection parallelprojectionon orthogonal isorthographic", &[F::Parallel]),
    ("perspective", &[F::Perspective]),
    ("polymorphicname cameramodel distortionmodel model type class projection mode setprojectionmode sensorfit fisheye isfisheye projectiontype", &[F::Model]),
    ("fovaxis", &[F::FovAxis]),
    ("name imgname filepath filename label imagename def DEF", &[F::Name]),
    ("distok1 distok3 distot2 distortioncoefficients distortion distortions distcoeffs distcoef distcoeff distortioncoeffs lensdistortion dist d D coeffs conrady brown radialdistortion tangentialdistortion kc", &[F::Distortion]),
    ("k1 k2 k3 k4 k5 k6 p1 p2 p3 p4 b1 b2 omega sx1 sy1", &[F::Coefficient]),
    ("q Q", &[F::Map16]),
    ("tr Tr", &[F::Map12]),
    ("rrect rectificationmatrix h H homography e E essential f F fundamental", &[F::Map9]),
    ("r0rect extrinsicparameters squaresize imagepoints trvelotocam trimutovelo trvelocam", &[F::NotCamera]),
    ("part", &[F::Part]),
    ("gltf.scale", &[F::Scale]),
    ("version versionmajor versionminor sfmdataversion uuid id idview idintrinsic idpose key polymorphicid interval isloop \
      panel node layers generator metadata timestamp calibrationtime calibtime cornerdist nrofframes flags flagvalue avgreprojectionerror \
      rostopic camoverlaps timeshiftcamimu frameid seq stamp sec nanosec secs nsecs ndisp isint vmin vmax doffs focus parent current \
      boardwidth boardheight rootpath localpath caldatasource calibdatasource colmapimid sharpness aabbscale plyfilepath classname asset \
      scene scenes meshes materials accessors buffers bufferviews images textures samplers animations skins extensionsused structure \
      controlpoints geometries description points2d cameraid imageid cameratype centerofrotation rotationfactor upaxis xformoporder \
      interactionmode imagezoomlocked masksource frametime enabled nextid nextgroupid sensorid resolution.id rectifiedsize \
      startframe endframe dorectify numberofelements index fstop shutteropen shutterclose focusdistance", &[F::Skip]),
];

/// Names, and the meanings of their numbers.
type Row = (&'static str, &'static [Field]);

/// The rows of each last part of a name.
static TABLE: LazyLock<HashMap<&str, Vec<Row>>> = LazyLock::new(|| {
    let mut table: HashMap<&str, Vec<Row>> = HashMap::new();
    for (names, fields) in ROWS {
        for name in names.split_whitespace() {
            let last = name.rsplit('.').next().unwrap_or(name);
            table.entry(last).or_default().push((name, fields));
        }
    }
    table
});

/// A name as it stands in the table.
pub(crate) fn plain(name: &str) -> String {
    let parts = name.split('.').filter(|part| !part.is_empty()).map(|part| {
        let part: String = part.chars().filter(|c| !matches!(c, '_' | '-' | ' ' | '$')).collect();
        if part.len() == 1 { part } else { part.to_lowercase() }
    });
    parts.collect::<Vec<_>>().join(".")
}

/// The meanings of a list under a path of plain names, of which `is_inner` has names of its own. The longest
/// name decides.
pub(crate) fn meaning(path: &str, count: usize, is_inner: bool) -> Option<&'static [Field]> {
    let last = path.rsplit('.').next()?;
    let rows = TABLE.get(last)?.iter().filter(|(name, fields)| {
        let is_end = path.strip_suffix(name).is_some_and(|before| before.is_empty() || before.ends_with('.'));
        let fits = match fields {
            [F::Model | F::Name | F::FovAxis] => count == 0,
            [field] => field.count().map_or(!is_inner || field.is_left_out(), |fixed| fixed == count),
            _ => !is_inner && fields.iter().map(|field| field.count().unwrap_or(0)).sum::<usize>() == count,
        };
        is_end && fits
    });
    rows.max_by_key(|(name, fields)| (name.len(), fields.len(), fields[0].count())).map(|(_, fields)| *fields)
}

/// True if the table has a meaning for a name.
pub(crate) fn is_known(name: &str) -> bool {
    TABLE.get(name).is_some_and(|rows| rows.iter().any(|(own, fields)| *own == name && *fields != [F::Skip]))
}
