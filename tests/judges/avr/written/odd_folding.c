// Constants at the ends of their types: types of literals, folding that wraps, sizes, comparisons of mixed signs, in initialisers.
// shows: l long 80
// sets: X[0] 1, P[0] 32768
// sets: X[0] 255, P[0] 65535
long l[80];
enum { lowest = -32767 - 1, highest = 32767, next = highest - 1, bits = 1 << 14 };
int gi = 32767 + 1; unsigned gu = -1; char gc = 300; unsigned char gb = -1; long gl = 65535; long gm = 0xFFFF; long gn = 32767 * 2; unsigned long go = -1; long gp = 40000 + 40000; long gq = 0x8000; long gr = -0x8000; long gs = 1 << 15; long gt = ~0u; int gv = -32768 / -1; int gw = 'a' - '\377'; unsigned gx = 40000u * 2; long gy = 5 / -2 * 1000 + 5 % -2; long gz = sizeof(int) - 3;
int array[(0x7FFF < 0) + (65535 > 0) + (0xFFFF > 0) + (-1 > 0u) + sizeof(40000)];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0; int i = P[0]; unsigned u = P[0]; unsigned char b = X[0]; long q = i;
  l[k++] = gi; l[k++] = gu; l[k++] = gc; l[k++] = gb; l[k++] = gl; l[k++] = gm; l[k++] = gn; l[k++] = go; l[k++] = gp; l[k++] = gq; l[k++] = gr; l[k++] = gs; l[k++] = gt; l[k++] = gv; l[k++] = gw; l[k++] = gx; l[k++] = gy; l[k++] = gz; l[k++] = sizeof array;
  l[k++] = lowest; l[k++] = next; l[k++] = bits * 2; l[k++] = lowest - 1; l[k++] = -lowest; l[k++] = highest + b;
  l[k++] = sizeof(0x8000) * 1000 + sizeof(32768) * 100 + sizeof(0177777) * 10 + sizeof(0200000); l[k++] = sizeof('a') * 1000 + sizeof(1u) * 100 + sizeof(1l) * 10 + sizeof(b + b); l[k++] = sizeof(b ? 1 : 2l) * 100 + sizeof(b << 3l) * 10 + sizeof(b, q); l[k++] = sizeof(-b) + sizeof(b = q) * 10 + sizeof(b++) * 100 + sizeof(!q) * 1000;
  l[k++] = -1 < sizeof(int); l[k++] = -1 < 1u; l[k++] = -1L < 1u; l[k++] = -1L < 1ul; l[k++] = -1 < b; l[k++] = 0xFFFF == -1; l[k++] = 65535 == -1; l[k++] = i == 0x8000; l[k++] = i == 32768; l[k++] = u == 32768; l[k++] = i == -32768; l[k++] = u == -32768; l[k++] = u == 0xFFFFFFFF;
  l[k++] = i - 1 > 0; l[k++] = i < i + 1; l[k++] = -i < 0; l[k++] = i * 2; l[k++] = u * 2; l[k++] = u * 2L; l[k++] = i / 2; l[k++] = i % 7; l[k++] = u % 7; l[k++] = u / -2; l[k++] = q / -2; l[k++] = u * u; l[k++] = (long) i * i; l[k++] = b * b; l[k++] = b * b * b; l[k++] = b << 8; l[k++] = (b << 8) >> 8; l[k++] = (unsigned) (b << 8) >> 8;
  l[k++] = i >> 15; l[k++] = u >> 15; l[k++] = q >> 16; l[k++] = ~b; l[k++] = (unsigned char) ~b; l[k++] = -b; l[k++] = !b * -1; l[k++] = b - 1u; l[k++] = b - 2 < 0u; l[k++] = b - 300 > 0u;
  l[k++] = (b > 5 ? -1 : 1u); l[k++] = (b > 5 ? b : -1l); l[k++] = b > 5 ? 'x' : 100000; l[k++] = (b > 5 ? -1 : 1u) / 2; l[k++] = (1 ? -1 : 0u) > 0; l[k++] = (1 ? -1 : 0l) > 0;
}
void plc2() { }
