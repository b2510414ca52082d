#!/usr/bin/env python3
"""The report's pages of the sample machines in a headless Chromium: layout, search, links, keyboard, colours, paper.

    browser_test.py PLCXX ROOT [CHROMIUM]

Exit code 77, "skipped", where there is no Chromium.
"""

import base64
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # nothing is written beside the sources
from browser import Browser  # noqa: E402

SAMPLES = ("nc110/lathe_16k20", "prostep/mill_fnd32", "host50/ck6150", "technol/mcv_750", "hnc/mill_xk7132")
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


def write_page(plcxx, root, sample, directory):
    folder = os.path.join(root, "samples", sample)
    dialect = sample.split("/")[0]
    ran = subprocess.run([plcxx, "report", "--name", dialect, "-o", directory], cwd=folder, capture_output=True, text=True,
                         check=False)
    check(ran.returncode == 0, sample + ": plcxx report gives " + str(ran.returncode) + "\n" + ran.stderr)
    return os.path.join(directory, dialect + ".html")


def layout(browser, page, name):
    for width in (1280, 800, 390):
        browser.open(page, width=width)
        # Laid out as a whole: what is not near the window would not count.
        browser.evaluate("""document.head.appendChild(Object.assign(document.createElement('style'),
            {textContent: '.row, .group, .sig { content-visibility: visible !important }'})); 0""")
        wide = browser.evaluate("""Array.from(document.querySelectorAll('main *:not(svg *)')).filter(element =>
            element.getBoundingClientRect().right > innerWidth + 1 && !element.closest('.lad svg'))
            .slice(0, 3).map(element => element.outerHTML.slice(0, 120))""")
        check(browser.evaluate("document.documentElement.scrollWidth <= innerWidth"),
              f"{name}: wider than a window of {width} pixels: {wide}")
        over = browser.evaluate("""Array.from(document.querySelectorAll('.row:not(.text)')).filter(row => {
            const cells = Array.from(row.querySelectorAll(':scope > pre, :scope > .lad'), c => c.getBoundingClientRect());
            return cells.some((a, i) => cells.some((b, k) => i < k && a.width > 0 && b.width > 0 &&
                a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1));
        }).length""")
        check(over == 0, f"{name}: {over} rows whose cells overlap at {width} pixels")


def long_names(browser, plcxx, root, directory):
    """Names of programs and files have no blanks where a line could end; and the language whose ladder is drawn whole."""
    stem = "lathe_with_turret_and_hydraulic_chuck_2026_as_delivered_and_repaired"
    source = os.path.join(directory, stem + ".plc")
    with open(source, "w", encoding="utf-8") as file:
        file.write("$\nU4A8=I0A3*/I0A4\n")
    turret = os.path.join(root, "samples/classicladder/turret/turret.clp")
    for name, path in ((stem, source), ("turret", turret)):
        ran = subprocess.run([plcxx, "report", "--name", name, "-o", directory, path], capture_output=True, text=True,
                             check=False)
        check(ran.returncode == 0, f"{name}: plcxx report gives {ran.returncode}\n{ran.stderr}")
        layout(browser, os.path.join(directory, name + ".html"), name)


def links(browser, page, name):
    browser.open(page)
    dead = browser.evaluate("""Array.from(document.querySelectorAll('a[href^="#"]')).map(a => a.getAttribute('href'))
        .filter(href => document.getElementById(decodeURIComponent(href.slice(1))) === null).slice(0, 5)""")
    check(dead == [], f"{name}: links without a target: {dead}")
    outside = browser.evaluate("""Array.from(document.querySelectorAll('[href], [src]'))
        .filter(e => !(e.getAttribute('href') || '').startsWith('#')).length""")
    check(outside == 0, name + ": refers to something outside of the page")
    browser.evaluate("document.querySelector('.sig a[href^=\"#s-\"]').click()")
    browser.wait("location.hash.startsWith('#s-')")
    browser.wait("""(() => { const r = document.querySelector(':target').getBoundingClientRect();
        return r.top >= 0 && r.top < innerHeight; })()""")
    requests = [event["params"]["request"]["url"] for event in browser.events
                if event.get("method") == "Network.requestWillBeSent"]
    check(all(url.startswith(("file:", "about:")) for url in requests), f"{name}: requests {requests}")
    faults = [event for event in browser.events if event.get("method") == "Runtime.exceptionThrown"]
    check(not faults, f"{name}: faults of the script: {faults[:1]}")


