//! The world: the scene, the camera in it, and the camera's view volume.

pub(super) mod camera_gizmo;
pub(super) mod cameras;
pub(super) mod components;
pub(super) mod dimensions;
pub(super) mod framing;
pub(super) mod ghost;
pub(super) mod gizmos;
pub(super) mod object_parts;
pub(super) mod section;
pub(super) mod transform_preview;
pub(super) mod volume;
pub(super) mod world_framing;

use std::borrow::Cow;
use std::sync::Arc;

use glam::{DMat4, DVec2, DVec3};

use crate::appearance::{Dash, HiddenLines, MarkShape, Rgba, Role, Texture};
use crate::camera::{ParameterKey, Projection};
use crate::figure::WorldPart;
use crate::inspect::quantity::Quantity;
use crate::pipeline::{Frame, Scenes};
use crate::sanitize;
use crate::scene::{Line, Mesh, Object, ObjectPaint, Pictured, Scene};

use super::pixels::PixelRect;
use super::timed_pipeline::TimedPipeline;
use super::{Handle, Palette, Request, View};
use crate::views::image::{light_view, vanishing};
use crate::views::interact::{handles, hits, transform_gizmo};
use crate::views::reveal::revealed_scene::PipelineReveal;
use crate::views::reveal::{probe, revealed_scene, triangle_overlay};
use crate::views::screen::Screen;
use crate::views::words::label_layout::{Author, Rules};
use crate::views::words::{author_labels, label_layout};
use crate::views::world::camera_gizmo::GizmoSizes;
use crate::views::world::framing::Content;
use crate::views::world::gizmos::{AnnotationBuilder, SMALL_TYPE, TYPE};
use crate::views::world::world_framing::{screen_of, seen_from};

impl Request {
    /// False if the view window shows no image, so that none has to be drawn for it.
    pub(crate) fn shows_image_on_window(&self) -> bool {
        let look = &self.shot.look.world;
        // The image on a window that's drawn narrower isn't to scale.
        let is_to_scale = || Content::of(self).volume.narrowed == [1.0; 2];
        self.view == View::World
            && !look.section
            && look.parts.has(WorldPart::Window)
            && look.window_opacity.map_or_else(is_to_scale, |opacity| opacity > 0.0)
    }
}

/// Draws the world with `on_window` as the image on the view window. An observer that isn't a camera sees nothing.
pub(super) fn frame_of(request: &Request, on_window: Option<&Arc<Texture>>, pipeline: &mut TimedPipeline) -> Frame {
    let style = &request.shot.look.style;
    let palette = Palette::of(style.theme);
    let target = request.size.target(palette.paper);
    let content = Content::of(request);
    let Some(screen) = screen_of(request, &seen_from(request), &content) else {
        return pipeline.frame(request, &Scene::default(), &request.camera, target, style, |_, _| {});
    };
    let mut world = World::new(request, palette, content, &screen, on_window);
    let (scene, style) = gizmos::wired(std::mem::take(&mut world.revealed.scene), style);
    let layers = if request.shot.look.world.section { LAYERS_OF_SECTION } else { LAYERS };
    layers.concat().into_iter().for_each(|add| add(&mut world));
    let World { mut revealed, builder, .. } = world;
    let lights = light_view::lights(request, &scene);
    let scenes = Scenes::new(&scene, &builder.gear)
        .with_fineness(screen.fineness(request, |p| screen.place(p)))
        .in_shadows_of(&request.scene)
        .lit_by(&lights);
    let mut drawn = pipeline.frame(request, scenes, screen.camera(), target, &style, |_, _| {});
    revealed.rows.extend(revealed_scene::drawn_rows(&drawn, request, palette));
    let legend = revealed_scene::legend(request, revealed.rows, PixelRect::whole(request.size), target.scale, palette);
    let rules = Rules {
        reserved: revealed_scene::room(legend.as_ref()),
        leader: Some((palette.soft, 0.8 * request.size.scale)),
        author: Some(Author::of(request, palette)),
    };
    author_labels::add_notes(&mut drawn.drawing, request, DVec2::ZERO, Some(&screen));
    label_layout::settle(&mut drawn.drawing, &rules);
    revealed_scene::explain(&mut drawn, request, legend.as_ref());
    drawn
}

