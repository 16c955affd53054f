//! The explanation of the order of transforms.

use crate::explain::order::{Call, Reading, Unbalanced};
use crate::numbers::DecimalMark;

texts!("why/order");

/// The kind of a call, as a name.
pub fn kind(lang: Lang, call: Call) -> &'static str {
    match call {
        Call::Translate(_) => text!(lang, kind_translate),
        Call::RotateX(_) => text!(lang, kind_rotate_x),
        Call::RotateY(_) => text!(lang, kind_rotate_y),
        Call::RotateZ(_) => text!(lang, kind_rotate_z),
        Call::Scale(_) => text!(lang, kind_scale),
        Call::Push => text!(lang, kind_push),
        Call::Pop => text!(lang, kind_pop),
    }
}

/// The function of OpenGL.
pub const fn function(call: Call) -> &'static str {
    match call {
        Call::Translate(_) => "glTranslate",
        Call::RotateX(_) | Call::RotateY(_) | Call::RotateZ(_) => "glRotate",
        Call::Scale(_) => "glScale",
        Call::Push => "glPushMatrix",
        Call::Pop => "glPopMatrix",
    }
}

/// The step at a place, from 0, for screen readers.
pub fn step(lang: Lang, place: usize, call: Call) -> String {
    let (number, symbol) = (place + 1, call.symbol());
    text!(lang, step, number, symbol)
}

/// The effect of a call. `number` writes a number.
pub fn sentence(lang: Lang, reading: Reading, call: Call, number: impl Fn(f64) -> String) -> String {
    let vector = |v: glam::DVec3| {
        let separator = if lang.mark() == DecimalMark::Comma { "; " } else { ", " };
        format!("({})", v.to_array().map(&number).join(separator))
    };
    let turned = match call {
        Call::RotateX(degrees) => Some((degrees, "x")),
        Call::RotateY(degrees) => Some((degrees, "y")),
        Call::RotateZ(degrees) => Some((degrees, "z")),
        _ => None,
    };
    if let Some((degrees, axis)) = turned {
        let degrees = number(degrees);
        return match reading {
            Reading::Frame => text!(lang, sentence_frame, degrees, axis),
            Reading::Object => text!(lang, sentence_object, degrees, axis),
        };
    }
    match (reading, call) {
        (Reading::Frame, Call::Translate(t)) => text!(lang, sentence_translate, vector = vector(t)),
        (Reading::Object, Call::Translate(t)) => text!(lang, sentence_translate_fixed, vector = vector(t)),
        (Reading::Frame, Call::Scale(s)) => text!(lang, sentence_scale, vector = vector(s)),
        (Reading::Object, Call::Scale(s)) => text!(lang, sentence_scale_fixed, vector = vector(s)),
        (_, Call::Push) => text!(lang, sentence_push).to_owned(),
        (_, _) => text!(lang, sentence_pop).to_owned(),
    }
}

/// A pop without a push.
pub fn unbalanced(lang: Lang, Unbalanced { call }: Unbalanced) -> String {
    let number = call + 1;
    text!(lang, unbalanced, number)
}

/// The reason why an object alone can't hold a list, and the remedy. The call at `place`, from 0, comes too late for T
/// Rz Ry Rx S, so `groups` groups are created.
pub fn needs_groups(lang: Lang, (place, call): (usize, Call), groups: usize) -> String {
    let (number, symbol) = (place + 1, call.symbol().replace('_', ""));
    match groups {
        1 => text!(lang, needs_groups_one, number, symbol),
        _ => text!(lang, needs_groups_many, number, symbol, groups),
    }
}
