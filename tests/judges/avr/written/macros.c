// Macros as they are met: without parentheses, with arguments used twice, pasted and nested, redefined on the way.
// shows: out int 24
// sets: X[0] 7, X[1] 5
// sets: X[0] 130, X[1] 131
#define TWICE(x) x + x
#define SQUARE(x) ((x) * (x))
#define BIT(byte, n) (byte & (1 << (n)))
#define SET(byte, n) byte |= 1 << n
#define CLR(byte, n) (byte) &= ~(1 << (n))
#define BETWEEN(lo, x, hi) ((lo) <= (x) && (x) <= (hi))
#define CAT(a, b) a##b
#define XCAT(a, b) CAT(a, b)
#define NAME value
#define SWAP(type, a, b) { type t_; t_ = a; a = b; b = t_; }
#define EMPTY
#define DO_BOTH(a, b) do { a; b; } while (0)
#define MINUS -
#if 'A' == 65 && -1 < 0 && (3 - 5) / 2 == -1 && defined(BIT) && !defined NOTHING
#define FIRST 100
#elif 1
#define FIRST 200
#endif
int out[24], value1 = 11, value2 = 22;
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0, a = X[0], b = X[1];
  out[i++] = TWICE(a) * 3; out[i++] = TWICE(a ? 1 : 2); out[i++] = SQUARE(a - b); out[i++] = BIT(a | b, 1); out[i++] = SQUARE(SQUARE(3));
  SET(a, 3); CLR(b, 0); out[i++] = a; out[i++] = b; out[i++] = BETWEEN(a, b, 200) + BETWEEN(5, a & 7, 6);
  out[i++] = CAT(value, 1) + XCAT(NAME, 2); SWAP(int, a, b) out[i++] = a - b;
  if (a > b) DO_BOTH(out[i] = 1, b++); else DO_BOTH(out[i] = 2, a++);
  i++;
  out[i++] = MINUS-a; out[i++] = -MINUS EMPTY b; out[i++] = FIRST;
#undef FIRST
#define FIRST(x) ((x) ? FIRST : 1)
  {
    int FIRST = 77;
    out[i++] = FIRST(a) + FIRST;
  }
#define LAST(x, y) (x\
 - \
y)
  out[i++] = LAST((a, b), /* , */ 3) /LAST(4,2); out[i++] = sizeof(XCAT(un, signed)) + sizeof("a" "bc"); out[i++] = __LINE__ - __LINE__ == 0;
#ifdef NEVER
  out[0] = 'x
#else /* NEVER */
  out[i++] = '\x41' + 'B' * '\0' + '\377' + '\'';
#endif
}
void plc2() { }
