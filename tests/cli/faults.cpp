// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded into glissade by LD_PRELOAD, not into its children: memory that ends, a clock that is set
// while the program runs, no threads, little room. Calls that fail: inject.cpp.
//   FAULT_MEMORY=64                so many KB of memory once a file of these is flushed to the disk
//   FAULT_IN=.units                files in paths with these words
//   FAULT_CLOCK=1                  the time of day jumps by days between two calls
//   FAULT_FREE_MB=10               so much room every disk has
//   FAULT_THREADS=2                no thread can be started from the second on
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

namespace {

std::atomic<long> clock_calls = 0;

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

bool is_meant(int fd) {
  static const char* const words = getenv("FAULT_IN");
  char link[64], path[4096] = {};
  snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
  return words != nullptr && readlink(link, path, sizeof path - 1) > 0 &&
         strstr(path, words) != nullptr;
}

template <class Next>
Next next(const char* name) {
  return reinterpret_cast<Next>(dlsym(RTLD_NEXT, name));
}

time_t jump() {
  static const bool jumps = number("FAULT_CLOCK") != 0;
  constexpr time_t day_s = 86400;
  return jumps ? (7 * ++clock_calls % 11 - 5) * day_s : 0;
}

}  // namespace

extern "C" {

int fsync(int fd) {
  if (number("FAULT_MEMORY") != 0 && is_meant(fd)) end_memory(number("FAULT_MEMORY"));
  return next<int (*)(int)>("fsync")(fd);
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
