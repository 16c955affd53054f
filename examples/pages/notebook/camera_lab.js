// The widget of camera_lab.py: the element <camera-lab>, whose figure and numbers are values of the notebook.
const given = ['figure', 'lesson', 'step', 'view', 'lang', 'theme'];

export default {
  async render({ model, el }) {
    const page = new URL('camera-lab-element.js', model.get('page').replace(/\/?$/, '/'));
    if (!customElements.get('camera-lab')) {
      const script = document.createElement('script');
      script.src = page;
      document.head.append(script);
      await customElements.whenDefined('camera-lab');
    }
    const lab = document.createElement('camera-lab');
    const put = (name) => (model.get(name) ? lab.setAttribute(name, model.get(name)) : lab.removeAttribute(name));
    given.forEach(put);
    let heard = model.get('figure');
    for (const name of given) {
      // Not what came from the figure itself.
      model.on(`change:${name}`, () => { if (name !== 'figure' || model.get(name) !== heard) put(name); });
    }
    lab.addEventListener('changed', async () => {
      heard = await lab.get('figure');
      model.set('figure', heard);
      model.set('numbers', await lab.get('numbers'));
      model.save_changes();
    });
    lab.addEventListener('answered', ({ detail }) => {
      model.set('answers', [...model.get('answers'), detail]);
      model.save_changes();
    });
    el.append(lab);
    return () => lab.remove();
  },
};
