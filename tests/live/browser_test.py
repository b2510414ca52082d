#!/usr/bin/env python3
"""The page of `plcxx live` in a headless Chromium, on the sample of each language.

    browser_test.py PLCXX ROOT [CHROMIUM] [--pictures FOLDER]

Exit code 77, "skipped", where there is no Chromium.
"""

import base64
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # nothing is written beside the sources
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "report"))
from browser import Browser  # noqa: E402
from server import Server  # noqa: E402
from station import Station, build  # noqa: E402

SAMPLES = ("nc110/lathe_16k20", "prostep/mill_fnd32", "host50/ck6150", "technol/mcv_750", "hnc/mill_xk7132",
           "classicladder/turret")
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAILED:", what)


class Page:
    """The page of one server."""

    def __init__(self, browser, server, width=1280, height=800, dark=False):
        self.browser, self.server = browser, server
        browser.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        browser.call("Emulation.setEmulatedMedia",
                     features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        browser.events.clear()
        browser.call("Page.navigate", url="about:blank")
        browser.call("Page.navigate", url=server.url)
        self.wait("document.querySelectorAll('#rows .row').length > 0 && document.querySelector('#signal-list .value')?.textContent !== '–'")

    def wait(self, condition, seconds=20):
        self.browser.wait(condition, seconds)

    def evaluate(self, expression):
        return self.browser.evaluate(expression)

    def click(self, selector):
        self.evaluate(f"document.querySelector({json.dumps(selector)}).click(); 0")

    def step_until(self, condition):
        """Some controls deliver an input at their next look at it."""
        for _ in range(50):
            time.sleep(0.05)
            if self.evaluate(condition):
                return
            self.server.act("step", what="period")
        self.wait(condition, 2)

    def picture(self, folder, name):
        if not folder:
            return
        data = self.browser.call("Page.captureScreenshot", format="png")["data"]
        with open(os.path.join(folder, name + ".png"), "wb") as file:
            file.write(base64.b64decode(data))

    def errors(self):
        return [event["params"] for event in self.browser.events
                if event.get("method") in ("Runtime.exceptionThrown",)]


def layout(page, name):
    wide = page.evaluate("""Array.from(document.querySelectorAll('.bar, .signals, .side, .chart, .card, .program')).filter(one =>
        one.scrollWidth > one.clientWidth + 1 || one.getBoundingClientRect().right > innerWidth + 1).map(one => one.className)""")
    check(not wide, f"{name}: wider than their place: {wide}")
    check(page.evaluate("document.documentElement.scrollWidth <= innerWidth"), name + ": the page scrolls sideways")


def named(page):
    """What has no name for a screen reader."""
    return page.evaluate("""Array.from(document.querySelectorAll('button, input, select, canvas, svg:not([aria-hidden=true])')).filter(one => {
        const name = one.getAttribute('aria-label') || one.textContent.trim() || one.closest('label')?.textContent.trim() || one.title;
        return !name && one.offsetParent !== null; }).map(one => one.outerHTML.slice(0, 100))""")


def main_functions(page, name):
    """Each function once, as somebody at the page does it."""
    check(page.evaluate("document.querySelectorAll('#rows svg.ladder').length") > 0, name + ": no ladder")
    check(not named(page), f"{name}: without a name: {named(page)[:3]}")
    # Run, pause, step, back.
    page.browser.key(" ", " ")
    page.wait("document.querySelector('#state').textContent === 'running'")
    page.wait("parseInt(document.querySelector('#period').textContent.slice(7)) > 3")
    page.browser.key(" ", " ")
    page.wait("document.querySelector('#state').textContent !== 'running'")
    period = "parseInt(document.querySelector('#period').textContent.slice(7))"
    time.sleep(0.2)
    before = page.evaluate(period)
    page.click("[data-step=period]")
    page.wait(f"{period} === {before + 1}")
    page.click("[data-back='1']")
    page.wait(f"{period} === {before}")
    page.click("[data-step=statement]")
    page.wait("document.querySelector('.row.at') !== null")
    page.click("#back-statement")
    page.click("[data-step=period]")
    page.wait("document.querySelector('.row.at') === null")
    # An input is toggled by a click: itself, or a bit of a word where the language has words.
    # What the plant drives is not the operator's.
    is_bit = page.evaluate("document.querySelector('.list li:not(.driven) button.bit') !== null")
    if not is_bit:
        page.click(".list li:not(.driven) .name")
    bit = ".list li:not(.driven) button.bit" if is_bit else ".bits button:last-child"
    was = page.evaluate(f"document.querySelector({json.dumps(bit)}).className.includes('on')")
    is_toggled = f"document.querySelector({json.dumps(bit)}).className.includes('on') === "
    page.click(bit)
    page.step_until(is_toggled + ("false" if was else "true") + " || !document.querySelector('#toast').hidden")
    check(page.evaluate("document.querySelector('#toast').hidden"),
          name + ": a click is refused: " + page.evaluate("document.querySelector('#toast').textContent"))
    chosen = page.evaluate("document.querySelector('.chosen b').textContent")
    # Force it, see it everywhere, release it.
    button = "Array.from(document.querySelectorAll('#card button')).find(one => one.textContent === '%s').click(); 0"
    page.evaluate(button % "Force")
    page.wait("!document.querySelector('#forced-card').hidden && document.querySelector('.list .forced') !== null")
    page.click("#release-all")
    page.wait("document.querySelector('#forced-card').hidden")
    # Watch it; chart.
    page.evaluate(button % "Watch")
    page.wait("document.querySelectorAll('#watches tbody tr').length === 1")
    page.evaluate(button % "Stop on change")
    page.wait("document.querySelectorAll('#breaks li').length === 1")
    page.click("#run")
    page.click(bit)
    page.wait("document.querySelector('#state').textContent.includes('has changed')")
    page.click("#breaks .remove")
    page.wait("document.querySelectorAll('#breaks li').length === 0")
    page.evaluate(button % "Why?")
    page.wait("!document.querySelector('.why').hidden || !document.querySelector('#toast').hidden")
    check(page.evaluate("document.querySelector('.why').textContent").startswith(chosen), name + ": why says nothing")
    # Stop at a statement, switch one off.
    page.click("#rows button.gutter")
    page.wait("document.querySelector('#rows .gutter.stop') !== null")
    page.click("#rows button.gutter")
    page.wait("document.querySelector('#rows .gutter.stop') === null")
    page.click("#rows .switch")
    page.wait("document.querySelector('#rows .switch[aria-checked=false]') !== null && !document.querySelector('#all-on').hidden")
    page.click("#all-on")
    page.wait("document.querySelector('#rows .switch[aria-checked=false]') === null")
    # A trigger.
    condition = f"'{chosen}'" + ("" if is_bit else " != 0")
    page.evaluate(f"document.querySelector('#trigger-text').value = {json.dumps(condition)}; "
                  "document.querySelector('#trigger-samples').value = 5; "
                  "document.querySelector('#trigger-edge').value = 'condition'; 0")
    page.click("#trigger-form button")
    page.wait("document.querySelector('#trigger-state').textContent.includes('armed')")
    page.click("#trigger-off")
    # Power.
    page.click("#power")
    page.wait("document.querySelector('#state').textContent === 'off'")
    page.click("#power")
    page.wait("document.querySelector('#clock').textContent === '0 ms'")
    # A scenario.
    page.click("#restart")
    page.wait(f"{period} === 0")
    was = page.evaluate(f"document.querySelector({json.dumps(bit)}).className.includes('on')")  # a panel may have switched it on
    page.click(bit)
    page.step_until(is_toggled + ("false" if was else "true"))
    page.click("[data-step=period]")
    page.click("#expect")
    page.click("#show-scenario")
    page.wait("document.querySelector('#scenario').textContent.includes('expect:')")
    # Messages of refusal are said, and lists are there.
    for group in ("output", "internal", "retentive", "instance", "input"):
        page.click(f"[data-group={group}]")
        check(page.evaluate("document.querySelectorAll('#signal-list li').length") > 0, f"{name}: no list of {group}")
    check(not page.errors(), f"{name}: errors in the page: {page.errors()[:1]}")


def sides(browser, plcxx, root, pictures):
    for sample in SAMPLES:
        dialect = sample.split("/")[0]
        with Server(plcxx, [os.path.join(root, "samples", sample)], root) as server:
            page = Page(browser, server)
            layout(page, dialect)
            main_functions(page, dialect)
            for number in range(12):
                server.request("POST", "/api/command", json.dumps({"do": "step", "what": "period"}))
            page.picture(pictures, dialect)
            if dialect == "nc110":
                layout(page, dialect)
                page = Page(browser, server, dark=True)
                page.picture(pictures, dialect + "-dark")
                page = Page(browser, server, width=820, height=1180)
                layout(page, dialect + " on a tablet")
                page.picture(pictures, dialect + "-tablet")


# What an operator does at each panel: ("press", text), ("turn", text, position), ("flip", text), ("see", text, what it shows).
PANELS = {
    "classicladder/turret": [("press", "RESET"), ("turn", "Station wanted", 2), ("key", "CHANGE"), ("see", "Station", "2"),
                             ("lit", "Clamped"), ("flip", "Emergency stop"), ("dark", "RESET")],
    "nc110/lathe_16k20": [("press", "Machine on"), ("lit", "Feed permitted"), ("press", "Next tool"), ("see", "Tool", "2"), ("lit", "Locked"),
                          ("turn", "Mode", 0), ("flip", "Part program"), ("turn", "T", 4), ("press", "T strobe"), ("lit", "Next tool"),
                          ("flip", "Door"), ("lit", "Feed hold"), ("see", "Tool", "5"), ("dark", "Feed permitted"), ("flip", "Door"),
                          ("lit", "Feed permitted")],
    "host50/ck6150": [("lit", "黄 Yellow"), ("press", "Chuck pedal"), ("lit", "Chuck pedal"), ("press", "Next tool"), ("see", "Tool", "2"),
                      ("turn", "Mode", 0), ("flip", "Part program"), ("turn", "T", 5), ("press", "T strobe"), ("lit", "Next tool"),
                      ("flip", "门 Door"), ("lit", "Feed hold"), ("see", "Tool", "6"), ("flip", "门 Door"), ("dark", "Feed hold")],
    "prostep/mill_fnd32": [("press", "Hydraulika"), ("lit", "Next block"), ("turn", "T", 4), ("press", "T strobe"), ("lit", "T strobe"),
                           ("press", "M06"), ("lit", "M06"), ("flip", "Osłona / guard"), ("see", "In the spindle", "5"), ("dark", "M06"),
                           ("dark", "Feed permitted"), ("flip", "Osłona / guard"), ("lit", "Feed permitted")],
    "technol/mcv_750": [("press", "Zapnutí"), ("lit", "Připraven"), ("turn", "Pocket", 2), ("turn", "Tool", 5), ("press", "Zápis"),
                        ("turn", "T", 4), ("press", "T"), ("see", "Pocket", "3"), ("press", "M06"), ("lit", "M06"), ("flip", "Dveře / door"),
                        ("dark", "Připraven"), ("see", "In the spindle", "0005"), ("flip", "Dveře / door"), ("lit", "Připraven")],
    "hnc/mill_xk7132": [("press", "Reset"), ("turn", "T", 4), ("flip", "T asks"), ("lit", "Done"), ("flip", "T asks"), ("flip", "M06 asks"),
                        ("lit", "Unclamp"), ("flip", "Door"), ("see", "In the spindle", "5"), ("lit", "Done"), ("flip", "M06 asks"),
                        ("flip", "Door")],
}
CONTROL = ("Array.from(document.querySelectorAll('#panel .control%s')).find(one => "
           "(one.querySelector('.legend') ?? one).textContent === %s)")


def operate(page, name, action, text, *more):
    """One thing that is done, or seen, at the panel."""
    kinds = {"press": ".button", "key": ".button", "turn": ".knob", "flip": "", "see": ".display", "lit": "", "dark": ""}
    one = CONTROL % (kinds[action], json.dumps(text))
    if not page.evaluate(one + " !== undefined"):
        check(False, f"{name}: the panel has no {text}")
        return
    if action == "press":
        page.evaluate(one + ".querySelector('button').click(); 0")
    elif action == "key":
        page.evaluate(one + ".querySelector('button').focus(); 0")
        page.browser.key("Enter", "\r")
    elif action == "flip":
        before = page.evaluate(one + ".querySelector('[role=switch]').ariaChecked")
        page.evaluate(one + ".querySelector('[role=switch]').click(); 0")
        page.wait(one + f".querySelector('[role=switch]').ariaChecked !== '{before}'")
    elif action == "turn":
        page.evaluate("{ const range = %s.querySelector('input'); range.value = %d; "
                      "range.dispatchEvent(new Event('input', { bubbles: true })); } 0" % (one, more[0]))
        page.wait(one + f".querySelector('input').value === '{more[0]}' && {one}.querySelector('.position').textContent.length > 0")
        time.sleep(0.1)
    elif action == "see":
        page.wait(one + ".querySelector('.digits').textContent === " + json.dumps(more[0]), 30)
    else:
        page.wait(one + ".querySelector('.lit') " + ("!==" if action == "lit" else "===") + " null", 30)


def panels(browser, plcxx, root, pictures):
    for sample, script in PANELS.items():
        name = "panel of " + sample.split("/")[0]
        with Server(plcxx, [os.path.join(root, "samples", sample)], root) as server:
            page = Page(browser, server)
            page.click("#tab-panel")
            page.wait("!document.querySelector('#panel').hidden && document.querySelector('#program').hidden")
            page.wait("document.querySelector('#panel [aria-checked], #panel [aria-pressed]') !== null")
            check(not named(page), f"{name}: without a name: {named(page)[:3]}")
            server.act("speed", times=10)
            page.click("#run")
            for number, step in enumerate(script):
                try:
                    operate(page, name, *step)
                except Exception as error:  # the rest of it cannot come about
                    check(False, f"{name}: step {number + 1} {step}: {str(error)[:200]}")
                    break
                if number == 6:
                    page.picture(pictures, "panel-" + sample.split("/")[0])
            page.click("#run")
            check(page.evaluate("document.querySelector('#panel').scrollWidth <= document.querySelector('#panel').clientWidth + 1"),
                  name + ": wider than its place")
            page.picture(pictures, "panel-end-" + sample.split("/")[0])
            answer = json.loads(server.request("POST", "/api/command", json.dumps({"do": "scenario"}))[2])
            check("plant: " in answer.get("yaml", ""), f"{name}: what was done is no scenario: {answer}")
            check(not page.errors(), f"{name}: errors in the page: {page.errors()[:1]}")
            if sample.startswith("nc110"):
                page = Page(browser, server, dark=True)
                page.click("#tab-panel")
                page.picture(pictures, "panel-nc110-dark")
                page = Page(browser, server, width=820, height=1180)
                page.click("#tab-panel")
                check(page.evaluate("document.documentElement.scrollWidth <= innerWidth"), name + ": a tablet scrolls sideways")
                page.picture(pictures, "panel-nc110-tablet")


HOSTILE = ("W3K0=[W3K0+1]\n$\n;<img src=x onerror=window.bad=1><script>window.bad=1</script> лампа 灯 مصباح\n"
           "U4A8=I0A3*/I0A4+U4A8*/I0A4\n")


def what_authors_write_is_text(browser, plcxx, folder):
    with open(os.path.join(folder, "lamp.plc"), "w", encoding="utf-8") as file:
        file.write(HOSTILE)
    with Server(plcxx, ["lamp.plc"], folder) as server:
        page = Page(browser, server)
        text = page.evaluate("document.querySelector('#rows').textContent")
        check("<img src=x onerror" in text and "灯" in text and "مصباح" in text, "a comment is not shown as it is")
        check(page.evaluate("window.bad === undefined && document.querySelectorAll('#rows img').length === 0"),
              "a comment became markup")
    with open(os.path.join(folder, "hostile.panel.yaml"), "w", encoding="utf-8") as file:
        file.write('title: "<img src=x onerror=window.bad=1>"\ngroups:\n- title: "<script>window.bad=1</script>"\n  controls:\n'
                   '  - button: {text: "<img src=x onerror=window.bad=1>", input: I0A3}\n'
                   '  - knob: {text: K, location: W1K0, positions: ["<b>", "</span><img src=x onerror=window.bad=1>"]}\n')
    with Server(plcxx, ["lamp.plc", "--panel", "hostile.panel.yaml"], folder) as server:
        page = Page(browser, server)
        page.click("#tab-panel")
        check("<img src=x onerror" in page.evaluate("document.querySelector('#panel').textContent"), "a panel does not show its texts")
        check(page.evaluate("window.bad === undefined && document.querySelectorAll('#panel img, #panel script').length === 0"),
              "a text of the panel became markup")


def latency(browser, plcxx, folder):
    """From a click to the repaint, while it runs with a period of 10 ms."""
    with Server(plcxx, ["lamp.plc"], folder) as server:
        page = Page(browser, server)
        page.click("#run")
        page.wait("document.querySelector('#state').textContent === 'running'")
        times = page.evaluate("""(async () => {
            const times = [];
            for (let i = 0; i < 30; ++i) {
                const bit = document.querySelector('.list button.bit');
                const before = bit.textContent, begin = performance.now();
                bit.click();
                while (bit.textContent === before && performance.now() - begin < 2000) await new Promise(requestAnimationFrame);
                times.push(performance.now() - begin);
            }
            return times;
        })()""")
        median = statistics.median(times)
        print(f"from click to repaint: median {median:.0f} ms, worst {max(times):.0f} ms")
        check(median < 50 * float(os.environ.get("PLCXX_SLOW", "4")), f"a click takes {median:.0f} ms")


def shows_a_trace(browser, plcxx, folder):
    trace = os.path.join(folder, "trace.vcd")
    subprocess.run([plcxx, "sim", "lamp.plc", "--watch", "U4A8,W3K0", "--at", "100ms:I0A3=1", "--for", "300ms", "--vcd", trace],
                   cwd=folder, check=True, capture_output=True)
    with open(os.path.join(folder, "wrong.vcd"), "w", encoding="utf-8") as file:
        file.write("$var wire 1 ! <b> $end")
    with Server(plcxx, ["lamp.plc"], folder) as server:
        page = Page(browser, server)
        document = browser.call("DOM.getDocument")["root"]["nodeId"]
        node = browser.call("DOM.querySelector", nodeId=document, selector="#trace")["nodeId"]
        browser.call("DOM.setFileInputFiles", nodeId=node, files=[trace])
        page.wait("document.querySelector('#trace-name').textContent === 'trace.vcd'")
        read = page.evaluate("""(async () => {
            const { readVcd } = await import('/vcd.js');
            return readVcd(%s, 16);
        })()""" % json.dumps(open(trace, encoding="utf-8").read()))
        check([one["name"] for one in read["watched"]] == ["U4A8", "W3K0"], f"of the trace: {read['watched']}")
        values = {sample[1]: sample[2] for sample in read["samples"]}
        check(values[90][0] == 0 and values[100][0] == 1 and values[200][1] == 21, f"of the trace: {values}")
        browser.call("DOM.setFileInputFiles", nodeId=node, files=[os.path.join(folder, "wrong.vcd")])
        page.wait("document.querySelector('#toast').textContent.includes('no waveform')")
        page.click("#trace-off")
        page.wait("document.querySelector('#trace-off').hidden")


def large(browser, plcxx, folder, statements=10_000):
    text = "W3K0=[W3K0+1]\n$\n" + "".join(
        f"U{i % 250}K{i % 30}=I0A{i % 30}*/U{(i * 7) % 250}K{(i + 1) % 30}\n" for i in range(statements))
    with open(os.path.join(folder, "large.plc"), "w", encoding="utf-8") as file:
        file.write(text)
    with Server(plcxx, ["large.plc"], folder) as server:
        page = Page(browser, server)
        page.click("#run")
        worst = page.evaluate("""(async () => {
            const pane = document.querySelector('#program'), gaps = [];
            let last = performance.now();
            for (let i = 0; i < 80; ++i) {
                pane.scrollTop += 900;
                await new Promise(requestAnimationFrame);
                gaps.push(performance.now() - last);
                last = performance.now();
            }
            gaps.sort((a, b) => a - b);
            return [gaps[gaps.length >> 1], gaps[gaps.length - 1], document.querySelectorAll('#rows .row').length];
        })()""")
        print(f"scrolling 10,000 statements while they run: median {worst[0]:.0f} ms a frame, worst {worst[1]:.0f} ms, "
              f"{worst[2]} rows there")
        check(worst[2] < 2000, f"{worst[2]} rows are there")
        page.wait("document.querySelectorAll('#rows .row').length > 0")


def comes_back(browser, plcxx, folder):
    server = Server(plcxx, ["lamp.plc"], folder)
    page = Page(browser, server)
    port = server.port
    server.end()
    page.wait("!document.querySelector('#gone').hidden")
    with Server(plcxx, ["lamp.plc", "--port", str(port)], folder) as again:
        page.wait("document.querySelector('#gone').hidden", 30)
        again.act("set", name="I0A3", value="1")
        page.wait("document.querySelector('.list button.bit[aria-checked=true]') !== null")


def of_use(selector):
    return f"document.querySelector({json.dumps(selector)}).getAttribute('aria-disabled') !== 'true' && !document.querySelector({json.dumps(selector)}).disabled"


def linked(browser, plcxx, root, folder, pictures):
    """The page of a running machine: what it shows, what is of no use, and why."""
    os.makedirs(folder)
    program = build(plcxx, root, folder)
    socket = os.path.join(folder, "link.socket")
    toggle = "[aria-label='Toggle I0A3']"
    force = "Array.from(document.querySelectorAll('#card button')).find(one => one.textContent === 'Force')"
    with Station(program, socket) as station:
        with Server(plcxx, ["lamp.plc", "--link", "socket:" + socket], folder) as server:
            page = Page(browser, server)
            page.wait("document.querySelector('#link').textContent.includes('reading only')")
            layout(page, "link")
            check(not named(page), f"link: without a name: {named(page)[:3]}")
            page.wait("document.querySelector('#state').textContent === 'running' && document.querySelector('#lost').hidden")
            for selector in ("#run", "#power", "#speed", "#slider", "#back-statement", "[data-back]", "[data-step]", "#break-text", "#restart",
                             "#show-scenario", "#save-name", "#rows button.gutter", "#rows .switch", toggle):
                check(not page.evaluate(of_use(selector)), f"link: {selector} is of use")
                check(len(page.evaluate(f"document.querySelector({json.dumps(selector)}).title")) > 10, f"link: {selector} says not why")
            check(page.evaluate(of_use("#watch-name")), "link: nothing can be watched")
            page.click("#run")
            page.wait("document.querySelector('#toast').textContent.includes('only a simulation')")
            # What the machine does is seen: values, and power in the ladder.
            before = page.evaluate("document.querySelectorAll('#rows svg.ladder .live').length")
            station.tell("3")
            page.wait(f"document.querySelector({json.dumps(toggle)}).classList.contains('on')")
            page.wait(f"document.querySelectorAll('#rows svg.ladder .live').length > {before}")
            page.evaluate("document.querySelector('#watch-name').value = 'W3K0'; 0")
            page.click("#watch-form button")
            page.wait("document.querySelectorAll('#watches tbody tr').length === 1")
            page.wait("Number(document.querySelector('#watches .value').textContent) > 10")
            # The key switch lets write: then what can be done is of use.
            station.tell("w")
            page.wait(of_use(toggle))
            page.evaluate("document.querySelector(\"[aria-label='Toggle I0A5']\").closest('li').querySelector('.name').click(); 0")
            page.evaluate("document.querySelector('#card input').value = '1'; 0")
            page.evaluate(force + ".click(); 0")
            page.wait("!document.querySelector('#forced-card').hidden && document.querySelector('.list .forced') !== null")
            page.picture(pictures, "link")
            page.click("#release-all")
            page.wait("document.querySelector('#forced-card').hidden")
            # The wire breaks, and is there again.
            station.end()
            page.wait("!document.querySelector('#lost').hidden && document.body.classList.contains('stale')")
            page.wait("document.querySelector('#lost').textContent.includes('What is shown is old')")
            check(not page.evaluate(of_use("#watch-name")), "link: without a machine something can be watched")
            page.picture(pictures, "link-lost")
            with Station(program, socket) as again:
                page.wait("document.querySelector('#lost').hidden", 30)
                again.tell("3")
                page.wait(f"document.querySelector({json.dumps(toggle)}).classList.contains('on')")
            check(not page.errors(), f"link: errors in the page: {page.errors()[:1]}")


def main(plcxx, root, *more):
    pictures = more[more.index("--pictures") + 1] if "--pictures" in more else None
    chromium = more[0] if more and not more[0].startswith("--") else shutil.which("chromium")
    if not chromium or not os.path.exists(chromium):
        print("skipped: no Chromium")
        return 77
    with tempfile.TemporaryDirectory() as folder, Browser(chromium, os.path.join(folder, "profile")) as browser:
        what_authors_write_is_text(browser, plcxx, folder)
        latency(browser, plcxx, folder)
        comes_back(browser, plcxx, folder)
        shows_a_trace(browser, plcxx, folder)
        linked(browser, plcxx, root, os.path.join(folder, "linked"), pictures)
        sides(browser, plcxx, root, pictures)
        panels(browser, plcxx, root, pictures)
        if "--large" in more:
            large(browser, plcxx, folder)
    print("failures:", len(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
