// What plcxx' C dialect defines beyond C, written out for avr-gcc: the register areas, accesses outside an object,
// division by 0, shift counts outside the width, and the fault record. Programs of the judge are compiled with -fwrapv.
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <string.h>

#define AREA(bytes)                \
  union {                          \
    unsigned char uc[bytes];       \
    signed char c[bytes];          \
    unsigned ui[(bytes) / 2];      \
    int i[(bytes) / 2];            \
    unsigned long ul[(bytes) / 4]; \
    long l[(bytes) / 4];           \
  }
static AREA(128) X, Y;
static AREA(768) R;
static AREA(512) F, G;
static AREA(200) P, B;
static unsigned plc1_time, plc2_time;
static struct {
  unsigned char x[100];
  unsigned f[256], p[100];
} host;
static int fault_code;
static long fault_count;
// What the control keeps (4.2, 7.3).
enum { IDLE, ACTIVE, DONE };
static unsigned char request[4][4], asked[4];
static void (*handler[4][5])(int);
static long now, next1, next2;

static void fault(int code) {
  fault_code = code;
  ++fault_count;
}

// An element, or outside of the array an object that is 0 and that nobody reads again.
#define AT(array, index)                                                              \
  (*({                                                                                \
    static __typeof__((array)[0]) none_;                                              \
    long index_ = (index);                                                            \
    int inside_ = index_ >= 0 && index_ < (long)(sizeof(array) / sizeof((array)[0])); \
    if (!inside_) {                                                                   \
      fault(2);                                                                       \
      memset((void*)&none_, 0, sizeof none_);                                         \
    }                                                                                 \
    inside_ ? &(array)[index_] : &none_;                                              \
  }))
// *F_T[word] of the pointer tables F and G.
#define WORD(area, type, word)                                           \
  (*({                                                                   \
    static type none_;                                                   \
    long index_ = (word);                                                \
    int inside_ = index_ >= 0 && 2 * index_ + (long)sizeof(type) <= 512; \
    if (!inside_) {                                                      \
      fault(2);                                                          \
      none_ = 0;                                                         \
    }                                                                    \
    inside_ ? (type*)&(area).uc[2 * index_] : &none_;                    \
  }))

#define DIVISION(suffix, type, trap)            \
  static type divide_##suffix(type a, type b) { \
    if (b == 0) {                               \
      fault(1);                                 \
      return 0;                                 \
    }                                           \
    if ((type) - 1 < 0 && b == (type) - 1) {    \
      if (trap && a != 0 && a == (type) - a) {  \
        fault(1);                               \
      }                                         \
      return -a;                                \
    }                                           \
    return a / b;                               \
  }                                             \
  static type rest_##suffix(type a, type b) {   \
    if (b == 0) {                               \
      fault(1);                                 \
      return 0;                                 \
    }                                           \
    if ((type) - 1 < 0 && b == (type) - 1) {    \
      if (trap && a != 0 && a == (type) - a) {  \
        fault(1);                               \
      }                                         \
      return 0;                                 \
    }                                           \
    return a % b;                               \
  }
DIVISION(i, int, 1)
DIVISION(u, unsigned, 0)
DIVISION(l, long, 0)
DIVISION(ul, unsigned long, 0)
#define OF_TYPE(expression, name) \
  _Generic(expression, int: name##_i, unsigned: name##_u, long: name##_l, unsigned long: name##_ul)
#define DIV(a, b) OF_TYPE((a) + (b), divide)((a), (b))
#define MOD(a, b) OF_TYPE((a) + (b), rest)((a), (b))

#define SHIFT(suffix, type, width)                          \
  static type left_##suffix(type a, unsigned char count) {  \
    unsigned char n = width == 16 ? count & 31 : count;     \
    return n >= width ? 0 : a << n;                         \
  }                                                         \
  static type right_##suffix(type a, unsigned char count) { \
    unsigned char n = width == 16 ? count & 31 : count;     \
    return n >= width ? (a < 0 ? -1 : 0) : a >> n;          \
  }
SHIFT(i, int, 16)
SHIFT(u, unsigned, 16)
SHIFT(l, long, 32)
SHIFT(ul, unsigned long, 32)
#define SHL(a, count) OF_TYPE((a) << 0, left)((a), (unsigned char)(count))
#define SHR(a, count) OF_TYPE((a) << 0, right)((a), (unsigned char)(count))

// avr-gcc 5.4 takes v > 2u ? v : 3u for 129 when v is a signed char of -127: it may not look into the operands.
#define ARM(value)                  \
  ({                                \
    __auto_type arm_ = (value) + 0; \
    arm_;                           \
  })

