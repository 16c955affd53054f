//! A page as PDF.

use std::collections::BTreeMap;
use std::sync::Arc;

use pdf_writer::types::{AssociationKind, LineCapStyle, LineJoinStyle, StructRole};
use pdf_writer::writers::Resources;
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, Str, TextStr};
use tiny_skia::Pixmap;

use super::font::{FONTS_NAMED, Glyphs};
use super::{Item, Letters, Page, PageText, straight};
use crate::appearance::Rgba;
use crate::text::{self, Element, Face};

/// The objects with fixed references.
const CATALOG: Ref = Ref::new(1);
const PAGES: Ref = Ref::new(2);
const PAGE: Ref = Ref::new(3);
const CONTENT: Ref = Ref::new(4);
const INFO: Ref = Ref::new(5);
const TREE: Ref = Ref::new(6);
const DOCUMENT: Ref = Ref::new(7);
const FIGURE: Ref = Ref::new(8);
const ATTACHED: Ref = Ref::new(9);
const ATTACHMENT: Ref = Ref::new(10);
/// The first of the fonts. Each has five.
const FONTS: i32 = 11;
/// The first of the pictures. Each has two.
const PICTURES: i32 = FONTS + 5 * 4;

/// Pages as a PDF file, each tagged as a figure with its description, and with a figure file attached. An empty
/// `figure` isn't attached. The file has the title and language of the first page. `None` if the font can't be cut.
///
/// *Guarantees*: the same pages and figure give the same bytes.
pub fn pdf_of(pages: &[Page], letters: Letters, figure: &str) -> Option<Vec<u8>> {
    let first = pages.first()?;
    let mut writer = Writer {
        operators: Content::new(),
        ink: PenState::default(),
        letters,
        glyphs: Face::ALL.map(Glyphs::of),
        opacities: Vec::new(),
        pictures: Vec::new(),
        uses: BTreeMap::new(),
        forms: Vec::new(),
    };
    pages.iter().for_each(|page| count_uses(&page.items, &mut writer.uses));
    let contents: Vec<Vec<u8>> = pages.iter().map(|page| writer.page(page)).collect();
    let Writer { glyphs, opacities, pictures, forms, .. } = writer;
    // Pages after the first come after everything else.
    let refs = |k: usize| match k {
        0 => [PAGE, CONTENT, FIGURE, TREE],
        _ => {
            let at = |k: usize| i32::try_from(2 * pictures.len() + 4 * (k - 1)).unwrap_or(0);
            [0, 1, 2, 3].map(|i| Ref::new(PICTURES + at(k) + i))
        }
    };
    // After the last page.
    let form_ref = |k: usize| {
        let at = 2 * pictures.len() + 4 * (pages.len() - 1) + k;
        Ref::new(PICTURES + i32::try_from(at).unwrap_or(0))
    };

    let mut pdf = Pdf::new();
    let mut catalog = pdf.catalog(CATALOG);
    catalog.pages(PAGES).lang(TextStr(first.language));
    catalog.mark_info().marked(true);
    catalog.viewer_preferences().display_doc_title(true);
    let mut tree = catalog.struct_tree_root();
    tree.child(DOCUMENT);
    let mut parents = tree.parent_tree();
    let mut numbers = parents.nums();
    for k in 0..pages.len() {
        numbers.insert(i32::try_from(k).unwrap_or(0), refs(k)[3]);
    }
    numbers.finish();
    parents.finish();
    tree.finish();
    if !figure.is_empty() {
        catalog.names().embedded_files().names().insert(Str(b"figure.toml"), ATTACHED);
    }
    catalog.finish();
    for k in 0..pages.len() {
        pdf.indirect(refs(k)[3]).array().item(refs(k)[2]);
    }
    let mut document = pdf.struct_element(DOCUMENT);
    document.kind(StructRole::Document).parent(Ref::new(CATALOG.get()));
    let mut children = document.children();
    for k in 0..pages.len() {
        children.struct_element(refs(k)[2]);
    }
    children.finish();
    document.finish();
    for (k, page) in pages.iter().enumerate() {
        let [leaf, _, figure, _] = refs(k);
        let mut element = pdf.struct_element(figure);
        element.kind(StructRole::Figure).parent(DOCUMENT).page(leaf).title(TextStr(&page.title));
        element.alt(TextStr(&page.description)).lang(TextStr(page.language));
        element.children().marked_content_id(0);
        element.finish();
    }
    pdf.document_info(INFO).title(TextStr(&first.title)).creator(TextStr("Camera Lab"));
    let count = i32::try_from(pages.len()).unwrap_or(i32::MAX);
    pdf.pages(PAGES).kids((0..pages.len()).map(|k| refs(k)[0])).count(count);

    // All pages and forms have the same.
    let resources = |mut resources: Resources<'_>| {
        if glyphs.iter().any(|glyphs| !glyphs.is_empty()) {
            let mut fonts = resources.fonts();
            for (k, _) in glyphs.iter().enumerate().filter(|(_, glyphs)| !glyphs.is_empty()) {
                fonts.pair(FONTS_NAMED[k], font_refs(k)[0]);
            }
        }
        let mut states = resources.ext_g_states();
        for opacity in &opacities {
            let share = f32::from(*opacity) / 255.0;
            states
                .insert(Name(state_name(*opacity).as_bytes()))
                .start::<pdf_writer::writers::ExtGraphicsState>()
                .stroking_alpha(share)
                .non_stroking_alpha(share);
        }
        states.finish();
        let mut objects = resources.x_objects();
        for k in 0..pictures.len() {
            objects.pair(Name(picture_name(k).as_bytes()), picture_refs(k)[0]);
        }
        for k in 0..forms.len() {
            objects.pair(Name(form_name(k).as_bytes()), form_ref(k));
        }
    };
    let used = || glyphs.iter().enumerate().filter(|(_, glyphs)| !glyphs.is_empty());
    for (k, page) in pages.iter().enumerate() {
        let [width, height] = page.size.map(|side| side * page.points);
        let mut leaf = pdf.page(refs(k)[0]);
        leaf.media_box(Rect::new(0.0, 0.0, width, height)).parent(PAGES).contents(refs(k)[1]);
        leaf.struct_parents(i32::try_from(k).unwrap_or(0));
        resources(leaf.resources());
        leaf.finish();
    }
    for (k, form) in forms.iter().enumerate() {
        let packed = packed(&form.content);
        let mut object = pdf.form_xobject(form_ref(k), &packed);
        object.filter(Filter::FlateDecode);
        let [left, top, right, bottom] = form.clip;
        object.bbox(Rect::new(left, top, right, bottom));
        resources(object.resources());
        object.finish();
    }
    for (k, content) in contents.iter().enumerate() {
        pdf.stream(refs(k)[1], &packed(content)).filter(Filter::FlateDecode);
    }
    for (k, glyphs) in used() {
        glyphs.write(&mut pdf, font_refs(k))?;
    }
    for (k, picture) in pictures.iter().enumerate() {
        write_picture(&mut pdf, picture, picture_refs(k))?;
    }
    if !figure.is_empty() {
        let mut attached = pdf.file_spec(ATTACHED);
        attached.path(Str(b"figure.toml")).unic_file(TextStr("figure.toml"));
        attached.association_kind(AssociationKind::Source).embedded_file(ATTACHMENT);
        attached.finish();
        // Uncompressed, so that it can be found without reading the whole file.
        pdf.embedded_file(ATTACHMENT, figure.as_bytes()).subtype(Name(b"application/toml"));
    }
    Some(pdf.finish())
}

