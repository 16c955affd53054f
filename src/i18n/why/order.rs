//! The explanation of the order of transforms.

use crate::explain::order::{Call, Reading, Unbalanced};
use crate::i18n::Lang;

texts! {
    object: "Object:", "Objeto:";
    example: "No object is selected, so this is a cube as an example.", "Nenhum objeto está selecionado, e este é um cubo de exemplo.";
    frame: "The frame moves", "O referencial se move";
    frame_hint: "From left to right, as the program runs. Each step moves the frame along and about its current axes", "Da esquerda para a direita, como o programa roda. Cada passo move o referencial ao longo e em torno dos eixos atuais";
    fixed: "The object moves", "O objeto se move";
    fixed_hint: "From right to left. Each step moves the object along and about fixed axes, those of its parent", "Da direita para a esquerda. Cada passo move o objeto ao longo e em torno de eixos fixos, os do pai";
    list: "Transforms, from left to right", "Transformações, da esquerda para a direita";
    list_hint: "As in OpenGL, each multiplies the current matrix from the right. Drag a step by its dots, or Alt+↑ and Alt+↓. In the world in grey, with axes x₁ y₁ z₁.", "Como em OpenGL, cada uma multiplica a matriz corrente pela direita. Arraste um passo pelos pontos, ou Alt+↑ e Alt+↓. No mundo em cinza, com eixos x₁ y₁ z₁.";
    earlier: "Earlier", "Mais cedo";
    later: "Later", "Mais tarde";
    remove: "Remove", "Remover";
    add: "Add", "Adicionar";
    add_hint: "A transform at the end, or push and pop", "Uma transformação no fim, ou push e pop";
    again: "Start over", "Recomeçar";
    again_hint: "Restores the object's own transform, T R S", "Volta à transformação do próprio objeto, T R S";
    done: "Steps applied", "Passos aplicados";
    back: "Step back", "Um passo atrás";
    forward: "Step forward", "Um passo à frente";
    nothing: "No step is applied, so the frame is that of the parent.", "Nenhum passo foi aplicado, e o referencial é o do pai.";
    this_step: "The matrix of this step", "A matriz deste passo";
    so_far: "All steps so far", "Todos os passos até aqui";
    other: "In another order", "Em outra ordem";
    other_hint: "The same list with two steps exchanged. It's red in the world, with axes x₂ y₂ z₂", "A mesma lista com dois passos trocados. No mundo fica em vermelho, com eixos x₂ y₂ z₂";
    first: "One step", "Um passo";
    second: "The other step", "O outro passo";
    same: "= The same matrix. These two steps commute.", "= A mesma matriz. Estes dois passos comutam.";
    differs: "≠ Another matrix. The order matters.", "≠ Outra matriz. A ordem importa.";
    so_far_same: "The same so far, but not in the end. The order matters.", "A mesma até aqui, mas não no fim. A ordem importa.";
    take: "Apply", "Aplicar";
    take_hint: "The object in the figure gets the whole list; Ctrl+Z undoes it", "O objeto na figura recebe a lista inteira; Ctrl+Z desfaz";
    take_nothing: "Select an object of the figure", "Selecione um objeto da figura";
    take_preset: "It belongs to the named scene: “Edit a copy” makes it an object of the figure", "Pertence à cena nomeada: “Editar uma cópia” faz dele um objeto da figura";
    is_form: "The list is T R S, so the object itself can hold it.", "A lista é T R S, e o próprio objeto pode guardá-la.";
    group: "group", "grupo";
}

/// The kind of a call, as a name.
pub fn kind(lang: Lang, call: Call) -> &'static str {
    match call {
        Call::Translate(_) => pick!(lang; "translate", "transladar"),
        Call::RotateX(_) => pick!(lang; "rotate about x", "girar em torno de x"),
        Call::RotateY(_) => pick!(lang; "rotate about y", "girar em torno de y"),
        Call::RotateZ(_) => pick!(lang; "rotate about z", "girar em torno de z"),
        Call::Scale(_) => pick!(lang; "scale", "escalar"),
        Call::Push => pick!(lang; "push: save the matrix", "push: salvar a matriz"),
        Call::Pop => pick!(lang; "pop: restore it", "pop: restaurá-la"),
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
    both!(lang; "Step {number}: {symbol}", "Passo {number}: {symbol}")
}

/// The effect of a call. `number` writes a number.
pub fn sentence(lang: Lang, reading: Reading, call: Call, number: impl Fn(f64) -> String) -> String {
    let vector = |v: glam::DVec3| {
        let separator = if lang == Lang::PtBr { "; " } else { ", " };
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
            Reading::Frame => both!(lang; "The frame turns by {degrees}° about its own {axis}.",
                "O referencial gira {degrees}° em torno de seu próprio {axis}."),
            Reading::Object => both!(lang;
                "The object turns by {degrees}° about the fixed {axis}, through the origin of its parent.",
                "O objeto gira {degrees}° em torno do {axis} fixo, pela origem do pai."),
        };
    }
    match (reading, call) {
        (Reading::Frame, Call::Translate(t)) => both!(lang; "The frame moves by {} along its own axes.",
            "O referencial se move {} ao longo de seus próprios eixos."; vector(t)),
        (Reading::Object, Call::Translate(t)) => both!(lang; "The object moves by {} along the fixed axes.",
            "O objeto se move {} ao longo dos eixos fixos."; vector(t)),
        (Reading::Frame, Call::Scale(s)) => both!(lang; "The units of the frame's axes are multiplied by {}.",
            "As unidades dos eixos do referencial são multiplicadas por {}."; vector(s)),
        (Reading::Object, Call::Scale(s)) => both!(lang;
            "The object is scaled by {} along the fixed axes, from the origin of its parent.",
            "O objeto é escalado por {} ao longo dos eixos fixos, a partir da origem do pai."; vector(s)),
        (_, Call::Push) => both!(lang; "The current matrix is saved on the stack.",
            "A matriz corrente é salva na pilha."),
        (_, _) => both!(lang; "The matrix that was saved last becomes the current one again.",
            "A última matriz salva volta a ser a corrente."),
    }
}

/// A pop without a push.
pub fn unbalanced(lang: Lang, Unbalanced { call }: Unbalanced) -> String {
    let number = call + 1;
    both!(lang; "Step {number} is a pop, and nothing was pushed before it.",
        "O passo {number} é um pop, e nada foi salvo na pilha antes dele.")
}

/// The reason why an object alone can't hold a list, and the remedy. The call at `place`, from 0, comes too late for T
/// Rz Ry Rx S, so `groups` groups are created.
pub fn needs_groups(lang: Lang, (place, call): (usize, Call), groups: usize) -> String {
    let (number, symbol) = (place + 1, call.symbol().replace('_', ""));
    match groups {
        1 => both!(lang;
            "An object in a figure file is one T Rz Ry Rx S. Step {number} ({symbol}) doesn't fit into that order. A group above the object holds exactly the steps before it.",
            "Um objeto no arquivo da figura é um só T Rz Ry Rx S. O passo {number} ({symbol}) não cabe nessa ordem. Um grupo acima do objeto guarda exatamente os passos anteriores."),
        _ => both!(lang;
            "An object in a figure file is one T Rz Ry Rx S. Step {number} ({symbol}) doesn't fit into that order. {groups} groups above the object, one below the other, hold exactly the rest.",
            "Um objeto no arquivo da figura é um só T Rz Ry Rx S. O passo {number} ({symbol}) não cabe nessa ordem. {groups} grupos acima do objeto, um sob o outro, guardam exatamente o resto."),
    }
}
