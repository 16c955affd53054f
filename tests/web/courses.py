"""Plays packages of SCORM 1.2 to their end, on the platform of scorm-again (https://github.com/jcputney/scorm-again)."""

import json
import pathlib
import subprocess
import time
import tomllib
import zipfile

from browser import wait

WORDS = pathlib.Path(__file__).resolve().parents[2] / "assets" / "words"

# The platform, which keeps what the package says. Its answers go to the controls for screen readers.
PLATFORM = """<!DOCTYPE html><script src="scorm-again/dist/scorm12.min.js"></script><script>
window.API = new Scorm12API({ autocommit: false });
const kept = localStorage.getItem('cmi');
if (kept) API.loadFromJSON(JSON.parse(kept).cmi);
API.on('LMSCommit', () => localStorage.setItem('cmi', JSON.stringify(API.renderCMIToJSONObject())));
const inner = () => frames[0]?.document?.querySelector('iframe')?.contentWindow;
const isReady = () => !!inner()?.cameraLab?.ready;
const controls = () => [...inner().document.querySelectorAll('#camera-lab *')];
const called = (name) => controls().find((one) => one.getAttribute('aria-label') === name);
const value = (key) => API.cmi.core[key] ?? API.cmi[key];
const marks = () => JSON.parse(API.cmi.suspend_data || '{}').marks || '';
const pause = () => new Promise((go) => setTimeout(go, 50));
const until = async (there, what) => {
  for (let k = 0; k < 600; k++) {
    const found = there();
    if (found) return found;
    await pause();
  }
  throw new Error(`waited for ${what}`);
};
// The fields of each question that is open, and the button under them.
const questions = (words) => {
  const all = [];
  let fields = [];
  for (const one of controls()) {
    const name = one.getAttribute('aria-label') || '';
    if (words.some((word) => name.startsWith(`${word}: `))) {
      all.push({ fields, button: one });
      fields = [];
    } else if (['input', 'textarea'].includes(one.localName) && one.type !== 'range' || one.getAttribute('role') === 'radio') {
      fields.push(one);
    }
  }
  return all;
};
// True if the button of a question can be pressed.
const isOpen = (words, place) => questions(words)[place] && !questions(words)[place].button.getAttribute('aria-disabled');
async function answer(words, place, given, mark) {
  // Again if the step has just been opened, and its controls are replaced.
  for (let k = 0; k < 10 && !isOpen(words, place); k++) {
    const { fields } = await until(() => questions(words)[place], `question ${place}`);
    const own = fields.slice(-given.length);
    if (typeof given[0] === 'number') {
      // Those of a panel may come first.
      fields.filter((one) => one.getAttribute('role') === 'radio').at(given[0] - given[1])?.click();
    } else {
      own.forEach((field, k) => {
        field.value = given[k];
        field.dispatchEvent(new Event('change', { bubbles: true }));
      });
    }
    for (let k = 0; k < 60 && !isOpen(words, place); k++) await pause();
  }
  await press(words, place, mark);
}
async function press(words, place, mark) {
  await until(() => isOpen(words, place), 'the button');
  questions(words)[place].button.click();
  await until(() => marks()[mark] !== '-', `mark ${mark}`);
}
</script><iframe src="index.html" width="1240" height="680"></iframe>"""


def texts(answer):
    """The entries of an answer, as they are typed."""
    if isinstance(answer, list):
        return [entry for part in answer for entry in texts(part)]
    return [answer if isinstance(answer, str) else repr(answer)]


