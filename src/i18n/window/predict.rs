//! The words of *Predict first*: an operation asks about its effect beforehand.

texts! {
    switch: "Predict first", "Prever antes";
    switch_hint: "An operation asks first where a point M will go in the image, or how the objects will change in size. Then it's done, and you compare both. The sliders are inactive meanwhile", "Uma operação pergunta antes aonde irá um ponto M na imagem, ou como mudará o tamanho dos objetos. Depois é feita, e você compara os dois. Enquanto isso os controles deslizantes ficam inativos";
    mark_here: "Where will M go? Mark it here", "Aonde irá M? Marque aqui";
    click: "Click in *Image*, or drag the cross. With the keyboard: Tab to *Image*, then the arrows (with Shift, ten pixels).", "Clique em *Imagem* ou arraste a cruz. Com o teclado: Tab até *Imagem*, depois as setas (com Shift, dez pixels).";
    larger: "larger", "maiores";
    smaller: "smaller", "menores";
    same: "as large", "do mesmo tamanho";
    do_it: "Do it", "Fazer";
    do_it_hint: "Does the operation, and compares what you said with what happens", "Faz a operação e compara o que você disse com o que acontece";
    as_said: "As you said.", "Como você disse.";
    otherwise: "That isn't what you said.", "Não foi como você disse.";
}

texts_with_values! {
    /// The question of an operation about a point.
    where_to(lang, operation: &str): "**{operation}**: where will M go?", "**{operation}**: aonde irá M?";

    /// The question of an operation about sizes.
    how_large(lang, operation: &str): "**{operation}**: how large will the objects be in the image?",
        "**{operation}**: de que tamanho ficarão os objetos na imagem?";

    /// The answer about a point: its pixel, and the distance `off` of the mark.
    landed(lang, place: [f64; 2], off: &str): "M is now at the pixel {pixel}. {off}",
        "M está agora no pixel {pixel}. {off}" (pixel = lang.mark().tuple(&place.map(f64::floor), 5));

    /// The answer about sizes beside the outcome, as the factor by which the objects grow.
    sizes(lang, said: &str, happened: &str, times: f64): "You said {said}. They are {happened}: {times} times as large as before.",
        "Você disse {said}. Ficaram {happened}: {times} vezes o tamanho de antes."
        (times = lang.mark().number(times, 3));
}
