//! The names of cameras of other programs: one table. Names decide what numbers are, in whatever order they stand;
//! numbers decide only among the readings that a name leaves open.

use std::collections::HashMap;
use std::sync::LazyLock;

use crate::camera::recovery::{Axes, MatrixKind, Order, Reading};

/// The table: a meaning, the count of its numbers (`_` for any), its symbol, and its names.
macro_rules! fields {
    (@count _) => { None };
    (@count $count:literal) => { Some($count) };
    ($($(#[$doc:meta])* $field:ident $count:tt $symbol:literal $names:literal,)*) => {
        /// The meaning of a number, or of several.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Field { $($(#[$doc])* $field,)* }

        impl Field {
            /// The count of its numbers; `None` for any.
            pub(crate) const fn count(self) -> Option<usize> {
                match self { $(Self::$field => fields!(@count $count),)* }
            }

            /// Its symbol, the same in every language.
            pub(crate) const fn symbol(self) -> &'static str {
                match self { $(Self::$field => $symbol,)* }
            }
        }

        /// Names of one meaning.
        const OF_ONE: &[Row] = &[$(($names, &[Field::$field])),*];
    };
}

// A name may stand inside another one: `fixed.width`. It has no capitals, underscores and blanks, but names of one
// letter keep their capital. Those up to `Chain` are parts of a pose.
fields! {
    Eye 3 "C" "mlocalposition eye eyepoint eyeposition position campos camerapos cameraposition pos location origin vrp cameracenter from C relativelocation position.set setposition \
        freecamera fromxyz setpositionandrotation.vector3 setactorlocationandrotation.fvector",
    /// The target beside an eye, else C.
    Center 3 "C" "center centre",
    Target 3 "PF" "camtarget target focalpoint camerafocalpoint lookat lookatpoint at focus cameratarget to setfocalpoint settarget PF pf interest",
    Up 3 "VUP" "camup up vup viewup cameraup cameraviewup upvector up.set setviewup",
    /// Before Up.
    Sky 3 "VUP" "sky",
    Forward 3 "DOP" "forward direction dir dop viewdirection lookdirection",
    Backward 3 "n" "viewnormal normal vpn",
    /// From the target to the camera in `Open3D`, ahead elsewhere.
    Front 3 "DOP" "front camerafront",
    T 3 "t" "t T tvec tvecs translation translationvector tr trans camtranslation",
    /// −C and 1, of `MeshLab`.
    MinusEye 4 "C" "translationvector",
    Rvec 3 "R" "rvec rvecs rotationvector om r R",
    /// In radians, about x, y and z in this order.
    Euler 3 "R" "rotationeuler",
    /// In degrees, of Unreal.
    Pitch 1 "R" "pitch",
    Yaw 1 "R" "yaw",
    Roll 1 "R" "roll",
    /// Open what it is.
    Rotation3 3 "R" "rotation",
    Quaternion 4 "q" "mlocalrotation rotation quaternion orientation quat q rot",
    Wxyz 4 "q" "qvec wxyz quaternionwxyz",
    Xyzw 4 "q" "xyzw quaternionxyzw gltf.rotation",
    AxisAngle 4 "R" "axisangle viewpoint.orientation",
    R 9 "R" "r R rotation rotationmatrix rot",
    R4 16 "R" "rotationmatrix",
    /// Sixteen numbers, or twelve. A word says which.
    Matrix 1 "M_v" "",
    Pinhole 12 "K [R | t]" "p P prect projectionmatrix",
    /// M_p beside a pose.
    Projection 16 "M_p" "",
    /// From the camera before.
    Chain 16 "M_v" "tcncnm1",
    K 9 "K" "k K cameramatrix intrinsics intrinsic intrinsicmatrix matrix cam m mtx kmatrix newcameramatrix",
    /// K in four rows.
    K4 16 "K" "k K intrinsics intrinsic intrinsicmatrix colorintrinsic mcalibrationcolorintrinsic",
    Fx 1 "f_x" "mu fx flx focallengthx focalx fu",
    Fy 1 "f_y" "mv fy fly focallengthy focaly fv",
    Cx 1 "c_x" "cx ppx u0 principalpointx centerx cu",
    Cy 1 "c_y" "cy ppy v0 principalpointy centery cv",
    /// In pixels, or in millimetres beside a sensor.
    Focal 1 "f" "f focal focallength focallengthpx",
    FocalMm 1 "f" "lens focalmm focallengthmm",
    SensorWidth 1 "window" "sensorwidth horizontalaperture sensorwidthmm",
    SensorHeight 1 "window" "sensorheight verticalaperture sensorheightmm",
    SensorX 1 "c_x" "horizontalapertureoffset",
    SensorY 1 "c_y" "verticalapertureoffset",
    PixelWidth 1 "window" "",
    PixelHeight 1 "window" "",
    /// The program decides which side it spans.
    Fov 1 "theta" "fov fieldofview angle setfieldofview",
    AngleX 1 "theta" "fovh xfov fovx hfov cameraanglex horizontalfov",
    AngleY 1 "theta" "fovv camva yfov fovy vfov viewangle cameraviewangle setviewangle cameraangley fovdegrees verticalfov",
    FovAxis _ "theta" "fovaxis",
    Aspect 1 "A" "aspect aspectratio setaspectratio",
    Near 1 "F" "nearplanedistance nearclippingplane neardistance near znear nearclip nearclipplane clipstart clipnear minz setorthonearclipplane orthonearclipplane F",
    Far 1 "B" "farplanedistance farclippingplane fardistance far zfar farclip farclipplane clipend clipfar maxz setorthofarclipplane orthofarclipplane B",
    /// From the target, as in `VisIt`.
    NearOfTarget 1 "F" "nearplane",
    FarOfTarget 1 "B" "farplane",
    Left 1 "l" "left l",
    Right 1 "r" "right r",
    Bottom 1 "b" "bottom b",
    Top 1 "t" "top t",
    Height 1 "H" "orthoscale fixed.height",
    Width 1 "W" "setorthowidth orthowidth fixed.width",
    HalfHeight 1 "H" "parallelscale cameraparallelscale setparallelscale orthographicsize ymag",
    HalfWidth 1 "W" "xmag",
    WindowHeight 1 "H" "",
    OffsetX 1 "window" "",
    OffsetY 1 "window" "",
    /// Of the middle, in shares of the height.
    ShiftX 1 "window" "shiftx",
    ShiftY 1 "window" "shifty",
    /// Of the middle, in half windows.
    CenterX 1 "window" "",
    CenterY 1 "window" "",
    Zoom 1 "window" "zoom imagezoom",
    Pan 2 "window" "imagepan",
    FilmOffset 1 "window" "filmoffset",
    FilmGauge 1 "window" "filmgauge",
    PixelAspectX 1 "A" "pixelaspectx",
    PixelAspectY 1 "A" "pixelaspecty",
    ImageWidth 1 "m" "mcolorwidth imagewidth width w resolutionx resx imgwidth xresolution",
    ImageHeight 1 "n" "mcolorheight imageheight height h resolutiony resy imgheight yresolution",
    FullWidth 1 "window" "view.fullwidth",
    FullHeight 1 "window" "view.fullheight",
    CropX 1 "window" "view.offsetx roi.xoffset cropoffsetx",
    CropY 1 "window" "view.offsety roi.yoffset cropoffsety",
    CropWidth 1 "window" "view.width roi.width cropwidth",
    CropHeight 1 "window" "view.height roi.height cropheight",
    Crop _ "window" "view.enabled",
    BinningX 1 "window" "binningx",
    BinningY 1 "window" "binningy",
    /// Its length is that of the window in POV-Ray.
    Across 3 "W" "right",
    BoundsMin 3 "window" "boundingboxmin",
    BoundsMax 3 "window" "boundingboxmax",
    Parallel _ "projection" "orthographic parallelprojection cameraparallelprojection parallelprojectionon orthogonal isorthographic",
    Perspective _ "projection" "perspective",
    /// Of Godot: 1 is parallel, and a size is that of its window.
    Orthogonal 1 "projection" "projection",
    Extent 1 "H" "size",
    Baseline 1 "baseline" "baseline",
    Distortion _ "window" "distok1 distok3 distot2 distortioncoefficients distortion distortions distcoeffs distcoef distcoeff distortioncoeffs lensdistortion \
        dist d D coeffs conrady brown radialdistortion tangentialdistortion kc",
    Coefficient 1 "window" "k1 k2 k3 k4 k5 k6 p1 p2 p3 p4 b1 b2 omega sx1 sy1",
    /// The model of the lens, or the kind of projection.
    Model _ "projection" "polymorphicname cameramodel distortionmodel modeltype model type class projection mode setprojectionmode sensorfit fisheye isfisheye projectiontype",
    Name _ "name" "cameraname name imgname filepath filename label imagename def DEF",
    /// A part of the pose that is in a product.
    Part _ "M_v" "part",
    /// Above a camera.
    Scale 3 "window" "gltf.scale usd.scale collada.scale zup.scale",
    /// One number that says nothing of the image.
    Ignored 1 "window" "frames.rotation",
    /// It says nothing of the image.
    Skip _ "window" "version versionmajor versionminor sfmdataversion uuid id idview idintrinsic idpose key polymorphicid interval isloop \
        panel node layers mlocalscale generator metadata timestamp calibrationtime calibtime cornerdist nrofframes flags flagvalue avgreprojectionerror \
        rostopic camoverlaps timeshiftcamimu frameid seq stamp sec nanosec secs nsecs ndisp isint vmin vmax doffs focus parent current \
        boardwidth boardheight rootpath localpath caldatasource calibdatasource colmapimid sharpness aabbscale plyfilepath classname asset \
        scene scenes meshes materials accessors buffers bufferviews images textures samplers animations skins extensionsused structure \
        controlpoints geometries xmlns film sampler integrator pixelfilter colorspace option worldbegin description points2d cameraid imageid cameratype centerofrotation rotationfactor upaxis xformoporder \
        interactionmode imagezoomlocked masksource frametime enabled nextid nextgroupid sensorid resolution.id rectifiedsize \
        startframe endframe dorectify numberofelements index fstop shutteropen shutterclose focusdistance",
    /// Another sensor.
    NotCamera _ "window" "r0rect extrinsicparameters squaresize imagepoints trvelotocam trimutovelo trvelocam",
    Map9 9 "window" "rrect rectificationmatrix h H homography e E essential f F fundamental",
    Map12 12 "window" "tr Tr",
    Map16 16 "window" "q Q",
    /// No name of the table.
    Unknown 1 "window" "",
}

use Field as F;

impl Field {
    /// True if it's left out with all that is inside.
    pub(crate) const fn is_left_out(self) -> bool {
        matches!(self, Self::NotCamera | Self::Map9 | Self::Map12 | Self::Map16)
    }

    /// A part of a pose.
    pub(crate) const fn is_pose(self) -> bool {
        self as u8 <= Self::Chain as u8
    }

    /// A part without which a lens says nothing.
    pub(crate) const fn is_lens(self) -> bool {
        use Field::{AngleX, AngleY, Focal, FocalMm, Fov, Fx, HalfHeight, Height, K, K4, Left, WindowHeight};
        matches!(
            self,
            K | K4 | Fx | Focal | FocalMm | Fov | AngleX | AngleY | Left | Height | HalfHeight | WindowHeight
        )
    }
}

/// Names of several meanings in order.
#[rustfmt::skip]
const OF_SEVERAL: &[Row] = &[
    ("lookat lookatrh lookatlh glulookat lookatmat4 cameraposition", &[F::Eye, F::Target, F::Up]),
    ("lookat", &[F::Eye, F::Target]),
    ("frotator", &[F::Pitch, F::Yaw, F::Roll]),
    ("lookingat", &[F::Target, F::Up]),
    ("lookrotation makefromxz", &[F::Forward, F::Up]),
    ("intrinsics intrinsic", &[F::Fx, F::Fy, F::Cx, F::Cy]),
    ("f focal focallength", &[F::Fx, F::Fy]),
    ("p pp principalpoint centerpx", &[F::Cx, F::Cy]),
    ("sensor sensorsize", &[F::SensorWidth, F::SensorHeight]),
    ("pixelsizemm", &[F::PixelWidth, F::PixelHeight]),
    ("getprojectiontransformmatrix", &[F::Aspect, F::Ignored, F::Ignored]),
    ("setviewoffset", &[F::FullWidth, F::FullHeight, F::CropX, F::CropY, F::CropWidth, F::CropHeight]),
    ("format", &[F::ImageWidth, F::ImageHeight, F::Ignored]),
    ("clippingrange setclippingrange cameraclippingrange nearfar clipping", &[F::Near, F::Far]),
    ("perspective perspectiverhno perspectiverh gluperspective perspectivecamera", &[F::AngleY, F::Aspect, F::Near, F::Far]),
    ("perspectivefovlh perspectivefovrh xmmatrixperspectivefovlh xmmatrixperspectivefovrh", &[F::AngleY, F::Aspect, F::Near, F::Far]),
    ("pinhole", &[F::Fx, F::Fy, F::Cx, F::Cy, F::Coefficient, F::ImageWidth, F::ImageHeight]),
    ("setperspective", &[F::AngleY, F::Near, F::Far]),
    ("frustum frustumrhno frustumrh glfrustum", &[F::Left, F::Right, F::Bottom, F::Top, F::Near, F::Far]),
    ("makeperspective", &[F::Left, F::Right, F::Top, F::Bottom, F::Near, F::Far]),
    ("ortho orthorhno orthorh glortho orthographic", &[F::Parallel, F::Left, F::Right, F::Bottom, F::Top, F::Near, F::Far]),
    ("orthographiccamera makeorthographic", &[F::Parallel, F::Left, F::Right, F::Top, F::Bottom, F::Near, F::Far]),
    ("fovorthographiccameras.minx ortholeft", &[F::Parallel, F::Left]),
    ("fovorthographiccameras.maxx orthoright", &[F::Parallel, F::Right]),
    ("fovorthographiccameras.miny orthobottom", &[F::Parallel, F::Bottom]),
    ("fovorthographiccameras.maxy orthotop", &[F::Parallel, F::Top]),
    ("setfrustum", &[F::WindowHeight, F::OffsetX, F::OffsetY, F::Near, F::Far]),
    ("setorthogonal", &[F::Parallel, F::Height, F::Near, F::Far]),
    ("setwindowcenter windowcenter", &[F::CenterX, F::CenterY]),
    ("windowsize resolution size imagesize srect s viewportpx imsize imgsize imageresolution", &[F::ImageWidth, F::ImageHeight]),
    ("perspectivecameras.imagesize orthographiccameras.imagesize", &[F::ImageHeight, F::ImageWidth]),
];

/// Names, and the meanings of their numbers.
type Row = (&'static str, &'static [Field]);

/// The rows of each last part of a name.
static TABLE: LazyLock<HashMap<&str, Vec<Row>>> = LazyLock::new(|| {
    let mut table: HashMap<&str, Vec<Row>> = HashMap::new();
    for (names, fields) in OF_ONE.iter().chain(OF_SEVERAL) {
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
            [F::Parallel | F::Perspective | F::Crop] => count < 2 && !is_inner,
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

/// A word, and the reading that it means. `None` leaves a part of it open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Word {
    pub(crate) word: &'static str,
    pub(crate) kind: Option<MatrixKind>,
    pub(crate) axes: Option<Axes>,
    pub(crate) order: Option<Order>,
    /// Other things have this name too, so it refuses nothing.
    pub(crate) is_weak: bool,
}

impl Word {
    /// A word that leaves nothing open.
    pub(crate) const fn full(word: &'static str, kind: MatrixKind, axes: Axes, order: Order) -> Self {
        Self { order: Some(order), ..with_axes(word, kind, axes) }
    }

    /// True if it means a reading in each of its parts.
    pub(crate) fn means(&self, reading: &Reading, order: Order) -> bool {
        self.kind.is_none_or(|kind| kind == reading.kind)
            && self.axes.is_none_or(|axes| axes == reading.axes)
            && self.order.is_none_or(|own| own == order)
    }
}

const fn row(word: &'static str, kind: MatrixKind) -> Word {
    Word { word, kind: Some(kind), axes: None, order: None, is_weak: false }
}

const fn with_axes(word: &'static str, kind: MatrixKind, axes: Axes) -> Word {
    Word { axes: Some(axes), ..row(word, kind) }
}

/// Without regard to capitals and underscores. A word stands before the shorter ones that it contains.
const WORDS: [Word; 43] = [
    Word { is_weak: true, ..row("camerapose", MatrixKind::CameraToWorld) },
    row("worldviewproj", MatrixKind::ViewProjection),
    row("modelviewproj", MatrixKind::ViewProjection),
    row("viewproj", MatrixKind::ViewProjection),
    with_axes("fullprojtransform", MatrixKind::ViewProjection, Axes::OPENCV),
    with_axes("matrixworldinverse", MatrixKind::View, Axes::OPENGL),
    with_axes("worldtocameramatrix", MatrixKind::View, Axes::UNITY),
    with_axes("cameratoworldmatrix", MatrixKind::CameraToWorld, Axes::UNITY),
    with_axes("localtoworldmatrix", MatrixKind::CameraToWorld, Axes::DIRECT3D),
    with_axes("matrixworld", MatrixKind::CameraToWorld, Axes::OPENGL),
    Word::full("transformmatrix", MatrixKind::CameraToWorld, Axes::BLENDER, Order::Rows),
    with_axes("extrinsic", MatrixKind::View, Axes::OPENCV),
    with_axes("worldviewtransform", MatrixKind::View, Axes::OPENCV),
    // Godot: the order of its numbers depends on how they're written.
    with_axes("transform3d", MatrixKind::CameraToWorld, Axes::OPENGL),
    row("toworld", MatrixKind::CameraToWorld),
    Word::full("tcamimu", MatrixKind::View, Axes::OPENCV, Order::Rows),
    Word::full("tcambody", MatrixKind::View, Axes::OPENCV, Order::Rows),
    Word::full("timucam", MatrixKind::CameraToWorld, Axes::OPENCV, Order::Rows),
    Word::full("tbs", MatrixKind::CameraToWorld, Axes::OPENCV, Order::Rows),
    row("tcamworld", MatrixKind::View),
    row("tworldcam", MatrixKind::CameraToWorld),
    with_axes("cameratransform", MatrixKind::CameraToWorld, Axes::OPENGL),
    row("viewmatrix", MatrixKind::View),
    row("viewmat", MatrixKind::View),
    row("viewtransform", MatrixKind::View),
    row("modelview", MatrixKind::View),
    row("worldtocam", MatrixKind::View),
    row("world2cam", MatrixKind::View),
    row("w2c", MatrixKind::View),
    row("tcw", MatrixKind::View),
    row("cameratoworld", MatrixKind::CameraToWorld),
    row("camtoworld", MatrixKind::CameraToWorld),
    row("cam2world", MatrixKind::CameraToWorld),
    row("c2w", MatrixKind::CameraToWorld),
    row("twc", MatrixKind::CameraToWorld),
    row("projection", MatrixKind::Projection),
    row("perspective", MatrixKind::Projection),
    row("projmat", MatrixKind::Projection),
    row("projmatrix", MatrixKind::Projection),
    row("intrinsic", MatrixKind::Intrinsics),
    row("cameramatrix", MatrixKind::Intrinsics),
    row("cameraposition", MatrixKind::LookAt),
    // Files of glTF and three.js: sixteen numbers by columns, of a node.
    Word { is_weak: true, ..Word::full("\"matrix\":", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Columns) },
];

/// Names of matrices that say all of them. A longer path ends in one.
const NAMES: [Word; 12] = [
    Word::full("zup.matrix", MatrixKind::CameraToWorld, Axes::BLENDER, Order::Rows),
    Word::full("usd.matrix", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Rows),
    Word::full("collada.matrix", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Rows),
    Word::full("pbrt.view", MatrixKind::View, Axes::DIRECT3D, Order::Rows),
    Word::full("mirrored.view", MatrixKind::View, Axes::OPENGL, Order::Rows),
    Word::full("gltf.matrix", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Rows),
    Word::full("three.js.matrix", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Rows),
    Word::full("open3d.pose", MatrixKind::CameraToWorld, Axes::OPENCV, Order::Rows),
    Word::full("metashape.transform", MatrixKind::CameraToWorld, Axes::OPENCV, Order::Rows),
    Word { is_weak: true, ..row("transform", MatrixKind::CameraToWorld) },
    Word { is_weak: true, ..row("pose", MatrixKind::CameraToWorld) },
    Word { is_weak: true, ..Word::full("matrix", MatrixKind::CameraToWorld, Axes::OPENGL, Order::Columns) },
];

/// The word that a name in plain letters is.
pub(crate) fn of_name(path: &str) -> Option<Word> {
    let last = path.rsplit('.').next().unwrap_or(path);
    let is_end = |row: &&Word| path.strip_suffix(row.word).is_some_and(|rest| rest.is_empty() || rest.ends_with('.'));
    let contained = || WORDS.iter().find(|row| last.contains(row.word));
    NAMES.iter().find(is_end).or_else(contained).copied()
}

/// The word of a text that says which matrix it is.
pub(crate) fn find(text: &str) -> Option<Word> {
    let plain: String = text.to_lowercase().chars().filter(|c| !c.is_whitespace() && *c != '_').collect();
    // `matrix_world` is Blender's, `matrixWorld` that of three.js.
    if text.contains("matrix_world") {
        return Some(with_axes("matrix_world", MatrixKind::CameraToWorld, Axes::BLENDER));
    }
    // The columns of glam have names.
    if text.contains("x_axis") {
        let word = WORDS.into_iter().find(|row| plain.contains(row.word));
        let open = Word { word: "x_axis", kind: None, axes: None, order: None, is_weak: false };
        return Some(Word { order: Some(Order::Columns), ..word.unwrap_or(open) });
    }
    WORDS.into_iter().find(|row| plain.contains(row.word))
}
