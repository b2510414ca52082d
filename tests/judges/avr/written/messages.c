// Texts: tables of names, characters compared with signs, digits made and read, escapes and joined literals.
// shows: line char 20, out int 16
// sets: X[0] 42, P[0] 65535
// sets: X[0] 199, P[0] 1234
const char *const names[4] = {"OK", "ALARM", "", "T\xC4\x80"};
const char *text;
char line[20];
int out[16];
int length(const char *p) { int n; for (n = 0; n < 10; n++) if (!p[n]) break; return n; }
int compare(const char *a, const char *b) { int i; for (i = 0; i < 6; i++) { if (a[i] != b[i]) return a[i] - b[i]; if (a[i] == 0) return 0; } return 1; }
void digits(char *to, unsigned n) { char k; for (k = 4; k >= 0; --k) { to[k] = '0' + n % 10; n /= 10; } to[5] = '\0'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? c - ' ' : c; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0, k;
  text = X[0] & 1 ? "odd" : "even" "ly";
  for (k = 0; k < 6; k++) { line[k + 12] = upper(text[k]); if (text[k] == 0) break; }
  digits(line, P[0]); digits(line + 6, X[0] * X[0]); line[5] = "-+*"[X[0] % 3];
  out[i++] = length(names[1]); out[i++] = length(names[X[0] & 1 ? 3 : 2]); out[i++] = compare(names[0], "OK"); out[i++] = compare(names[3], "T\200"); out[i++] = compare("ab", "abc");
  out[i++] = names[3][1]; out[i++] = names[3][1] > 0x7F; out[i++] = (unsigned char) names[3][2]; out[i++] = *names[1] + names[1][4]; out[i++] = "\1234"[0]; out[i++] = "\1234"[1]; out[i++] = sizeof "\0\0";
  out[i++] = length("a\
b"); out[i++] = line[0] - '0'; out[i++] = '\?' + '"' + "'"[0];
}
void plc2() { }
