// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded into glissade by LD_PRELOAD, not into its children: a disk to which some calls of the
// system fail, memory that ends, and a clock that is set while the program runs.
//   FAULT_ERRNO=28 FAULT_FROM=17   from the 17th call on that writes, each fails with that error
//   FAULT_ERRNO=5 FAULT_AT=17      the 17th only; FAULT_ERRNO=0: what pwrite writes is lost
//   FAULT_CALLS=pwrite,fsync       of these functions only, which may be read and pread too
//   FAULT_IN=out/journal           of those in paths with these words
//   FAULT_COUNT=FILE               how many such calls there were of each function
//   FAULT_MEMORY=64                so many KB of memory once a file of these is flushed to the disk
//   FAULT_CLOCK=1                  the time of day jumps by days between two calls
//   FAULT_FREE_MB=10               so much room every disk has
//   FAULT_THREADS=2                no thread can be started from the second on
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

namespace {

struct Function {
  const char* name;
  bool writes;  ///< fails where no function is named
  std::atomic<long> calls = 0;
};
Function functions[] = {{"open", true},      {"write", true},     {"pwrite", true}, {"fsync", true},
                        {"ftruncate", true}, {"fallocate", true}, {"close", true},  {"mkdir", true},
                        {"rename", true},    {"remove", true},    {"access", true}, {"read", false},
                        {"pread", false},    {"mmap", true}};
std::atomic<long> calls = 0, clock_calls = 0;

bool is_glissade() { return strcmp(program_invocation_short_name, "glissade") == 0; }

long number(const char* name) {
  const char* text = is_glissade() ? getenv(name) : nullptr;
  return text == nullptr ? 0 : atol(text);
}

/// No more address space than the process has now, but for its stack, and nothing large of that
/// free.
void end_memory(long left_kb) {
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
  limit.rlim_cur = atol(pages) * sysconf(_SC_PAGESIZE) + stack_bytes + (left_kb << 10);
  setrlimit(RLIMIT_AS, &limit);
  void* const left = malloc(left_kb << 10);
  constexpr size_t large_bytes = 16 << 10;
  void* volatile taken = malloc(large_bytes);
  while (taken != nullptr) taken = malloc(large_bytes);
  free(left);
}

/// Whether a word stands in a list with commas.
bool is_in(const char* list, const char* word) {
  const size_t size = strlen(word);
  for (const char* at = list; (at = strstr(at, word)) != nullptr; at += size) {
    if ((at == list || at[-1] == ',') && (at[size] == '\0' || at[size] == ',')) return true;
  }
  return false;
}

/// Counts a call of `function`, and whether it is one that fails.
bool fails(const char* function) {
  static const char* const named = getenv("FAULT_CALLS");
  static const long from = number("FAULT_FROM"), only = number("FAULT_AT");
  static const int error = static_cast<int>(number("FAULT_ERRNO"));
  Function* f = functions;
  while (strcmp(f->name, function) != 0) ++f;
  if (named != nullptr ? !is_in(named, function) : !f->writes) return false;
  ++f->calls;
  const long call = ++calls;
  if ((from == 0 || call < from) && (only == 0 || call != only)) return false;
  errno = error;
  return true;
}

/// A full disk still has names removed.
bool removal_fails(const char* function) {
  static const bool is_read_only = number("FAULT_ERRNO") == EROFS;
  return is_read_only && fails(function);
}

bool is_meant(const char* path) {
  static const char* const words = getenv("FAULT_IN");
  return words == nullptr || strstr(path, words) != nullptr;
}

/// A regular file or folder on a disk.
bool is_meant(int fd) {
  struct stat status = {};
  if (fd <= STDERR_FILENO || fstat(fd, &status) != 0) return false;
  if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) return false;
  char link[64], path[4096] = {};
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  return readlink(link, path, sizeof path - 1) > 0 && strncmp(path, "/memfd:", 7) != 0 &&
         strncmp(path, "/dev/", 5) != 0 && is_meant(path);
}

bool writes(int fd) { return (fcntl(fd, F_GETFL) & O_ACCMODE) != O_RDONLY; }