/// A part of the picture, added to it.
type Layer = fn(&mut World<'_>);

/// The layers of the world. Of two at the same depth, the later one is over the earlier, and of two texts of the same
/// role and size, the earlier one chooses its place first.
const LAYERS: [&[Layer]; 3] = [
    &[
        |w| w.ground(),
        |w| w.volume(),
        |w| w.window(),
        |w| w.camera(),
        |w| w.aim(),
        |w| w.planes(),
        |w| w.axes(),
        |w| w.drop_lines(),
        |w| cameras::in_world(&mut w.builder, w.request, w.palette, &w.content.others),
        |w| w.unnamed(),
        |w| w.speck(),
        |w| dimensions::in_world(&mut w.builder, w.request, w.palette, &w.content.volume, w.gear),
        |w| components::in_world(&mut w.builder, w.request, w.palette, &w.content.volume, w.gear),
        |w| object_parts::in_world(&mut w.builder, w.request, w.palette),
    ],
    &CHANGES,
    &[
        |w| probe::in_world(&mut w.builder, w.request, w.palette, &w.content.volume),
        |w| vanishing::in_world(&mut w.builder, w.request, w.palette),
        |w| triangle_overlay::in_world(&mut w.builder, w.request, w.palette),
        |w| transform_gizmo::in_world(&mut w.builder, w.request, w.palette),
        |w| light_view::in_world(&mut w.builder, w.request, w.palette),
    ],
];

/// Those of the section along **u**, as lines alone, without the scene.
const LAYERS_OF_SECTION: [&[Layer]; 3] = [
    &[
        |w| section::draw(&mut w.builder, w.request, w.palette, &w.content),
        |w| w.camera(),
        |w| w.aim(),
        |w| w.unnamed(),
    ],
    &CHANGES,
    &[|w| light_view::in_world(&mut w.builder, w.request, w.palette)],
];

/// The marks of a change, before it's made and after it.
const CHANGES: [Layer; 4] = [
    |w| w.hot_handle(),
    |w| ghost::in_world(&mut w.builder, w.request, w.palette, w.gear),
    |w| transform_preview::in_world(&mut w.builder, w.request, w.palette),
    |w| w.revealed.mark(&mut w.builder, w.palette),
];

/// Greatest number of faces to test for hiding a corner.
const MOST_FACES: usize = 200_000;

/// The picture in the making.
struct World<'a> {
    request: &'a Request,
    on_window: Option<&'a Arc<Texture>>,
    palette: Palette,
    content: Content,
    gear: GizmoSizes,
    builder: AnnotationBuilder<'a>,
    revealed: PipelineReveal<'a>,
}

impl<'a> World<'a> {
    fn new(
        request: &'a Request,
        palette: Palette,
        content: Content,
        screen: &'a Screen,
        on_window: Option<&'a Arc<Texture>>,
    ) -> Self {
        let look = &request.shot.look.world;
        let revealed = if look.section {
            PipelineReveal::plain(Cow::default())
        } else {
            revealed_scene::in_world(request, palette)
        };
        let gear = GizmoSizes::new(screen, &request.camera, look);
        Self { request, on_window, palette, content, gear, builder: AnnotationBuilder::new(screen), revealed }
    }

    fn has(&self, part: WorldPart) -> bool {
        self.request.shot.look.world.parts.has(part)
    }

    /// Removes the names drawn so far, if the figure has no names.
    fn unnamed(&mut self) {
        if !self.has(WorldPart::Names) {
            self.builder.gear.texts.clear();
        }
    }

    /// The grid on y = 0.
    fn ground(&mut self) {
        let Some(ground) = self.content.ground().filter(|_| self.has(WorldPart::Grid)) else { return };
        let style = gizmos::stroke(self.palette.grid, 1.0, Dash::Solid, HiddenLines::Hidden);
        self.builder
            .gear
            .lines
            .extend(ground.lines().iter().map(|ends| Line { role: Role::Ground, ..Line::new(ends.to_vec(), style) }));
    }

    /// The view volume, from the corners that the matrices in use give.
    fn volume(&mut self) {
        if !self.has(WorldPart::Volume) {
            return;
        }
        let (volume, color) = (self.content.volume, self.palette.volume_edge);
        self.builder.volume("volume", &volume, [color, self.palette.volume], 1.3);
        self.face(&volume.far_face(), color, 1.5, Dash::Dashed);
    }

