// Machine code whose meaning is not in its instructions alone is refused, demanded to be what it is taken for, or not
// known: addresses in two halves, notes of the linker, what is below the stack pointer, callees, jumps into the middle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/prove/verify/object_code.h"

namespace plcxx::prove {
namespace {

using ::testing::HasSubstr;

constexpr uint32_t kStateBytes = 16;

class ZeroState : public verify::CodeEnvironment {
 public:
  explicit ZeroState(terms::Terms& all) : terms_(all) {}
  terms::TermId Initial(uint32_t) override { return terms_.Const(0, 8); }
  terms::TermId CallHost(verify::CodeMemory&, const verify::HostRequest& request, std::string& refusal) override {
    refusal = "a call of " + std::string(request.function);
    return {};
  }

 private:
  terms::Terms& terms_;
};

/// What becomes of f(State&) in these files: why it is refused, "demanded" what is not so for every state, or the first
/// word of State afterwards.
std::string Meaning(const char* target_name, const std::vector<std::string>& files) {
  const testing_support::TemporaryDirectory directory;
  const compile::Target& target = *compile::FindTarget(target_name);
  const auto found = compile::FindToolchain(target, "");
  const auto* toolchain = std::get_if<compile::Toolchain>(&found);
  if (toolchain == nullptr) return "no compiler";
  std::vector<std::string> objects;
  for (const std::string& text : files) {
    directory.Write("code.s", text);
    std::vector<std::string> command = toolchain->command;
    for (const std::string& flag : compile::FlagsOf(target)) command.push_back(flag);
    command.insert(command.end(), {"-c", "code.s", "-o", "code.o"});
    const compile::ProcessResult result = compile::RunProcess(command, 60, directory.path().string());
    if (result.exit_code != 0) return "not assembled: " + result.output;
    std::ifstream stream(directory.File("code.o"), std::ios::binary);
    objects.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  std::vector<verify::Signature> signatures = {{.function = "f", .parameters = {{.name = "m"}}},
                                               {.function = "declared", .parameters = {{.name = "m"}}},
                                               {.function = "many", .parameters = {{.name = "m"}}}};
  for (int i = 1; i < 10; ++i) signatures.back().parameters.push_back({.name = std::to_string(i), .width = 32});
  const verify::LoadedCode loaded = verify::LoadObjectCode(
      {.objects = objects, .signatures = signatures, .processor = std::string(target.processor)});
  if (loaded.code == nullptr) return loaded.reason;
  terms::Terms all;
  ZeroState state(all);
  verify::CodeRun run;
  run.function = "f";
  run.state_bytes = kStateBytes;
  run.arguments = {{.kind = verify::CodeArgument::Kind::kState, .name = "m", .value = {}}};
  const verify::CodeOutcome outcome = loaded.code->Execute(all, state, run);
  if (!outcome.refusal.empty()) return outcome.refusal;
  if (!outcome.obligations.empty()) return "demanded";
  terms::TermId word = outcome.slots[3];
  for (uint32_t i = 3; i-- > 0;) word = all.Concat(word, outcome.slots[i]);
  return all.IsConst(word) ? std::to_string(all.Value(word)) : "not known";
}

struct Code {
  const char* what;
  std::string text;  // of f
  const char* meaning;
};

void Expect(const char* target, const std::string& head, const std::string& tail, const std::vector<Code>& all) {
  for (const Code& code : all) {
    const std::string meaning = Meaning(target, {head + code.text + tail});
    if (meaning == "no compiler") GTEST_SKIP() << "no compiler for " << target;
    EXPECT_THAT(meaning, HasSubstr(code.meaning)) << target << ": " << code.what;
  }
}

TEST(ObjectCode, OfRiscvIsWhatTheLinkerMakesOfIt) {
  const std::string head = R"(
  .section .rodata
  .balign 4
words: .word 11, 12
  .section .text.f, "ax"
  .globl f
  .type f, @function
f:
)";
  const std::string tail = R"(
  .size f, . - f
  .section .text.g, "ax"
  .globl g
  .type g, @function
g: li a2, 1; li a2, 2; ret
  .size g, . - g
  .section .text.reads, "ax"
  .globl reads
  .type reads, @function
reads: sw t1, 0(a0); ret
  .size reads, . - reads
  .section .text.back, "ax"
  .globl back
  .type back, @function
back: andi a1, ra, 1; ret
  .size back, . - back
)";
  Expect(
      "rv32imac", head, tail,
      {{"a constant", "lla a1, words; lw a1, 4(a1); sw a1, 0(a0); ret", "12"},
       {"halves in order", "1: auipc a1, %pcrel_hi(words); lw a1, %pcrel_lo(1b)(a1); sw a1, 0(a0); ret", "11"},
       {"another upper half",
        "1: auipc a1, %pcrel_hi(words); addi a1, a1, 4; lw a1, %pcrel_lo(1b)(a1); sw a1, 0(a0); ret", "demanded"},
       {"an upper half alone", "1: auipc a1, %pcrel_hi(words); lw a1, 0(a1); sw a1, 0(a0); ret", "demanded"},
       {"absolute halves", "lui a1, %hi(words); lw a1, %lo(words)(a1); sw a1, 0(a0); ret", "11"},
       {"halves of two words", "lui a1, %hi(words); lw a1, %lo(words+4)(a1); sw a1, 0(a0); ret", "demanded"},
       {"a note of another instruction", "lui a1, %hi(words); xori a1, a1, %lo(words); ret",
        "a note of the linker for"},
       {"a jump to a function", "tail g", "0"},
       {"a jump into its middle", "tail g+2", "into the middle of a function"},
       {"a register of a far jump", "li t1, 7; tail reads", "not known"},
       {"a call without its second half", ".reloc ., R_RISCV_CALL_PLT, g; auipc t1, 0; li a1, 7; ret",
        "do not fit together"},
       {"halves that only one of them may lose",
        ".option relax; lui a1, %hi(words); .option norelax; lw a1, %lo(words)(a1); .option relax; sw a1, 0(a0); ret",
        "demanded"},
       {"halves that both may lose", ".option relax; lui a1, %hi(words); lw a1, %lo(words)(a1); sw a1, 0(a0); ret",
        "11"},
       {"a note that is longer than its instruction", ".reloc ., R_RISCV_BRANCH, f; c.beqz a1, f; nop; ret",
        "a note of the linker for"},
       {"a note of what is not executed", "j 1f; .reloc ., R_RISCV_32, words; c.nop; 1: c.li a1, 7; ret",
        "a note of the linker for"},
       {"bytes that the linker takes away", ".reloc ., R_RISCV_ALIGN, 2; c.li a1, 7; ret", "a note of the linker for"},
       {"a half of what it takes away", ".reloc ., R_RISCV_ALIGN, 2; .option norvc; nop; ret",
        "a note of the linker for"},
       {"nops that it takes away", ".reloc ., R_RISCV_ALIGN, 4; nop; nop; ret", "0"},
       {"a branch that it does not know of",
        "addi sp, sp, -16; sw ra, 0(sp); .4byte 0x00058663; call g; lw ra, 0(sp); addi sp, sp, 16; ret",
        "that the linker does not know of"},
       {"the global pointer", "mv t0, gp; li gp, 5; mv gp, t0; ret", "demanded"},
       {"the thread pointer", "mv t0, tp; li tp, 5; mv tp, t0; ret", "demanded"},
       {"both as they were", "mv t0, gp; mv gp, t0; mv t0, tp; mv tp, t0; ret", "0"},
       {"an uneven stack pointer", "addi sp, sp, -4; addi sp, sp, 4; ret", "demanded"},
       {"a stack pointer into State", "mv t0, sp; mv sp, a0; mv sp, t0; ret", "demanded"},
       {"a stack pointer far away", "mv t0, sp; li t1, 0x40000000; sub sp, sp, t1; mv sp, t0; ret", "demanded"},
       {"where a call comes back",
        "addi sp, sp, -16; sw ra, 0(sp); call back; sw a1, 0(a0); lw ra, 0(sp)\n"
        "addi sp, sp, 16; ret",
        "not known"},
       {"halves of a call", ".reloc ., R_RISCV_CALL_PLT, g; auipc t1, 0; jalr zero, 0(t2)", "do not fit together"},
       {"above the stack pointer",
        "addi sp, sp, -16; li a1, 5; sw a1, 8(sp); lw a2, 8(sp); addi sp, sp, 16; sw a2, 0(a0); ret", "5"},
       {"below the stack pointer", "sw a1, -4(sp); ret", "below the stack pointer"},
       {"a frame that is given back",
        "addi sp, sp, -16; li a1, 5; sw a1, 8(sp); addi sp, sp, 16; addi sp, sp, -16; lw a2, 8(sp); sw a2, 0(a0)\n"
        "addi sp, sp, 16; ret",
        "not known"},
       {"below it by another register", "addi a3, sp, -16; sw a1, 8(a3); lw a2, 8(a3); ret", "demanded"},
       {"below it when it is raised",
        "addi sp, sp, -16; li a1, 5; sw a1, 8(sp); mv a3, sp; addi sp, sp, 16; lw a2, 8(a3); ret", "demanded"}});
}

TEST(ObjectCode, OfArmIsWhatTheLinkerMakesOfIt) {
  const std::string head = R"(
  .syntax unified
  .thumb
  .section .rodata
  .balign 4
words: .word 11, 12
  .section .text.f, "ax"
  .globl f
  .thumb_func
  .type f, %function
f:
)";
  const std::string tail = R"(
  .size f, . - f
  .section .text.g, "ax"
  .globl g
  .thumb_func
  .type g, %function
g: movs r2, #1; movs r2, #2; bx lr
  .size g, . - g
)";
  Expect(
      "cortex-m4", head, tail,
      {{"halves in order", "movw r1, #:lower16:words; movt r1, #:upper16:words; ldr r1, [r1, #4]; str r1, [r0]; bx lr",
        "12"},
       {"halves of two words",
        "movw r1, #:lower16:words; movt r1, #:upper16:words+4; ldr r1, [r1]; str r1, [r0]; bx lr", "demanded"},
       {"a lower half alone", "movw r1, #:lower16:words; ldr r1, [r1]; str r1, [r0]; bx lr", "demanded"},
       {"a note of another instruction",
        "ldr r1, 1f; bx lr; .reloc ., R_ARM_THM_ALU_ABS_G0_NC, words; adds r1, #0; 1: nop", "a note of the linker for"},
       {"a jump to a function", "b.w g", "0"},
       {"a jump into its middle", "b.w g+2", "into the middle of a function"},
       {"flags of a move", "movs r1, #0; movs r2, #5; movs r3, r1; it eq; streq r2, [r0]; bx lr", "5"},
       {"flags of an older comparison",
        "movs r1, #1; movs r2, #5; cmp r1, #1; movs r3, r1; it eq; streq r2, [r0]; bx lr", "0"},
       {"waiting", "wfi; bx lr", "waits or signals"},
       {"a constant beside code", ".balign 4; ldr r1, 1f; str r1, [r0]; bx lr; .balign 4; 1: .word 9", "9"},
       {"one of a section that is anywhere", "ldr.w r1, [pc, #4]; str r1, [r0]; bx lr; nop; nop", "not in the section"},
       {"below the stack pointer", "str r1, [sp, #-4]; bx lr", "below the stack pointer"},
       {"a list that is given back", "movs r1, #5; push {r1, r2}; pop {r2, r3}; ldr r1, [sp, #0]; str r2, [r0]; bx lr",
        "demanded"},
       {"a constant that is executed", "movs r1, #5; .short 0x2300; str r1, [r0]; bx lr",
        "constants where instructions"},
       {"a constant in front of all", ".short 0x2300; movs r1, #5; str r1, [r0]; bx lr",
        "constants where instructions"},
       {"a jump over a constant", "movs r1, #5; b 1f; .short 0x2300; 1: str r1, [r0]; bx lr", "5"},
       {"two notes of a constant",
        ".balign 4; ldr r1, 1f; ldr r1, [r1]; str r1, [r0]; bx lr; .balign 4; 1: .word words; .reloc 1b, R_ARM_REL32, "
        "f",
        "the address of"},
       {"half a word of the stack", "sub sp, #2; add sp, #2; bx lr", "demanded"},
       {"a word of the stack", "sub sp, #4; add sp, #4; bx lr", "0"},
       {"a word of the stack at a call",
        "push {r4, lr}; sub sp, #4; movs r1, #0; movs r2, #4; bl memset; add sp, #4; pop {r4, pc}", "demanded"},
       {"below it by another register", "sub r2, sp, #8; str r1, [r2]; bx lr", "demanded"},
       {"below it by a register's number", "mvn r2, #7; str r1, [sp, r2]; bx lr", "demanded"},
       {"below it by a library's function",
        "push {r4, lr}; sub r0, sp, #64; movs r1, #0; movs r2, #8; bl memset; pop {r4, pc}", "demanded"},
       {"above it as it goes down", "str r1, [sp, #-8]!; add sp, #8; bx lr", "0"},
       {"a register of the linker's", "movs r1, #5; mov r12, r1; push {r4, lr}; bl g; str r12, [r0]; pop {r4, pc}",
        "not known"},
       {"a call under a condition that others follow",
        "push {r4, lr}; cmp r0, #1; .inst.n 0xbf04; bl g; movs r1, #1; pop {r4, pc}", "no instruction"},
       {"a jump under a condition", "cbz r0, 1f; cmp r0, #1; it eq\n1: moveq r2, #1; bx lr", "under a condition"}});
}