fn packed(bytes: &[u8]) -> Vec<u8> {
    miniz_oxide::deflate::compress_to_vec_zlib(bytes, 6)
}

fn state_name(opacity: u8) -> String {
    format!("A{opacity}")
}

fn picture_name(k: usize) -> String {
    format!("P{k}")
}

fn form_name(k: usize) -> String {
    format!("F{k}")
}

/// Items of several groups, written once.
struct Form {
    /// The items, by their place in memory.
    items: *const Vec<Item>,
    clip: [f32; 4],
    content: Vec<u8>,
}

/// Counts the groups that have the same items.
fn count_uses(items: &[Item], uses: &mut BTreeMap<*const Vec<Item>, usize>) {
    for item in items {
        if let Item::Group { items, .. } = item {
            let count = uses.entry(Arc::as_ptr(items)).or_default();
            *count += 1;
            if *count == 1 {
                count_uses(items, uses);
            }
        }
    }
}

/// The references of a picture and its opacities; or of a font, its descendant, its description, its file, its
/// characters.
fn font_refs(k: usize) -> [Ref; 5] {
    let first = FONTS.saturating_add(i32::try_from(5 * k).unwrap_or(0));
    [0, 1, 2, 3, 4].map(|i| Ref::new(first + i))
}

fn picture_refs(k: usize) -> [Ref; 2] {
    let first = PICTURES.saturating_add(i32::try_from(2 * k).unwrap_or(0));
    [Ref::new(first), Ref::new(first + 1)]
}

