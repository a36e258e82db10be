# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a screen, by chromedriver's WebDriver protocol."""
import base64
import json
import re
import shutil
import subprocess
import tempfile
import urllib.request

FLAGS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars")


def missing():
    """The first program that is not installed, if any."""
    return next((name for name in ("chromium", "chromedriver") if not shutil.which(name)), None)


class Browser:
    def __init__(self):
        self.profile = tempfile.TemporaryDirectory(prefix="report-browser-", ignore_cleanup_errors=True)
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE,
                                       stderr=subprocess.DEVNULL, text=True)
        self.opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        self.session = None
        try:
            started = re.compile(r"successfully on port (\d+)")
            port = next(match[1] for line in self.driver.stdout if (match := started.search(line)))
            self.base = f"http://127.0.0.1:{port}/session"
            options = {"binary": shutil.which("chromium"), "args": [*FLAGS, f"--user-data-dir={self.profile.name}"]}
            wanted = {"goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}
            self.session = self.call("POST", "", {"capabilities": {"alwaysMatch": wanted}})["sessionId"]
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        try:
            if self.session:
                self.call("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()
            self.driver.stdout.close()
            self.profile.cleanup()

    def call(self, method, command, body=None):
        url = self.base + (f"/{self.session}" if self.session else "") + command
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(url, data, {"Content-Type": "application/json"}, method=method)
        with self.opener.open(request, timeout=200) as answer:
            return json.load(answer)["value"]

    def open(self, path):
        self.call("POST", "/url", {"url": path.resolve().as_uri()})

    def leave(self):
        """Shows nothing; a window of another size would lay the page of before out anew."""
        self.call("POST", "/url", {"url": "about:blank"})

    def run(self, script, *arguments):
        return self.call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def emulate(self, width, dark=False):
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=844 if width < 600 else 900,
                      deviceScaleFactor=1, mobile=width < 600)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.devtools("Emulation.setEmulatedMedia", features=[scheme])

    def devtools(self, command, **parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def log(self, kind):
        return self.call("POST", "/se/log", {"type": kind})

    def printed(self):
        """The page as a PDF, without the tags for screen readers, which take half of the time. It is not what the
        command `print` of WebDriver makes, as chromedriver gives that ten seconds."""
        answer = self.devtools("Page.printToPDF", preferCSSPageSize=True, generateTaggedPDF=False)
        return base64.b64decode(answer["data"])