/// ARMv6-M stops at an access that ARMv7-M makes.
TEST(ObjectCode, OfCortexM0PlusIsAligned) {
  const std::string head = R"(
  .syntax unified
  .thumb
  .section .text.f, "ax"
  .globl f
  .thumb_func
  .type f, %function
f:
)";
  const std::string tail = "\n  .size f, . - f\n";
  const auto all = [](const char* misaligned) {
    return std::vector<Code>{
        {"a word", "adds r2, r0, #1; ldr r1, [r2]; str r1, [r0]; bx lr", misaligned},
        {"a half word", "adds r2, r0, #1; ldrh r1, [r2]; str r1, [r0]; bx lr", misaligned},
        {"a word by its index", "movs r2, #2; ldr r1, [r0, r2]; str r1, [r0]; bx lr", misaligned},
        {"a word that is written", "movs r1, #0; adds r2, r0, #2; str r1, [r2]; bx lr", misaligned},
        {"an aligned word", "adds r2, r0, #4; ldr r1, [r2]; str r1, [r0]; bx lr", "0"},
        {"an aligned half word", "adds r2, r0, #2; ldrh r1, [r2]; str r1, [r0]; bx lr", "0"}};
  };
  Expect("cortex-m0plus", head, tail, all("demanded"));
  Expect("cortex-m4", head, tail, all("0"));
}

