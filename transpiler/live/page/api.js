// What the page and the server say to each other: commands out, states in.

const token = new URLSearchParams(location.hash.slice(1)).get("token") ?? "";
const withToken = (path) => (token ? path + (path.includes("?") ? "&" : "?") + "token=" + encodeURIComponent(token) : path);

export async function get(path) {
  const answer = await fetch(path, { headers: token ? { "X-Plcxx-Token": token } : {} });
  const given = await answer.json();
  if (!answer.ok) throw new Error(given.error ?? answer.statusText);
  return given;
}

let before = Promise.resolve();

/** Gives what the command answers; an Error has the server's reason. Commands arrive in the order in which they were given: two
    requests at a time may overtake each other. */
export function send(command) {
  const answer = before.then(() => post(command));
  before = answer.catch(() => {});
  return answer;
}

async function post(command) {
  const answer = await fetch("/api/command", {
    method: "POST",
    headers: { "Content-Type": "application/json", ...(token ? { "X-Plcxx-Token": token } : {}) },
    body: JSON.stringify(command),
  });
  const given = await answer.json();
  if (!answer.ok) throw new Error(given.error ?? answer.statusText);
  return given;
}

/** Calls `change` with each change of the state, `gone` with whether the server is away. A new stream begins with all. */
export function listen(change, begin, gone) {
  const events = new EventSource(withToken("/api/events"));
  events.onopen = () => {
    begin();
    gone(false);
  };
  events.onmessage = (event) => change(JSON.parse(event.data));
  events.onerror = () => {
    gone(true);
    if (events.readyState !== EventSource.CLOSED) return;
    setTimeout(() => listen(change, begin, gone), 1000);
  };
}
