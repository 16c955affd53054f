//! Limits: each one once, with its reason.

use std::ops::RangeInclusive;

/// The longest side of a picture in pixels. The rasterizer counts in 1/256 of a pixel, and has room for this and a
/// border.
pub const MAX_SIDE: u32 = 16_384;

/// The most pixels of a picture: 15360 × 8640, with a little room.
pub const MAX_PIXELS: u64 = 1 << 27;

/// The most pixels of a picture on the clipboard: 128 MiB there, and as much again in each program that takes it.
pub const MAX_COPIED_PIXELS: u64 = 1 << 25;

/// The sides of a picture on paper, in centimetres: from a mark in the margin to the wall of a lecture hall.
pub const PAPER_CM: RangeInclusive<f64> = 0.1..=1000.0;

/// Pixels per inch of paper: from the wall of a lecture hall to the films that printers expose, with a little room.
pub const PAPER_DPI: RangeInclusive<f64> = 1.0..=10_000.0;

/// The height of letters on paper, in points. Smaller ones leave no ink, and larger ones (35 cm) aren't names in a
/// picture.
pub const PAPER_LETTERS: RangeInclusive<f64> = 0.5..=1000.0;

/// The width of lines on paper, in points: beyond the finest line of printers, and up to one that covers a picture.
pub const PAPER_LINES: RangeInclusive<f64> = 0.01..=100.0;

/// The factor of pictures, strokes and letters: from a stamp to sixteen screens.
pub const SCALE: RangeInclusive<f64> = 0.1..=16.0;

/// The most pictures of a family. A sheet of paper with eight by eight of them has the size of stamps.
pub const MAX_FAMILY: usize = 64;

/// The most pictures of an animation of a family: a minute of them.
pub const MAX_FRAMES: usize = 1200;

/// The duration of a step of an animation, in seconds. Shorter ones can't be followed, and longer ones take more
/// pictures than a file has use for.
pub const STEP_SECONDS: RangeInclusive<f64> = 0.1..=60.0;

/// The time that `accuracy` spends on measuring, in seconds: an hour. 0 leaves the times out.
pub const MEASURED_SECONDS: RangeInclusive<f64> = 0.0..=3600.0;

/// The greatest distance of the corner of a viewport outside the image, in pixels: twice the longest side.
pub const MAX_OFFSET: i64 = 2 * MAX_SIDE as i64;

/// The fewest segments of a curved shape: a triangle.
pub const MIN_SEGMENTS: u32 = 3;

/// The most segments of a curved shape: half a million triangles for a sphere.
pub const MAX_SEGMENTS: u32 = 512;

/// Default segments of a curved shape: at usual sizes it looks round.
pub const DEFAULT_SEGMENTS: u32 = 32;

/// The most meridians that a curved shape names as edges: with more, the wireframe of a sphere is no longer legible.
pub const MAX_MERIDIANS: u32 = 16;

/// No mesh has more vertices than this. They are counted with 32 bits, with room for those that cutting makes.
pub const MAX_VERTICES: usize = 1 << 31;

/// The most objects of a scene, the parts of its meshes included. They take about a gigabyte and some seconds to be
/// drawn, and a mesh file can begin one with each face.
pub const MAX_OBJECTS: usize = 1 << 17;

/// The most steps of cutting the concave polygons of a mesh file into triangles, each a corner compared with an ear: a
/// second. A polygon takes about the square of its corners, so that one of 10 000 is still cut right.
pub const MAX_EAR_STEPS: usize = 1 << 28;

/// The most lights of a scene. Each is computed at each pixel, and more than a few can hardly be distinguished.
pub const MAX_LIGHTS: usize = 1024;

/// The most texels of all shadow maps of a scene: half a gigabyte of depths, which all its pictures share. A lamp has
/// six maps.
pub const MAX_SHADOW_TEXELS: u64 = 1 << 27;

/// The most named points of a figure. More names and rays can hardly be distinguished in a picture.
pub const MAX_NAMED_POINTS: usize = 32;

