// "C++ beside the source": what `plcxx emit` makes of the open program, made anew when one of its sources is saved. A
// line that is chosen on one side is marked on the other.
import { mkdtemp, readdir, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import * as vscode from "vscode";

import { Commands } from "./commands";
import { below, cppLinesOf, MappedText, readLineMap, sourceOf } from "./line_map";
import { argumentsOf, folderOf, ProgramOfFile } from "./program";

const SCHEME = "plcxx-cpp";
const STALE = "// Not up to date: the program has errors, see Problems.";

interface Shown {
  program: ProgramOfFile;
  uri: vscode.Uri;
  mapped: MappedText;
}

export class CppBeside implements vscode.TextDocumentContentProvider, vscode.Disposable {
  private readonly shown = new Map<string, Shown>();
  private readonly changed = new vscode.EventEmitter<vscode.Uri>();
  private readonly mark = vscode.window.createTextEditorDecorationType({
    isWholeLine: true,
    backgroundColor: new vscode.ThemeColor("editor.wordHighlightBackground"),
  });
  private readonly subscriptions: vscode.Disposable[];
  readonly onDidChange = this.changed.event;

  constructor(private readonly commands: Commands) {
    this.subscriptions = [
      vscode.workspace.registerTextDocumentContentProvider(SCHEME, this),
      vscode.commands.registerCommand("plcxx.cppBeside", () => this.show()),
      vscode.workspace.onDidSaveTextDocument((document) => this.saved(document)),
      vscode.window.onDidChangeTextEditorSelection((event) => this.follow(event.textEditor)),
    ];
  }

  dispose(): void {
    this.subscriptions.forEach((one) => one.dispose());
    this.mark.dispose();
    this.changed.dispose();
  }

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.shown.get(uri.toString())?.mapped.text ?? "";
  }

  async show(): Promise<void> {
    const open = await this.commands.openProgram();
    if (open === undefined) return;
    const { program, editor } = open;
    const mapped = await this.emit(program);
    if (mapped === undefined) return;
    const name = program.program !== "" ? program.program : "program";
    const query = encodeURIComponent(program.project ?? program.sources.join("|"));
    const uri = vscode.Uri.parse(`${SCHEME}:/${encodeURIComponent(name)}.cpp?${query}`);
    this.shown.set(uri.toString(), { program, uri, mapped });
    this.changed.fire(uri);
    const document = await vscode.workspace.openTextDocument(uri);
    await vscode.window.showTextDocument(document, {
      viewColumn: vscode.ViewColumn.Beside, preserveFocus: true, preview: false });
    this.follow(editor);
  }

  /** Undefined: the program has errors or plcxx is not there, which has been said. */
  private async emit(program: ProgramOfFile): Promise<MappedText | undefined> {
    const folder = await mkdtemp(join(tmpdir(), "plcxx-"));
    try {
      const { options, sources } = argumentsOf(program);
      const ran = await this.commands.run(
        ["emit", ...options, "--line-directives", "--parts", "1", "--quiet", "-o", folder, ...sources], folderOf(program));
      if (ran === undefined) return undefined;
      const cpp = (await readdir(folder)).find((name) => name.endsWith(".cpp"));
      if (ran.exitCode !== 0 || cpp === undefined) {
        await this.commands.showFailure("no C++", ran);
        return undefined;
      }
      return readLineMap(await readFile(join(folder, cpp), "utf8"));
    } finally {
      await rm(folder, { recursive: true, force: true });
    }
  }

  private async saved(document: vscode.TextDocument): Promise<void> {
    for (const [key, shown] of [...this.shown]) {
      if (!vscode.workspace.textDocuments.some((one) => one.uri.toString() === key)) {
        this.shown.delete(key);  // closed since
        continue;
      }
      const program = await this.commands.programOf(document.uri);
      if (program === undefined || program.project !== shown.program.project || program.program !== shown.program.program) {
        continue;
      }
      if (program.project === null && program.sources[0] !== shown.program.sources[0]) continue;
      const mapped = await this.emit(program);
      shown.program = program;
      if (mapped !== undefined) shown.mapped = mapped;
      else if (!shown.mapped.text.startsWith(STALE)) shown.mapped = below(STALE, shown.mapped);
      this.changed.fire(shown.uri);
    }
  }

  private editorOf(uri: vscode.Uri): vscode.TextEditor | undefined {
    return vscode.window.visibleTextEditors.find((editor) => editor.document.uri.toString() === uri.toString());
  }

  /** Marks on the other side what is chosen on this one. */
  private follow(editor: vscode.TextEditor): void {
    const line = editor.selection.active.line;
    const own = this.shown.get(editor.document.uri.toString());
    if (own !== undefined) {
      const place = sourceOf(own.mapped, line, own.program.sources);
      const other = place && this.editorOf(vscode.Uri.file(place.file));
      if (place && other) this.markLines(other, place.line, place.line);
      return;
    }
    for (const shown of this.shown.values()) {
      const lines = cppLinesOf(shown.mapped, editor.document.uri.fsPath, line);
      const other = this.editorOf(shown.uri);
      if (lines && other) this.markLines(other, lines[0], lines[1]);
    }
  }

  private markLines(editor: vscode.TextEditor, first: number, last: number): void {
    const range = new vscode.Range(first, 0, last, 0);
    editor.setDecorations(this.mark, [range]);
    editor.revealRange(range, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
  }
}