/// The compiler knows what a function of the same section writes.
TEST(ObjectCode, CalleesOfTheSameSectionCount) {
  const std::string text = R"(
  .text
  .globl f
  .type f, @function
f: addi sp, sp, -16; sw ra, 12(sp); sw s0, 8(sp); mv s0, a0; li t3, 5; call declared; sw REG, 0(s0)
   lw ra, 12(sp); lw s0, 8(sp); addi sp, sp, 16; ret
  .size f, . - f
  .globl declared
  .type declared, @function
declared: li t3, 7; ret
  .size declared, . - declared
)";
  const auto with = [&](const char* reg) { return std::string(text).replace(text.find("REG"), 3, reg); };
  if (Meaning("rv32imac", {with("t3")}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {with("t3")}), "not known");
  EXPECT_EQ(Meaning("rv32imac", {with("zero")}), "0");
}

/// What is passed on the stack is the callee's: it may be another number when it comes back.
TEST(ObjectCode, ArgumentsOnTheStackAreGone) {
  const auto caller = [](const std::string& slot) {
    return R"(
  .section .text.f, "ax"
  .globl f
  .type f, @function
f: addi sp, sp, -32; sw ra, 28(sp); sw s0, 24(sp); mv s0, a0; li t0, 5; sw t0, 0(sp); sw t0, 4(sp); sw t0, 8(sp)
   call many; lw t0, )" +
           slot + R"((sp); sw t0, 0(s0); lw ra, 28(sp); lw s0, 24(sp); addi sp, sp, 32; ret
  .size f, . - f
  .section .text.many, "ax"
  .globl many
  .type many, @function
many: sw zero, 0(sp); ret
  .size many, . - many
)";
  };
  if (Meaning("rv32imac", {caller("0")}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {caller("0")}), "not known");
  EXPECT_EQ(Meaning("rv32imac", {caller("4")}), "not known");
  EXPECT_EQ(Meaning("rv32imac", {caller("8")}), "5");
}

