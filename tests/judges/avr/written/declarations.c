// Declarations as old programs have them: repeated, extern in blocks, qualifiers anywhere, names of types in any order.
// shows: out long 24, later int 3
// sets: X[0] 9
// sets: X[0] 200 cycles 2
extern int later[];
int counter;
int counter;
static unsigned char table[] = {1, 2, 3, 4,}, *at = table, rest = 9;
const volatile unsigned char fixed = 77;
typedef int (word), words[3];
typedef const char *name;
struct node;
struct node { struct inner { char c; } in; word w; };
struct inner alone = {-5};
union { unsigned all; unsigned char half[2]; } both = {0x1234};
long unsigned int wide = 5; int long signed tall = -5; short unsigned brief = 65535; char unsigned tiny = 256 + 3;
double *unused;
static int helper(const word a, register char b, words c);
name title = "y\x41\102\0x";
long out[24];
void init(void) { plc1_time = 1; plc2_time = 1; }
void plc1(void)
{
  extern int counter;
  int far *p = &counter, near *q;
  static words w = {1, 2};
  struct node n, *r = &n;
  enum { HERE = 3, THERE } e = THERE;
  int k = 0;
  n.in = alone; n.in.c -= 100; n.w = sizeof(struct node); q = w + 1;
  ++*p; *q += counter;
  out[k++] = helper(X[0], X[0], w); out[k++] = n.in.c; out[k++] = r->w + e; out[k++] = both.half[1]; both.half[0]++; out[k++] = both.all; out[k++] = wide - tall; out[k++] = brief + tiny;
  out[k++] = *at++; if (at == table + 4) at = table; out[k++] = title[1] * title[2] + title[3]; out[k++] = sizeof(words) + sizeof table + sizeof both; out[k++] = fixed; out[k++] = rest--; out[k++] = w[2] = w[0]++;
  { typedef char word; word x = X[0]; out[k++] = x; { struct inner { long l; } y; y.l = x * 70000; out[k++] = y.l + sizeof(struct inner); } out[k++] = sizeof(word); }
  out[k++] = counter; later[1] += counter;
  {
    extern long out[]; out[k] = k; k++;
  }
  goto end; k = 100;
end: ;
  out[k] += 1;
}
void plc2(void) { extern int later[3]; later[2] = later[0]--; }
int later[3] = {5};
static int helper(const int a, char b, int *c) { return a * b + c[1] * sizeof c[0]; }
