// Constant tables, texts, memory functions, arrays of arrays and of structures, indices that are computed.
// shows: l long 60
// sets: X[0] 2, X[1] 1
// sets: X[0] 0, X[1] 3
#include <string.h>
#include <stdlib.h>
long l[60]; static const int curve[2][4] = { { -5, 300, 32767, -32768 }, { 1, 2 } }; static const unsigned char seven[] = { 63, 6, 91, 79, 102, 109, 125, 7, 127, 111 };
static const struct row { char kind; int from, to; unsigned char t[2]; } rows[] = { { 'a', -10, 10, { 1, 2 } }, { -1, 11, 99, { 255 } }, { 'z' } };
int cube[2][3][4]; char word[8] = "abc"; char text[] = "x\"\\\101\x41\n"; unsigned char raw[12]; struct row copy[3]; int sorted[6];
int find(int v) { unsigned i; for (i = 0; i < sizeof rows / sizeof rows[0]; i++) if (v >= rows[i].from && v <= rows[i].to) return i; return -1; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i, j, n; int *p; struct row *r = copy; unsigned char *b;
  l[k++] = curve[X[1] & 1][X[0]]; l[k++] = curve[0][X[1]]; l[k++] = seven[X[0] + X[1]]; l[k++] = seven[sizeof seven - 1 - X[0]]; l[k++] = find(0) * 100 + find(50) * 10 + find(-11); l[k++] = rows[1].t[0] + rows[X[0] ? 2 : 1].kind; l[k++] = sizeof rows; l[k++] = sizeof curve[1] + sizeof text * 100;
  for (i = 0; i < 2; i++) for (j = 0; j < 3; j++) for (n = 0; n < 4; n++) cube[i][j][n] = i * 100 + j * 10 + n; l[k++] = cube[X[1] & 1][X[0]][X[1]]; p = cube[1][0]; l[k++] = p[X[1] * 4 + X[0] - 4]; l[k++] = *cube[1][X[0]]; l[k++] = **cube[1]; l[k++] = (&cube[0][1][2])[X[0] + 1]; l[k++] = &cube[1][0][0] - &cube[0][X[0]][1]; l[k++] = sizeof cube[0] / sizeof cube[0][0][0];
  l[k++] = word[X[0]] + word[3] + word[7]; word[X[1]]++; l[k++] = word[X[1]]; l[k++] = text[1] + text[2] * 2 + text[3] * 3 + text[4] * 5 + text[5] + text[6]; l[k++] = "0123456789ABCDEF"[X[0] * 5 + X[1]];
  for (i = 0; i < 12; i++) raw[i] = i * 21; memmove(raw + 2, raw, 8); l[k++] = raw[2] + raw[9] * 256L; memcpy(raw + X[0], word, 3); l[k++] = raw[X[0] + 2]; memset(raw + 4, -3, 3); l[k++] = raw[4] + raw[6] + raw[7]; l[k++] = memcmp(raw + 4, raw + 5, 2); l[k++] = memcmp(raw, raw + 1, 3) > 0; memcpy(copy, rows, sizeof copy); copy[2] = copy[X[1] & 1]; l[k++] = copy[2].from + r[2].t[1]; b = (unsigned char *) r; l[k++] = b[1] + b[2] * 256L; l[k++] = r[1].t - b;
  for (i = 0; i < 6; i++) sorted[i] = (i * 7 + X[0] * 3) % 6 - 2; for (i = 1; i < 6; i++) for (j = i; j > 0; j--) if (sorted[j - 1] > sorted[j]) { n = sorted[j]; sorted[j] = sorted[j - 1]; sorted[j - 1] = n; } for (i = 0; i < 6; i++) l[k++] = sorted[i]; l[k++] = abs(sorted[0]) + labs(-100000L) + abs(-32767); sorted[sorted[5] - 1] = 77; l[k++] = sorted[2]; i = 1; sorted[i] += i; l[k++] = sorted[1]; 
}
void plc2() { }
