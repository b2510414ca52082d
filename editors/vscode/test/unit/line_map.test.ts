import assert from "node:assert/strict";
import { test } from "node:test";

import { below, cppLinesOf, readLineMap, sourceOf } from "../../src/line_map";

const CPP = `void fast(State& m) noexcept {
  // a
#line 6 "fast.plc"
  m[A] = m[B];

  // two lines
#line 9 "fast.plc"
  m[C] = m[D] &
         m[E];
#line 2 "sub dir/slow.plc"
  m[F] = 1;
#line 40 "lathe.cpp"
  Clear(m);
}
`;

test("directives are not shown, and each line keeps its statement", () => {
  const mapped = readLineMap(CPP);
  assert.ok(!mapped.text.includes("#line"));
  assert.deepEqual(cppLinesOf(mapped, "/machine/fast.plc", 5), [2, 2]);
  assert.deepEqual(cppLinesOf(mapped, "/machine/fast.plc", 8), [5, 6]);
  assert.deepEqual(sourceOf(mapped, 6, ["/machine/fast.plc"]), { file: "/machine/fast.plc", line: 8 });
  assert.deepEqual(sourceOf(mapped, 7, ["/m/sub dir/slow.plc"]), { file: "/m/sub dir/slow.plc", line: 1 });
});

test("a line without a statement of its own belongs to none, a line after a statement to it", () => {
  const mapped = readLineMap(CPP);
  assert.equal(sourceOf(mapped, 0, []), undefined);
  assert.equal(sourceOf(mapped, 8, []), undefined, "the C++ itself is no source");
  assert.equal(sourceOf(mapped, 1000, []), undefined);
  assert.deepEqual(cppLinesOf(mapped, "/machine/fast.plc", 7), [2, 2]);
  assert.equal(cppLinesOf(mapped, "/machine/fast.plc", 3), undefined);
  assert.equal(cppLinesOf(mapped, "/machine/breakfast.plc", 8), undefined);
});

test("lines of the extension's own move the map", () => {
  const mapped = below("// not up to date", readLineMap(CPP));
  assert.ok(mapped.text.startsWith("// not up to date\nvoid fast"));
  assert.deepEqual(cppLinesOf(mapped, "fast.plc", 5), [3, 3]);
});
