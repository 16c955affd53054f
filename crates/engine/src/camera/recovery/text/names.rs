//! The names of cameras of other programs: one table. Names decide what numbers are, in whatever order they stand;
//! numbers decide only among the readings that a name leaves open.

use std::collections::HashMap;
use std::sync::LazyLock;

/// The meaning of a number, or of several.
#[rustfmt::skip]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Field {
    /// Of a pose. Center is the target beside an eye, else C. Front leads from the target to the camera in `Open3D`, and
    /// ahead elsewhere.
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
            F::Eye | F::Center | F::Target | F::Up | F::Forward | F::Backward | F::Front => 3,
            F::T | F::Rvec | F::Euler | F::Rotation3 | F::BoundsMin | F::BoundsMax | F::Scale => 3,
            F::Quaternion | F::Wxyz | F::Xyzw | F::AxisAngle | F::MinusEye => 4,
            F::R | F::K => 9,
            F::Pinhole | F::Map12 => 12,
            F::Chain | F::R4 => 16,
            F::Pan => 2,
            F::Map9 => 9,
            F::Map16 => 16,
            F::Distortion | F::Part | F::Skip | F::NotCamera | F::Model | F::Name | F::FovAxis => return None,
            F::Parallel | F::Perspective | F::Crop => return None,
            _ => 1,
        })
    }

    /// True if it's left out with all that is inside.
    pub(crate) const fn is_left_out(self) -> bool {
        matches!(self, F::NotCamera | F::Map9 | F::Map12 | F::Map16)
    }

    /// A part of a pose.
    pub(crate) fn is_pose(self) -> bool {
        (self as u8) < F::K as u8
    }

    /// A part without which a lens says nothing.
    pub(crate) fn is_lens(self) -> bool {
        use F::{AngleX, AngleY, Focal, FocalMm, Fov, Fx, HalfHeight, Height, K, Left, WindowHeight};
        matches!(self, K | Fx | Focal | FocalMm | Fov | AngleX | AngleY | Left | Height | HalfHeight | WindowHeight)
    }

    /// Its symbol, the same in every language.
    pub(crate) const fn symbol(self) -> &'static str {
        match self {
            F::Eye | F::Center | F::MinusEye => "C",
            F::Target => "PF",
            F::Up => "VUP",
            F::Forward | F::Front => "DOP",
            F::Backward => "n",
            F::T => "t",
            F::Rvec | F::Euler | F::Rotation3 | F::R | F::R4 | F::AxisAngle => "R",
            F::Quaternion | F::Wxyz | F::Xyzw => "q",
            F::K => "K",
            F::Pinhole => "K [R | t]",
            F::Matrix | F::Chain | F::Part => "M_v",
            F::Fx => "f_x",
            F::Fy => "f_y",
            F::Cx | F::SensorX => "c_x",
            F::Cy | F::SensorY => "c_y",
            F::Focal | F::FocalMm => "f",
            F::Fov | F::AngleX | F::AngleY | F::FovAxis => "theta",
            F::Aspect | F::PixelAspectX | F::PixelAspectY => "A",
            F::Near | F::NearOfTarget => "F",
            F::Far | F::FarOfTarget => "B",
            F::Left => "l",
            F::Right => "r",
            F::Bottom => "b",
            F::Top => "t",
            F::Height | F::HalfHeight | F::WindowHeight => "H",
            F::Width | F::HalfWidth => "W",
            F::ImageWidth => "m",
            F::ImageHeight => "n",
            F::Parallel | F::Perspective | F::Model => "projection",
            F::Name => "name",
            F::Baseline => "baseline",
            _ => "window",
        }
    }
}

/// Names without capitals, underscores and blanks, and the meanings of their numbers in order. A name may stand inside
/// another one: `fixed.width`. Names of one letter keep their capital.
#[rustfmt::skip]
const ROWS: &[(&str, &[Field])] = &[
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

/// The rows of each last part of a name.
static TABLE: LazyLock<HashMap<&str, Vec<(&str, &[Field])>>> = LazyLock::new(|| {
    let mut table: HashMap<&str, Vec<(&str, &[Field])>> = HashMap::new();
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

/// The meanings of so many numbers under a path of plain names, of which `is_inner` has names of its own. The longest
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
