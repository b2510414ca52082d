// A table of tools as an array of structs: search, exchange, sorting, pointers that walk.
// shows: found int 8, sum long 2, order unsigned char 8
// sets: X[0] 33, X[1] 2
// sets: X[0] 5, X[1] 7
struct tool { unsigned char number; char wear; unsigned life; long length; };
struct tool magazine[8] = {{12, -3, 500, 100000}, {5, 7, 40000, -20}, {33, -128, 0, 65536}, {1, 127, 65535}, {9}, {7, 1, 2, 3}, {200, -1, 32768, -1}, {5}};
int found[8];
long sum[2];
unsigned char order[8];

int search(struct tool *p, int n, unsigned char number)
{
  int i;
  for (i = 0; i < n; i++, p++)
    if (p->number == number) return i;
  return -1;
}
void exchange(struct tool *a, struct tool *b)
{
  struct tool t;
  t = *a; *a = *b; *b = t;
}
struct tool worn(struct tool t, int by)
{
  t.wear += by;
  t.life -= by;
  t.length = t.length + t.wear;
  return t;
}
void sort(void)
{
  int i, j;
  for (i = 0; i < 7; i++)
    for (j = 0; j < 7 - i; j++)
      if (magazine[j].length > magazine[j + 1].length || (magazine[j].length == magazine[j + 1].length && magazine[j].number > magazine[j + 1].number))
        exchange(&magazine[j], &magazine[j + 1]);
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  struct tool *p = magazine;
  int i;
  found[0] = search(magazine, 8, X[0]);
  found[1] = search(magazine + 3, 5, X[0]);
  found[2] = search(&magazine[X[1] & 3], 4, 5);
  found[3] = worn(magazine[X[1]], 200).wear;
  found[4] = worn(magazine[X[1]], -1).life > magazine[1].life;
  magazine[X[1]] = worn(worn(magazine[6], 3), 4);
  sort();
  for (sum[0] = 0, i = 0; i < 8; ++i, ++p) {
    order[i] = p->number;
    sum[0] += p->length * p->wear;
    sum[1] += (*p).life;
  }
  found[5] = p - magazine;
  found[6] = (--p)->number == magazine[7].number;
  found[7] = sizeof(struct tool) + sizeof magazine / sizeof *magazine;
}
void plc2() { }
