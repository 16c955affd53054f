"""Headless Chromium, its tabs, a judge of pictures, and a server for the page. Nothing but Python's own library is needed."""

import base64
import http.server
import json
import os
import shutil
import socket
import struct
import subprocess
import sys
import time

WIDTH, HEIGHT = 1280, 720
CTRL, SHIFT = 2, 8


class Browser:
    """Chromium, driven by its own protocol: https://chromedevtools.github.io/devtools-protocol/"""

    def __init__(self, scratch):
        program = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
        if not program:
            sys.exit("tests/web/run: there is no chromium")
        profile = scratch / "profile"
        self.log = open(scratch / "chromium.log", "wb")
        self.process = subprocess.Popen(
            [
                program, "--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
                "--disable-component-update", "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                "--force-color-profile=srgb", "--hide-scrollbars", "--lang=en-US", "--remote-debugging-port=0",
                f"--user-data-dir={profile}", "about:blank",
            ],
            stdout=self.log, stderr=self.log,
        )
        port_file = profile / "DevToolsActivePort"
        wait(lambda: port_file.exists() and len(port_file.read_text().split()) == 2, "Chromium to start", 60)
        port, path = port_file.read_text().split()
        self.socket = connect(int(port), path)
        self.next, self.events = 0, []

    def call(self, method, session=None, **parameters):
        """Asks for something, and waits for the answer."""
        self.next += 1
        message = {"id": self.next, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        send(self.socket, json.dumps(message).encode())
        while True:
            answer = json.loads(receive(self.socket))
            if answer.get("id") == self.next:
                if "error" in answer:
                    raise AssertionError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def close(self):
        self.socket.close()
        self.process.terminate()
        self.process.wait()
        self.log.close()


def connect(port, path):
    """Opens a web socket (RFC 6455)."""
    link = socket.create_connection(("127.0.0.1", port), timeout=120)
    key = base64.b64encode(os.urandom(16)).decode()
    link.sendall(
        f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
    )
    head = b""
    while not head.endswith(b"\r\n\r\n"):
        head += link.recv(1)
    assert b" 101 " in head.split(b"\r\n")[0], head
    return link


def send(link, data):
    mask = os.urandom(4)
    length = len(data)
    head = b"\x81" + (
        bytes([0x80 | length]) if length < 126
        else b"\xfe" + struct.pack(">H", length) if length < 1 << 16
        else b"\xff" + struct.pack(">Q", length)
    )
    repeated = (mask * (length // 4 + 1))[:length]
    masked = (int.from_bytes(data, "big") ^ int.from_bytes(repeated, "big")).to_bytes(length, "big")
    link.sendall(head + mask + masked)


def receive(link):
    whole = b""
    while True:
        first, second = exactly(link, 2)
        length = second & 0x7F
        if length == 126:
            (length,) = struct.unpack(">H", exactly(link, 2))
        elif length == 127:
            (length,) = struct.unpack(">Q", exactly(link, 8))
        whole += exactly(link, length)
        if first & 0x80:
            return whole


def exactly(link, count):
    parts = []
    while count:
        part = link.recv(min(count, 1 << 20))
        if not part:
            raise AssertionError("Chromium has gone")
        parts.append(part)
        count -= len(part)
    return b"".join(parts)


def wait(there, what, seconds=20.0):
    """Waits until something is there, and gives it."""
    end = time.monotonic() + seconds
    while True:
        found = there()
        if found:
            return found
        if time.monotonic() > end:
            raise AssertionError(f"waited {seconds} s for {what}")
        time.sleep(0.05)


class Page:
    """A tab, with storage of its own."""

    def __init__(self, browser, downloads, language="en-US", size=(WIDTH, HEIGHT), dark=False, touch=False):
        self.browser, self.downloads = browser, downloads
        self.context = browser.call("Target.createBrowserContext")["browserContextId"]
        browser.call(
            "Browser.setDownloadBehavior", behavior="allow", browserContextId=self.context, downloadPath=str(downloads)
        )
        target = browser.call("Target.createTarget", url="about:blank", browserContextId=self.context)["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.do("Page.enable")
        self.do("Runtime.enable")
        self.do("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=touch)
        self.do("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        if touch:
            self.do("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=5)
        # Headless Chromium takes its language from the system.
        self.do(
            "Page.addScriptToEvaluateOnNewDocument",
            source=f"Object.defineProperty(navigator, 'language', {{get: () => '{language}'}});",
        )

    def do(self, method, **parameters):
        return self.browser.call(method, self.session, **parameters)

    def ask(self, expression):
        """The value of an expression in the page; of a promise, what comes of it."""
        answer = self.do("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise AssertionError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def open(self, url):
        self.do("Page.navigate", url=url)
        self.ready()

    def reload(self):
        self.do("Page.reload")
        self.ready()

    def ready(self):
        wait(lambda: self.ask("window.cameraLab?.ready"), "the first picture", 60)
        self.settle()

    def settle(self):
        """Waits until nothing on the screen changes any more."""
        before = None
        for _ in range(60):
            now = self.shot()
            if now == before:
                return now
            before = now
            time.sleep(0.12)
        raise AssertionError("the page does not come to rest")

    def shot(self, place=None):
        clip = {"clip": {**place, "scale": 1}} if place else {}
        return base64.b64decode(self.do("Page.captureScreenshot", format="png", **clip)["data"])

    def figure(self):
        return self.ask("cameraLab.figure()")

    def pictures(self):
        return self.ask("cameraLab.pictures()")

    def mouse(self, kind, x, y, **more):
        self.do("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def click(self, x, y):
        self.mouse("mouseMoved", x, y)
        self.mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
        self.mouse("mouseReleased", x, y, button="left", clickCount=1)

    def key(self, key, code=None, modifiers=0):
        codes = {"Enter": 13, "Tab": 9, "Escape": 27}
        number = codes.get(key) or (ord(key.upper()) if len(key) == 1 else 0)
        common = {"key": key, "code": code or key, "modifiers": modifiers, "windowsVirtualKeyCode": number}
        text = {"text": key} if len(key) == 1 and not modifiers & CTRL else {}
        self.do("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", **common, **text)
        self.do("Input.dispatchKeyEvent", type="keyUp", **common)

    def control(self, letter, shift=False):
        self.key(letter, f"Key{letter.upper()}", CTRL | (SHIFT if shift else 0))

    def write(self, text):
        # As text and not as keys: the code of "." as a letter is that of the key Delete.
        for character in text:
            self.do("Input.insertText", text=character)
            time.sleep(0.02)

    def downloaded(self, name):
        """The bytes of the file that was handed over last."""
        path = self.downloads / name
        wait(lambda: path.exists() and path.stat().st_size > 0, f"{name} among the downloads")
        data = path.read_bytes()
        path.unlink()
        return data

    def close(self):
        self.browser.call("Target.disposeBrowserContext", browserContextId=self.context)


class Judge:
    """A page of its own that looks at pictures: their colours, and how two of them differ."""

    LOOK = """async (encoded) => {
      const bytes = Uint8Array.from(atob(encoded), (c) => c.charCodeAt(0));
      const picture = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const canvas = new OffscreenCanvas(picture.width, picture.height);
      const context = canvas.getContext('2d', { willReadFrequently: true });
      context.drawImage(picture, 0, 0);
      return context.getImageData(0, 0, picture.width, picture.height);
    }"""

    def __init__(self, browser, downloads):
        self.page = Page(browser, downloads)

    def colours(self, picture):
        return self.page.ask(
            f"({self.LOOK})('{base64.b64encode(picture).decode()}').then((p) => new Set(new Uint32Array(p.data.buffer)).size)"
        )

    def difference(self, one, other):
        """How many pixels inside of the frame differ, by how much at most, and where the first are."""
        one, other = (base64.b64encode(picture).decode() for picture in (one, other))
        return self.page.ask(
            f"""(async () => {{
              const look = {self.LOOK};
              const [one, other] = [await look('{one}'), await look('{other}')];
              if (one.width !== other.width || one.height !== other.height)
                return `${{one.width}} x ${{one.height}}, ${{other.width}} x ${{other.height}}`;
              let count = 0, most = 0;
              const at = [];
              for (let i = 0; i < one.data.length; i += 4) {{
                const x = (i / 4) % one.width, y = Math.floor(i / 4 / one.width);
                // The frame of the window is around its pictures.
                if (x === 0 || y === 0 || x === one.width - 1 || y === one.height - 1) continue;
                let by = 0;
                for (let c = 0; c < 4; c++) by = Math.max(by, Math.abs(one.data[i + c] - other.data[i + c]));
                if (by) {{ count++; if (at.length < 5) at.push([x, y]); }}
                most = Math.max(most, by);
              }}
              return [count, most, at];
            }})()"""
        )


class Server(http.server.SimpleHTTPRequestHandler):
    extensions_map = {".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm"}
    # A file that the server has lost.
    lost = None

    def do_GET(self):
        if self.lost and self.path.endswith(self.lost):
            self.send_error(404)
        else:
            super().do_GET()

    def log_message(self, *_):
        pass