// <stdlib.h> of the dialect
#define abs judge_abs
#define labs judge_labs
static int abs(int a) { return a < 0 ? -a : a; }
static long labs(long a) { return a < 0 ? -a : a; }
#define ABS(a) _Generic((a) + 0, long: labs, unsigned long: labs, default: abs)(a)
static unsigned _rotl(unsigned a, int n) { return n ? a << n | a >> (16 - n) : a; }
static unsigned _rotr(unsigned a, int n) { return n ? a >> n | a << (16 - n) : a; }
static unsigned long _lrotl(unsigned long a, int n) { return n ? a << n | a >> (32 - n) : a; }
static unsigned long _lrotr(unsigned long a, int n) { return n ? a >> n | a << (32 - n) : a; }
#define max(a, b) (((a) > (b)) ? ARM(a) : ARM(b))
#define min(a, b) (((a) < (b)) ? ARM(a) : ARM(b))

// Hands bytes to the runner.
static void show(const void* at, unsigned count) {
  GPIOR1 = (unsigned)at;
  GPIOR2 = (unsigned)at >> 8;
  OCR3A = count;
  __asm__ volatile("" ::: "memory");
  GPIOR0 = 1;
}
struct shown {
  const void* at;
  unsigned count;
};
static void show_all(const struct shown* one, unsigned count) {
  for (; count != 0; --count, ++one) show(one->at, one->count);
}

// Options (10.5).
static unsigned char mirrored = 28, calls_once, flags_off, stop_printed, stop_at_fault;
static int base = 1;
static int hw[4];
static unsigned char called[4][4], halted, was_due1, was_due2;

// The system functions (6.10), on the images.
#define G_L(word) (*(long*)&G.uc[2 * (word)])
#define F_L(word) (*(long*)&F.uc[2 * (word)])
static int is_axis(int a) {
  if (a >= 0 && a < 16) return 1;
  fault(2);
  return 0;
}
static long magnitude(long v) { return v < 0 ? -v : v; }
static void set_axis_home(int a, int on) {
  if (!is_axis(a)) return;
  if (on)
    G.ui[10 * a] |= 0x40;
  else
    G.ui[10 * a] &= ~0x40;
}
static void set_axis_jog(int a, int v) {
  if (is_axis(a)) G.i[10 * a + 4] = v;
}
static void step_axis(int a, long d) {
  long v;
  if (d == 0) return;
  v = magnitude((long)((unsigned long)G_L(10 * a + 1) + d)) / 200 * (long)F.ui[251];
  if (v > F.i[10 * a + 7]) v = F.i[10 * a + 7];
  if (v < 2) v = 2;
  G_L(10 * a + 1) += d;
  G.i[10 * a + 3] = v;
}
static void set_axis_step(int a, long d) {
  if (is_axis(a)) step_axis(a, d);
}
static void set_axis_move(int a, long d, int s) {
  long l1, l2, v1, v2;
  if (!is_axis(a) || d == 0) return;
  l1 = magnitude(G_L(10 * a + 1));
  l2 = magnitude(d);
  v1 = G.i[10 * a + 3] < 0 ? -G.i[10 * a + 3] : G.i[10 * a + 3];
  v2 = s < 0 ? -s : s;
  G.i[10 * a + 3] = divide_l(l1 * v1 + l2 * v2, l1 + l2);
  G_L(10 * a + 1) += d;
}
static long get_axis_pos(int a) { return is_axis(a) ? F_L(10 * a + 1) + G_L(10 * a + 1) : 0; }
static int get_axis_den(int a) { return !is_axis(a) || (G_L(10 * a + 1) == 0 && G.i[10 * a + 4] == 0); }
static void set_axis_moveto(int a, long p, int s) {
  if (a < 0 || a > 15)
    fault(2);
  else
    set_axis_move(a, p - get_axis_pos(a), s);
}
static void set_axis_stop(int a) {
  long l, b;
  if (!is_axis(a)) return;
  l = G_L(10 * a + 1);
  b = G.i[10 * a + 3] * (long)F.ui[251] / 200;
  if (l > 0) {
    if (l > b) l = b;
  } else if (-l > b) {
    l = stop_printed ? -l : -b;
  }
  G_L(10 * a + 1) = l;
  set_axis_jog(a, 0);
  set_axis_home(a, 0);
}
static int get_handwheel(int h) {
  int n;
  if (h < 0 || h > 3) {
    fault(2);
    return 0;
  }
  n = hw[h];
  hw[h] = 0;
  return n;
}
static void handwheel(int h, int a, int mul) {
  const int ok = h >= 0 && h < 4 && a >= 0 && a < 16;
  if (!ok)
    fault(2);
  else
    step_axis(a, (long)get_handwheel(h) * mul);
}

// What a power cycle keeps.
static struct {
  unsigned char b[200];
  unsigned char host[100 + 512 + 200];
  long now;
} kept __attribute__((section(".noinit")));
extern char __data_start, __data_end, __bss_start, __bss_end, __data_load_start;
// Variables get their initial values again, of every program: this is the one that runs.
static void load_data(void) {
  char* to = &__data_start;
  unsigned long from;
  __asm__(
      "ldi %A0, lo8(__data_load_start)\n\tldi %B0, hi8(__data_load_start)\n\tldi %C0, hh8(__data_load_start)\n\tclr %D0"
      : "=d"(from));
  for (; to != &__data_end; ++to, ++from) *to = pgm_read_byte_far(from);
  for (to = &__bss_start; to != &__bss_end; ++to) *to = 0;
}

