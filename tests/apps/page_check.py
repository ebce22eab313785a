# SPDX-License-Identifier: MIT
"""page_check.py PAGE.html [SCREENSHOT_FOLDER]: opens a page in a headless Chromium, at the widths of
laptops and phones, and says what is wrong with it. Needs Debian's chromium and chromium-driver."""
import base64
import contextlib
import json
import pathlib
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

import page_rules

WIDTHS = {1280: 800, 768: 1024, 360: 740, 320: 640}  # and heights
CHROMIUM_ARGUMENTS = [
    "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--disable-dev-shm-usage", "--hide-scrollbars",
]
SMALLEST_TEXT = 11  # CSS pixels

OVERFLOWING = """
const wide = [];
const scroll = document.documentElement.scrollWidth;
if (scroll > innerWidth) wide.push(`the page is ${scroll} wide`);
for (const e of document.body.querySelectorAll('*')) {
  const style = getComputedStyle(e);
  if (style.clipPath !== 'none') continue;
  const box = e.getBoundingClientRect();
  const name = `<${e.tagName.toLowerCase()} class="${e.className}"> ${e.textContent.slice(0, 40)}`;
  if (box.width > 0 && (box.right > innerWidth + 0.5 || box.left < -0.5)) wide.push(`${name} sticks out`);
  if (style.overflowX !== 'visible' && e.scrollWidth > e.clientWidth) wide.push(`${name} scrolls`);
}
return wide;
"""

SPILLING_CELLS = """
return [...document.querySelectorAll('th, td')].filter(e => {
  if (!e.textContent) return false;
  if (e.closest('thead') && getComputedStyle(e.closest('thead')).clipPath !== 'none') return false;
  const range = document.createRange();
  range.selectNodeContents(e);
  const cell = e.getBoundingClientRect(), text = range.getBoundingClientRect();
  return cell.width > 0 && (text.right > cell.right + 1 || text.left < cell.left - 1);
}).map(e => `text leaves its cell: ${e.textContent.slice(0, 40)}`);
"""

BAD_IMAGES = """
return [...document.images].filter(i => !i.complete || !i.naturalWidth).map(i => `not shown: ${i.alt}`);
"""

REQUESTS = """
return performance.getEntriesByType('resource').map(e => e.name)
  .filter(name => !name.startsWith('data:')).map(name => `asked for ${name}`);
"""

SMALL_TEXT = """
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
const found = [];
for (let n = walker.nextNode(); n; n = walker.nextNode()) {
  const size = parseFloat(getComputedStyle(n.parentElement).fontSize);
  if (n.textContent.trim() && size < arguments[0])
    found.push(`${size} px: ${n.textContent.trim().slice(0, 40)}`);
}
return found;
"""

# Each radio input must bring up a view of its own, and move nothing.
TOGGLES = """
const faults = [];
for (const gallery of document.querySelectorAll('.gallery')) {
  const shown = () => [...gallery.querySelectorAll('.view')]
    .map((v, i) => getComputedStyle(v).visibility === 'visible' ? i : -1).filter(i => i >= 0).join();
  const inputs = [...gallery.querySelectorAll('input')];
  const height = gallery.getBoundingClientRect().height;
  inputs.forEach((input, i) => {
    gallery.querySelector(`label[for="${input.id}"]`).click();
    if (shown() !== String(i)) faults.push(`${input.id} shows view ${shown()}`);
    if (gallery.getBoundingClientRect().height !== height) faults.push(`${input.id} moves the page`);
  });
  if (inputs.length) inputs[0].click();
  if (shown() !== '0') faults.push(`${gallery.id} shows view ${shown()} first`);
}
return faults;
"""

FIRST_RADIO = "const r = document.querySelector('.gallery input'); if (r) r.focus(); return !!r;"
SECOND_CHOSEN = "return document.querySelectorAll('.gallery input')[1].checked;"
ARROW_RIGHT = "\ue014"


class Browser:
    """A session of chromedriver (W3C WebDriver)."""

    def __init__(self, port, profile):
        self.base = f"http://127.0.0.1:{port}"
        options = {"args": CHROMIUM_ARGUMENTS + [f"--user-data-dir={profile}"]}
        answer = self.ask("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL"}}}})
        self.base += f"/session/{answer['sessionId']}"

    def ask(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"},
                                         method=method)
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(error.read().decode()[:2000]) from error

    def run(self, script, *arguments):
        return self.ask("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def devtools(self, command, **parameters):
        return self.ask("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def open(self, page, width):
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=WIDTHS[width],
                      deviceScaleFactor=1, mobile=width < 700)
        self.ask("POST", "/url", {"url": pathlib.Path(page).resolve().as_uri()})

    def console(self):
        entries = self.ask("POST", "/se/log", {"type": "browser"})
        return [f"console: {e['message']}" for e in entries if e["level"] in ("SEVERE", "WARNING")]

    def press(self, key):
        self.ask("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": [
            {"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]}]})

    def screenshot(self, file):
        shot = self.devtools("Page.captureScreenshot", format="png", captureBeyondViewport=True)
        file.write_bytes(base64.b64decode(shot["data"]))

    def close(self):
        self.ask("DELETE", "")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for(port, driver):
    for _ in range(200):
        if driver.poll() is not None:
            raise RuntimeError("chromedriver ended at once")
        with contextlib.suppress(OSError):
            socket.create_connection(("127.0.0.1", port), timeout=1).close()
            return
        time.sleep(0.1)
    raise RuntimeError("chromedriver does not answer")


@contextlib.contextmanager
def browser():
    port = free_port()
    with tempfile.TemporaryDirectory(prefix="penumbra-chromium-", ignore_cleanup_errors=True) as profile:
        driver = subprocess.Popen(["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL)
        try:
            wait_for(port, driver)
            session = Browser(port, profile)
            try:
                yield session
            finally:
                session.close()
        finally:
            driver.terminate()
            driver.wait()


def keyboard_faults(session):
    """An arrow key goes on to the next view, as in any group of radio inputs."""
    if session.run("return document.querySelectorAll('.gallery input').length") < 2:
        return []
    session.run(FIRST_RADIO)
    session.press(ARROW_RIGHT)
    found = [] if session.run(SECOND_CHOSEN) else ["the arrow key does not choose the next view"]
    session.run("document.querySelector('.gallery input').click()")
    return found


def faults_at(session, page, width, folder):
    session.open(page, width)
    found = session.run(OVERFLOWING) + session.run(SPILLING_CELLS) + session.run(BAD_IMAGES)
    found += session.run(REQUESTS) + session.run(TOGGLES) + keyboard_faults(session)
    found += session.run(SMALL_TEXT, SMALLEST_TEXT)
    if folder:
        session.run("document.activeElement.blur(); scrollTo(0, 0)")
        session.screenshot(folder / f"{width}.png")
    return [f"{width} wide: {fault}" for fault in found + session.console()]


def main():
    page = pathlib.Path(sys.argv[1])
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    if folder:
        folder.mkdir(parents=True, exist_ok=True)
    found = page_rules.faults(page)
    with browser() as session:
        for width in WIDTHS:
            found += faults_at(session, page, width, folder)
    print("\n".join(found) or f"{page}: nothing wrong at {', '.join(map(str, WIDTHS))} pixels")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
