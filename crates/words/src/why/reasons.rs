//! The reasons why stages run, and why they are skipped.

use crate::pipeline::{PlaneSet, Reason};

texts!("why/reasons");

/// The reason why a stage runs, or why it's skipped.
pub fn reason(lang: Lang, reason: Reason) -> String {
    let t = texts(lang);
    let objects = |n: usize| match n {
        1 => text!(lang, reason_one_object).to_owned(),
        n => text!(lang, reason_many_objects, n),
    };
    let n_of = |n: usize, of: usize| text!(lang, reason_n_of, n, objects = objects(of));
    match reason {
        Reason::Always => t.always.to_owned(),
        Reason::NothingInView => t.nothing_in_view.to_owned(),
        Reason::SomethingInView => t.something_in_view.to_owned(),
        Reason::FacesInView { objects: n } => text!(lang, reason_faces_in_view, objects = objects(n)),
        Reason::Forced => t.forced.to_owned(),
        Reason::Outside { outside, of } => text!(lang, reason_outside, n_of = n_of(outside, of)),
        Reason::NoneOutside { of: 0 } => t.no_objects.to_owned(),
        Reason::NoneOutside { of: 1 } => text!(lang, reason_one_not_outside).to_owned(),
        Reason::NoneOutside { of } => text!(lang, reason_none_outside, objects = objects(of)),
        Reason::Wireframe => t.wireframe.to_owned(),
        Reason::NoFaces => t.no_faces.to_owned(),
        Reason::NoLight => t.no_light.to_owned(),
        Reason::Unlit { .. } => t.unlit.to_owned(),
        Reason::FlatShading => t.flat_shading.to_owned(),
        Reason::LitFaces { objects: n } => text!(lang, reason_lit_faces, objects = objects(n)),
        Reason::LitVertices { objects: n } => text!(lang, reason_lit_vertices, objects = objects(n)),
        Reason::LitPixels { objects: n } => text!(lang, reason_lit_pixels, objects = objects(n)),
        Reason::LitVerticesAndPixels { vertices, pixels } => {
            text!(lang, reason_lit_vertices_and_pixels, at_vertices = objects(vertices), at_pixels = objects(pixels))
        }
        Reason::BackFaces { objects: n, of } => text!(lang, reason_back_faces, n_of = n_of(n, of)),
        Reason::BothSidesSeen { .. } => t.both_sides_seen.to_owned(),
        Reason::CutOpen { objects: n, of } => text!(lang, reason_cut_open, n_of = n_of(n, of)),
        Reason::NoFaceLeft => t.no_face_left.to_owned(),
        Reason::AllInside { objects: n } => text!(lang, reason_all_inside, objects = objects(n)),
        Reason::Crossing { objects: 1, of, planes: crossed } => {
            text!(lang, reason_one_crossing, n_of = n_of(1, of), planes = planes(lang, crossed))
        }
        Reason::Crossing { objects: n, of, planes: crossed } => {
            text!(lang, reason_crossing, n_of = n_of(n, of), planes = planes(lang, crossed))
        }
        Reason::SymmetricWindow => t.symmetric_window.to_owned(),
        Reason::ObliqueWindow => t.oblique_window.to_owned(),
        Reason::ParallelProjection => t.parallel_projection.to_owned(),
        Reason::PerspectiveProjection => t.perspective_projection.to_owned(),
        Reason::OneColorAFace => t.one_color_a_face.to_owned(),
        Reason::VariesOverFaces { objects: n } => text!(lang, reason_varies_over_faces, objects = objects(n)),
        Reason::ConvexAlone => t.convex_alone.to_owned(),
        Reason::SeveralObjects { objects: n } => text!(lang, reason_several_objects, objects = objects(n)),
        Reason::HidesItself => t.hides_itself.to_owned(),
        Reason::LinesAskForDepth => t.lines_ask_for_depth.to_owned(),
        Reason::PaintedByCentroid => t.painted_by_centroid.to_owned(),
        Reason::PaintedBySplitting => t.painted_by_splitting.to_owned(),
        Reason::NoDepthBuffer => t.no_depth_buffer.to_owned(),
        Reason::TooManyPieces { pieces } => text!(lang, reason_too_many_pieces, pieces),
        Reason::TextureOfOneColor { objects: n } => text!(lang, reason_texture_of_one_color, objects = objects(n)),
        Reason::NoTexture => t.no_texture.to_owned(),
        Reason::Textured { objects: n } => text!(lang, reason_textured, objects = objects(n)),
        Reason::NoShadows => t.no_shadows.to_owned(),
        Reason::NothingShadowed => t.nothing_shadowed.to_owned(),
        Reason::Shadowed { objects: n } => text!(lang, reason_shadowed, objects = objects(n)),
        Reason::AllOpaque => t.all_opaque.to_owned(),
        Reason::Translucent { objects: n } => text!(lang, reason_translucent, objects = objects(n)),
        Reason::OneSample => t.one_sample.to_owned(),
        Reason::Samples { samples } => text!(lang, reason_samples, samples),
        Reason::LinesInView => t.lines_in_view.to_owned(),
        Reason::DepthsShown => t.depths_shown.to_owned(),
        Reason::DividedFirst => t.divided_first.to_owned(),
        Reason::NoLines => t.no_lines.to_owned(),
    }
}

/// The names of planes: "left and near", "os planos da esquerda e da frente".
pub fn planes(lang: Lang, planes: PlaneSet) -> String {
    let names = text!(lang, planes_names);
    let names: Vec<&str> =
        names.into_iter().enumerate().filter(|(i, _)| planes & (1 << i) != 0).map(|(_, name)| name).collect();
    let [first @ .., last] = names.as_slice() else { return String::new() };
    let first = first.join(", ");
    if first.is_empty() {
        return text!(lang, planes_first, last);
    }
    text!(lang, planes, first, last)
}
