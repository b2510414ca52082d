// A session of the official client with plcxx mcp.
import assert from "node:assert";
import { Client } from "@modelcontextprotocol/sdk/client/index.js";
import { StdioClientTransport } from "@modelcontextprotocol/sdk/client/stdio.js";

const [plcxx, folder] = process.argv.slice(2);
const client = new Client({ name: "test", version: "1" });
await client.connect(new StdioClientTransport({ command: plcxx, args: ["mcp", folder] }));
assert.equal(client.getServerVersion().name, "plcxx");
await client.ping();

const { tools } = await client.listTools();
assert.ok(tools.length >= 10, "tools are listed");
const sources = ["ck6150.il", "texts.il", "fast.il", "main.il", "spindle.il", "turret.il", "units.il", "mcodes.il"];
const check = await client.callTool({ name: "check", arguments: { sources } });
assert.equal(check.structuredContent.ok, true, JSON.stringify(check));
const uses = await client.callTool({ name: "cross_reference", arguments: { sources, signal: "HYD_FAULT" } });
assert.ok(uses.structuredContent.signals[0].written.length >= 2, JSON.stringify(uses));
const run = await client.callTool({ name: "test", arguments: { scenarios: ["power_on.yaml"] } });
assert.equal(run.structuredContent.passed, true, JSON.stringify(run));
await assert.rejects(client.callTool({ name: "check", arguments: { sources: ["../x.il"] } }), /outside/);
await assert.rejects(client.callTool({ name: "no_such_tool", arguments: {} }), /no tool/);
await client.close();
console.log("the official client is content");
