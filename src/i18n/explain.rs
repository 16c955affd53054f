//! The side of explanations.

texts! {
    matrices: "Matrices", "Matrizes";
    matrices_hint: "Why each entry of each matrix is what it is", "Por que cada elemento de cada matriz é o que é";
}
