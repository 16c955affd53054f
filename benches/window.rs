//! Time of a frame of the window, and from a hand that moves to the pictures: `cargo bench --bench window [-- WORDS…]`.
//!
//! The whole window with the figure that it begins with, 1920 × 1080 points, a pixel to a point, is run without a
//! display: events go in, shapes and textures come out. A frame here is the layout by egui with all of this program's
//! code. It waits for its pictures, however long they take, so that it ends when all pictures of a change are in their
//! textures. The window's work after that is not included: tessellation is a column of its own, and OpenGL is not
//! called (for its share see `docs/performance.md`). Each row takes turns with frames in which nothing changes, and
//! "beyond" is how much longer its frame takes than those, of the medians and of the least. "layers" is how often a
//! frame paints each pixel of the window, on average, "kB" is how much it sends to textures, "pictures" how many it
//! draws. The rows are: nothing changes, the pointer moves, a hand drags the observer of the world, θ, or the slider of
//! the azimuth, or a field has the caret in it and no key is pressed. Words choose rows (`observer`).

#![expect(clippy::print_stdout, reason = "a benchmark prints")]

#[path = "../tests/common/overdraw.rs"]
mod overdraw;

use std::time::{Duration, Instant};

use camera_lab::gui::{App, Start, State};
use camera_lab::views::View;
use camera_lab_words::{Lang, window};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Context, Event, FullOutput, Modifiers, PointerButton, Pos2, RawInput, Rect, Vec2, ViewportId, pos2, vec2,
};

/// Of the window, in points.
const SIZE: Vec2 = vec2(1920.0, 1080.0);

/// Frames of each row.
const FRAMES: usize = 200;

/// Seconds between frames that follow one another.
const STEP: f64 = 1.0 / 60.0;

/// How far a hand goes to and fro, in points.
const WAY: usize = 24;

/// The window, without a display.
struct Window {
    ctx: Context,
    app: App,
    /// Seconds.
    now: f64,
}

/// The cost of a frame.
struct Frame {
    layout: Duration,
    tessellation: Duration,
    /// How often each pixel is painted, on average.
    layers: f32,
    /// Bytes that go to textures.
    uploaded: usize,
    /// Pictures.
    drawn: u64,
    /// When the next frame is wanted.
    next: Duration,
}

impl Window {
    fn new() -> Option<Self> {
        let mut state =
            State::new(Start { figure: camera_lab_desk::document::fresh(), lang: Lang::En, ..Start::default() })
                .ok()?;
        // As in a window that has been used before.
        state.model.settings.welcomed = true;
        let ctx = Context::default();
        let mut app = App::new(&ctx, state);
        app.canvas.patience = Some(Duration::from_secs(60));
        let mut window = Self { ctx, app, now: 0.0 };
        // Sizes settle, and the atlas gets its letters.
        for _ in 0..30 {
            window.frame(Vec::new());
        }
        Some(window)
    }

    fn run(&mut self, events: Vec<Event>) -> FullOutput {
        self.now += STEP;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, SIZE)),
            max_texture_side: Some(8192),
            time: Some(self.now),
            events,
            ..RawInput::default()
        };
        self.ctx.run_ui(input, |ui| self.app.show(ui))
    }

    fn frame(&mut self, events: Vec<Event>) -> Frame {
        let drawn = |app: &App| app.canvas.drawn().iter().sum::<u64>();
        let before = drawn(&self.app);
        let start = Instant::now();
        let mut output = self.run(events);
        let layout = start.elapsed();
        let start = Instant::now();
        let primitives = self.ctx.tessellate(output.shapes, output.pixels_per_point);
        let tessellation = start.elapsed();
        let layers = overdraw::painted(&primitives) / (SIZE.x * SIZE.y);
        let images = output.textures_delta.set.values().flatten().map(|delta| &delta.image);
        let uploaded = images.map(|image| image.width() * image.height() * image.bytes_per_pixel()).sum();
        output.textures_delta.clear();
        let next = output.viewport_output.get(&ViewportId::ROOT).map_or(Duration::MAX, |root| root.repaint_delay);
        Frame { layout, tessellation, layers, uploaded, drawn: drawn(&self.app) - before, next }
    }

    /// The place of the widget with this name.
    fn place(&mut self, role: Role, name: &str) -> Option<Rect> {
        self.ctx.enable_accesskit();
        let mut output = self.run(Vec::new());
        self.ctx.disable_accesskit();
        output.textures_delta.clear();
        let update = output.platform_output.accesskit_update?;
        let (_, node) = update.nodes.iter().find(|(_, node)| node.role() == role && node.label() == Some(name))?;
        let bounds = node.bounds()?;
        #[expect(clippy::cast_possible_truncation, reason = "points of a screen")]
        let corner = |x: f64, y: f64| pos2(x as f32, y as f32);
        Some(Rect::from_min_max(corner(bounds.x0, bounds.y0), corner(bounds.x1, bounds.y1)))
    }

    /// The place of a picture.
    fn picture(&self, view: View) -> Option<Rect> {
        self.app.canvas.places().find(|(of, _)| *of == view).map(|(_, place)| place)
    }

    fn press(&mut self, pos: Pos2, pressed: bool) {
        let button = Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE };
        self.frame(vec![Event::PointerMoved(pos), button]);
    }
}