/// Files have functions of one name for themselves: each is called by its own file.
TEST(ObjectCode, FunctionsOfOneNameAreTold) {
  const auto file = [](const std::string& number, const std::string& more) {
    return "  .text\n  .type declared, @function\ndeclared: li a1, " + number +
           "; ret\n  .size declared, . - declared\n" + more;
  };
  const std::string caller = R"(
  .globl f
  .type f, @function
f: addi sp, sp, -16; sw ra, 12(sp); sw s0, 8(sp); mv s0, a0; call declared; sw zero, 0(s0)
   lw ra, 12(sp); lw s0, 8(sp); addi sp, sp, 16; ret
  .size f, . - f
)";
  if (Meaning("rv32imac", {file("5", caller)}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {file("5", caller)}), "0");
  EXPECT_EQ(Meaning("rv32imac", {file("5", caller), file("5", "")}), "0");
  EXPECT_EQ(Meaning("rv32imac", {file("5", caller), file("6", "")}), "several functions declared");
}

/// As the linker takes symbols: one that no function has is not the library's, a strong one is before weak ones.
TEST(ObjectCode, SymbolsAreTheLinkers) {
  const std::string caller = R"(
  .section .text.f, "ax"
  .globl f
  .type f, @function
f: addi sp, sp, -16; sw ra, 12(sp); sw s0, 8(sp); mv s0, a0; li a1, 7; li a2, 4; call memset; sw zero, 0(s0)
   lw ra, 12(sp); lw s0, 8(sp); addi sp, sp, 16; ret
  .size f, . - f
)";
  if (Meaning("rv32imac", {caller}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {caller}), "0");
  for (const char* other :
       {".text; memset: ret", ".text; .globl memset; memset: ret", ".globl memset; .set memset, 0x80000000",
        ".text; .type memset, @gnu_indirect_function; memset: ret", ".comm memset, 4, 4",
        ".text; .type memset, @object; .globl memset; memset: ret", ".weak memset"})
    EXPECT_EQ(Meaning("rv32imac", {caller + other + "\n"}), "a call of memset") << other;
  EXPECT_EQ(Meaning("rv32imac", {caller, ".text; .globl memset; memset: ret\n"}), "a call of memset");
  // Nobody else calls what is a file's own.
  EXPECT_EQ(Meaning("rv32imac", {caller, ".text; memset: ret\n"}), "0");
  const auto function = [](const std::string& binding, const std::string& number) {
    return "  .section .text.memset, \"ax\"\n  " + binding + " memset\n  .type memset, @function\nmemset: li t1, " +
           number + "; sw t1, 0(a0); ret\n  .size memset, . - memset\n";
  };
  const std::string stores = std::string(caller).replace(caller.find("sw zero, 0(s0)"), 14, "nop");
  EXPECT_EQ(Meaning("rv32imac", {stores + function(".weak", "5")}), "5");
  EXPECT_EQ(Meaning("rv32imac", {stores + function(".weak", "5"), function(".weak", "5")}), "5");
  EXPECT_EQ(Meaning("rv32imac", {stores + function(".weak", "5"), function(".weak", "6")}), "a call of memset");
  EXPECT_EQ(Meaning("rv32imac", {stores + function(".weak", "5"), function(".globl", "6")}), "6");
}

