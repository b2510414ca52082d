#include "transpiler/dialects/hnc/machine/headers.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "transpiler/dialects/hnc/machine/machine.h"

namespace plcxx::hnc {
namespace {

struct HeaderRow {
  std::string_view name;
  std::string_view text;  // besides the functions of functions.def
};

constexpr std::string_view kNull =
    "#ifndef NULL\n"
    "#define NULL 0\n"
    "#endif\n";
constexpr std::string_view kSize =
    "#ifndef __plcxx_size_t\n"
    "#define __plcxx_size_t\n"
    "typedef unsigned size_t;\n"
    "#endif\n";

constexpr std::string_view kLimits =
    "#define CHAR_BIT 8\n"
    "#define SCHAR_MIN (-128)\n"
    "#define SCHAR_MAX 127\n"
    "#define UCHAR_MAX 255\n"
    "#ifdef _CHAR_UNSIGNED\n"
    "#define CHAR_MIN 0\n"
    "#define CHAR_MAX 255\n"
    "#else\n"
    "#define CHAR_MIN (-128)\n"
    "#define CHAR_MAX 127\n"
    "#endif\n"
    "#define SHRT_MIN (-32767-1)\n"
    "#define SHRT_MAX 32767\n"
    "#define USHRT_MAX 65535u\n"
    "#define INT_MIN (-32767-1)\n"
    "#define INT_MAX 32767\n"
    "#define UINT_MAX 65535u\n"
    "#define LONG_MIN (-2147483647l-1)\n"
    "#define LONG_MAX 2147483647l\n"
    "#define ULONG_MAX 4294967295ul\n";

// What the macros of a header with refused functions expand to is itself refused by name.
constexpr HeaderRow kHeaders[] = {
    {"stdlib.h",
     "#define max(a,b) (((a) > (b)) ? (a) : (b))\n"
     "#define min(a,b) (((a) < (b)) ? (a) : (b))\n"},
    {"string.h", ""},
    {"mem.h", ""},
    {"math.h", ""},
    {"dos.h", ""},
    {"conio.h", ""},
    {"stdio.h", "typedef struct __plcxx_file FILE;\n#define EOF (-1)\n"},
    {"io.h", ""},
    {"bios.h", ""},
    {"time.h", "typedef long time_t;\ntypedef long clock_t;\n"},
    {"stdarg.h", "typedef int va_list;\n"},
    {"setjmp.h", "typedef int jmp_buf[10];\n"},
    {"alloc.h", ""},
    {"stddef.h", ""},
    {"limits.h", kLimits},
    {"ctype.h", ""},
    {"signal.h", ""},
    {"process.h", ""},
};

constexpr std::string_view kSystemHeaderNames[] = {"plc.h", "plcs.h", "hncplc.h", "hnc.h"};

bool SameLetters(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// abs that keeps the width of its argument: every type of one that C converts to int without the option has its own,
/// for none of two would fit better.
constexpr std::string_view kAbsOfBothWidths =
    "int abs(int) __attribute__((overloadable));\nint abs(unsigned) __attribute__((overloadable));\n"
    "int abs(double) __attribute__((overloadable));\nlong abs(long) __attribute__((overloadable));\n"
    "long abs(unsigned long) __attribute__((overloadable));";

std::string Prototypes(std::string_view header, AbsMeaning abs) {
  std::string text;
  for (const FunctionRow& row : SystemFunctions()) {
    if (!IsDeclaredBy(row, header)) continue;
    const bool keeps_type = row.function == SystemFunction::kAbs && abs == AbsMeaning::kLong;
    text += keeps_type ? kAbsOfBothWidths : std::string_view(row.prototype);
    text += '\n';
  }
  return text;
}

std::string AreaDeclarations(std::string_view prefix) {
  std::string text;
  for (const AreaRow& area : Areas()) {
    const auto declare = [&](std::string_view type, std::string_view suffix) {
      text += "extern " + std::string(type) + (area.table ? " *" : " ") + std::string(prefix) + std::string(area.name) +
              std::string(suffix) + "[];\n";
    };
    declare(area.basic, "");
    for (const ViewRow& view : Views()) declare(view.type, view.suffix);
  }
  const std::string time = "extern unsigned " + std::string(prefix);
  return text + time + "plc1_time;\n" + time + "plc2_time;\n";
}

struct RefusedRow {
  RefusedKind kind;
  std::string_view names;  // with blanks in between; a '*' at the end stands for any rest
};

constexpr RefusedRow kRefused[] = {
    {RefusedKind::kMemory,
     "malloc calloc realloc free farmalloc farcalloc farrealloc farfree alloca allocmem freemem sbrk brk coreleft "
     "farcoreleft heapcheck heapwalk farheapcheck strdup"},
    {RefusedKind::kInputOutput,
     "fopen freopen fclose fflush fread fwrite fseek ftell rewind fgetc fputc fgets fputs getc putc feof ferror "
     "fprintf "
     "printf sprintf vprintf vfprintf vsprintf scanf fscanf sscanf puts gets getchar putchar getch getche ungetch "
     "kbhit "
     "putch cprintf cputs cgets cscanf clrscr clreol gotoxy wherex wherey textcolor textbackground textattr textmode "
     "window open creat close read write lseek tell eof filelength access unlink remove rename chmod perror _open "
     "_creat _close _read _write setmode dup dup2 tmpfile fdopen fileno setbuf setvbuf ungetc"},
    {RefusedKind::kHardware,
     "inp outp inpw outpw inport outport inportb outportb peek peekb poke pokeb geninterrupt int86 int86x intdos "
     "intdosx intr getvect setvect keep bios* _bios_* _dos_* bdos bdosptr segread absread abswrite getpsp "
     "hardresume hardretn harderr MK_FP FP_SEG FP_OFF __emit__"},
    {RefusedKind::kNonLocalJump, "setjmp longjmp"},
    {RefusedKind::kTime,
     "delay sleep time clock gettime getdate settime setdate ftime stime difftime localtime gmtime mktime asctime "
     "ctime "
     "strftime nosound sound"},
    {RefusedKind::kVariableArgument, "va_start va_arg va_end"},
    {RefusedKind::kLibrary,
     "exit _exit abort atexit signal raise rand random srand randomize system getenv putenv exec* spawn* div ldiv atoi "
     "atol atof itoa ltoa ultoa strtol strtoul strtod ecvt fcvt gcvt qsort bsearch lfind lsearch swab "
     "strcpy strncpy strcat strncat strcmp strncmp stricmp strnicmp strcmpi strlen strchr strrchr strstr strtok strspn "
     "strcspn strpbrk strset strnset strrev strlwr strupr stpcpy strerror memchr memccpy memicmp movmem setmem "
     "movedata "
     "sin cos tan asin acos atan atan2 sinh cosh tanh exp log log10 pow pow10 fmod modf frexp ldexp hypot poly cabs "
     "isalpha isdigit isalnum isspace isupper islower isxdigit ispunct isprint isgraph iscntrl isascii toupper tolower "
     "toascii _toupper _tolower"},
};

bool IsIn(std::string_view names, std::string_view name) {
  while (!names.empty()) {
    const size_t end = std::min(names.find(' '), names.size());
    const std::string_view word = names.substr(0, end);
    if (word.ends_with('*') ? name.starts_with(word.substr(0, word.size() - 1)) : word == name) return true;
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return false;
}

}  // namespace

bool IsSystemHeaderName(std::string_view name) {
  return std::ranges::any_of(kSystemHeaderNames, [&](std::string_view known) { return SameLetters(known, name); });
}

std::string SystemHeader(AbsMeaning abs) {
  std::string text = "#ifndef __plcxx_plc_h\n#define __plcxx_plc_h\n";
  text += AreaDeclarations("");
  text += Prototypes("plc.h", abs);
#define HNC_POINTER(Name, Parameters, Table, Index) text += "#define " Name "(" Parameters ") (" Table "[" Index "])\n";
#define HNC_ADDRESS(Name, Parameters, Text) text += "#define " Name "(" Parameters ") " Text "\n";
#define HNC_CELL(Name, Number) text += "#define " Name "(ch) (*ch_mst_mod(ch," #Number "))\n";
#define HNC_CONSTANT(Name, Text) text += "#define " Name " " Text "\n";
#include "transpiler/dialects/hnc/machine/machine.def"
  return text + "#endif\n";
}

bool IsNameOfSystemHeader(std::string_view name) {
#define HNC_POINTER(Name, Parameters, Table, Index) \
  if (name == Name) return true;
#define HNC_ADDRESS(Name, Parameters, Text) \
  if (name == Name) return true;
#define HNC_CELL(Name, Number) \
  if (name == Name) return true;
#define HNC_CONSTANT(Name, Text) \
  if (name == Name) return true;
#include "transpiler/dialects/hnc/machine/machine.def"
  const FunctionRow* function = FindSystemFunction(name);
  return FindSystemName(name).has_value() || name == "plc1_time" || name == "plc2_time" ||
         (function != nullptr && IsDeclaredBy(*function, "plc.h"));
}

std::string ExpectedDeclarations(std::string_view prefix) {
  std::string text = AreaDeclarations(prefix);
  for (const FunctionRow& row : SystemFunctions()) {
    std::string prototype(row.prototype);
    const size_t name = prototype.find(std::string(row.name) + "(");
    text += prototype.insert(name, prefix) + "\n";
  }
  return text;
}

std::optional<std::string> StandardHeader(std::string_view name, AbsMeaning abs) {
  const auto* const row =
      std::ranges::find_if(kHeaders, [&](const HeaderRow& header) { return SameLetters(header.name, name); });
  if (row == std::end(kHeaders)) return std::nullopt;
  const std::string guard = "__plcxx_" + std::string(row->name.substr(0, row->name.find('.')));
  std::string text = "#ifndef " + guard + "\n#define " + guard + "\n";
  text += row->name == "limits.h" ? "" : std::string(kNull) + std::string(kSize);
  return text + std::string(row->text) + Prototypes(row->name, abs) + "#endif\n";
}

std::optional<RefusedKind> RefusedFunction(std::string_view name) {
  for (const RefusedRow& row : kRefused) {
    if (IsIn(row.names, name)) return row.kind;
  }
  return std::nullopt;
}

}  // namespace plcxx::hnc
