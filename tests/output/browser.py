"""What tests of pages have in common: the program, a browser, and what is looked for on a page.

A test ends with 77, and says why, where Chromium, its driver or Selenium are not there.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 77

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    webdriver = ActionChains = By = Keys = None

FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--window-size=1200,900",
         "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]  # WebGL without a graphics card

program, folder = None, None


def number(text):
    """What the page shows as -1,234.5 or 1.23 times a power of ten."""
    mantissa, _, exponent = text.replace(",", "").replace("\u2212", "-").partition("\u00d710")
    return float(mantissa) * 10.0 ** int(exponent.translate(str.maketrans("\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079", "-0123456789")) or 0)


def missing():
    if webdriver is None:
        return "python3-selenium is not there"
    for name in ["chromium", "chromedriver"]:
        if shutil.which(name) is None:
            return f"{name} is not there"
    return None


def run(*arguments, status=0, environment={}):
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True,
                          env={**os.environ, "GOMP_SPINCOUNT": "1000", **environment})
    assert done.returncode == status, f"{arguments}: status {done.returncode}\n{done.stdout}{done.stderr}"


def place(name):
    """What runs of this test have left."""
    return pathlib.Path(folder) / name


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.profile = tempfile.mkdtemp()
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for flag in [*FLAGS, f"--user-data-dir={cls.profile}"]:
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        cls.browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        shutil.rmtree(cls.profile, ignore_errors=True)

    def open(self, path):
        """Opens a page, which must tell of no error and ask for nothing but itself."""
        for log in ["browser", "performance"]:
            self.browser.get_log(log)
        self.browser.get(place(path).as_uri())
        self.addCleanup(self.expect_quiet)

    def expect_quiet(self):
        told = [entry for entry in self.browser.get_log("browser")
                if "Canvas2D" not in entry["message"] and "ReadPixels" not in entry["message"]]  # pictures read by this test
        self.assertEqual(told, [])
        for entry in self.browser.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                url = message["params"]["request"]["url"]
                self.assertRegex(url, "^(file|data|chrome):", "a request")  # chrome: of the tab that it begins with

    def all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        found = self.all(selector)
        self.assertEqual(len(found), 1, selector)
        return found[0]

    def texts(self, selector):
        return [element.text for element in self.all(selector)]

    def panel(self, title):
        panels = self.browser.execute_script("""
            return [...document.querySelectorAll('figure.panel')].filter((p) => p.querySelector('h3').innerText.trim() === arguments[0]);
            """, title)
        self.assertEqual(len(panels), 1, title)
        return panels[0]

    def shown(self, selector, inside=None):
        """Texts of what is displayed, and how high each is: asked for at once, since each question takes milliseconds."""
        return self.browser.execute_script(r"""
            return [...(arguments[1] || document).querySelectorAll(arguments[0])]
                .filter((e) => e.checkVisibility({checkOpacity: true, checkVisibilityCSS: true}))
                .map((e) => [e.innerText.replace(/\s+/g, ' ').trim(), e.offsetHeight]);""", selector, inside)

    def expect_curves(self):
        """Every panel has more than a few points drawn on its canvas."""
        drawn = self.browser.execute_script("""
            return [...document.querySelectorAll('figure.panel')].map((panel) => {
              const canvas = panel.querySelector('canvas');
              const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
              let points = 0;
              for (let i = 3; i < pixels.length; i += 4) if (pixels[i] > 200) ++points;
              return [panel.querySelector('h3').textContent, points];
            });""")
        self.assertGreater(len(drawn), 2)
        for title, points in drawn:
            self.assertGreater(points, 200, title)

    def values(self, panel):
        return {li.find_element(By.CSS_SELECTOR, "button > span:nth-child(2)").text:
                li.find_element(By.TAG_NAME, "output").text for li in panel.find_elements(By.CSS_SELECTOR, ".legend li")}

    def hover(self, panel, across=0.5):
        canvas = panel.find_element(By.CSS_SELECTOR, ".chart canvas:last-of-type")
        self.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
        width = canvas.size["width"]
        ActionChains(self.browser).move_to_element_with_offset(canvas, int((across - 0.5) * width), 0).perform()


def main():
    """Of a test: NAME.py PROGRAM FOLDER."""
    global program, folder
    reason = missing()
    if reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    program, folder = (os.path.abspath(path) for path in sys.argv[1:3])
    os.makedirs(folder, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