/// The program's own function is the one that the linker takes for its name.
TEST(ObjectCode, FunctionsOfTheProgramAreTheLinkers) {
  const auto file = [](const std::string& head, const std::string& number) {
    return "  .section .text.f, \"ax\"\n" + head + "\nf: li a1, " + number + "; sw a1, 0(a0); ret\n  .size f, . - f\n";
  };
  const std::string function = ".type f, @function\n", shared = ".globl f\n", weak = ".weak f\n";
  if (Meaning("rv32imac", {file(function + shared, "5")}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {file(function, "5")}), "5");
  EXPECT_EQ(Meaning("rv32imac", {file(function, "5"), file(shared, "6")}), "several functions f");
  EXPECT_EQ(Meaning("rv32imac", {file(function + weak, "5"), file(shared, "6")}), "several functions f");
  EXPECT_EQ(Meaning("rv32imac", {file(function + weak, "5"), file(function + shared, "6")}), "several functions f");
}

TEST(ObjectCode, ConstantsAreTheLinkers) {
  const auto reader = [](const std::string& place) {
    return "  .section .text.f, \"ax\"\n  .globl f\n  .type f, @function\nf: lui a1, %hi(" + place + "); lw a1, %lo(" +
           place + ")(a1); sw a1, 0(a0); ret\n  .size f, . - f\n";
  };
  const auto words = [](const std::string& section, const std::string& head, const std::string& numbers) {
    return "  .section " + section + "\n  .balign 4\n" + head + "\nwords: .word " + numbers +
           "\n  .size words, . - words\n";
  };
  const std::string plain = ".rodata", merged = ".rodata.cst4, \"aM\", @progbits, 4";
  const std::string shared = ".globl words", weak = ".weak words";
  if (Meaning("rv32imac", {reader("words") + words(plain, "", "5, 6")}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {reader("words+4") + words(plain, "", "5, 6")}), "6");
  EXPECT_EQ(Meaning("rv32imac", {reader("words"), words(plain, shared, "5, 6")}), "5");
  EXPECT_EQ(Meaning("rv32imac", {reader("words") + words(plain, weak, "5"), words(plain, weak, "5")}), "5");
  EXPECT_EQ(Meaning("rv32imac", {reader("words") + words(plain, weak, "5"), words(plain, shared, "6")}), "6");
  EXPECT_EQ(Meaning("rv32imac", {reader("words") + words(plain, weak, "5"), words(plain, weak, "6")}),
            "the address of words");
  EXPECT_EQ(Meaning("rv32imac", {reader("words") + words(plain, weak, "5"), shared + "\n.set words, 0x80000000\n"}),
            "the address of words");
  // Equal ones become one: what stands behind one is another.
  EXPECT_EQ(Meaning("rv32imac", {reader("words") + words(merged, "", "5, 5, 6")}), "5");
  EXPECT_EQ(Meaning("rv32imac", {reader("words+8") + words(merged, "", "5, 5, 6")}), "demanded");
}