/// The most cameras of a figure besides its own. More volumes can hardly be distinguished in a picture.
pub const MAX_CAMERAS: usize = 32;

/// The longest name of a camera in characters. It's a label in the world.
pub const MAX_CAMERA_NAME: usize = 60;

/// The most notes of a figure, and the most labels that it hides, renames, moves or styles. A picture has no room for
/// more.
pub const MAX_LABELS: usize = 256;

/// The longest text of a label and the longest name of one, in characters: a line across a picture.
pub const MAX_LABEL_TEXT: usize = 120;

/// The greatest distance of a label from its point, to the side and upwards, in heights of its type: from one end of a
/// large picture to the other.
pub const MAX_LABEL_MOVE: f64 = 1000.0;

/// The factor of a label's size: from hardly legible to a title.
pub const LABEL_SIZE: RangeInclusive<f64> = 0.25..=8.0;

/// The longest title of a figure in characters: a line of a slide.
pub const MAX_TITLE: usize = 120;

/// The longest caption of a figure in characters: a paragraph under a picture.
pub const MAX_CAPTION: usize = 600;

/// The most objects whose place by a list of transforms a figure shows (`[[show.moved]]`). More axes can hardly be
/// distinguished.
pub const MAX_SHOWN_OBJECTS: usize = 32;

/// The most keys and operations of a comparison: all of a camera, and a few more that the headings name.
pub const MAX_COMPARED_KEYS: usize = 16;

/// The longest figure file in bytes: a hundred times the largest that people write.
pub const MAX_FIGURE_BYTES: usize = 8 << 20;

/// The longest file with cameras of other programs in bytes: more than the poses of a thousand photographs. In memory
/// JSON is sixty times as large. Of a GLB file, its JSON alone.
pub const MAX_CAMERA_FILE_BYTES: u64 = 8 << 20;

/// The most bytes of files that a picture carries for its figure, when they are packed: a mesh of some ten thousand
/// triangles with a texture. Larger ones make the picture too heavy for mail and for a page.
pub const MAX_CARRIED_BYTES: usize = 1 << 20;
/// The files of a page that's handed out, or of a link, packed. The page finds them in its address, of which Firefox
/// takes 1 MiB, and they're a third longer there.
pub const MAX_HANDED_OUT_BYTES: usize = 640 << 10;

/// The longest file of preferences or of progress with exercises in bytes. Both take some kilobytes.
pub const MAX_KEPT_BYTES: u64 = 8 << 20;

/// The longest session file in bytes: the text of a figure twice, with characters that JSON writes longer.
pub const MAX_SESSION_BYTES: u64 = 8 * MAX_FIGURE_BYTES as u64;

/// The longest link to a figure: browsers take more, but mail, chat and learning platforms cut longer ones.
pub const MAX_LINK_CHARACTERS: usize = 8000;

/// The longest file of any kind in bytes: more than any picture or mesh that can be shown.
pub const MAX_FILE_BYTES: u64 = 1 << 30;

/// The most bytes that a figure makes the program read, meshes and the files they name together: some five million
/// triangles as text. In memory a mesh is several times as large.
pub const MAX_SCENE_BYTES: usize = 512 << 20;

/// The longest side of a texture in texels.
pub const MAX_TEXTURE_SIDE: u32 = 16_384;

/// The most texels of a texture, and of all textures of a scene together: 4096 × 4096, which take 90 MB with their
/// levels of detail, and 270 if a filter mixes two of these, for which they are laid out once more.
pub const MAX_TEXELS: u64 = 1 << 24;

/// The most pixels of a picture that is halved while it's read, so that it has no more than [`MAX_TEXELS`]: unpacked,
/// its 3 bytes a pixel take 200 MB for a moment. Other kinds unpack to more, or hold as much again while they're read.
pub const MAX_HALVED_TEXELS: u64 = 4 * MAX_TEXELS;

