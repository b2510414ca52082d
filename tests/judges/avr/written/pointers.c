// Pointers: handed on, moved by expressions, compared, to elements, members, bytes of wider objects, registers.
// shows: a int 8, out long 24, w unsigned char 6
// sets: R[0] 3, R[1] 200
// sets: R[0] 0, R[1] 129
struct pair { unsigned char n; int v; } pairs[4] = {{1, 10}, {2, -20}, {3, 30000}, {4}};
int a[8] = {5, -5, 32767, -32768, 1000};
unsigned char w[6] = "plc";
long out[24], big = 0x01020304;
unsigned char *cursor = &R[5];
int *current = a;
void add(int *p, int v) { *p += v; p[1] = -*p; }
int sum(int *from, int *to) { int s = 0, i; for (i = 0; i < 8; i++) { if (from + i == to) break; s += from[i]; } return s; }
unsigned char most(unsigned char *p, int n) { unsigned char m = 0; while (n-- > 0) { if (*p > m) m = *p; p++; } return m; }
void swap(long *x, int *y) { long t = *x; *x = *y; *y = t; }
int *either(int *p, int *q, int which) { return which ? p : q; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0, local[3], *p = a + 3, k = R[0] & 3;
  char *bytes = (char *) &big;
  struct pair *q = pairs + k;
  local[0] = 1; local[1] = 2; local[2] = R[1];
  add(&a[k], R[1]); add(local, 7); add(a + 6, -1); add(p, *p); add(&local[k & 1], 5);
  out[i++] = local[0] * 100L + local[1] * 10 + local[2]; out[i++] = sum(a, a + 5); out[i++] = sum(&a[2], p + 3); out[i++] = most(R, 3) + most(w, 6) + most(&w[1], k);
  out[i++] = *p++; out[i++] = *++p; out[i++] = (*p)--; out[i++] = --*p; out[i++] = p - a; out[i++] = p > a + k; out[i++] = *(p - k); out[i++] = p[-1];
  out[i++] = q->v; q->v += q->n; out[i++] = (*q).v--; out[i++] = (q = pairs)->n; q += 2; out[i++] = q[1].n - q[-1].v; out[i++] = q - pairs; out[i++] = (q++)->v; out[i++] = q[0].n;
  out[i++] = bytes[0] * 1000 + bytes[3]; bytes[2] ^= 0xFF; *(int *) (bytes + 1) += 300; out[i++] = big; swap(&big, &a[7]); swap(&out[0], &pairs[1].v);
  *cursor++ = *w + k; if (cursor > &R[40]) cursor = R + 5; *current-- ^= 0x55; current += 2; if (current == a + 8) current = &a[0]; out[i++] = !current || current - a; out[i++] = *either(a, &a[1], k) - *either(&a[2], a + 3, !k);
}
void plc2() { }