template <class Next>
Next next(const char* name) {
  return reinterpret_cast<Next>(dlsym(RTLD_NEXT, name));
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
    FILE* out = fopen(file, "w");
    for (const Function& f : functions) {
      if (out != nullptr && f.calls > 0) fprintf(out, "%s %ld\n", f.name, f.calls.load());
    }
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
  const bool is_device = strncmp(path, "/dev/", 5) == 0;
  if ((flags & O_ACCMODE) != O_RDONLY && !is_device && is_meant(path) && fails("open")) return -1;
  return next<int (*)(const char*, int, ...)>("open")(path, flags, mode);
}
ssize_t write(int fd, const void* data, size_t size) {
  if (is_meant(fd) && fails("write")) return -1;
  return next<ssize_t (*)(int, const void*, size_t)>("write")(fd, data, size);
}
ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
  if (is_meant(fd) && fails("pwrite")) return errno == 0 ? static_cast<ssize_t>(size) : -1;
  return next<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite")(fd, data, size, at);
}
ssize_t pwrite64(int fd, const void* data, size_t size, off64_t at) {
  return pwrite(fd, data, size, at);
}
ssize_t read(int fd, void* data, size_t size) {
  if (is_meant(fd) && fails("read")) return -1;
  return next<ssize_t (*)(int, void*, size_t)>("read")(fd, data, size);
}
ssize_t pread(int fd, void* data, size_t size, off_t at) {
  if (is_meant(fd) && fails("pread")) return -1;
  return next<ssize_t (*)(int, void*, size_t, off_t)>("pread")(fd, data, size, at);
}
ssize_t pread64(int fd, void* data, size_t size, off64_t at) { return pread(fd, data, size, at); }
int fsync(int fd) {
  if (!is_meant(fd)) return next<int (*)(int)>("fsync")(fd);
  if (number("FAULT_MEMORY") != 0) end_memory(number("FAULT_MEMORY"));
  return fails("fsync") ? -1 : next<int (*)(int)>("fsync")(fd);
}
int ftruncate(int fd, off_t size) noexcept {
  return is_meant(fd) && fails("ftruncate") ? -1 : next<int (*)(int, off_t)>("ftruncate")(fd, size);
}
int posix_fallocate(int fd, off_t at, off_t size) {
  if (is_meant(fd) && fails("fallocate")) return errno;
  return next<int (*)(int, off_t, off_t)>("posix_fallocate")(fd, at, size);
}
int close(int fd) {
  const bool failed = is_meant(fd) && writes(fd) && fails("close");
  const int error = errno, status = next<int (*)(int)>("close")(fd);
  if (!failed) return status;
  errno = error;
  return -1;
}
void* mmap(void* at, size_t size, int protection, int flags, int fd, off_t offset) noexcept {
  using Next = void* (*)(void*, size_t, int, int, int, off_t);
  if (is_meant(fd) && writes(fd) && fails("mmap")) return MAP_FAILED;
  return next<Next>("mmap")(at, size, protection, flags, fd, offset);
}
int mkdir(const char* path, mode_t mode) noexcept {
  if (is_meant(path) && fails("mkdir")) return -1;
  return next<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}
int rename(const char* from, const char* to) noexcept {
  if (is_meant(to) && fails("rename")) return -1;
  return next<int (*)(const char*, const char*)>("rename")(from, to);
}
int remove(const char* path) noexcept {
  if (is_meant(path) && removal_fails("remove")) return -1;
  return next<int (*)(const char*)>("remove")(path);
}
int unlink(const char* path) noexcept {
  if (is_meant(path) && removal_fails("remove")) return -1;
  return next<int (*)(const char*)>("unlink")(path);
}
/// A disk that is read-only answers so before anything is written.
int faccessat(int folder, const char* path, int mode, int flags) noexcept {
  if ((mode & W_OK) != 0 && is_meant(path) && removal_fails("access")) return -1;
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

int pthread_create(pthread_t* thread, const pthread_attr_t* how, void* (*start)(void*),
                   void* with) noexcept {
  static const long from = number("FAULT_THREADS");
  static std::atomic<long> threads = 0;
  if (from > 0 && ++threads >= from) return EAGAIN;
  using Next = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  return next<Next>("pthread_create")(thread, how, start, with);
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