/// The most bytes that a texture's file may unpack beside its texels, such as a color profile. A real one takes at most
/// some megabytes.
pub const MAX_TEXTURE_METADATA: u64 = 16 << 20;

/// The most repetitions of a texture on a surface. Beyond these nothing is left of it.
pub const MAX_TEXTURE_SCALE: f64 = 10_000.0;

/// The most items of sparse accessors that are 0 because no bytes are behind them. A line of JSON can ask for billions.
pub const MAX_ZEROS: usize = 1 << 20;

/// The most pieces into which faces are split to be sorted: crossing faces make pieces by the cube of their number.
/// This number takes more than a second and 260 MiB. 400 plates that all cross would take eight million, half a minute
/// and 5 GiB.
pub const MAX_PIECES: usize = 1 << 19;

/// The most bytes that the corners of these pieces take. The corners of a piece have no bound.
pub const MAX_PIECE_BYTES: usize = 256 << 20;

/// The most steps in which strokes are compared with faces and one another, for outputs without a depth buffer. They
/// take some seconds. A stored result counts as several steps, so that memory stays below some hundred MiB.
pub const MAX_STROKE_STEPS: usize = 1 << 28;

/// The longest expression in characters, and how deep its parentheses may be nested: more than people type. Deeper ones
/// would need more of the stack.
pub const MAX_EXPRESSION: (usize, u32) = (500, 60);

/// The most characters of a name, a colour or words to look for that you can type: more than a picture or a list has
/// room for.
pub const MAX_TYPED_NAME: usize = 200;

/// The most characters of a path or an address that you can type: Windows' longest path, four times the longest link.
pub const MAX_TYPED: usize = 1 << 15;

/// The longest formula of a text in characters, and the greatest depth of its pairs: more than fits on a line, and less
/// than the stack of the typesetter.
pub const MAX_FORMULA: (usize, usize) = (1000, 30);

/// The longest answer to an exercise in bytes. A matrix of roots takes a few hundred.
pub const MAX_ANSWER: usize = 10_000;

/// The longest file of an exercise of one's own in bytes. A figure with a scene takes some kilobytes.
pub const MAX_EXERCISE_BYTES: usize = 1 << 20;

/// The most exercises in a folder. All are read when the folder is. A lecture has a few dozen.
pub const MAX_OWN_EXERCISES: usize = 256;

/// The most questions of one exercise. They are lettered from a to z.
pub const MAX_ASKS: usize = 26;

/// The longest identifier of an exercise or of a question, in characters. It's part of a command line.
pub const MAX_EXERCISE_NAME: usize = 64;

/// The most undo steps, more than people go back.
pub const MAX_UNDO_STEPS: usize = 500;

/// The most bytes of scenes that undo stores besides the current one: several steps of the largest figures, all steps
/// of usual ones. One step is stored however large it is.
pub const MAX_UNDO_BYTES: usize = 64 << 20;

/// The longest list of points that the panel shows as fields. Longer ones are edited in the file.
pub const MAX_POINTS_IN_PANEL: usize = 48;

/// The most lines that are shown if two texts are compared, more than people read.
pub const MAX_COMPARED_LINES: usize = 2000;

/// The most stored sessions of windows, including those that didn't close. More than people open at once.
pub const MAX_SESSIONS: usize = 16;

/// In larger images the pixels of a single triangle aren't looked at, because that's done while the window waits.
pub const MAX_STEPPED_PIXELS: u64 = 1 << 22;

/// In scenes of more triangles shadow maps aren't compared with rays. The tree over them takes some 250 MB.
pub const MAX_RAY_TRIANGLES: usize = 1 << 21;

/// Steps of a lesson: more than fit into an hour.
pub const MAX_LESSON_STEPS: usize = 100;

/// Conditions of one goal of a lesson. Each may draw the image.
pub const MAX_CONDITIONS: usize = 64;

/// Bytes of a lesson file: a hundred steps with their texts and figures.
pub const MAX_LESSON_BYTES: usize = 4 << 20;
