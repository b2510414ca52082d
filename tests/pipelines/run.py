#!/usr/bin/env python3
"""The pipelines of ci/ and of `plcxx init`: what their services read is well-formed, and their commands, with sh in
place of the runner, find on a local repository what a reviewer has to see."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

try:
    import yaml
except ImportError:
    print("skipped: python3-yaml is not there")
    sys.exit(77)

OLD = "$\nU4A8=I0A3*/I0A4\n; the fan\nU4A9=I0A5\n"
NEW = "$\nU4A8=I0A3*/I0A4*I0A7\n; the fan\nU4A9=I0A5\n"
SCENARIO = "steps:\n- set: {I0A3: 1, I0A7: 1}\n- run: {slow: 1}\n- expect: {U4A8: 1}\n"
PROJECT = """name: lamp
dialect: nc110
sources: [lamp.plc]
scenarios: [lamp.yaml]
targets:
  host: {max-code: %d}
"""


class WrongForm(Exception):
    pass


def need(condition, what):
    if not condition:
        raise WrongForm(what)


def keys_of(mapping, required, optional, where):
    need(isinstance(mapping, dict), f"{where}: no mapping")
    missing, unknown = required - mapping.keys(), mapping.keys() - required - optional
    need(not missing and not unknown, f"{where}: missing {sorted(missing)}, unknown {sorted(map(str, unknown))}")


def check_steps(steps, where, needs_shell):
    need(isinstance(steps, list) and steps, f"{where}: no steps")
    for number, step in enumerate(steps):
        place = f"{where}, step {number + 1}"
        keys_of(step, set(), {"name", "id", "if", "run", "uses", "with", "env", "shell", "working-directory"}, place)
        need(("run" in step) != ("uses" in step), f"{place}: run or uses")
        need(not needs_shell or "uses" in step or "shell" in step, f"{place}: a composite action names its shell")
        need("with" not in step or "uses" in step, f"{place}: with belongs to uses")
        need("uses" not in step or step["uses"].startswith("./") or re.search(r"@v\d", step["uses"]), f"{place}: no version")
        # What a stranger may write is not pasted into a script: it comes by the environment.
        need("${{" not in step.get("run", ""), f"{place}: an expression within a script")


def check_action(text):
    action = yaml.safe_load(text)
    keys_of(action, {"name", "description", "runs"}, {"inputs", "outputs", "branding", "author"}, "action")
    for name, value in action["inputs"].items():
        keys_of(value, {"description"}, {"default", "required"}, f"input {name}")
        need(isinstance(value.get("default", ""), str), f"input {name}: its default is no text")
    keys_of(action["runs"], {"using", "steps"}, set(), "runs")
    need(action["runs"]["using"] == "composite", "runs: composite")
    check_steps(action["runs"]["steps"], "action", needs_shell=True)
    used = set(re.findall(r"inputs\.([\w-]+)", text))
    need(used == set(action["inputs"]), f"inputs that are used: {sorted(used)}")
    return action


def check_workflow(text):
    workflow = yaml.safe_load(text)
    keys_of(workflow, {"name", True, "jobs"}, {"permissions", "env"}, "workflow")  # YAML 1.1 reads 'on' as true
    for name, job in workflow["jobs"].items():
        keys_of(job, {"runs-on", "steps"}, {"container", "if", "env", "needs", "permissions"}, f"job {name}")
        check_steps(job["steps"], f"job {name}", needs_shell=False)
    return workflow


def check_job(name, job):
    keys_of(job, {"script"}, {"stage", "image", "variables", "before_script", "artifacts", "rules"}, f"job {name}")
    for part in ("before_script", "script"):
        need(all(isinstance(line, str) for line in job.get(part, [])), f"job {name}: {part} is no list of texts")
    for key, value in job.get("variables", {}).items():
        need(isinstance(value, str), f"job {name}: the variable {key} is no text")


def check_component(text):
    documents = list(yaml.safe_load_all(text))
    need(len(documents) == 2, "a component is its spec and its jobs")
    keys_of(documents[0], {"spec"}, set(), "component")
    inputs = documents[0]["spec"]["inputs"]
    for name, value in inputs.items():
        keys_of(value, {"description", "default"}, {"type", "options", "regex"}, f"input {name}")
        need(value.get("type", "string") in {"string", "boolean", "number", "array"}, f"input {name}: its type")
        need(isinstance(value["default"], bool) == (value.get("type") == "boolean"), f"input {name}: its default")
    used = set(re.findall(r"\$\[\[ inputs\.([\w-]+) \]\]", text))
    need(used == set(inputs), f"inputs that are used: {sorted(used)}")
    for name, job in documents[1].items():
        check_job(name, job)
    return documents


def refused(check, text, change):
    try:
        check(change(text))
    except WrongForm:
        return
    raise AssertionError("a wrong form is not seen")


class Repository:
    """One commit with the old program, one with the new."""

    def __init__(self, plcxx, folder):
        self.folder = folder
        self.environment = {**os.environ, "PATH": f"{pathlib.Path(plcxx).parent}:{os.environ['PATH']}",
                            "HOME": str(folder), "GIT_CONFIG_NOSYSTEM": "1"}
        self.git("init", "-q")
        for key, value in {"user.name": "nobody", "user.email": "nobody@localhost"}.items():
            self.git("config", key, value)
        self.write("lamp.plc", OLD)
        self.write("lamp.yaml", SCENARIO)
        self.write("plcxx.yaml", PROJECT % 100000)
        self.commit("the machine as it is")
        self.base = self.git("rev-parse", "HEAD").strip()
        self.write("lamp.plc", NEW)
        self.commit("the lamp waits for the door")

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def git(self, *words):
        return subprocess.run(["git", *words], cwd=self.folder, env=self.environment, check=True, text=True,
                              stdout=subprocess.PIPE).stdout

    def commit(self, message):
        self.git("add", ".")
        self.git("commit", "-q", "-m", message)

    def run(self, script, **environment):
        return subprocess.run(["sh", "-e", "-c", script], cwd=self.folder, env={**self.environment, **environment},
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def result(self, name):
        return (self.folder / "plcxx-results" / name).read_text()

    def judge(self, changes):
        assert len(json.loads(self.result("check.sarif"))["runs"]) == 1
        tests = xml.etree.ElementTree.fromstring(self.result("tests.xml"))
        assert len(list(tests.iter("testcase"))) == 1
        assert "U4A8" in changes and "different" in changes.lower(), changes
        ladder = changes[changes.index("```diff"):]
        assert re.search(r"^\+.*\[ I0A7 \]", ladder, re.M), ladder
        assert re.search(r"^-.*\( U4A8 \)", ladder, re.M), ladder
        assert "U4A9 )" not in "".join(line for line in ladder.splitlines() if line[:1] in "+-"), ladder


def replaced(text, values):
    def value(match):
        found = values[match.group(1)]
        return str(found).lower() if isinstance(found, bool) else found
    return re.sub(r"\$(?:\[\[|\{\{) ?(?:inputs\.)?([\w.-]+) ?(?:\]\]|\}\})", value, text)


def run_action(action, repository, **given):
    """Exit codes by step. A condition is one of those that the action has."""
    values = {name: value.get("default", "") for name, value in action["inputs"].items()} | given
    summary = repository.folder / "summary.md"
    summary.write_text("")
    codes, failed = {}, False
    for step in action["runs"]["steps"]:
        condition = step.get("if", "success()")
        meant = {"success()": not failed, "always()": True, "always() && inputs.base != ''": values["base"] != "",
                 "always() && inputs.budgets == 'true'": values["budgets"] == "true"}[condition]
        if not meant:
            continue
        environment = {key: replaced(value, values) for key, value in step.get("env", {}).items()}
        ran = repository.run(step["run"], GITHUB_STEP_SUMMARY=str(summary), GITHUB_WORKSPACE=str(repository.folder),
                             **environment)
        print(f"--- action, {step['name']}: {ran.returncode}\n{ran.stdout}")
        codes[step["name"]] = ran.returncode
        failed = failed or ran.returncode != 0
    return codes, summary.read_text()


def run_component(documents, repository, **given):
    values = {name: value["default"] for name, value in documents[0]["spec"]["inputs"].items()} | given
    job = documents[1]["plcxx"]
    environment = {key: replaced(value, values) for key, value in job["variables"].items()}
    ran = repository.run("\n".join(job["script"]), CI_MERGE_REQUEST_DIFF_BASE_SHA=repository.base, **environment)
    print(f"--- component: {ran.returncode}\n{ran.stdout}")
    return ran.returncode


def proposed(plcxx, folder, service):
    folder.mkdir()
    (folder / "lamp.plc").write_text(OLD)
    subprocess.run([plcxx, "init", str(folder), "--pipeline", service], check=True, stdout=subprocess.DEVNULL)
    name = {"github": ".github/workflows/plcxx.yml", "gitlab": ".gitlab-ci.yml"}[service]
    return (folder / name).read_text()


def own_commands(scripts):
    """Without what installs plcxx on the runner."""
    return "\n".join(line for script in scripts for line in script.splitlines() if "apt-get" not in line)


def main():
    plcxx, root = sys.argv[1], pathlib.Path(sys.argv[2])
    action_text = (root / "ci/github/action.yml").read_text()
    action = check_action(action_text)
    check_workflow((root / "ci/github/example.yml").read_text())
    component_text = (root / "ci/gitlab/templates/plcxx.yml").read_text()
    component = check_component(component_text)
    refused(check_action, action_text, lambda text: text.replace("    shell: sh\n", "", 1))
    refused(check_action, action_text, lambda text: text.replace("inputs.folder", "inputs.directory"))
    refused(check_action, action_text, lambda text: text.replace("mkdir -p", "mkdir -p ${{ inputs.folder }}"))
    refused(check_component, component_text, lambda text: text.replace("inputs.stage", "inputs.state"))
    refused(check_component, component_text, lambda text: text.replace("  script:", "  scripts:"))

    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        repository = folder / "action"
        repository.mkdir()
        repository = Repository(plcxx, repository)
        codes, summary = run_action(action, repository, base=repository.base, budgets="true")
        assert codes == {"check": 0, "test": 0, "compare": 0, "budgets": 0}, codes
        repository.judge(summary)
        # What is wrong fails the step that finds it, and the others still say what they find.
        repository.write("lamp.yaml", SCENARIO.replace("U4A8: 1", "U4A8: 0"))
        repository.write("plcxx.yaml", PROJECT % 1)
        codes, _ = run_action(action, repository, base=repository.base, budgets="true")
        assert codes == {"check": 0, "test": 1, "compare": 0, "budgets": 1}, codes
        repository.write("lamp.plc", "$\nU4A8=IOA3\n")
        codes, _ = run_action(action, repository, base="")
        assert codes == {"check": 1, "test": 1}, codes

        other = folder / "component"
        other.mkdir()
        other = Repository(plcxx, other)
        assert run_component(component, other, budgets=True) == 0
        other.judge(other.result("changes.md"))
        other.write("lamp.yaml", SCENARIO.replace("U4A8: 1", "U4A8: 0"))
        assert run_component(component, other) == 1
        other.judge(other.result("changes.md"))

        workflow = check_workflow(proposed(plcxx, folder / "github", "github"))
        gitlab = yaml.safe_load(proposed(plcxx, folder / "gitlab", "gitlab"))
        for name, job in gitlab.items():
            check_job(name, job)
        scripts = {"github": [step["run"] for step in workflow["jobs"]["plc"]["steps"] if "run" in step],
                   "gitlab": gitlab["plc"]["script"]}
        for service, script in scripts.items():
            place = folder / f"init_{service}"
            place.mkdir()
            own = Repository(plcxx, place)
            own.git("branch", "origin/main", own.base)
            summary = place / "summary.md"
            environment = {"BASE": "main", "GITHUB_STEP_SUMMARY": str(summary),
                           "CI_MERGE_REQUEST_DIFF_BASE_SHA": own.base}
            ran = own.run(own_commands(script), **environment)
            print(f"--- init, {service}: {ran.returncode}\n{ran.stdout}")
            assert ran.returncode == 0, service
            changes = (summary if service == "github" else place / "changes.md").read_text()
            assert "U4A8" in changes, changes
            own.write("lamp.yaml", SCENARIO.replace("U4A8: 1", "U4A8: 0"))
            assert own.run(own_commands(script), **environment).returncode != 0, service


main()
