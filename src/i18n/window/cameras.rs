//! The words of the list of cameras, in both languages.

texts! {
    cameras: "Cameras", "Câmeras";
    current: "current", "atual";
    name: "Name of the camera", "Nome da câmera";
    name_hint: "The label in the world. Each camera has a name of its own", "O rótulo no mundo. Cada câmera tem um nome próprio";
    name_bad: "Another camera has this name, or the name is empty", "Outra câmera tem esse nome, ou ele está vazio";
    color: "Colour of the camera", "Cor da câmera";
    color_hint: "The colour of its body, axes and volume in the world", "A cor do corpo, dos eixos e do volume no mundo";
    look: "Look", "Olhar";
    look_hint: "Exchanges this camera and the current one. A click on the camera in the world does the same", "Troca esta câmera e a atual. Um clique na câmera no mundo faz o mesmo";
    beside: "its image beside", "sua imagem ao lado";
    beside_hint: "Shows the image of this camera beside that of the current one. A pixel that you mark here is a line there, its epipolar line", "Mostra a imagem desta câmera ao lado da imagem da atual. Um pixel que você marca aqui é uma reta lá, a reta epipolar dele";
    click: "click to look through this camera", "clique para olhar por esta câmera";
    remove: "Remove", "Remover";
    remove_hint: "Removes the camera from the figure", "Remove a câmera da figura";
    add: "Keep this camera", "Guardar esta câmera";
    add_hint: "Adds a copy of the current camera to the list", "Adiciona à lista uma cópia da câmera atual";
    before: "Before and after", "Antes e depois";
    before_hint: "Keeps the current camera under the name *before*. Each operation then shows both", "Guarda a câmera atual com o nome *antes*. Cada operação então mostra as duas";
    before_name: "before", "antes";
    pair: "Stereo pair", "Par estéreo";
    pair_hint: "Two cameras side by side, half a baseline to the left and to the right of the current one", "Duas câmeras lado a lado, meia linha de base à esquerda e à direita da atual";
    baseline: "Baseline", "Linha de base";
    baseline_hint: "The distance between the two positions, along u", "A distância entre as duas posições, ao longo de u";
    shifted: "Shifted windows", "Janelas deslocadas";
    shifted_hint: "Parallel axes. The windows coincide at distance D, so a point at D has no disparity", "Eixos paralelos. As janelas coincidem à distância D, e um ponto em D não tem disparidade";
    toe_in: "Toe-in", "Eixos convergentes";
    toe_in_hint: "Both cameras look at PF. Points beside the plane of both axes also differ in height", "As duas câmeras olham para PF. Pontos fora do plano dos dois eixos também diferem na altura";
    left: "left", "esquerda";
    right: "right", "direita";
    full: "A figure has at most 32 more cameras", "Uma figura tem no máximo 32 câmeras a mais";
}
