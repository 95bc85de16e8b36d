/* A plugin of QEMU's: counts the instructions that a program executes, and writes their number into a file when the
   program ends. QEMU loads it as -plugin count.so,out=FILE.

   Debian has no header of that interface, so what is used of its version 1, which QEMU 7.2 has, is declared here. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

struct qemu_plugin_tb; /* a block: instructions of the program that QEMU translates together, and executes in a row */
enum qemu_plugin_op { QEMU_PLUGIN_INLINE_ADD_U64 };

size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
void qemu_plugin_register_vcpu_tb_trans_cb(uint64_t plugin,
                                           void (*call)(uint64_t plugin, struct qemu_plugin_tb *block));
void qemu_plugin_register_vcpu_tb_exec_inline(struct qemu_plugin_tb *block, enum qemu_plugin_op op, void *number,
                                              uint64_t operand);
void qemu_plugin_register_atexit_cb(uint64_t plugin, void (*call)(uint64_t plugin, void *data), void *data);

int qemu_plugin_version = 1;

static uint64_t executed;

/* QEMU's addition to the code of a block is not atomic: the number is that of a program with one thread. */
static void count_block(uint64_t plugin, struct qemu_plugin_tb *block) {
  (void)plugin;
  qemu_plugin_register_vcpu_tb_exec_inline(block, QEMU_PLUGIN_INLINE_ADD_U64, &executed, qemu_plugin_tb_n_insns(block));
}

/* A file that cannot be written stays away or empty, which tools/measure neon notices. */
static void write_number(uint64_t plugin, void *path) {
  FILE *const file = fopen(path, "w");
  (void)plugin;
  if (!file) return;
  fprintf(file, "%" PRIu64 "\n", executed);
  fclose(file);
}

int qemu_plugin_install(uint64_t plugin, const void *qemu, int count, char **arguments) {
  static const char name[] = "out=";
  (void)qemu;
  if (count != 1 || strncmp(arguments[0], name, strlen(name)) != 0) {
    fputs("count.so: QEMU is to be called with -plugin count.so,out=FILE\n", stderr);
    return 1;
  }
  qemu_plugin_register_vcpu_tb_trans_cb(plugin, count_block);
  qemu_plugin_register_atexit_cb(plugin, write_number, arguments[0] + strlen(name));
  return 0;
}
