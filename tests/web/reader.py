"""What a screen reader has of the page: Chromium's accessibility tree and its actions, and nothing of what is drawn."""

from browser import wait


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

    def there(self, role, name):
        """The first control whose name is this one, or passes this test."""
        passes = name if callable(name) else lambda found: found == name
        return next((node for found, called, node in self.nodes() if found == role and passes(called)), None)

    def do(self, node, function, *given):
        control = self.page.do("DOM.resolveNode", backendNodeId=node["backendDOMNodeId"])["object"]["objectId"]
        self.page.do("Runtime.callFunctionOn", objectId=control, functionDeclaration=function, arguments=[{"value": one} for one in given])

    def press(self, role, name):
        self.do(wait(lambda: self.there(role, name), f"{role} {name}"), "function() { this.click(); }")

    def write(self, role, name, text):
        node = wait(lambda: self.there(role, name), f"{role} {name}")
        self.do(node, "function(text) { this.value = text; this.dispatchEvent(new Event('change', { bubbles: true })); }", text)
