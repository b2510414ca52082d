// Tables with two dimensions, with rows handed on, initialisers that leave elements out, indices with effects.
// shows: grid int 20, out int 16
// sets: X[0] 1, X[1] 2
// sets: X[0] 3, X[1] 4
int grid[20];
int table[4][5] = {{1, 2, 3, 4, 5}, {6}, {-7, -8, 900}};
const char names[3][4] = {"ab", "cdef", {'g', 0}};
const unsigned char cube[2][2][3] = {1, 2, 3, 4, 5, 6, 7};
char text[] = "M03 S1200";
int out[16];
int sum(int *row, int n) { int i, s = 0; for (i = 0; i < n; i++) s += row[i]; return s; }
int total(int t[][5], int rows) { int i, s = 0; for (i = 0; i < rows; i++) s = s * 3 + sum(t[i], 5); return s; }
unsigned number(char *p) { unsigned n = 0; int i; for (i = 0; i < 5; i++) { if (p[i] < '0' || p[i] > '9') break; n = n * 10 + (p[i] - '0'); } return n; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i, j, k = 0;
  table[X[0]][X[1]] += 10; table[3][k++] -= X[0] + 1; table[X[0] - 1][X[1] % 5] <<= 1;
  for (i = 0; i < 4; i++) for (j = 0; j < 5; j++) grid[i * 5 + j] = table[i][j] * table[3 - i][4 - j];
  k = 0; out[k++] = sum(table[1], 5); out[k++] = total(table, 4); out[k++] = total(table + 1, 2); out[k++] = sum(&table[0][3], 4);
  out[k++] = names[1][3] + names[0][2] + names[2][0]; out[k++] = cube[1][0][0] * 10 + cube[X[0] & 1][1][X[1] & 1]; out[k++] = sizeof table[0] + sizeof text;
  out[k++] = number(&text[1]); out[k++] = number(text + 5); out[k++] = *(*(table + 2) + 2); out[k++] = *table[X[0]]; out[k++] = (*(table + 1))[0]; out[k++] = 2[table[0]];
  text[5 + X[0]] = '0' + X[1]; text[2]++; out[k++] = table[X[0] < 3] - table[0]; out[k++] = &table[2][1] - &table[0][4];
}
void plc2() { }