fn write_picture(pdf: &mut Pdf, pixels: &Pixmap, [itself, mask]: [Ref; 2]) -> Option<()> {
    let [width, height] = [i32::try_from(pixels.width()).ok()?, i32::try_from(pixels.height()).ok()?];
    let (colors, opacities) = straight(pixels);
    let colors = packed(&colors);
    let mut image = pdf.image_xobject(itself, &colors);
    image.filter(Filter::FlateDecode);
    image.width(width).height(height).bits_per_component(8).color_space().device_rgb();
    if opacities.is_some() {
        image.s_mask(mask);
    }
    image.finish();
    if let Some(opacities) = opacities {
        let opacities = packed(&opacities);
        let mut image = pdf.image_xobject(mask, &opacities);
        image.filter(Filter::FlateDecode);
        image.width(width).height(height).bits_per_component(8).color_space().device_gray();
    }
    Some(())
}

/// The part of the graphics state that has been set since the last save or restore. Most neighbours on a page share
/// it, and writing it once for all of them halves the page.
#[derive(Default)]
struct PenState {
    color: Option<[u8; 3]>,
    opacity: Option<u8>,
    /// Width, round ends and joins, dashes and their phase.
    line: Option<(f32, bool, Vec<f32>, f32)>,
}

/// The operators of a page.
struct Writer<'a> {
    operators: Content,
    ink: PenState,
    letters: Letters,
    /// By [`Face`].
    glyphs: [Glyphs; 4],
    /// The used opacities, each a graphics state.
    opacities: Vec<u8>,
    pictures: Vec<&'a Pixmap>,
    /// The number of groups that have the same items.
    uses: BTreeMap<*const Vec<Item>, usize>,
    /// The items that several groups have.
    forms: Vec<Form>,
}

impl<'a> Writer<'a> {
    /// The operators of a page. Fonts and pictures are collected over all pages.
    fn page(&mut self, page: &'a Page) -> Vec<u8> {
        (self.operators, self.ink) = (Content::new(), PenState::default());
        self.operators.begin_marked_content_with_properties(Name(b"Figure")).properties().identify(0);
        self.operators.save_state();
        // From here on y points down, and the unit is that of the page.
        let height = page.size[1] * page.points;
        self.operators.transform([page.points, 0.0, 0.0, -page.points, 0.0, height]);
        self.items(&page.items);
        self.operators.restore_state();
        self.operators.end_marked_content();
        std::mem::replace(&mut self.operators, Content::new()).finish().into_vec()
    }

    /// The place of items among those that are written once.
    fn form(&mut self, items: &'a Arc<Vec<Item>>, clip: [f32; 4]) -> usize {
        let place = Arc::as_ptr(items);
        if let Some(known) = self.forms.iter().position(|form| form.items == place && form.clip == clip) {
            return known;
        }
        let outside = std::mem::replace(&mut self.operators, Content::new());
        self.ink = PenState::default();
        self.items(items);
        let content = std::mem::replace(&mut self.operators, outside).finish().into_vec();
        self.forms.push(Form { items: place, clip, content });
        self.forms.len() - 1
    }

    fn items(&mut self, items: &'a [Item]) {
        for item in items {
            self.item(item);
        }
    }

