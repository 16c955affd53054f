//! The side of explanations.

texts! {
    matrices: "Matrices", "Matrizes";
    matrices_hint: "Why each entry of each matrix is what it is", "Por que cada elemento de cada matriz é o que é";
    dialects: "Dialects", "Dialetos";
    dialects_hint: "The camera in the words of other sources, whose numbers set it; and a pasted matrix → its camera", "A câmera nas palavras de outras fontes, cujos números a definem; e uma matriz colada → sua câmera";
    code: "Code", "Código";
    code_hint: "The camera as code for a library", "A câmera como código para uma biblioteca";
    code_for: "Code for", "Código para";
    copy: "Copy", "Copiar";
    copy_code_hint: "Copies the code", "Copia o código";
}