    /// The sides of the window or of the far face. They're broken if they're longer than drawn.
    fn face(&mut self, corners: &[DVec3; 4], color: Rgba, width: f32, dash: Dash) {
        const GAPS: [[f64; 2]; 2] = [[0.11, 0.14], [0.86, 0.89]];
        let volume = self.content.volume;
        if !volume.is_narrowed(0) && !volume.is_narrowed(1) {
            return self.builder.closed(corners, color, width, dash);
        }
        for side in 0..4 {
            let (a, b) = (corners[side], corners[(side + 1) % 4]);
            if !volume.is_narrowed(side % 2) {
                self.builder.line(vec![a, b], color, width, dash);
                continue;
            }
            let [first, last] = GAPS.map(|gap| gap.map(|t| a.lerp(b, t)));
            for ends in [[a, first[0]], [first[1], last[0]], [last[1], b]] {
                self.builder.line(ends.to_vec(), color, width, dash);
            }
            for [from, to] in [first, last] {
                self.builder.breaks(from, to, color);
            }
        }
    }

    /// The window at distance F, with the image on it, and the rays through its corners.
    fn window(&mut self) {
        if !self.has(WorldPart::Window) {
            return;
        }
        let camera = &self.request.camera;
        let volume = self.content.volume;
        let (near, color) = (volume.window(), self.palette.volume_edge);
        if camera.projection() == Projection::Perspective {
            for part in volume.parts_before() {
                self.builder.edges(&volume, part, color, 1.0);
            }
            self.builder.gap(&volume, volume.before, color);
        }
        match self.on_window {
            Some(image) => {
                let look = &self.request.shot.look.world;
                let opacity = look.window_opacity.unwrap_or_else(|| self.unobtrusive());
                if self.request.shows_image_on_window() && opacity > 0.0 {
                    self.builder.gear.objects.push(painted(near, image, opacity));
                }
            }
            None => self.builder.sheer("window", &[near], self.palette.volume),
        }
        self.face(&near, self.palette.ink, 2.0, Dash::Solid);
    }

    /// Opacity of the image on the window that doesn't hide the scene. It's full as long as it covers little of it, and
    /// fades the more it covers.
    fn unobtrusive(&self) -> f64 {
        const LITTLE: f64 = 0.12;
        const MUCH: f64 = 0.45;
        const FAINTEST: f64 = 0.3;
        // A window this many times as large as everything else is a wall without a picture.
        const LARGE: f64 = 2.0;
        const WALL: f64 = 6.0;
        let Some(bounds) = self.request.scene.bounds() else { return 1.0 };
        let (window, eye) = (self.request.camera.window(), self.builder.screen.camera());
        let camera = &self.request.camera;
        let covers = |p: DVec3| {
            let towards = match eye.projection() {
                Projection::Perspective => eye.position() - p,
                Projection::Parallel => eye.basis().n * (eye.far() - eye.near()),
            };
            let (a, b) = (camera.view_point(p).z + camera.near(), camera.view_point(p + towards).z + camera.near());
            if a * b >= 0.0 {
                return false;
            }
            let crossing = camera.view_point(p + towards * (a / (a - b)));
            (window.left..=window.right).contains(&crossing.x) && (window.bottom..=window.top).contains(&crossing.y)
        };
        const STEPS: u32 = 4;
        let stops = || (0..=STEPS).map(|i| f64::from(i) / f64::from(STEPS));
        let grid = stops().flat_map(|x| stops().flat_map(move |y| stops().map(move |z| DVec3::new(x, y, z))));
        let (mut hidden, mut all) = (0.0, 0.0);
        for share in grid {
            all += 1.0;
            hidden += f64::from(u8::from(covers(bounds.min + (bounds.max - bounds.min) * share)));
        }
        let share = ((hidden / all - LITTLE) / (MUCH - LITTLE)).clamp(0.0, 1.0);
        let size = window.width().hypot(window.height()) / (2.0 * self.content.radius());
        let wall = ((size - LARGE) / (WALL - LARGE)).clamp(0.0, 1.0);
        1.0 - (1.0 - FAINTEST * (1.0 - wall)) * share
    }

