"""Reads the page of a command in bench/: its sections, figures and numbers."""

import json
import os
import subprocess
from html.parser import HTMLParser


def lookup(results, pointer):
    for key in pointer.split("/")[1:]:
        key = key.replace("~1", "/").replace("~0", "~")
        results = results[int(key)] if isinstance(results, list) else results[key]
    return results


class Page(HTMLParser):
    """Sections, images, numbers with the places that they come from, and the text of each section."""

    def __init__(self, text):
        super().__init__()
        self.sections, self.images, self.numbers = {}, [], []
        self.section = self.number = None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "section":
            self.section = attributes["id"]
            self.sections[self.section] = ""
        elif tag == "img":
            self.images.append(attributes)
        elif tag == "data":
            self.number = {**attributes, "text": "", "section": self.section}

    def handle_data(self, text):
        if self.section:
            self.sections[self.section] += text
        if self.number:
            self.number["text"] += text

    def handle_endtag(self, tag):
        if tag == "data":
            self.numbers.append(self.number)
            self.number = None


def half_of_last_digit(text):
    mantissa, _, exponent = text.replace(",", "").partition("e")
    digits = len(mantissa.partition(".")[2])
    return 0.5000001 * 10.0 ** (int(exponent or 0) - digits)


class QuickForm:
    """To be mixed into a unittest.TestCase. command: path of the program, whose quick form is run into the folder `out`."""

    command = out = ""

    @classmethod
    def setUpClass(cls):
        done = subprocess.run([cls.command, "--quick", "--out", cls.out], stdout=subprocess.PIPE, text=True)
        assert done.returncode == 0, f"{cls.command} --quick ended with status {done.returncode}"
        cls.said = done.stdout
        with open(os.path.join(cls.out, "results.json"), encoding="utf-8") as file:
            cls.results = json.load(file)
        with open(os.path.join(cls.out, "index.html"), encoding="utf-8") as file:
            cls.text = file.read()
        cls.page = Page(cls.text)

    def test_says_where_to_look(self):
        self.assertIn(os.path.join(self.out, "index.html"), self.said)