/// The median and the least, in milliseconds.
fn median_and_least(times: impl Iterator<Item = Duration>) -> [f64; 2] {
    let mut times: Vec<f64> = times.map(|time| time.as_secs_f64() * 1e3).collect();
    times.sort_by(f64::total_cmp);
    [times.get(times.len() / 2), times.first()].map(|time| time.copied().unwrap_or(f64::NAN))
}

/// Times frames with events that `events` gives for each, in turns with frames without any.
fn row(name: &str, window: &mut Window, mut events: impl FnMut(usize) -> Vec<Event>) {
    let (mut idle, mut frames) = (Vec::new(), Vec::new());
    for turn in 0..FRAMES {
        let frame = window.frame(events(turn));
        // One more frame may show the effect of the event.
        window.frame(Vec::new());
        frames.push(frame);
        idle.push(window.frame(Vec::new()));
    }
    let [median, least] = median_and_least(frames.iter().map(|frame| frame.layout));
    let [median_idle, least_idle] = median_and_least(idle.iter().map(|frame| frame.layout));
    let [tessellation, _] = median_and_least(frames.iter().map(|frame| frame.tessellation));
    let mean = |of: fn(&Frame) -> f64| frames.iter().map(of).sum::<f64>() / frames.len() as f64;
    let layers = mean(|frame| f64::from(frame.layers));
    let (sent, drawn) = (mean(|frame| frame.uploaded as f64 / 1e3), mean(|frame| frame.drawn as f64));
    print!("{name:<34}");
    for time in [median, least, median - median_idle, least - least_idle, tessellation] {
        print!(" {time:>11.2}");
    }
    println!(" {layers:>11.2} {sent:>11.0} {drawn:>11.2}");
}

/// The place of a hand that goes to and fro, always another place than in the frame before.
fn to_and_fro(turn: usize) -> f32 {
    let at = turn % (2 * WAY);
    at.min(2 * WAY - at) as f32 - WAY as f32 / 2.0
}

/// Times a drag from a place, by so many points for each step of the hand.
fn drag(name: &str, window: &mut Window, from: Option<Pos2>, step: Vec2) {
    let Some(from) = from else {
        println!("{name:<34} not found");
        return;
    };
    window.press(from, true);
    row(name, window, |turn| vec![Event::PointerMoved(from + step * to_and_fro(turn))]);
    window.press(from, false);
    window.frame(vec![Event::PointerGone]);
}

/// Counts the frames that a window asks for while a field has the caret in it and no key is pressed.
fn caret(name: &str, window: &mut Window) {
    let Some(field) = window.place(Role::SpinButton, "θ") else {
        println!("{name:<34} not found");
        return;
    };
    window.press(field.center(), true);
    window.press(field.center(), false);
    let begin = window.now;
    let mut frames = vec![window.frame(vec![Event::PointerGone])];
    while let Some(next) = frames.last().map(|frame| frame.next)
        && next < Duration::MAX
        && window.now - begin < 60.0
    {
        window.now += (next.as_secs_f64() - STEP).max(0.0);
        frames.push(window.frame(Vec::new()));
    }
    let (count, seconds) = (frames.len(), window.now - begin);
    let [median, _] = median_and_least(frames.iter().map(|frame| frame.layout + frame.tessellation));
    let a_second = count as f64 / seconds;
    println!(
        "{name:<34} {count} frames of {median:.2} ms in {seconds:.1} s, {:.2} % of a core; {}",
        a_second * median / 10.0,
        if frames.last().is_some_and(|frame| frame.next == Duration::MAX) { "none after these" } else { "and more" }
    );
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let wanted = |name: &str| words.iter().all(|word| name.contains(word.as_str()));
    let Some(mut window) = Window::new() else { return };
    let window = &mut window;
    print!("{:<34}", "ms");
    ["frame", "least", "beyond", "least", "tessellated", "layers", "kB", "pictures"]
        .iter()
        .for_each(|column| print!(" {column:>11}"));
    println!();

    if wanted("nothing changes") {
        row("nothing changes", window, |_| Vec::new());
    }
    let world = window.picture(View::World).map(|place| place.left_bottom() + vec2(40.0, -40.0));
    let image = window.picture(View::Image).map(|place| place.center());
    for (name, place) in [("pointer moves, beside the scene", world), ("pointer moves, over the scene", image)] {
        if let Some(from) = place.filter(|_| wanted(name)) {
            row(name, window, |turn| vec![Event::PointerMoved(from + vec2(to_and_fro(turn), 0.0))]);
            window.frame(vec![Event::PointerGone]);
        }
    }
    if wanted("observer of the world") {
        drag("observer of the world", window, world, vec2(1.0, 0.0));
    }
    if wanted("θ") {
        let field = window.place(Role::SpinButton, "θ").map(|place| place.center());
        drag("θ", window, field, vec2(1.0, 0.0));
    }
    if wanted("azimuth") {
        let t = window::texts(Lang::En);
        // The slider is in the row of its name, which opens at a click.
        let name = window.place(Role::DisclosureTriangle, t.azimuth).map(|place| place.center());
        for pressed in [true, false] {
            name.iter().for_each(|name| window.press(*name, pressed));
        }
        window.frame(Vec::new());
        let slider = window.place(Role::Slider, &format!("{}: {}", t.azimuth, t.scrub)).map(|place| place.center());
        drag("azimuth", window, slider, vec2(3.0, 0.0));
    }
    if wanted("caret, nobody types") {
        caret("caret, nobody types", window);
    }
}
