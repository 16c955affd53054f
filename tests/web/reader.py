"""What a screen reader has of the page: Chromium's accessibility tree and its actions, and nothing of what is drawn."""

import time

from browser import wait
from courses import texts


def disabled(node):
    return any(told["name"] == "disabled" and told["value"]["value"] for told in node.get("properties", []))


class Reader:
    def __init__(self, page):
        self.page = page
        page.do("DOM.enable")
        page.do("Accessibility.enable")
        self.press("button", "Controls for screen readers · Controles para leitores de tela")
        wait(lambda: len(self.nodes()) > 20, "the controls")

    def nodes(self):
        """Role, name and node of all that it finds."""
        nodes = self.page.do("Accessibility.getFullAXTree")["nodes"]
        told = lambda node, key: node.get(key, {}).get("value", "")
        return [(told(node, "role"), str(told(node, "name")), node) for node in nodes if not node["ignored"]]

    def all(self, role):
        return [(name, node) for found, name, node in self.nodes() if found == role]

    def there(self, role, name):
        """The first control whose name is this one, or passes this test."""
        passes = name if callable(name) else lambda found: found == name
        return next((node for found, called, node in self.nodes() if found == role and passes(called)), None)

    def do(self, node, function, *given):
        control = self.page.do("DOM.resolveNode", backendNodeId=node["backendDOMNodeId"])["object"]["objectId"]
        self.page.do("Runtime.callFunctionOn", objectId=control, functionDeclaration=function, arguments=[{"value": one} for one in given])

    def press(self, role, name):
        """Presses a control that has stayed the same for a moment, as nobody is faster."""
        before = None

        def able():
            nonlocal before
            node = self.there(role, name)
            found = node and not disabled(node) and node["backendDOMNodeId"]
            same, before = found and found == before, found
            return same and node or time.sleep(0.2)

        self.do(wait(able, f"{role} {name}"), "function() { this.click(); }")

    def write(self, node, text):
        self.do(node, "function(text) { this.value = text; this.dispatchEvent(new Event('change', { bubbles: true })); }", text)

    def answer(self, exercise):
        """Answers all questions of an exercise, as `camera-lab exercise show --solution --format json` has it."""
        fields = lambda: [node for name, node in self.all("textbox") if name and "earch" not in name]
        entries = [texts(exercise["answers"][ask["name"]]) for ask in exercise["asks"]]
        wait(lambda: len(fields()) >= sum(len(given) for given in entries), "the fields")
        for node, text in zip(fields(), [text for given in entries for text in given]):
            self.write(node, text)
        for place in range(len(entries)):
            button = lambda: [node for name, node in self.all("button") if name.startswith("Check: ")][place]
            wait(lambda: not disabled(button()), "the button of the question")
            self.do(button(), "function() { this.click(); }")
        wait(lambda: self.there("StaticText", lambda text: text.startswith("✓ ")), "the verdict")
