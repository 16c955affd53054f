//! Long work, and work over budget.

use crate::limits::{MAX_PIECES, MAX_STROKE_STEPS};
use crate::pipeline::MisplacedVertex;
use crate::pipeline::budget::{OverBudget, names};
use crate::progress::Activity;
use crate::sanitize::escaped;

texts!("window/progress");

/// The present activity, and its finished share, if known.
pub fn progress(lang: Lang, doing: Activity, share: Option<f32>) -> String {
    let t = texts(lang);
    let doing = match doing {
        Activity::Reading => t.reading,
        Activity::Ordering => t.ordering,
        Activity::Painting => t.painting,
        Activity::Encoding => t.encoding,
        Activity::Measuring => t.measuring,
    };
    match share {
        Some(share) => format!("{doing}… {:.0} %", (100.0 * share).floor()),
        None => format!("{doing}…"),
    }
}

/// The exceeded budget. In English, the error's own words.
pub fn over_budget(lang: Lang, over_budget: &OverBudget) -> String {
    translated! { lang, over_budget;
        OverBudget::Pieces { objects } =>
            "as faces de {} se cruzam demais para serem divididas (mais de {MAX_PIECES} pedaços), e o z-buffer decide; permitido: menos faces, ou visibility = \"depth-buffer\"" (names(objects, "e outros"));
        OverBudget::Strokes =>
            "os traços encontram faces demais, ou uns aos outros vezes demais, para serem desenhados sem z-buffer (mais de {MAX_STROKE_STEPS} passos); permitido: menos arestas e linhas";
        OverBudget::Rounding { vertices } =>
            "{}: a imagem amplia além do que os dígitos das coordenadas permitem; permitido: uma janela maior, ou cena e câmera mais perto da origem" (beside(vertices));
    }
}

/// The misplaced vertices, in Portuguese.
fn beside(vertices: &[MisplacedVertex]) -> String {
    let one = |MisplacedVertex { object, vertex, off }: &MisplacedVertex| {
        let off = Lang::PtBr.mark().printed(&format!("{off:.1}"));
        format!("o vértice {vertex} de {:?} é desenhado com desvio de {off} px", escaped(object))
    };
    let first = vertices.first().map(one).unwrap_or_default();
    match vertices.len() {
        0 | 1 => first,
        objects => format!("{first}, e também vértices de outros objetos ({})", objects - 1),
    }
}
