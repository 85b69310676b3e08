// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded into glissade by LD_PRELOAD, not into its children: a disk to which nothing can be written
// from some call on, memory that ends, and a clock that is set while the program runs.
//   FAULT_ERRNO=28 FAULT_FROM=17   from the 17th writing call on, each fails with that error
//   FAULT_IN=out/journal           of those in paths with these words
//   FAULT_MEMORY=1                 no more memory once a file of these is flushed to the disk
//   FAULT_COUNT=FILE               how many writing calls there were
//   FAULT_CLOCK=1                  the time of day jumps by days between two calls
//   FAULT_FREE_MB=10               so much room every disk has
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

namespace {

std::atomic<long> calls = 0, clock_calls = 0;

bool is_glissade() { return strcmp(program_invocation_short_name, "glissade") == 0; }

long number(const char* name) {
  const char* text = is_glissade() ? getenv(name) : nullptr;
  return text == nullptr ? 0 : atol(text);
}

/// No more address space than the process has now, but for its stack, and nothing large of that
/// free.
void end_memory() {
  static bool has_ended = false;
  if (has_ended) return;
  has_ended = true;
  char pages[32] = {};
  FILE* statm = fopen("/proc/self/statm", "r");
  if (statm == nullptr || fgets(pages, sizeof pages, statm) == nullptr) abort();
  fclose(statm);
  constexpr rlim_t stack_bytes = 256 << 10;
  rlimit limit = {};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = atol(pages) * sysconf(_SC_PAGESIZE) + stack_bytes;
  setrlimit(RLIMIT_AS, &limit);
  constexpr size_t large_bytes = 16 << 10;
  void* volatile taken = malloc(large_bytes);
  while (taken != nullptr) taken = malloc(large_bytes);
}

bool fails() {
  static const long from = number("FAULT_FROM");
  static const int error = static_cast<int>(number("FAULT_ERRNO"));
  const long call = ++calls;
  if (from == 0 || call < from) return false;
  errno = error;
  return true;
}

/// A full disk still has names removed.
bool removal_fails() {
  static const bool is_read_only = number("FAULT_ERRNO") == EROFS;
  return is_read_only && fails();
}

bool is_meant(const char* path) {
  static const char* const words = getenv("FAULT_IN");
  return words == nullptr || strstr(path, words) != nullptr;
}

bool is_meant(int fd) {
  struct stat status = {};
  if (fd <= STDERR_FILENO || fstat(fd, &status) != 0 || !S_ISREG(status.st_mode)) return false;
  char link[64], path[4096] = {};
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  return readlink(link, path, sizeof path - 1) > 0 && is_meant(path);
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int open_next(const char* name, const char* path, int flags, mode_t mode) {
  const bool is_device = strncmp(path, "/dev/", 5) == 0;
  if ((flags & O_ACCMODE) != O_RDONLY && !is_device && is_meant(path) && fails()) return -1;
  return next<int (*)(const char*, int, ...)>(name)(path, flags, mode);
}

time_t jump() {
  static const bool jumps = number("FAULT_CLOCK") != 0;
  constexpr time_t day_s = 86400;
  return jumps ? (7 * ++clock_calls % 11 - 5) * day_s : 0;
}

struct Count {
  ~Count() {
    const char* file = is_glissade() ? getenv("FAULT_COUNT") : nullptr;
    if (file == nullptr) return;
    const long so_far = calls;
    FILE* out = fopen(file, "w");
    if (out != nullptr) fprintf(out, "%ld\n", so_far);
    if (out != nullptr) fclose(out);
  }
} count;

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = va_arg(rest, mode_t);
  va_end(rest);
  return open_next("open", path, flags, mode);
}
ssize_t write(int fd, const void* data, size_t size) {
  if (is_meant(fd) && fails()) return -1;
  return next<ssize_t (*)(int, const void*, size_t)>("write")(fd, data, size);
}
int fsync(int fd) {
  if (!is_meant(fd)) return next<int (*)(int)>("fsync")(fd);
  if (number("FAULT_MEMORY") != 0) end_memory();
  return fails() ? -1 : next<int (*)(int)>("fsync")(fd);
}
int mkdir(const char* path, mode_t mode) noexcept {
  return is_meant(path) && fails() ? -1 : next<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}
int rename(const char* from, const char* to) noexcept {
  return is_meant(to) && fails() ? -1 : next<int (*)(const char*, const char*)>("rename")(from, to);
}
int remove(const char* path) noexcept {
  return is_meant(path) && removal_fails() ? -1 : next<int (*)(const char*)>("remove")(path);
}
int unlink(const char* path) noexcept {
  return is_meant(path) && removal_fails() ? -1 : next<int (*)(const char*)>("unlink")(path);
}
/// A disk that is read-only answers so before anything is written.
int faccessat(int folder, const char* path, int mode, int flags) noexcept {
  if ((mode & W_OK) != 0 && is_meant(path) && removal_fails()) return -1;
  using Next = int (*)(int, const char*, int, int);
  return next<Next>("faccessat")(folder, path, mode, flags);
}

int statvfs(const char* __restrict path, struct statvfs* __restrict disk) noexcept {
  using Next = int (*)(const char*, struct statvfs*);
  const int status = next<Next>("statvfs")(path, disk);
  if (const long free_mb = number("FAULT_FREE_MB"); free_mb > 0)
    disk->f_bavail = static_cast<fsblkcnt_t>(free_mb) * 1000000 / disk->f_frsize;
  return status;
}

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  const int status = next<int (*)(clockid_t, timespec*)>("clock_gettime")(clock, now);
  if (clock == CLOCK_REALTIME) now->tv_sec += jump();
  return status;
}
int gettimeofday(timeval* __restrict now, void* __restrict zone) noexcept {
  const int status = next<int (*)(timeval*, void*)>("gettimeofday")(now, zone);
  now->tv_sec += jump();
  return status;
}
time_t time(time_t* result) noexcept {
  const time_t now = next<time_t (*)(time_t*)>("time")(nullptr) + jump();
  if (result != nullptr) *result = now;
  return now;
}
}