    fn item(&mut self, item: &'a Item) {
        match item {
            Item::Group { corner: [x, y], scale, clip: [left, top, right, bottom], items } => {
                self.operators.save_state();
                self.operators.transform([*scale, 0.0, 0.0, *scale, *x, *y]);
                self.operators.rect(*left, *top, right - left, bottom - top).clip_nonzero().end_path();
                if self.uses.get(&Arc::as_ptr(items)).is_some_and(|count| *count > 1) {
                    let form = self.form(items, [*left, *top, *right, *bottom]);
                    self.operators.x_object(Name(form_name(form).as_bytes()));
                } else {
                    self.items(items);
                }
                self.operators.restore_state();
                self.ink = PenState::default();
            }
            Item::Fill { path, color } => {
                self.color(*color);
                self.path(path);
                self.operators.fill_nonzero();
            }
            Item::Stroke { path, color, width, dashes, phase, round } => {
                self.color(*color);
                self.line(*width, *round, dashes, *phase);
                self.path(path);
                self.operators.stroke();
            }
            Item::Text(text) => {
                if text.halo.a > 0 {
                    self.color(text.halo);
                    self.line(text.halo_width, true, &[], 0.0);
                    self.path(&text.outline());
                    self.operators.stroke();
                }
                self.color(text.color);
                match self.letters {
                    Letters::Text => self.text(text),
                    Letters::Outlines => {
                        self.path(&text.outline());
                        self.operators.fill_nonzero();
                    }
                }
            }
            Item::Picture { corner: [x, y], size: [width, height], pixels } => {
                let name = picture_name(self.pictures.len());
                self.pictures.push(pixels);
                self.opacity(255);
                self.operators.save_state();
                // A picture fills the square from (0, 0) to (1, 1), its first row at the top.
                self.operators.transform([*width, 0.0, 0.0, -height, *x, y + height]);
                self.operators.x_object(Name(name.as_bytes())).restore_state();
                self.ink = PenState::default();
            }
        }
    }

    /// One PDF text for each, so that a selection in a viewer covers the whole name.
    fn text(&mut self, of: &PageText) {
        let [x, y] = of.at;
        self.operators.begin_text();
        for run in text::set_runs(&of.text, of.size, of.mathematical) {
            let font = run.face as usize;
            let bytes = self.glyphs[font].show(&run.text);
            self.operators.set_font(FONTS_NAMED[font], run.size);
            self.operators.set_text_matrix([1.0, 0.0, 0.0, -1.0, x + run.at[0], y + run.at[1]]).show(Str(&bytes));
        }
        self.operators.end_text();
    }

    fn color(&mut self, color: Rgba) {
        let rgb = [color.r, color.g, color.b];
        if self.ink.color.replace(rgb) != Some(rgb) {
            let [r, g, b] = rgb.map(|x| f32::from(x) / 255.0);
            self.operators.set_fill_rgb(r, g, b).set_stroke_rgb(r, g, b);
        }
        self.opacity(color.a);
    }

    fn opacity(&mut self, opacity: u8) {
        if self.ink.opacity.replace(opacity) == Some(opacity) {
            return;
        }
        if !self.opacities.contains(&opacity) {
            self.opacities.push(opacity);
        }
        self.operators.set_parameters(Name(state_name(opacity).as_bytes()));
    }

    fn line(&mut self, width: f32, round: bool, dashes: &[f32], phase: f32) {
        let line = Some((width, round, dashes.to_vec(), phase));
        if self.ink.line == line {
            return;
        }
        self.ink.line = line;
        let (cap, join) = if round {
            (LineCapStyle::RoundCap, LineJoinStyle::RoundJoin)
        } else {
            (LineCapStyle::ButtCap, LineJoinStyle::MiterJoin)
        };
        self.operators.set_line_width(width).set_line_cap(cap).set_line_join(join);
        self.operators.set_dash_pattern(dashes.iter().copied(), phase);
    }

    /// Writes a path, to a thousandth of a unit. Curves of second degree are raised to third.
    fn path(&mut self, path: &[Element]) {
        let near = |point: [f32; 2]| point.map(|x| (x * 1000.0).round() / 1000.0);
        let mut here = [0.0f32; 2];
        for element in path {
            let (controls, end) = match *element {
                Element::Move(p) | Element::Line(p) => (None, p),
                Element::Quad(c, p) => {
                    let towards = |end: [f32; 2]| [0, 1].map(|i| end[i] + (c[i] - end[i]) * (2.0 / 3.0));
                    (Some([towards(here), towards(p)]), p)
                }
                Element::Cubic(a, b, p) => (Some([a, b]), p),
                Element::Close => {
                    self.operators.close_path();
                    continue;
                }
            };
            here = end;
            let [x, y] = near(end);
            match controls.map(|controls| controls.map(near)) {
                Some([[ax, ay], [bx, by]]) => self.operators.cubic_to(ax, ay, bx, by, x, y),
                None if matches!(element, Element::Move(_)) => self.operators.move_to(x, y),
                None => self.operators.line_to(x, y),
            };
        }
    }
}
