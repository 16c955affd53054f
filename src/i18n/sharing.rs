//! Links to figures, and what is otherwise in a page of a browser, in both languages.

texts! {
    copy_link: "Copy a link…", "Copiar um link…";
    copy_link_hint: "The figure as a link that opens it in a browser", "A figura como um link que a abre em um navegador";
    title: "A link to this figure", "Um link para esta figura";
    text: "Whoever opens it in a browser sees this figure and can go on with it. The figure is in the link itself, after the #: nothing is sent anywhere.", "Quem o abre em um navegador vê esta figura e pode continuar com ela. A figura está no próprio link, depois do #: nada é enviado a lugar nenhum.";
    address: "Address of the page", "Endereço da página";
    address_hint: "https://…", "https://…";
    address_text: "Where Camera Lab for the browser lies, as your lecturer has put it up. It is remembered.", "Onde está o Camera Lab para navegador, como seu professor o publicou. É lembrado.";
    no_address: "Without an address, only what stands after it is copied, from the # on: append it to the address of any page with Camera Lab.", "Sem endereço, só se copia o que vem depois dele, a partir do #: acrescente-o ao endereço de qualquer página com o Camera Lab.";
    link: "Link", "Link";
    own_files: "These files do not go with it, and are missing for others:", "Estes arquivos não vão junto, e faltam aos outros:";
    copy: "Copy", "Copiar";
    copied: "The link is copied:", "O link está copiado:";
    characters: "characters", "caracteres";
    opened: "This is the figure of the link.", "Esta é a figura do link.";
    downloaded: "Handed to the browser, which keeps it with its downloads:", "Entregue ao navegador, que o guarda entre os downloads:";
    restored: "Your last work is back, as this browser has kept it.", "Seu último trabalho voltou, como este navegador o guardou.";
    name_text: "The browser puts it where its downloads are, and may change the name. Which name?", "O navegador o coloca onde ficam os downloads, e pode mudar o nome. Que nome?";
    name_hint: "name.toml", "nome.toml";
    help_touch: "Touch", "Toque";
    help_touch_text: "One finger turns a 3D picture, or holds what it touches; two fingers move and zoom it. A double tap shows one picture alone.", "Um dedo gira uma imagem 3D, ou segura o que toca; dois dedos a movem e ampliam. Dois toques mostram uma imagem sozinha.";
    keys_of_browser: "The browser keeps some keys for itself: what has none here is in the menus.", "O navegador guarda algumas teclas para si: o que aqui não tem teclas está nos menus.";
}
