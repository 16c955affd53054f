//! The words of the lens: the view angle as cameras and other programs give it, in both languages.

texts! {
    lens: "Lens", "Lente";
    lens_hint: "The lens as a horizontal angle, a focal length with a sensor, a focal length in pixels, or a lens shift", "A lente como ângulo horizontal, distância focal com um sensor, distância focal em pixels ou deslocamento da lente";
    vertical: "vertical angle", "ângulo vertical";
    horizontal: "horizontal angle", "ângulo horizontal";
    diagonal: "diagonal angle", "ângulo diagonal";
    angle_hint: "tan(θ/2) is H/2F, W/2F for the horizontal angle, and half the diagonal over F for the diagonal one. While the window is free, its angles follow from l, r, b and t", "tan(θ/2) é H/2F, no ângulo horizontal W/2F e no diagonal meia diagonal sobre F. Enquanto a janela é livre, os ângulos decorrem de l, r, b e t";
    focal_length: "focal length, mm", "distância focal, mm";
    focal_length_hint: "f / sensor = F / window, for the side of the sensor that spans the image", "f / sensor = F / janela, para o lado do sensor que cobre a imagem";
    sensor: "sensor, mm", "sensor, mm";
    sensor_hint: "Width and height of the sensor. Full frame: 36 × 24", "Largura e altura do sensor. Quadro cheio: 36 × 24";
    fit: "fit", "ajuste";
    fit_horizontal: "width", "largura";
    fit_horizontal_hint: "The width of the sensor spans the width of the image", "A largura do sensor cobre a largura da imagem";
    fit_vertical: "height", "altura";
    fit_vertical_hint: "The height of the sensor spans the height of the image", "A altura do sensor cobre a altura da imagem";
    fit_larger: "larger", "maior";
    fit_larger_hint: "The width of the sensor spans the larger side of the image, like Auto in Blender", "A largura do sensor cobre o lado maior da imagem, como o Auto do Blender";
    pixels: "f in pixels (x, y)", "f em pixels (x, y)";
    pixels_hint: "F m/W and F n/H, as in K of OpenCV", "F m/W e F n/H, como em K do OpenCV";
    shift: "lens shift", "deslocamento";
    shift_hint: "The middle of the window, to the right and up, as fractions of the side that the sensor spans, as Blender counts it", "O meio da janela, para a direita e para cima, em partes do lado que o sensor cobre, como conta o Blender";
    distance: "distance", "distância";
    distance_hint: "A distance from C along DOP. At first it's D", "Uma distância de C ao longo de DOP. No começo é D";
    view_there: "W × H there", "W × H ali";
    view_there_hint: "The size of the view at that distance", "O tamanho da vista nessa distância";
}