def search(browser, page):
    browser.open(page)
    every = browser.evaluate("document.querySelectorAll('#program .row').length")
    shown = "Array.from(document.querySelectorAll('#program .row')).filter(row => !row.hidden).length"
    browser.key("/", "/")
    check(browser.evaluate("document.activeElement.id") == "q", "'/' does not lead to the search")
    check(browser.evaluate("document.getElementById('q').value") == "", "'/' is typed into the search")
    browser.type("spori")
    browser.wait(shown + " < " + str(every))
    check(browser.evaluate(shown) > 1, "the search finds no row")
    check(browser.evaluate("""Array.from(document.querySelectorAll('#program .row')).filter(row => !row.hidden)
        .every(row => row.querySelector('.src').textContent.toLowerCase().includes('spori'))"""), "a row does not match")
    check(browser.evaluate("document.querySelectorAll('.sig:not([hidden]):not(.head)').length") >= 1, "no signal is found")
    check("rows" in browser.evaluate("document.getElementById('hits').textContent"), "the number of hits is not told")
    browser.key("Enter", "\r")
    first = browser.evaluate("document.querySelector('.chosen').id")
    browser.key("Enter", "\r")
    check(browser.evaluate("document.querySelector('.chosen').id") != first, "Enter does not go to the next match")
    check(browser.evaluate("""(() => { const r = document.querySelector('.chosen').getBoundingClientRect();
        return r.top >= 0 && r.bottom <= innerHeight + 400; })()"""), "the match is not on the screen")
    browser.key("Escape")
    browser.wait(shown + " === " + str(every))
    check(browser.evaluate("document.getElementById('q').value") == "", "Escape does not clear the search")


def keyboard_and_mouse(browser, page):
    browser.open(page)
    browser.key("j", "j")
    first = browser.evaluate("document.activeElement.id")
    browser.key("j", "j")
    second = browser.evaluate("document.activeElement.id")
    browser.key("k", "k")
    check(first.startswith("s-") and second != first and browser.evaluate("document.activeElement.id") == first,
          "'j' and 'k' do not go through the statements")
    check(browser.evaluate("document.querySelectorAll('.row[id]')[0].matches('.chosen')"), "the statement is not marked")
    for column in ("src", "cpp", "lad"):
        browser.evaluate(f"document.getElementById('show-{column}').click()")
        check(browser.evaluate(f"getComputedStyle(document.querySelector('.row .{column}')).display") == "none",
              column + " cannot be switched off")
        browser.evaluate(f"document.getElementById('show-{column}').click()")
    at = browser.evaluate("""(() => { const t = document.querySelector('.row:not(.text) svg text[data-s]');
        t.scrollIntoView({block: 'center'}); const r = t.getBoundingClientRect();
        return [r.x + r.width / 2, r.y + r.height / 2, t.textContent]; })()""")
    browser.click(at[0], at[1])
    browser.wait("!document.getElementById('card').hidden", 5)
    check(browser.evaluate("document.querySelector('#card strong').textContent").startswith(at[2].split("[")[0]),
          "a click at a contact shows another signal")
    browser.key("Escape")
    check(browser.evaluate("document.getElementById('card').hidden"), "Escape does not close the card")
    unnamed = browser.evaluate("""Array.from(document.querySelectorAll('input, button, svg[role], section')).filter(e =>
        !(e.getAttribute('aria-label') || e.getAttribute('aria-labelledby') || (e.labels && e.labels.length))).length""")
    check(unnamed == 0, f"{unnamed} fields, buttons, pictures or sections have no name")


