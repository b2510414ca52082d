// Effects in conditions: what && and || leave out, commas, conditional expressions with stores in one arm.
// shows: n int 8, out int 24
// sets: X[0] 0, X[1] 1, X[2] 2
// sets: X[0] 1, X[1] 0, X[2] 0
// sets: X[0] 7, X[1] 9, X[2] 200
int n[8], out[24];
int count(int k, int value) { n[k]++; return value; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int a = X[0], b = X[1], c = X[2], i = 0;
  if (count(0, a) && count(1, b) || count(2, c)) out[i] = 1;
  i++;
  if (count(3, a) || count(4, b) && !count(5, c)) out[i] = 2; else out[i] = 3;
  i++;
  out[i++] = a && b++ || c--; out[i++] = b; out[i++] = c;
  out[i++] = (a = 5, b += a, c ? b : -b); out[i++] = a ? b ? c ? 1 : 2 : 3 : 4; out[i++] = !a ? 1 : !b ? 2 : !c ? 3 : 4;
  a ? (out[i] = b++) : (c += 10); i++;
  out[i++] = c; out[i++] = (a > 3 ? b : c) + (a < 3 ? 1 : 2); out[i++] = a > b == c > b; out[i++] = a == b == c; out[i++] = a < b < c;
  out[i++] = !a == b; out[i++] = a & b == c; out[i++] = a | b && c; out[i++] = -a < b | c << 1 & 0xF;
  a = b = c ? a : b; out[i++] = a * b; (void) (a++ ? b-- : c++); out[i++] = a + 100 * b + c;
  out[i++] = (a++, b++, c) + sizeof(a++ + b); out[i++] = a; 
  //@loop_bound 50
  for (a = 0, b = 20; a < b && (c ^= a); a++, b--) n[6]++;
  out[i++] = a * 100 + b; while (a-- > 0 && b) { n[7] += b; if (--b > 18) continue; b -= 2; if (b < 4) break; }
}
void plc2() { }
