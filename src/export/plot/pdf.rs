//! One page of PDF as a back end of the plotting library. Letters are outlines of the bundled font, as in the pictures:
//! nothing has to be embedded, and every sign is there.

use std::convert::Infallible;

use pdf_writer::types::LineCapStyle;
use pdf_writer::{Content as Operators, Filter, Finish, Name, Pdf, Rect, Ref};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontTransform,
};

use crate::export::vector::path_of;
use crate::text;

/// The operators of a page, in units of the page, y down.
pub(super) struct Content {
    size: (u32, u32),
    operators: Operators,
    /// Opacities that are used, each a graphics state.
    opacities: Vec<u8>,
}

type Done = Result<(), DrawingErrorKind<Infallible>>;

#[expect(clippy::cast_precision_loss, reason = "places on a page")]
impl Content {
    pub(super) fn new(size: (u32, u32)) -> Self {
        let mut operators = Operators::new();
        // From here on y goes down, as in pictures.
        operators.transform([1.0, 0.0, 0.0, -1.0, 0.0, size.1 as f32]);
        operators.set_line_cap(LineCapStyle::RoundCap);
        Self { size, operators, opacities: Vec::new() }
    }

    /// The file.
    pub(super) fn finish(self) -> Vec<u8> {
        let [catalog, tree, page, content] = [1, 2, 3, 4].map(Ref::new);
        let mut pdf = Pdf::new();
        pdf.catalog(catalog).pages(tree);
        pdf.pages(tree).kids([page]).count(1);
        let mut leaf = pdf.page(page);
        leaf.media_box(Rect::new(0.0, 0.0, self.size.0 as f32, self.size.1 as f32)).parent(tree).contents(content);
        let mut resources = leaf.resources();
        let mut states = resources.ext_g_states();
        for opacity in &self.opacities {
            let share = f32::from(*opacity) / 255.0;
            states
                .insert(Name(name_of(*opacity).as_bytes()))
                .start::<pdf_writer::writers::ExtGraphicsState>()
                .stroking_alpha(share)
                .non_stroking_alpha(share);
        }
        states.finish();
        resources.finish();
        leaf.finish();
        let packed = miniz_oxide::deflate::compress_to_vec_zlib(&self.operators.finish(), 6);
        pdf.stream(content, &packed).filter(Filter::FlateDecode);
        pdf.finish()
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share as a byte")]
    fn color(&mut self, color: BackendColor) {
        let (r, g, b) = color.rgb;
        let [r, g, b] = [r, g, b].map(|x| f32::from(x) / 255.0);
        self.operators.set_fill_rgb(r, g, b).set_stroke_rgb(r, g, b);
        let opacity = (color.alpha * 255.0).round() as u8;
        if !self.opacities.contains(&opacity) {
            self.opacities.push(opacity);
        }
        self.operators.set_parameters(Name(name_of(opacity).as_bytes()));
    }

    fn path(&mut self, points: impl IntoIterator<Item = BackendCoord>) {
        for (i, (x, y)) in points.into_iter().enumerate() {
            let (x, y) = (x as f32, y as f32);
            if i == 0 {
                self.operators.move_to(x, y);
            } else {
                self.operators.line_to(x, y);
            }
        }
    }
}

fn name_of(opacity: u8) -> String {
    format!("A{opacity}")
}

/// The back end that fills a [`Content`].
pub(super) struct PdfBackend<'a>(&'a mut Content);

impl<'a> PdfBackend<'a> {
    pub(super) const fn new(content: &'a mut Content) -> Self {
        Self(content)
    }
}

#[expect(clippy::cast_precision_loss, reason = "places on a page")]
impl DrawingBackend for PdfBackend<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.0.size
    }

    fn ensure_prepared(&mut self) -> Done {
        Ok(())
    }

    fn present(&mut self) -> Done {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Done {
        self.0.color(color);
        self.0.operators.rect(x as f32, y as f32, 1.0, 1.0).fill_nonzero();
        Ok(())
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Done {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(&mut self, a: BackendCoord, b: BackendCoord, style: &S, fill: bool) -> Done {
        let corners = [a, (b.0, a.1), b, (a.0, b.1), a];
        if fill { self.fill_polygon(corners, style) } else { self.draw_path(corners, style) }
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Done {
        if style.color().alpha > 0.0 {
            self.0.color(style.color());
            self.0.operators.set_line_width(style.stroke_width() as f32);
            self.0.path(path);
            self.0.operators.stroke();
        }
        Ok(())
    }

    /// Four Bézier curves: off by less than 0.03 % of the radius.
    fn draw_circle<S: BackendStyle>(&mut self, (x, y): BackendCoord, radius: u32, style: &S, fill: bool) -> Done {
        const K: f32 = 0.552_284_8;
        self.0.color(style.color());
        self.0.operators.set_line_width(style.stroke_width() as f32);
        let (x, y, r) = (x as f32, y as f32, radius as f32);
        let at = |a: f32, b: f32| (x + a * r, y + b * r);
        let operators = &mut self.0.operators;
        operators.move_to(x + r, y);
        for quarter in [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]] {
            let [a, b] = quarter;
            let (p, q, end) = (at(a - K * b, b + K * a), at(K * a - b, K * b + a), at(-b, a));
            operators.cubic_to(p.0, p.1, q.0, q.1, end.0, end.1);
        }
        if fill {
            operators.fill_nonzero();
        } else {
            operators.stroke();
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, corners: I, style: &S) -> Done {
        self.0.color(style.color());
        self.0.path(corners);
        self.0.operators.close_path().fill_nonzero();
        Ok(())
    }

    #[expect(clippy::cast_possible_truncation, reason = "the size of letters")]
    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, (x, y): BackendCoord) -> Done {
        let color = style.color();
        if color.alpha == 0.0 {
            return Ok(());
        }
        let size = style.size() as f32;
        let width = text::measure(text, size, false).width;
        let left = match style.anchor().h_pos {
            HPos::Left => 0.0,
            HPos::Center => -width / 2.0,
            HPos::Right => -width,
        };
        // Position of the baseline as in the other back ends: capitals are about 0.73 em high.
        let down = match style.anchor().v_pos {
            VPos::Top => 0.86 * size,
            VPos::Center => 0.36 * size,
            VPos::Bottom => -0.1 * size,
        };
        let turn = match style.transform() {
            FontTransform::None => [1.0, 0.0, 0.0, 1.0],
            FontTransform::Rotate90 => [0.0, 1.0, -1.0, 0.0],
            FontTransform::Rotate180 => [-1.0, 0.0, 0.0, -1.0],
            FontTransform::Rotate270 => [0.0, -1.0, 1.0, 0.0],
        };
        self.0.color(color);
        let operators = &mut self.0.operators;
        operators.save_state();
        operators.transform([turn[0], turn[1], turn[2], turn[3], x as f32, y as f32]);
        operators.transform([1.0, 0.0, 0.0, 1.0, left, down]);
        path_of(operators, &text::outline(text, size, false));
        operators.fill_nonzero().restore_state();
        Ok(())
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the room of a text")]
    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        style: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let size = style.size() as f32;
        Ok((text::measure(text, size, false).width.ceil() as u32, size.ceil() as u32))
    }
}