class Course:
    """A lesson in a language, packed and on a platform."""

    def __init__(self, trials, path, lang, folder, address):
        self.trials = trials
        self.lesson = tomllib.loads(path.read_text(encoding="utf-8"))
        packed = trials.scratch / "course.zip"
        subprocess.run(
            [trials.program, "lesson", "package", self.lesson["id"], "--page", trials.out / "camera-lab.html", "--lang", lang, "-o", packed],
            check=True,
        )
        with zipfile.ZipFile(packed) as files:
            assert files.testzip() is None
            files.extractall(folder)
        (folder / "platform.html").write_text(PLATFORM, encoding="utf-8")
        words = tomllib.loads((WORDS / lang / "learn" / "exercise_window.toml").read_text(encoding="utf-8"))
        self.words = [words["guess"], words["check"]]
        lessons = tomllib.loads((WORDS / lang / "learn" / "lessons.toml").read_text(encoding="utf-8"))
        self.next = [f"{lessons[key]} ▶" for key in ("next", "pass")]
        # The marks of questions for a place.
        self.placed = set()
        self.page = trials.page(size=(1280, 720))
        # A tab has a store of its own.
        self.address = f"{address}/platform.html"

    def ask(self, expression):
        try:
            return self.page.ask(expression)
        except AssertionError:
            self.trials.keep(f"course-{self.lesson['id']}", self.page.shot())
            raise

    def visit(self):
        self.page.do("Page.navigate", url=self.address)
        wait(lambda: self.ask("typeof isReady === 'function' && isReady()"), "the page", 90)
        self.ask("inner().document.getElementById('controls').click()")
        wait(lambda: self.ask("controls().length > 20"), "the controls")

    def shown(self):
        """The step that the platform has heard of."""
        return int(self.ask("value('lesson_location')") or 1)

    def play(self):
        """Plays it with a break in the middle. Its answers are right, but for marks, which it puts near the middle of the image. Gives
        the number of right answers."""
        self.visit()
        steps, mark = self.lesson["step"], 0
        for number, step in enumerate(steps, 1):
            wait(lambda: self.shown() == number, f"step {number} of {self.lesson['id']}")
            if number == len(steps) // 2:
                self.page.do("Page.navigate", url="about:blank")
                self.visit()
                assert self.shown() == number, "not the same step after the break"
            wait(lambda: self.ask(f"controls().some((one) => /^\\S+ {number} .*▾$/.test(one.getAttribute('aria-label')))"), f"the controls of step {number}")
            mark += self.answered(step.get("ask"), mark)
            if number < len(steps):
                self.ask(f"until(() => called({json.dumps(self.next[0])}) || called({json.dumps(self.next[1])}), 'the way on').then((one) => one.click())")
        wait(lambda: self.ask("value('lesson_status')") == "passed", f"{self.lesson['id']} to be passed: {self.ask('marks()')}")
        marks, right = self.ask("marks()"), self.ask("marks()").count("1")
        assert len(marks) == mark and all(one == "1" for place, one in enumerate(marks) if place not in self.placed), marks
        assert abs(float(self.ask("value('score').raw")) - 100 * right / mark) < 0.01, self.ask("value('score').raw")
        assert len(self.ask("API.cmi.suspend_data")) <= 4096
        self.page.do("Page.navigate", url="about:blank")
        self.visit()
        assert self.ask("value('lesson_status')") == "passed" and self.shown() == len(steps)
        self.page.close()
        return right

    def answered(self, ask, mark):
        """Answers the questions of a step. Gives their number."""
        if not ask:
            return 0
        if "exercise" in ask:
            told = subprocess.run(
                [self.trials.program, "exercise", "show", ask["exercise"], "--seed", str(ask["seed"]), "--solution", "--format", "json", "--lang", "en"],
                check=True, capture_output=True, text=True,
            )
            exercise = json.loads(told.stdout)
            for place, one in enumerate(exercise["asks"]):
                answer = exercise["answers"][one["name"]]
                given = [one["choices"].index(answer), len(one["choices"])] if one["choices"] else texts(answer)
                self.ask(f"answer({json.dumps(self.words)}, {place}, {json.dumps(given)}, {mark + place})")
            return len(exercise["asks"])
        if "place" in ask:
            self.ask("controls().find((one) => /^Imagem?:/.test(one.getAttribute('aria-label'))).click()")
            self.placed.add(mark)
            self.page.key("ArrowUp")
            self.ask(f"press({json.dumps(self.words)}, 0, {mark})")
        elif "choices" in ask:
            given = [list(ask["choices"]).index(ask["answer"]), len(ask["choices"])]
            self.ask(f"answer({json.dumps(self.words)}, 0, {json.dumps(given)}, {mark})")
        else:
            answer = ask.get("answer")
            if answer is None:
                answer = json.loads(self.numbers())
                for key in ask["quantity"].split("."):
                    answer = answer[int(key) if key.isdigit() else key]
            self.ask(f"answer({json.dumps(self.words)}, 0, {json.dumps(texts(answer))}, {mark})")
        return 1

    def numbers(self):
        """Those of the figure, once it has come from the step before."""
        before = None
        while (now := self.ask("inner().cameraLab.ask('numbers', '', '')")) != before:
            before = now
            time.sleep(0.5)
        return now
