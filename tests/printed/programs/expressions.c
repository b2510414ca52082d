// Operators and conversions: what the types and the known bounds of their operands make of them.
#include "plc.h"
#include <stdlib.h>
#include <math.h>
int a, b, n;
unsigned u, v;
char s, t;
unsigned char c, d;
long l, m;
unsigned long w, x;
float f, g;
double r, q;
static int any() { return R_i[0]; }
static int small() { return R[1] & 7; }
static int truth() { return a > b; }
static unsigned char byte() { return R[2]; }
static int nothing() { if (a) return 3; }
static int three_or_five() { return a ? 3 : 5; }

static void arithmetic() {
  a = a + b; a = a - b; a = a * b; a = a / b; a = a % b; a = -a; a = ~a; a = +a; a = !a;
  u = u + v; u = u - v; u = u * v; u = u / v; u = u % v; u = -u; u = ~u;
  l = l + m; l = l - m; l = l * m; l = l / m; l = l % m; l = -l; l = ~l;
  w = w + x; w = w - x; w = w * x; w = w / x; w = w % x; w = -w; w = ~w;
  f = f + g; f = f - g; f = f * g; f = f / g; f = -f;
  r = r + q; r = r - q; r = r * q; r = r / q; r = -r; a = !r; a = !f;
  a = a & b; a = a | b; a = a ^ b; l = l & m; l = l | m; l = l ^ m;
  a = c / d; a = c % d; a = s / t; a = s % t; a = a / 3; a = a % 3; a = a / -1; a = a % -1; u = u / 3; l = l / -1;
  a = c / 3; a = c % 3; a = (c & 7) / ((d & 7) + 1); a = (a & 7) / (b & 7); a = a / (b | 1); a = (a | 1) / b;
  a = (a & 0x7F) % (b & 0x3F); l = (l & 255) / (m & 15); l = l % 1000; w = w % 1000; a = 100 / b; a = -32767 - 1; a = (a & 15) * (b & 15);
  a = (a & 15) + (b & 15); a = (a & 15) - (b & 15); a = -(a & 15); a = ~(a & 15); a = 0x7FFF; a = 0x10; a = 9 & b; a = 10 & b; a = -2 & b;
}
static void shifts() {
  a = a << 3; a = a >> 3; u = u << 3; u = u >> 3; l = l << 3; l = l >> 3; w = w << 3; w = w >> 3;
  a = a << b; a = a >> b; u = u >> b; l = l << b; l = l >> b; w = w >> b;
  a = a << (b & 15); a = a << (b & 31); a = a << (b & 63); a = a >> (c & 7); l = l << (b & 31); l = l << (b & 255); l = l << (b & 511);
  a = (a & 15) >> 2; a = (a & 15) << 2; a = c >> 1; a = c << 1; a = s >> 1; c = c >> 1; c = c << 1; s = s >> 1; s = s << 1;
  a = a << l; l = l << a; a = a << u; a = (a & 1) << (b & 7); a = a >> (a > b); a = (a > b) << 3; a = 1 << (b & 15); a = -1 >> (b & 15);
  a <<= 2; a >>= b; u >>= 2; c <<= 3; c >>= 3; s >>= 2; l >>= 7; w >>= b; a = a << 15; a = a << 0; l = l << 31; l = l >> 31;
}
static void comparisons() {
  n = a < b; n = a > b; n = a <= b; n = a >= b; n = a == b; n = a != b;
  n = u < v; n = u > v; n = u <= v; n = u >= v; n = u == v; n = u != v;
  n = l < m; n = l > m; n = l <= m; n = l >= m; n = l == m; n = l != m;
  n = w < x; n = w > x; n = w <= x; n = w >= x; n = w == x; n = w != x;
  n = f < g; n = f > g; n = f <= g; n = f >= g; n = f == g; n = f != g;
  n = r < q; n = r > q; n = r <= q; n = r >= q; n = r == q; n = r != q;
  n = c < d; n = c > 10; n = s < t; n = s > -5; n = c == d; n = c < 256; n = c > 255; n = c >= 0; n = c < 0; n = c <= 255; n = c == 256; n = c != 256;
  n = s < 128; n = s >= -128; n = s > 127; n = s < -128; n = u < 0; n = u >= 0; n = u > 65535u; n = (a & 7) < 8; n = (a & 7) <= 7; n = (a & 7) > 7;
  n = (a & 7) >= 8; n = (a & 7) == 8; n = (a & 7) != 8; n = 8 > (a & 7); n = (a & 7) < 7; n = (a & 7) <= 6; n = (a & 7) < b; n = (a & 7) < (b & 7);
  n = a < u; n = a < l; n = u < l; n = c < u; n = s < u; n = a < w; n = c < f; n = l < r; n = a == -1; n = u == 65535u; n = l == -1L; n = 5 == 5; n = 3 < 2;
  n = (a < b) == 0; n = (a < b) == 1; n = (a < b) != 0; n = (a < b) != 1; n = (a < b) == 2; n = (a < b) == (u < v); n = (a < b) != (u < v);
  n = (a < b) & (u < v); n = (a < b) | (u < v); n = (a < b) ^ (u < v); n = (a < b) + (u < v); n = (a < b) * 3; n = -(a < b); n = ~(a < b); n = !(a < b);
  c = a < b; l = a < b; u = a < b; f = a < b; r = a < b; s = !a; n = !!a; n = !c; n = !l; n = a && b; n = a || b; n = !(a && b); n = truth() == 1;
}
static void conversions() {
  c = a; c = l; c = u; s = a; s = l; a = c; a = s; a = l; a = u; u = a; u = c; u = s; u = l; l = c; l = s; l = a; l = u; w = a; w = s; w = c; w = u; w = l;
  f = a; f = u; f = c; f = s; f = l; f = w; f = r; r = f; r = a; r = u; r = c; r = l; r = w; a = f; a = r; u = f; c = f; s = r; l = f; l = r; w = r;
  c = a & b; c = a | b; c = a ^ b; c = ~a; c = a + b; c = c + d; c = c - d; c = c + 1; c = s + t; c = c + a; c = a + c; c = a - c; c = c - a; c = -5; c = 300; s = 200;
  c = a ? c : d; c = a ? c : 5; c = a ? b : c; c = a ? c : b; c = a ? 5 : s; c = (l & 15); c = l + 1; c = -a; s = -1; c = c & 0x0F; c = ~c; c = c ^ d; c = c * d; c = c / d;
  a = (char)b; a = (unsigned char)b; a = (long)b; a = (char)l; l = (int)m; l = (unsigned)m; l = (unsigned)a; l = (a & 7); l = (a & 0x7FFF); w = (a & 7); f = (a & 7);
  a = (c & 3) + (l & 3); u = (a & 7) + v; l = small(); l = byte(); u = byte(); f = small(); l = three_or_five(); c = three_or_five(); a = (int)3.7; a = (int)-3.7; l = 100000L; w = 4000000000UL;
  f = 1.5; r = 1.5; f = 3; r = -2; f = 0.1; a = 'A'; a = '\xFF'; u = 0xFFFF; l = 0xFFFF; a = 0xFFFF; l = -1; l = -2147483647L - 1; u = -1; c = 0xAB; w = 0xABCDEF01UL;
}
static void assignments() {
  a += b; a -= b; a *= b; a /= b; a %= b; a &= b; a |= b; a ^= b; u += c; c += a; c -= d; c *= 2; c /= d; c %= d; c &= 0x3C; c |= a; c ^= d; s += 5; s *= t;
  l += a; l *= u; w -= c; f += a; f *= g; r += f; r /= a; a += f; c += f; u -= r; l += 1.5; a += l; a *= 1.5; a = b = c; a = (b += 3); c = (a = 300); l = (c = a);
  a++; a--; ++a; --a; u++; c++; c--; ++c; --c; s++; l++; l--; w++; f++; f--; r++; --r; a = b++; a = ++b; a = b--; a = --b; a = c++; a = ++c; f = g++; f = ++g; l = m--;
  a = (b++, c); a = (any(), b); (any(), small()); a; a + b; any(); a ? any() : small(); a ? b : n; a && any(); a || any(); a && b; (void)any(); (char)any();
  R[5] = a; R[5] += 2; R_i[4]++; Y[3] = X[2]; Y[3] |= 4; Y[3] &= ~4; Y[3] ^= 1; P[4]; R_ul[1] = l; R_c[3] = s; B[2] = a; B_c[4]++; *F_i[3] = 5; *G_ui[7] = u; *G_ui[7] |= 3;
}
static void known() {
  if (a > 5) { n = a > 3; n = a > 5; n = a > 6; n = a; l = a; }
  if (a >= 0 && a < 100) { n = a / (a + 1); l = a; f = a; n = a >> 1; n = a * 2 > 198; n = a < 100; }
  if (a == 7) { n = a; n = a + 1; n = a == 7; } else n = a != 7;
  if (a != 0) n = 100 / a;
  if (a) n = 100 / a; else n = a;
  if (!a) n = a; else n = 100 / a;
  if (u) n = 100 / u; else n = u;
  if (u > 0) n = 100u / u;
  if (0 < u) n = 100u / u;
  if (5 >= a) n = a <= 5;
  if (c > 10 || c < 5) n = c; else { n = c >= 5; n = c <= 10; }
  if (!(c > 10 || c < 5)) { n = c >= 5; n = c <= 10; }
  if (c > 10 && any()) n = c > 10;
  if (c > 10 && d > c) n = d > 11;
  if (a < b) n = a < b;
  if (b < 10) { if (a < b) n = a < 9; }
  if (l == 5) n = l; if (s < 0) l = s; else l = s; if ((long)s >= 0) l = s; if ((char)a >= 0) l = a;
  { int k = 3; n = k; k = a & 3; n = k < 4; k = k + 1; n = k < 5; any(); n = k < 5; if (b) k = 9; n = k <= 9; k = b; n = k < 5; }
  { int k = a & 3, j = b & 1; n = k - j; l = k - j; l = k + j; l = k * j; n = 10 / (k + 1); n = 10 / (k + j); n = k % 2; n = (k | j) < 4; n = (k ^ j) < 4; n = (k & j) < 2; n = k << j; n = k >> j; }
  { int k; k = a > b ? a & 3 : 7; n = k < 8; k = a > 10 ? a : 10; n = k >= 10; k = a < 10 ? a : 10; n = k <= 10; k = a > 10 ? 10 : a < 0 ? 0 : a; n = k; l = k; }
  { int k = any(); n = k > 5 ? any() : k > 7; n = k > 5 ? k > 3 : any(); n = (k > 5 && any()) ? k > 3 : k < 9; k > 5 ? any() : (n = k > 7); k > 5 ? (n = k > 3) : any(); k > 5 && (n = k > 3); k > 5 || (n = k > 7); }
  { unsigned k = u; if (k < 3) { n = k; l = k; k--; n = k < 3; } }
  { unsigned char k = c; n = k + 1 > 0; k += 200; n = k < 256; k = 3; k -= 4; n = k; }
  { int k = any(); if (k < 0) k = 0; if (k > 9) k = 9; l = k; n = 10 / (k + 1); }
  { long k = any(); n = k < 40000L; w = k; if (k >= 0) w = k; }
  { int k = nothing(); n = k < 4; n = three_or_five() > 2; n = small() < 8; n = byte() < 256; n = truth() < 2; }
  R[7] = 3; n = R[7]; if (R[8] == 4) n = R[8] == 4; if (R[8] < 5) R[8] = 0; n = R[8] < 5; a = 5; n = a; any(); n = a;
}
const int seven = 7;
const unsigned char few[2] = {3, 200};
static void constants() {
  if (seven > 3) n = seven > 3; if (seven < 9) n = seven < 9; n = seven + 1; n = seven == 7; l = seven; n = 10 / seven;
  if (few[1] > 5) n = few[1] > 5; n = few[0]; n = few[a & 1]; n = a % seven; n = a << seven;
}
static void library() {
  a = abs(b); a = abs(-5); a = abs(a & 7); a = abs(-(a & 7)); a = abs(small() - 3); l = labs(m); l = labs(a); l = labs(l & 7);
  n = abs((a & 7) + 3) >= 3; n = abs((a & 7) + 3) < 4; n = abs(-(a & 7) - 2) >= 2; n = abs(-(a & 7) - 2) < 10; n = abs((a & 7) - 3) < 5; n = abs((a & 7) - 3) >= 0; l = labs((l & 7) + 3);
  u = _rotl(u, 3); u = _rotr(u, a); w = _lrotl(w, 3); w = _lrotr(w, c); u = _rotl(a, 0); u = _rotr(c, 17);
  r = fabs(q); r = floor(q); r = ceil(q); r = sqrt(q); f = fabs(f); a = floor(f); r = sqrt(a);
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { arithmetic(); shifts(); comparisons(); conversions(); assignments(); known(); constants(); library(); }
void plc2() { }
