//! Links to figures, and the differences in a page of a browser, in both languages.

texts! {
    code: "QR code", "Código QR";
    code_hint: "The link as a QR code over the whole window, for a class to scan with their phones", "O link como código QR na janela inteira, para os telefones da turma";
    too_long_for_code: "The link is too long for a QR code: it holds at most 2953 characters", "O link é longo demais para um código QR: cabem no máximo 2953 caracteres";
    whole_lesson: "The whole lesson", "A lição inteira";
    whole_lesson_hint: "All its steps are in the link; without it only the figure of this step is", "Todos os passos estão no link; sem isso, só a figura deste passo";
    address_first: "A QR code needs the address of a page with this program", "Um código QR precisa do endereço de uma página com este programa";
    copy_link: "Copy a link…", "Copiar um link…";
    copy_link_hint: "Copies the figure as a link that opens it in a browser", "Copia a figura como um link que a abre em um navegador";
    title: "A link to this figure", "Um link para esta figura";
    text: "Open it in any browser to see this figure and work on it. The link holds the whole figure, so nothing is sent anywhere.", "Abra em qualquer navegador para ver esta figura e trabalhar nela. O link contém a figura inteira, e nada é enviado a lugar nenhum.";
    address: "Address of the page", "Endereço da página";
    address_hint: "https://…", "https://…";
    address_text: "The address of a page with Camera Lab, for example your lecturer's. The program remembers it.", "O endereço de uma página com o Camera Lab, por exemplo a do seu professor. O programa o guarda.";
    no_address: "Without an address you copy only the part from the # on. Add it to the address of any page with Camera Lab.", "Sem endereço, você copia só a parte a partir do #. Junte-a ao endereço de qualquer página com o Camera Lab.";
    link: "Link", "Link";
    own_files: "The link doesn't include these files, so others won't see them:", "O link não inclui estes arquivos, e os outros não os verão:";
    copied: "Link copied:", "Link copiado:";
    characters: "characters", "caracteres";
    opened: "This is the figure of the link.", "Esta é a figura do link.";
    downloaded: "Your browser saves it with its downloads:", "Seu navegador o salva entre os downloads:";
    restored: "Your last work is restored from this browser.", "Seu último trabalho foi restaurado deste navegador.";
    name_text: "The browser saves it with its downloads and may change the name. Which name do you want?", "O navegador o salva entre os downloads e pode mudar o nome. Que nome você quer?";
    name_hint: "name.toml", "nome.toml";
    help_touch: "Touch", "Toque";
    help_touch_text: "One finger orbits a 3D view, or drags what it touches; two fingers pan and zoom it. A double tap maximises a view.", "Um dedo orbita uma vista 3D ou arrasta o que toca; dois dedos a movem e ampliam. Dois toques maximizam uma vista.";
    keys_of_browser: "The browser keeps some keys for itself. Commands without a key here are in the menus.", "O navegador reserva algumas teclas. Os comandos sem tecla aqui estão nos menus.";
}
