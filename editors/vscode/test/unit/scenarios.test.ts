import assert from "node:assert/strict";
import { test } from "node:test";

import { isScenario, placeOf, readJunit, titleOf } from "../../src/scenarios";

test("scenarios are told from other YAML", () => {
  const steps = "sources: [a.plc]\nsteps:\n- run: {ms: 1}\n";
  assert.ok(isScenario("a/turret.yaml", steps));
  assert.ok(isScenario("turret.yaml", "properties: never U4A8 and U4A9\n"));
  assert.ok(isScenario("bad.yaml", "expect_error: {line: 3}\n"));
  assert.ok(!isScenario("a/plcxx.yaml", steps));
  assert.ok(!isScenario(".github/workflows/a.yaml", steps));
  assert.ok(!isScenario("a.yml", steps));
  assert.ok(!isScenario("compose.yaml", "services:\n  steps: 1\n"));
});

test("titles", () => {
  assert.equal(titleOf('name: "Turret turns"\nsteps: []\n'), "Turret turns");
  assert.equal(titleOf("steps: []\n"), undefined);
});

const JUNIT = `<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="plcxx test" tests="3" failures="1" errors="1">
  <testsuite name="scenarios" tests="3" failures="1" errors="1" skipped="0">
    <testcase classname="" name="a&amp;b.yaml"/>
    <testcase classname="" name="spindle.yaml">
      <failure message="x">spindle.yaml:8:12: step 5 (expect), at 1510 ms: expected !MACON = 0, found 1
  last writes to !MACON, newest first:
    value 1 at 1500 ms: fast.plc:69:1: !MACON = T0U &lt;</failure>
    </testcase>
    <testcase classname="" name="broken.yaml">
      <error message="y">broken.yaml:2:3: &apos;foo&apos; is no step</error>
    </testcase>
  </testsuite>
</testsuites>`;

test("results have their places", () => {
  const [good, failed, broken] = readJunit(JUNIT);
  assert.deepEqual([good.name, good.outcome], ["a&b.yaml", "passed"]);
  assert.equal(failed.outcome, "failed");
  assert.deepEqual(failed.place, { path: "spindle.yaml", line: 7, column: 11 });
  assert.deepEqual([failed.expected, failed.found], ["0", "1"]);
  assert.ok(failed.text.endsWith("T0U <"));
  assert.equal(broken.outcome, "unusable");
  assert.equal(broken.text, "broken.yaml:2:3: 'foo' is no step");
});

test("no result at all, and no place", () => {
  assert.deepEqual(readJunit(""), []);
  assert.equal(placeOf("the time limit was reached"), undefined);
  assert.deepEqual(placeOf("C:\\m\\a.yaml:1:1: x"), { path: "C:\\m\\a.yaml", line: 0, column: 0 });
});
