import assert from "node:assert/strict";
import { test } from "node:test";

import { pictureOf, withPolicy } from "../../src/page";

test("a page is under a policy that loads nothing and executes only what has the nonce", () => {
  const page = withPolicy('<html><head><style>a{}</style></head><body><script>var a = "<style>";</script></body></html>', "N");
  const policy = /content="([^"]*)"/.exec(page)?.[1] ?? "";
  assert.match(policy, /default-src 'none'/);
  assert.ok(!policy.includes("unsafe"));
  assert.ok(page.includes('<style nonce="N">a{}</style>'));
  assert.ok(page.includes('<script nonce="N">var a = "<style>";</script>'), "the text of a script is left alone");
  assert.ok(page.indexOf("Content-Security-Policy") < page.indexOf("a{}"), "the policy comes first");
});

test("style attributes become rules, each once", () => {
  const page = withPolicy('<head></head><p style="--n:6">style="x"</p><b style="--n:6"></b><i style="--n:7"></i>', "N");
  assert.equal(page.match(/\[data-plcxx-style="/g)?.length, 2);
  assert.equal(page.match(/ data-plcxx-style="0"/g)?.length, 2);
  assert.ok(page.includes('>style="x"<'), "a text is no attribute");
  assert.ok(!/<\w+[^>]* style="/.test(page));
});

test("a picture gets a page", () => {
  const page = withPolicy(pictureOf("Ladder: <a>", "<svg><style>b{}</style></svg>"), "N");
  assert.ok(page.includes("<title>Ladder: &lt;a&gt;</title>"));
  assert.equal(page.match(/<style nonce="N">/g)?.length, 2);
});

test("what the page's script relies on comes in front of it, after its elements", () => {
  const page = withPolicy('<head></head><p style="--n:6"></p><script type="application/json">{}</script><script>run()</script>', "N");
  assert.match(page, /<script nonce="N" type="application\/json">\{\}<\/script><script nonce="N">\n\{\n  const styles = \["--n:6"\]/);
  assert.ok(page.indexOf("cssText") < page.indexOf("run()") && page.indexOf("<p ") < page.indexOf("cssText"));
  assert.ok(!withPolicy("<head></head><p style=\"--n:6\"></p>", "N").includes("cssText"), "no script where there was none");
});
