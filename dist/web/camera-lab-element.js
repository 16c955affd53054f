// <camera-lab lesson="basis" step="3"></camera-lab>: Camera Lab in a page. docs/web.md describes it.
'use strict';
{
  const script = document.currentScript.src;

  class CameraLab extends HTMLElement {
    static observedAttributes = ['figure', 'lesson', 'step', 'view', 'lang', 'theme', 'src'];

    #frame = null;
    #watch = null;
    #next = 0;
    #waiting = new Map();
    // Messages before the page is ready.
    #early = [];
    #isReady = false;
    #hear = (event) => this.#heard(event);

    connectedCallback() {
      if (!this.style.display) this.style.display = 'block';
      if (!this.style.minHeight) this.style.minHeight = '480px';
      this.#watch = new IntersectionObserver((seen) => {
        if (seen.some((one) => one.isIntersecting)) this.#load();
      });
      this.#watch.observe(this);
    }

    disconnectedCallback() {
      this.#watch.disconnect();
      this.#unload();
    }

    attributeChangedCallback(name, before, now) {
      if (!this.#frame || before === now) return;
      if (['lang', 'theme', 'src'].includes(name)) {
        this.#unload();
        this.#load();
      } else if (this.#isReady) {
        (name === 'view' ? this.show(now || 'all') : this.#begin(name)).catch(() => {});
      }
    }

    // Each gives a promise of the answer.
    open(what) { return this.#ask({ do: 'open', ...what }); }
    set(key, value) { return this.#ask({ do: 'set', key, value }); }
    act(op, seconds = 0) { return this.#ask({ do: 'act', op, seconds }); }
    get(what) { return this.#ask({ do: 'get', what }); }
    show(view) { return this.#ask({ do: 'show', view }); }

    #load() {
      this.#watch.disconnect();
      if (this.#frame) return;
      const src = new URL(this.getAttribute('src') || new URL('index.html', script), document.baseURI);
      for (const key of ['lang', 'theme', 'view']) {
        if (this.hasAttribute(key)) src.searchParams.set(key, this.getAttribute(key));
      }
      src.searchParams.set('allow', self.origin);
      this.#frame = document.createElement('iframe');
      this.#frame.title = 'Camera Lab';
      this.#frame.allow = 'fullscreen';
      this.#frame.style.cssText = 'width: 100%; height: 100%; min-height: inherit; border: 0; display: block';
      this.#frame.src = src.href;
      addEventListener('message', this.#hear);
      this.append(this.#frame);
    }

    #unload() {
      removeEventListener('message', this.#hear);
      if (this.#frame) this.#frame.remove();
      [this.#frame, this.#isReady] = [null, false];
      for (const { no } of this.#waiting.values()) no(new Error('gone'));
      this.#waiting.clear();
    }

    // Shows what the attributes ask for.
    async #begin(changed) {
      const [figure, lesson, step] = ['figure', 'lesson', 'step'].map((name) => this.getAttribute(name));
      if (changed === 'step' && lesson) return this.open({ step: Number(step || 1) });
      if (lesson) return this.open({ lesson, step: Number(step || 1) });
      if (!figure) return undefined;
      // A text has lines, an address does not.
      if (figure.includes('\n')) return this.open({ figure });
      const answer = await fetch(new URL(figure, document.baseURI));
      if (!answer.ok) throw new Error(`${figure}: ${answer.status}`);
      return this.open({ figure: await answer.text() });
    }

    #ask(message) {
      const id = ++this.#next;
      return new Promise((yes, no) => {
        this.#waiting.set(id, { yes, no });
        if (this.#isReady) this.#send({ id, ...message });
        else this.#early.push({ id, ...message });
      });
    }

    #send(message) {
      const { origin, protocol } = new URL(this.#frame.src);
      this.#frame.contentWindow.postMessage({ 'camera-lab': 1, ...message }, protocol === 'file:' ? '*' : origin);
    }

    #heard({ source, data }) {
      if (!this.#frame || source !== this.#frame.contentWindow || !data || data['camera-lab'] !== 1) return;
      const waiting = this.#waiting.get(data.id);
      if (waiting) {
        this.#waiting.delete(data.id);
        if (data.ok) waiting.yes(data.value);
        else waiting.no(new Error(data.error));
      }
      if (data.event === 'ready') {
        this.#isReady = true;
        this.#begin().catch((why) => this.#tell('error', { error: String(why) }));
        this.#early.splice(0).forEach((message) => this.#send(message));
      }
      if (data.event && !waiting) this.#tell(data.event, data);
    }

    #tell(event, detail) { this.dispatchEvent(new CustomEvent(event, { detail })); }
  }

  if (!customElements.get('camera-lab')) customElements.define('camera-lab', CameraLab);
}
