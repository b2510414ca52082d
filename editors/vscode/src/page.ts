// Pages of plcxx in a webview: nothing is loaded, and only what plcxx itself wrote is executed.

/** HTML of plcxx (`report`, `diff --format html`) under a strict policy. `nonce`: new for each page. */
export function withPolicy(html: string, nonce: string): string {
  const policy =
    `default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; ` +
    `style-src 'nonce-${nonce}'; script-src 'nonce-${nonce}'`;
  const styles: string[] = [];
  let hasScript = false;
  const page = html
    .split(/(<script\b[^>]*>[\s\S]*?<\/script>)/)
    .map((piece) => {
      if (!piece.startsWith("<script")) return withoutStyleAttributes(piece, nonce, styles);
      // What the page's own script relies on comes right in front of it: the elements are there then.
      const first = !hasScript && !/^<script[^>]*type="application\/json"/.test(piece);
      hasScript ||= first;
      return (first ? preludeOf(styles, nonce) : "") + nonceInto(piece, nonce);
    })
    .join("");
  const rules = styles.map((style, number) => `[data-plcxx-style="${number}"] { ${decoded(style)} }`).join("\n");
  const head =
    `<meta http-equiv="Content-Security-Policy" content="${policy}"/>` +
    (rules === "" ? "" : `<style nonce="${nonce}">\n${rules}\n</style>`);
  const at = /<head[^>]*>/.exec(page);
  if (at === null) return `<!DOCTYPE html><html><head>${head}</head><body>${page}</body></html>`;
  const end = at.index + at[0].length;
  return page.slice(0, end) + head + page.slice(end);
}

/** The page's script may read style attributes and make style elements, as it does outside of the editor. */
function preludeOf(styles: readonly string[], nonce: string): string {
  const texts = JSON.stringify(styles.map(decoded)).replace(/</g, "\\u003c");
  return `<script nonce="${nonce}">
{
  const styles = ${texts};
  for (const one of document.querySelectorAll("[data-plcxx-style]")) one.style.cssText = styles[one.dataset.plcxxStyle];
  const create = document.createElement.bind(document);
  document.createElement = (name, options) => {
    const made = create(name, options);
    if (name === "style") made.nonce = "${nonce}";
    return made;
  };
}
</script>`;
}

function nonceInto(element: string, nonce: string): string {
  return element.replace(/^<(\w+)/, `<$1 nonce="${nonce}"`);
}

/** The policy refuses style attributes: each becomes a rule of its own. */
function withoutStyleAttributes(html: string, nonce: string, styles: string[]): string {
  return html
    .replace(/<[a-zA-Z][^<>]*>/g, (tag) =>
      tag.replace(/\sstyle="([^"]*)"/g, (_, style: string) => {
        let number = styles.indexOf(style);
        if (number < 0) number = styles.push(style) - 1;
        return ` data-plcxx-style="${number}"`;
      }))
    .replace(/<style(?=[\s>])/g, `<style nonce="${nonce}"`);
}

/** A page around a picture. */
export function pictureOf(title: string, svg: string): string {
  return (
    `<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"/><title>${escaped(title)}</title>` +
    `<style>body { margin: 0; padding: 12px; background: var(--vscode-editor-background); }</style></head>` +
    `<body>${svg.replace(/<\?xml[^>]*\?>/, "")}</body></html>`);
}

export function escaped(text: string): string {
  return text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c] ?? c);
}

function decoded(text: string): string {
  return text.replace(/&quot;/g, '"').replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&amp;/g, "&");
}