/// Two files' own constants of one name.
TEST(ObjectCode, ConstantsOfAlikeFunctionsCount) {
  const auto file = [](const std::string& number, const std::string& more) {
    return "  .section .rodata\n  .balign 4\nword: .word " + number +
           "\n  .section .text.g, \"axG\", @progbits, g, comdat\n  .weak g\n  .type g, @function\n"
           "g: lui a1, %hi(word); lw a1, %lo(word)(a1); ret\n  .size g, . - g\n" +
           more;
  };
  const std::string caller = R"(
  .section .text.f, "ax"
  .globl f
  .type f, @function
f: addi sp, sp, -16; sw ra, 12(sp); call g; sw a1, 0(a0); lw ra, 12(sp); addi sp, sp, 16; ret
  .size f, . - f
)";
  if (Meaning("rv32imac", {file("5", caller)}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {file("5", caller), file("5", "")}), "5");
  EXPECT_EQ(Meaning("rv32imac", {file("5", caller), file("6", "")}), "a call of g");
}

/// The decoder of one function goes on with what another one ends with.
TEST(ObjectCode, ConditionsEndWithTheirFunction) {
  const std::string text = R"(
  .syntax unified
  .thumb
  .section .text.a, "ax"
  .globl a
  .thumb_func
  .type a, %function
a: bx lr
  .inst.n 0xbf08
  .size a, . - a
  .section .text.f, "ax"
  .globl f
  .thumb_func
  .type f, %function
f: movs r1, #5
  str r1, [r0]
  bx lr
  .size f, . - f
)";
  if (Meaning("cortex-m4", {text}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("cortex-m4", {text}), "5");
}

TEST(ObjectCode, FunctionsAreNotWritten) {
  const auto file = [](const std::string& flags) {
    return "  .section .text.f, \"" + flags + "\"\n  .globl f\n  .type f, @function\nf: ret\n  .size f, . - f\n";
  };
  if (Meaning("rv32imac", {file("ax")}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {file("ax")}), "0");
  EXPECT_EQ(Meaning("rv32imac", {file("awx")}), "a function that can be written: f");
}

TEST(ObjectCode, WhatRunsByItselfIsRefused) {
  const std::string text = "  .text\n  .globl f\n  .type f, @function\nf: ret\n  .size f, . - f\n";
  if (Meaning("rv32imac", {text}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {text}), "0");
  EXPECT_THAT(Meaning("rv32imac", {text + "  .section .init_array, \"aw\"\n  .word f\n"}),
              HasSubstr("functions that run before or after the program's (.init_array)"));
}

TEST(ObjectCode, InlineFunctionsMustBeAlike) {
  const auto file = [](const std::string& number, const std::string& more) {
    return "  .section .text.g, \"axG\", @progbits, g, comdat\n  .weak g\n  .type g, @function\ng: li a1, " + number +
           "; ret\n  .size g, . - g\n" + more;
  };
  const std::string caller = R"(
  .section .text.f, "ax"
  .globl f
  .type f, @function
f: addi sp, sp, -16; sw ra, 12(sp); call g; sw a1, 0(a0); lw ra, 12(sp); addi sp, sp, 16; ret
  .size f, . - f
)";
  if (Meaning("rv32imac", {file("5", caller)}) == "no compiler") GTEST_SKIP();
  EXPECT_EQ(Meaning("rv32imac", {file("5", caller), file("5", "")}), "5");
  EXPECT_EQ(Meaning("rv32imac", {file("5", caller), file("6", "")}), "a call of g");
  EXPECT_EQ(Meaning("rv32imac", {file("6", ""), file("5", caller)}), "a call of g");
}

}  // namespace
}  // namespace plcxx::prove