    /// The names of window and far face.
    fn planes(&mut self) {
        let (labels, volume) = (self.request.labels, self.content.volume);
        let window = match volume.before {
            None => format!("{} (F)", labels.window),
            Some(_) => format!(
                "{} (F = {})",
                labels.window,
                self.request.number(Quantity::Camera(ParameterKey::Near), self.request.camera.near())
            ),
        };
        let far = match volume.gap.or(volume.before) {
            None => format!("{} (B)", labels.far),
            Some(_) => format!(
                "{} (B = {})",
                labels.far,
                self.request.number(Quantity::Camera(ParameterKey::Far), self.request.camera.far())
            ),
        };
        for (part, role, name, face, text) in [
            (WorldPart::Window, Role::Window, "window", volume.window(), &window),
            (WorldPart::Volume, Role::FarFace, "far", volume.far_face(), &far),
        ] {
            if self.has(part) {
                self.name_face(role, name, &face, text);
            }
        }
    }

    /// Writes a face's name at the uppermost of its visible corners, unless the face is too small to be distinguished
    /// from a point.
    fn name_face(&mut self, role: Role, name: &str, face: &[DVec3; 4], text: &str) {
        let screen = self.builder.screen;
        let Some(middle) = screen.place(face.iter().sum::<DVec3>() / 4.0) else { return };
        let in_frame = face.iter().filter_map(|p| Some((*p, screen.place_inside(*p)?)));
        let mut corners: Vec<_> = in_frame.collect();
        let reach = corners.iter().map(|(_, px)| px.distance(middle)).fold(0.0, f64::max);
        if reach < 4.0 * screen.scale {
            return;
        }
        corners.sort_by(|a, b| a.1.y.total_cmp(&b.1.y));
        // With very many faces, testing which hides the corner would take longer than the picture.
        let faces: usize = self.request.scene.objects.iter().map(|o| o.mesh.triangles.len()).sum();
        let seen = |p: DVec3| faces > MOST_FACES || hits::can_be_seen(p, &self.request.scene, screen.camera());
        if let Some((corner, px)) = corners.into_iter().find(|(p, _)| seen(*p)) {
            self.builder.role = role;
            self.builder.named(name, corner, text, px - middle, SMALL_TYPE, self.palette.ink);
        }
    }

    /// The camera's body at C, and its VRC.
    fn camera(&mut self) {
        let camera = &self.request.camera;
        let (c, basis, gear) = (camera.position(), camera.basis(), self.gear);
        if self.has(WorldPart::CameraBody) {
            let colors = [self.palette.body_edge, self.palette.body];
            self.builder.camera_body("camera", camera, gear.body, colors);
        }
        self.builder.mark_above(c, MarkShape::Disc, 2.4, self.palette.ink);
        let screen = self.builder.screen;
        let crowd = screen.heading(c, basis.u) + screen.heading(c, basis.v) + screen.heading(c, basis.n);
        let name = self.request.shot.camera_name.as_ref();
        let text = name.map_or_else(|| "C".to_owned(), |name| format!("C ({})", sanitize::escaped(name)));
        self.builder.role = Role::Center;
        self.builder.named("C", c, &text, -crowd, TYPE, self.palette.ink);
        if self.has(WorldPart::Vrc) {
            for ((k, axis, name), color) in basis.named().into_iter().zip(self.palette.axes) {
                self.builder.axis(k, c, axis * gear.axis, (color, 2.0), name);
            }
        }
        if self.has(WorldPart::ViewUp) {
            let tip = gear.view_up_tip(camera);
            self.builder.arrow(vec![c, tip], self.palette.view_up, 1.8, Dash::Dashed);
            self.builder.role = Role::ViewUp;
            self.builder.text(tip, "VUP", screen.heading(c, tip - c), TYPE, self.palette.view_up);
        }
    }

    /// PF, and DOP from C towards it.
    fn aim(&mut self) {
        if self.has(WorldPart::FocalPoint) {
            self.focal_point();
        }
        if self.has(WorldPart::Dop) {
            self.dop();
        }
        if self.has(WorldPart::Volume) {
            let c = self.request.camera.position();
            for (handle, place) in handles::on_axis(self.request, self.builder.screen, &self.content.volume, 0.0) {
                if handle != Handle::Near || place.distance(c) > 0.3 * self.gear.usual_axis {
                    self.builder.mark(place, MarkShape::Square, 2.6, self.palette.volume_edge);
                }
            }
        }
    }

    fn focal_point(&mut self) {
        let (c, pf) = (self.request.camera.position(), self.request.camera.focal_point());
        self.builder.line(vec![c, pf], self.palette.aim, 1.1, Dash::DashDot);
        self.builder.mark(pf, MarkShape::Diamond, 5.0, self.palette.aim);
        self.builder.role = Role::FocalPoint;
        self.builder.text(pf, "PF", DVec2::new(0.7, 0.7), TYPE, self.palette.aim);
    }