static void power_on(void) {
  unsigned char c, k;
  memset(&X, 0, sizeof X);
  memset(&Y, 0, sizeof Y);
  memset(&R, 0, sizeof R);
  memset(&F, 0, sizeof F);
  memset(&G, 0, sizeof G);
  memset(&P, 0, sizeof P);
  memset(&B, 0, sizeof B);
  memset(&host, 0, sizeof host);
  for (c = 0; c < 4; ++c)
    for (k = 0; k < 4; ++k) G.i[170 + 20 * c + k] = -1;
  fault_code = 0;
  fault_count = 0;
  memset(asked, 0, sizeof asked);
  memset(request, 0, sizeof request);
  memset(handler, 0, sizeof handler);
  memset(hw, 0, sizeof hw);
  halted = 0;
  plc1_time = plc2_time = 0;
  now = next1 = next2 = 0;
}
static void power_cycle(void) {
  memcpy(kept.b, B.uc, 200);
  memcpy(kept.host, &host, sizeof kept.host);
  kept.now = now;
  load_data();
  power_on();
  memcpy(B.uc, kept.b, 200);
  memcpy(&host, kept.host, sizeof kept.host);
  now = next1 = next2 = kept.now;
}

// The dispatcher (7.3): kinds M, S, T, B; the fifth handler is E's.
static void dispatch(unsigned char c) {
  static const unsigned char code[4] = {4, 7, 5, 6};  // from F[160+20c] on
  const unsigned word = 160 + 20 * c;
  unsigned char k;
  if (asked[c]) {
    asked[c] = 0;
    if (handler[c][4]) handler[c][4](c);
  }
  for (k = 0; k < 4; ++k) {
    const unsigned strobe = F.ui[word + 3] & 0x0100 << k, cancel = F.ui[word + 3] & 0x8000u;
    const unsigned held = F.ui[word + 3] & 0x2000;
    if (request[c][k] == IDLE && strobe && !cancel) {
      G.ui[word + 10 + k] = F.ui[word + code[k]];
      G.ui[word + 14] |= 1 << k;
      request[c][k] = ACTIVE;
      called[c][k] = 0;
      if (!flags_off && k == 0 && F.ui[word + code[k]] == 0) G.ui[word + 14] |= 0x1000;
      if (!flags_off && k == 0 && F.ui[word + code[k]] == 1) G.ui[word + 14] |= 0x2000;
    }
    if (request[c][k] == ACTIVE && (!strobe || cancel)) {
      G.i[word + 10 + k] = -1;
      G.ui[word + 14] &= ~(1 << k);
      request[c][k] = DONE;
    }
    if (request[c][k] == ACTIVE && !(held && !(G.ui[word + 14] & 0x0100 << k)) && !(calls_once && called[c][k])) {
      called[c][k] = 1;
      if (handler[c][k])
        handler[c][k](c);
      else
        G.i[word + 10 + k] = -1;
    }
    if (request[c][k] == DONE && !strobe) {
      G.ui[word + 3] &= ~(1 << k);
      request[c][k] = IDLE;
    }
  }
}
static void complete(unsigned char c) {
  const unsigned word = 160 + 20 * c;
  unsigned char k, active = 0;
  for (k = 0; k < 4; ++k) {
    if (request[c][k] == ACTIVE && G.i[word + 10 + k] == -1) {
      G.ui[word + 14] &= ~(1 << k);
      G.ui[word + 3] |= 1 << k;
      request[c][k] = DONE;
    }
    if (request[c][k] == ACTIVE) active = 1;
  }
  G.ui[word + 3] &= ~0x10;
  if (active) G.ui[word + 3] |= 0x10;
}
// With faults=stop: after the part in which a fault was.
static int is_stopped(long faults) {
  if (!stop_at_fault || fault_count == faults) return halted;
  halted = 1;
  memset(&Y, 0, sizeof Y);
  memset(&G, 0, sizeof G);
  return 1;
}
// The cycle (4.2).
static void cycle(void (*plc1)(void), void (*plc2)(void)) {
  const unsigned char due1 = now - next1 >= 0, due2 = now - next2 >= 0;
  const long faults = fault_count;
  unsigned char c;
  was_due1 = due1 && !halted;
  was_due2 = due2 && !halted;
  memcpy(X.uc, host.x, 100);
  memcpy(F.uc, host.f, 512);
  memcpy(P.uc, host.p, 200);
  if (due2) memcpy(X.uc + 100, X.uc, mirrored);
  if (due1 && !halted) {
    for (c = 0; c < 4; ++c) dispatch(c);
    plc1();
    next1 = now + plc1_time;
  }
  if (!is_stopped(faults) && due2) {
    plc2();
    next2 = now + plc2_time;
  }
  if (!is_stopped(faults))
    for (c = 0; c < 4; ++c) complete(c);
  now += base;
}
static void stop(void) {
  for (;;) __asm__ volatile("cli\n\tsleep");
}