def contrast(browser, page):
    """Texts against what they stand on, at least 4.5 to 1 (WCAG AA), in light and in dark."""
    script = """(() => {
      const canvas = document.createElement('canvas').getContext('2d');
      const rgb = (colour) => { canvas.fillStyle = '#000'; canvas.fillStyle = colour; canvas.fillRect(0, 0, 1, 1);
        return Array.from(canvas.getImageData(0, 0, 1, 1).data.slice(0, 3)); };
      const light = (c) => { const [r, g, b] = c.map(v => { v /= 255;
        return v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; }); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
      const paper = light(rgb(getComputedStyle(document.body).backgroundColor));
      const bad = [];
      for (const selector of ['body', 'a', '.src', '.cpp .c', '.meta span', 'small', '.ladder text', '.ladder .a']) {
        const element = document.querySelector(selector);
        if (element === null) continue;
        const style = getComputedStyle(element);
        const ink = light(rgb(selector.startsWith('.ladder') ? style.fill : style.color));
        const ratio = (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
        if (ratio < 4.5) bad.push(selector + ' ' + ratio.toFixed(1));
      }
      return bad; })()"""
    papers = []
    for dark in (False, True):
        browser.open(page, dark=dark)
        papers.append(browser.evaluate("getComputedStyle(document.body).backgroundColor"))
        bad = browser.evaluate(script)
        check(bad == [], f"weak contrast ({'dark' if dark else 'light'}): {bad}")
    check(papers[0] != papers[1], "dark and light are the same")


def paper(browser, page):
    browser.open(page)
    printed = base64.b64decode(browser.call("Page.printToPDF", preferCSSPageSize=True)["data"])
    pages = len(re.findall(rb"/Type\s*/Page\b", printed))
    check(printed.startswith(b"%PDF") and pages >= 5, f"{pages} printed pages")
    browser.call("Emulation.setEmulatedMedia", media="print")
    check(browser.evaluate("getComputedStyle(document.querySelector('.tools')).display") == "none", "the search is printed")
    check(browser.evaluate("getComputedStyle(document.querySelector('.bar')).position") == "static", "a sticky bar on paper")
    check(browser.evaluate("getComputedStyle(document.querySelector('.row')).breakInside") == "avoid-page",
          "statements are broken between pages")
    check(browser.evaluate("getComputedStyle(document.querySelector('.group')).contentVisibility") == "visible",
          "rows are left out on paper")
    browser.call("Emulation.setEmulatedMedia", media="")


def main():
    plcxx, root = str(pathlib.Path(sys.argv[1]).resolve()), str(pathlib.Path(sys.argv[2]).resolve())
    chromium = sys.argv[3] if len(sys.argv) > 3 and sys.argv[3] else ""
    if not shutil.which(chromium or "chromium"):
        print("skipped: no chromium here (Debian package 'chromium', see dev/packages)")
        return 77
    with tempfile.TemporaryDirectory(prefix="plcxx-test-", ignore_cleanup_errors=True) as directory:
        pages = {sample: write_page(plcxx, root, sample, directory) for sample in SAMPLES}
        if failures:
            return 1
        with Browser(chromium or "chromium", os.path.join(directory, "profile")) as browser:
            for sample, page in pages.items():
                layout(browser, page, sample)
                check(browser.evaluate("document.querySelectorAll('.row svg.ladder').length") > 50,
                      sample + ": hardly any ladder")
                links(browser, page, sample)
            long_names(browser, plcxx, root, directory)
            first = pages[SAMPLES[0]]
            search(browser, first)
            keyboard_and_mouse(browser, first)
            contrast(browser, first)
            paper(browser, first)
    print("failed" if failures else "passed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
