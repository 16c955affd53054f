'use strict';
// Between a course platform (SCORM 1.2) and the page of Camera Lab, which is in a frame. lesson.js names the course.
(() => {
  const course = cameraLabCourse;
  const began = Date.now();

  // The platform's object: in a window around this one, or in those around the window that opened it.
  const found = (from) => {
    for (let one = from, k = 0; one && k < 32; k++) {
      try { if (one.API) return one.API; } catch (_) { /* of another origin */ }
      if (one.parent === one) return null;
      one = one.parent;
    }
    return null;
  };
  const opener = () => {
    try { return window.opener || window.top.opener; } catch (_) { return null; }
  };
  const api = found(window) || found(opener());
  const ask = (name, ...given) => {
    try { return api ? String(api[name](...given)) : ''; } catch (_) { return ''; }
  };
  const value = (key) => ask('LMSGetValue', `cmi.core.${key}`);
  const set = (key, text) => ask('LMSSetValue', `cmi.core.${key}`, String(text));

  // A mark for each question: '1' if it was right at the first try, '0' if not, '-' before.
  const state = { step: 1, done: false, marks: '-'.repeat(course.questions.length) };
  let isOpen = ask('LMSInitialize', '') === 'true';
  const before = isOpen ? value('lesson_status') : '';
  try {
    const kept = JSON.parse(ask('LMSGetValue', 'cmi.suspend_data'));
    if (Number.isInteger(kept.step) && kept.step >= 1 && kept.step <= course.steps) state.step = kept.step;
    state.done = kept.done === true;
    if (/^[01-]*$/.test(kept.marks)) {
      state.marks = (kept.marks + state.marks.slice(kept.marks.length)).slice(0, course.questions.length);
    }
  } catch (_) { /* the first visit */ }

  // As text of at most 4,096 characters. The marks of the last questions are the first to go.
  const kept = () => {
    const room = 4096 - JSON.stringify({ ...state, marks: '' }).length;
    return JSON.stringify({ ...state, marks: state.marks.slice(0, room) });
  };
  const score = () => {
    const right = state.marks.split('1').length - 1;
    return course.questions.length ? Math.round(1e4 * right / course.questions.length) / 100 : 100;
  };
  const status = () => {
    if (!state.done) return 'incomplete';
    if (!course.questions.length) return 'completed';
    return score() >= course.pass ? 'passed' : 'failed';
  };
  const time = () => {
    const seconds = Math.min(Math.floor((Date.now() - began) / 1000), 9999 * 3600);
    const two = (n) => String(n).padStart(2, '0');
    return `${String(Math.floor(seconds / 3600)).padStart(4, '0')}:${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}`;
  };
  const report = () => {
    if (!isOpen) return;
    if (before !== 'passed' || status() === 'passed') set('lesson_status', status());
    if (course.questions.length || state.done) {
      set('score.min', 0);
      set('score.max', 100);
      set('score.raw', score());
    }
    set('lesson_location', state.step);
    ask('LMSSetValue', 'cmi.suspend_data', kept());
    set('session_time', time());
    ask('LMSCommit', '');
  };
  const finish = () => {
    if (!isOpen) return;
    set('exit', state.done ? '' : 'suspend');
    report();
    isOpen = false;
    ask('LMSFinish', '');
  };

  const frame = document.createElement('iframe');
  frame.title = course.title;
  frame.allow = 'fullscreen';
  frame.src = `camera-lab.html?lang=${course.lang}&allow=${encodeURIComponent(self.origin)}`;
  const send = (message) =>
    frame.contentWindow.postMessage({ 'camera-lab': 1, ...message }, self.origin === 'null' ? '*' : self.origin);
  let isThere = false;
  addEventListener('message', (event) => {
    const told = event.data;
    if (event.source !== frame.contentWindow || !told || told['camera-lab'] !== 1) return;
    if (told.event === 'ready') {
      send({ id: 'open', do: 'open', lesson: course.lesson, step: state.step });
    } else if (told.id === 'open') {
      isThere = told.ok === true;
    } else if (!isThere) {
      return;
    } else if (told.event === 'changed' && Number.isInteger(told.step) && told.step !== state.step) {
      state.step = told.step;
      report();
    } else if (told.event === 'answered') {
      const place = course.questions.indexOf(`${told.question}:${told.seed}/${told.ask}`);
      // Those of an earlier visit count, even if the page has forgotten them.
      if (place >= 0 && state.marks[place] === '-') {
        state.marks = state.marks.slice(0, place) + (told.right && told.first ? '1' : '0') + state.marks.slice(place + 1);
        // The last step has no way on. So a wrong answer there ends the lesson too.
        state.done ||= state.step === course.steps && course.last > 0 && !state.marks.slice(-course.last).includes('-');
        report();
      }
    } else if (told.event === 'finished' && !state.done) {
      state.done = true;
      report();
    }
  });
  addEventListener('pagehide', finish);
  addEventListener('beforeunload', finish);
  if (!api) {
    const alone = document.getElementById('alone');
    alone.textContent = course.lang === 'pt-BR'
      ? 'Nenhuma plataforma de curso foi encontrada: nada é registrado.'
      : 'No course platform was found: nothing is recorded.';
    alone.hidden = false;
  }
  document.body.append(frame);
  report();
})();