    /// DOP at C, and its axis through the volume behind PF.
    fn dop(&mut self) {
        let camera = &self.request.camera;
        let (c, dop) = (camera.position(), camera.direction_of_projection());
        let volume = self.content.volume;
        let before = volume.before.map_or_else(Vec::new, |_| volume.parts_before());
        for [from, to] in before.into_iter().chain(volume.parts()) {
            let from = from.max(camera.distance());
            if from < to {
                self.builder.line(vec![c + dop * from, c + dop * to], self.palette.soft, 0.8, Dash::DashDot);
            }
        }
        for [from, to] in volume.before.into_iter().chain(volume.gap) {
            self.builder.breaks(c + dop * from, c + dop * to, self.palette.soft);
        }
        let length = (1.2 * self.gear.axis).min(0.8 * camera.distance());
        self.builder.arrow(vec![c, c + dop * length], self.palette.aim, 1.8, Dash::Solid);
        let beside = self.builder.screen.heading(c, dop).perp();
        self.builder.role = Role::Direction;
        self.builder.text(
            c + dop * (0.7 * length),
            "DOP",
            if beside.y < 0.0 { beside } else { -beside },
            SMALL_TYPE,
            self.palette.aim,
        );
    }

    /// The axes of the world.
    fn axes(&mut self) {
        let Some(tips) = self.content.axis_tips().filter(|_| self.has(WorldPart::Axes)) else { return };
        for ((tip, color), name) in tips.into_iter().zip(self.palette.axes).zip(["x", "y", "z"]) {
            self.builder.vector(DVec3::ZERO, tip, color, 1.5, name);
        }
    }

    /// A ring around a scene that's too small to be visible in its place.
    fn speck(&mut self) {
        const SMALL: f64 = 5.0;
        let (screen, bounds) = (self.builder.screen, self.request.scene.bounds());
        let Some(bounds) = bounds.filter(|b| b.radius() > 0.0) else { return };
        let middle = bounds.center();
        if bounds.radius() < SMALL * screen.scale * screen.units_per_pixel(middle) {
            self.builder.mark_above(middle, MarkShape::Ring, 4.5, self.palette.soft);
            let toward = DVec2::new(1.0, 0.4);
            self.builder.named("scene", middle, self.request.labels.scene, toward, SMALL_TYPE, self.palette.ink);
        }
    }

    /// From C and PF down (or up) to the ground, because people judge distance by the foot of a thing.
    fn drop_lines(&mut self) {
        if !self.has(WorldPart::GroundMarks) {
            return;
        }
        let reach = 4.0 * self.content.radius();
        for p in [self.request.camera.position(), self.request.camera.focal_point()] {
            if p.y.abs() > reach || p.y.abs() < 1e-6 * reach {
                continue;
            }
            let foot = DVec3::new(p.x, 0.0, p.z);
            self.builder.line(vec![p, foot], self.palette.soft, 1.2, Dash::Dotted);
            self.builder.mark(foot, MarkShape::Ring, 3.0, self.palette.soft);
        }
    }

    /// A ring around the handle under the pointer.
    fn hot_handle(&mut self) {
        let Some(hovered) = self.request.hover.hovered else { return };
        if let Some((_, p)) = handles::on_screen(self.request, self.builder.screen, &self.content.volume)
            .into_iter()
            .find(|(h, _)| *h == hovered)
        {
            self.builder.mark_above(p, MarkShape::Ring, 9.0, self.palette.probe);
        }
    }
}

/// The window with the image on it. (0, 0) of the image is the window's upper left corner.
fn painted(near: [DVec3; 4], image: &Arc<Texture>, opacity: f64) -> Object {
    let mut mesh = Mesh::default();
    gizmos::add_polygon(&mut mesh, &near);
    mesh.edges.clear();
    #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
    let opacity = (255.0 * opacity.clamp(0.0, 1.0)).round() as u8;
    let uv = vec![[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    Object {
        lit: false,
        two_sided: true,
        ..Object::new(
            "window",
            Arc::new(mesh),
            DMat4::IDENTITY,
            ObjectPaint::Texture(Pictured::plain(Arc::clone(image), uv, opacity)),
        )
    }
}
