// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded into glissade by LD_PRELOAD, not into its children: allocations that fail once main has
// begun, those of operator new and of the libraries alike.
//   FAULT_FROM=17      from the 17th on
//   FAULT_AT=17        the 17th only
//   FAULT_COUNT=FILE   how many there were
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <atomic>

extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* old, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

std::atomic<long> calls = 0, from = 0, only = 0;
std::atomic<bool> is_in_main = false;

bool fails() {
  if (!is_in_main) return false;
  const long call = ++calls;
  if ((from == 0 || call < from) && (only == 0 || call != only)) return false;
  errno = ENOMEM;
  return true;
}

int (*main_of_program)(int, char**, char**) = nullptr;

int counted_main(int argc, char** argv, char** variables) {
  const auto number = [](const char* name) {
    const char* text = getenv(name);
    return text == nullptr ? 0 : atol(text);
  };
  from = number("FAULT_FROM");
  only = number("FAULT_AT");
  is_in_main = strcmp(program_invocation_short_name, "glissade") == 0;
  const int status = main_of_program(argc, argv, variables);
  is_in_main = false;
  const char* file = getenv("FAULT_COUNT");
  FILE* out = file == nullptr ? nullptr : fopen(file, "w");
  if (out != nullptr) fprintf(out, "malloc %ld\n", calls.load());
  if (out != nullptr) fclose(out);
  return status;
}

}  // namespace

extern "C" {

void* malloc(size_t size) { return fails() ? nullptr : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return fails() ? nullptr : __libc_calloc(count, size); }
void* realloc(void* old, size_t size) { return fails() ? nullptr : __libc_realloc(old, size); }
void* aligned_alloc(size_t alignment, size_t size) {
  return fails() ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, size_t alignment, size_t size) {
  *memory = fails() ? nullptr : __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(),
                      void (*fini)(), void (*rtld_fini)(), void* stack_end) {
  using Next =
      int (*)(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
  main_of_program = main;
  const auto next = reinterpret_cast<Next>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return next(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}
}
