#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Opens the pages of cigsim report in Chromium, without a screen, and clicks through them.

    page_test.py CIGSIM

Exit code 77 (skipped) without Chromium, its driver or Debian's python3-selenium.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 77
HOSTILE = "</script><script>document.title='broken'</script><img src=x onerror=alert(1)> & \"'"
STAGES = 6


def skip(why):
    print("skipped:", why)
    sys.exit(SKIPPED)


if len(sys.argv) != 2:
    sys.exit(__doc__)
CIGSIM = pathlib.Path(sys.argv[1]).resolve()
CHROMIUM = shutil.which("chromium") or skip("chromium is missing (Debian package chromium)")
DRIVER = shutil.which("chromedriver") or skip("chromedriver is missing (chromium-driver)")
try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select
except ImportError:
    skip("selenium is missing (Debian package python3-selenium)")


def read_ids(file):
    """Object numbers of a PGM: width, height, and rows one after the other."""
    head, size, largest, values = file.read_bytes().split(b"\n", 3)
    assert (head, largest) == (b"P5", b"65535")
    width, height = map(int, size.split())
    return width, height, [values[2 * i] << 8 | values[2 * i + 1] for i in range(width * height)]


def hostile_scene():
    corners = [[x, y, z] for z in (0, 4) for y in (0, 4) for x in (0, 4)]
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]]

    def box(name, east):
        return {"name": name, "vertices": [[x + east, y, z] for x, y, z in corners],
                "faces": faces}

    return {"cigsim": 1, "name": HOSTILE,
            "objects": [box(HOSTILE, 0), box("&lt;b&gt; & <b>", 6)]}


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name)
        options = webdriver.ChromeOptions()
        options.binary_location = CHROMIUM
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu",
                         "--disable-dev-shm-usage", "--disable-background-networking",
                         "--window-size=1280,1000", f"--user-data-dir={cls.folder / 'profile'}"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        cls.browser = webdriver.Chrome(options=options, service=Service(DRIVER))

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.place.cleanup()

    def cigsim(self, *arguments):
        subprocess.run([CIGSIM, *map(str, arguments)], cwd=self.folder, check=True,
                       stdout=subprocess.DEVNULL)

    def report(self, folder, *arguments):
        self.cigsim("report", folder, *arguments)
        self.open(self.folder / folder / "report.html")

    def machine(self, preset, **changes):
        """The file of a preset with some figures changed."""
        told = subprocess.run([CIGSIM, "machines", preset, "--json"], check=True,
                              capture_output=True).stdout
        machine = json.loads(told)
        for name, value in changes.items():
            figures = machine["figures"]
            (figures if name in figures else figures["formats"])[name]["value"] = value
        (self.folder / "changed.json").write_text(json.dumps(machine))
        return "changed.json"

    def open(self, page):
        self.browser.get_log("performance")
        self.browser.get(page.as_uri())

    def tearDown(self):
        """No page writes errors, asks for anything, or is wider than a telephone."""
        self.assertEqual(self.browser.get_log("browser"), [])
        messages = [json.loads(entry["message"])["message"]
                    for entry in self.browser.get_log("performance")]
        asked = {message["params"]["request"]["url"].split(":")[0] for message in messages
                 if message["method"] == "Network.requestWillBeSent" and
                 message["params"]["documentURL"].startswith("file:")}  # not the first empty page
        self.assertLessEqual(asked, {"file", "data"})
        for width in (1280, 360):
            self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                "width": width, "height": 800, "deviceScaleFactor": 1, "mobile": False})
            self.assertLessEqual(self.browser.execute_script(
                "return document.documentElement.scrollWidth"), width)
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def place_of_hair(self):
        return [int(field.get_property("value")) for field in self.all(".coordinates input")]

    def shown_objects(self, points):
        """What the page shows after a click at the middle of each of these elements."""
        return self.browser.execute_script("""
            const box = document.querySelector('.picture'), [width, height] = data.run.options.raster;
            return arguments[0].map(([column, line]) => {
              const area = box.getBoundingClientRect();
              box.dispatchEvent(new MouseEvent('click', {
                clientX: area.left + (column + .5) * area.width / width,
                clientY: area.top + (line + .5) * area.height / height}));
              const place = [...document.querySelectorAll('.coordinates input')].map(i => +i.value);
              return [...place, +document.querySelector('.priority li').dataset.object];
            });""", points)

    def check_lists(self, frame, ids):
        """The first entry of the list is the object of the picture: clicked at some elements, and
        asked of the page's rule for all."""
        width, height, objects = ids
        points = [[i * 7919 % width, i * 104729 % height] for i in range(400)]
        expected = [[c, r, objects[r * width + c]] for c, r in points]
        self.assertEqual(self.shown_objects(points), expected)
        every = self.browser.execute_script("""
            const frame = data.run.shown[arguments[0]], [width, height] = data.run.options.raster;
            const out = [];
            for (let line = 0; line < height; ++line)
              for (let column = 0; column < width; ++column) {
                const first = facesAt(frame, column, line, width).find(face => !face.dropped);
                out.push(first ? first.object : 0);
              }
            return out;""", frame)
        self.assertEqual(every, objects)

    def test_functional_run(self):
        self.cigsim("run", "--path", "builtin", "--frames", 5, "--raster", "160x120", "--number",
                    "float", "--out", "air")
        self.report("air", "--frames", 3)
        select = Select(self.one("#frame-select"))
        self.assertEqual([option.text for option in select.options],
                         ["frame 0", "frame 2", "frame 4"])
        pictures = set()
        for index, frame in enumerate((0, 2, 4)):
            Select(self.one("#frame-select")).select_by_index(index)
            pictures.add(self.one(".picture img").get_attribute("src"))
            self.assertEqual(len(self.all(".timeline .stage")), STAGES)
            self.check_lists(index, read_ids(self.folder / "air" / f"ids-000{frame}.pgm"))
        self.assertEqual(len(pictures), 3)
        self.assertTrue(self.one("#frames .toolbar button:last-of-type").get_property("disabled"))
        self.one("#frames .toolbar button").click()
        self.assertEqual(Select(self.one("#frame-select")).first_selected_option.text, "frame 2")
        self.assertIn("not on machine words", self.one("#machine").text)

    def test_difference_pictures(self):
        narrow = self.machine("unlimited", coordinate_bits=16, raster_fraction=4)
        self.cigsim("run", "--machine", narrow, "--raster", "160x120", "--out", "words")
        self.report("words")
        self.assertIn("another object", self.one(".difference").text)
        sources = set()
        for kind in ("picture", "difference", "exact"):
            self.one(f"input[value={kind}]").click()
            self.assertEqual(self.browser.switch_to.active_element.get_attribute("value"), kind)
            self.assertGreater(self.one(".picture img").get_property("naturalWidth"), 0)
            sources.add(self.one(".picture img").get_attribute("src"))
        self.assertEqual(len(sources), 3)
        exact = self.browser.execute_script("return data.run.shown[0].difference")
        self.assertGreater(len(exact["places"]), 1)
        self.one("input[value=difference]").click()
        self.assertEqual(len(self.all(".hair circle")), len(exact["places"]))
        for _ in range(2):
            self.one(".next-difference").click()
            self.assertIn(self.place_of_hair(), exact["places"])

    def test_timed_run(self):
        self.cigsim("run", "--machine", "asupt1975", "--level", "timed", "--path", "builtin",
                    "--frames", 4, "--raster", "160x120", "--out", "timed")
        self.report("timed")
        stats = json.loads((self.folder / "timed" / "stats.json").read_text())
        for index in range(4):
            Select(self.one("#frame-select")).select_by_index(index)
            stages = self.all(".timeline .stage")
            self.assertEqual(len(stages), STAGES)
            for stage in stages:
                own = stats["frames"][index]["timing"]["stages"][stage.get_attribute("data-stage")]
                words = stage.get_attribute("aria-label").replace("\u202f", "")
                for doing in ("busy", "idle", "stalled"):
                    self.assertIn(f" {own[doing]} {doing}", words)
            self.check_lists(index, read_ids(self.folder / "timed" / f"ids-000{index}.pgm"))
        ActionChains(self.browser).move_to_element(stages[-1]).perform()
        self.assertIn("video processor: cycles", self.one(".readout").text)
        standings = {tag.text for tag in self.all("#machine .tag")}
        self.assertIn("recalled", standings)
        self.assertIn("reconstruction", standings)

    def test_overfull_lines(self):
        for policy in ("drop", "cut"):
            small = self.machine("asupt1975", crossing_capacity=12)
            self.cigsim("run", "--machine", small, "--raster", "160x120", "--overload", policy,
                        "--out", policy)
            self.report(policy)
            self.check_lists(0, read_ids(self.folder / policy / "ids-0000.pgm"))
            self.assertIsNotNone(self.one(".crossings .capacity"))

    def test_keys(self):
        self.cigsim("run", "--raster", "160x120", "--out", "keys")
        self.report("keys")
        picture = self.one(".picture")
        picture.click()
        place = self.place_of_hair()
        picture.send_keys(Keys.ARROW_RIGHT, Keys.ARROW_UP, Keys.SHIFT + Keys.ARROW_LEFT)
        self.assertEqual(self.place_of_hair(), [place[0] - 15, place[1] - 1])
        box = self.all(".coordinates input")[0]
        box.clear()
        box.send_keys("9999", Keys.TAB)
        self.assertEqual(self.place_of_hair()[0], 159)

    def test_hostile_names_are_text(self):
        name = "<b>&'.json"
        (self.folder / name).write_text(json.dumps(hostile_scene()))
        self.cigsim("run", name, "--eye", "3,-20,9", "--look-at", "5,2,2", "--raster", "160x120",
                    "--out", "hostile")
        self.report("hostile")
        self.assertEqual(self.browser.title, name + " – cigsim report")
        self.assertEqual(self.one("h1").text, name)
        ids = read_ids(self.folder / "hostile" / "ids-0000.pgm")
        self.check_lists(0, ids)
        first = ids[2].index(1)
        self.shown_objects([[first % ids[0], first // ids[0]]])
        self.assertEqual(self.one(".priority .name").get_property("textContent"), HOSTILE)
        self.assertEqual(self.all("main script, main b, img[src=x]"), [])

    def test_scene_that_is_gone(self):
        (self.folder / "gone.json").write_text(json.dumps(hostile_scene()))
        self.cigsim("run", "gone.json", "--raster", "160x120", "--out", "gone")
        (self.folder / "gone.json").unlink()
        self.report("gone")
        self.assertIn("The scene cannot be had any more", self.one(".note").text)
        self.assertGreater(self.one(".picture img").get_property("naturalWidth"), 0)
        self.assertEqual(self.all(".priority"), [])

    def test_experiment(self):
        self.cigsim("experiment", "levine", "--cases", 2, "--only", "hull", "--out", "levine")
        (self.folder / "levine" / "hostile.json").write_text(json.dumps(
            {"experiment": HOSTILE, "rows": [{HOSTILE: HOSTILE, "deep": {"list": [1, [2, 3]]}}],
             "matrix": [[1, 2], [3, 4]], "nothing": None, "many": list(range(100))}))
        (self.folder / "levine" / "z.svg").write_text(
            "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>"
            "<script>alert(1)</script><image href='http://example.invalid/x.png'/></svg>")
        self.report("levine")
        self.assertEqual(len(self.all(".drawing img")), 4)
        for details in self.all("details"):
            self.browser.execute_script("arguments[0].open = true", details)
        for drawing in self.all(".drawing img"):
            self.browser.execute_script("arguments[0].scrollIntoView()", drawing)
            self.browser.execute_async_script(
                "arguments[0].decode().then(arguments[1], arguments[1])", drawing)
            self.assertGreater(drawing.get_property("naturalWidth"), 0)
        self.assertIn(HOSTILE, self.one("#experiment-0").get_property("textContent"))
        self.assertEqual(self.all("main script, img[src=x]"), [])
        self.assertIn("cube-4", self.one("#experiment-1").get_property("textContent"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
