// SPDX-License-Identifier: GPL-3.0-or-later
// inject PROGRAM ARGUMENT...: runs a program some of whose calls of the system fail; its exit
// status, or 128 + the signal that ended it. Linux on x86-64.
//   FAULT_CALLS=pwrite,fsync       of these functions (`calls` below); without: of all
//   FAULT_IN=out/journal           of files whose paths have these words; without: none of /usr,
//                                  /etc ...; calls that name no file only without
//   FAULT_AT=17, FAULT_FROM=17     the 17th such call, or each from it on
//   FAULT_ERRNO=28                 with this error; 0: what pwrite writes is lost
//   FAULT_CHILDREN=1               of programs that it starts too (gnuplot, WeasyPrint)
//   FAULT_COUNT=FILE               how many such calls there were of each function
#include <errno.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#if defined(__x86_64__)
namespace {

enum class Names { no_file, descriptor, path };
struct Call {
  const char* function;
  long number;
  Names names = Names::no_file;
  int argument = 0;  ///< which of the call names the file
};
constexpr Call calls[] = {{"open", SYS_open, Names::path, 0},
                          {"open", SYS_openat, Names::path, 1},
                          {"read", SYS_read, Names::descriptor, 0},
                          {"read", SYS_readv, Names::descriptor, 0},
                          {"pread", SYS_pread64, Names::descriptor, 0},
                          {"list", SYS_getdents64, Names::descriptor, 0},
                          {"stat", SYS_stat, Names::path, 0},
                          {"stat", SYS_lstat, Names::path, 0},
                          {"stat", SYS_fstat, Names::descriptor, 0},
                          {"stat", SYS_newfstatat, Names::path, 1},
                          {"stat", SYS_statx, Names::path, 1},
                          {"readlink", SYS_readlink, Names::path, 0},
                          {"readlink", SYS_readlinkat, Names::path, 1},
                          {"access", SYS_access, Names::path, 0},
                          {"access", SYS_faccessat, Names::path, 1},
                          {"access", SYS_faccessat2, Names::path, 1},
                          {"space", SYS_statfs, Names::path, 0},
                          {"space", SYS_fstatfs, Names::descriptor, 0},
                          {"write", SYS_write, Names::descriptor, 0},
                          {"write", SYS_writev, Names::descriptor, 0},
                          {"pwrite", SYS_pwrite64, Names::descriptor, 0},
                          {"fsync", SYS_fsync, Names::descriptor, 0},
                          {"fsync", SYS_fdatasync, Names::descriptor, 0},
                          {"ftruncate", SYS_ftruncate, Names::descriptor, 0},
                          {"fallocate", SYS_fallocate, Names::descriptor, 0},
                          {"mmap", SYS_mmap, Names::descriptor, 4},
                          {"close", SYS_close, Names::descriptor, 0},
                          {"mkdir", SYS_mkdir, Names::path, 0},
                          {"mkdir", SYS_mkdirat, Names::path, 1},
                          {"rename", SYS_rename, Names::path, 1},
                          {"rename", SYS_renameat, Names::path, 3},
                          {"rename", SYS_renameat2, Names::path, 3},
                          {"remove", SYS_unlink, Names::path, 0},
                          {"remove", SYS_unlinkat, Names::path, 1},
                          {"remove", SYS_rmdir, Names::path, 0},
                          {"memory_file", SYS_memfd_create},
                          {"pipe", SYS_pipe2},
                          {"start", SYS_vfork},
                          {"start", SYS_clone},
                          {"start", SYS_clone3}};

using Arguments = std::array<unsigned long, 6>;

Arguments arguments_of(const user_regs_struct& r) {
  return {r.rdi, r.rsi, r.rdx, r.r10, r.r8, r.r9};
}

const char* variable(const char* name) { return getenv(name); }
long number(const char* name) { return variable(name) == nullptr ? 0 : atol(variable(name)); }

/// Whether a word stands in a list with commas.
bool is_in(const std::string& list, const std::string& word) {
  return ("," + list + ",").find("," + word + ",") != std::string::npos;
}

std::string link_of(pid_t process, const std::string& name) {
  std::array<char, 4096> path{};
  const std::string link = "/proc/" + std::to_string(process) + "/" + name;
  return readlink(link.c_str(), path.data(), path.size() - 1) < 0 ? "" : path.data();
}

/// A text of the process, up to its end or that of its page.
std::string text_at(pid_t process, unsigned long at) {
  std::string text;
  for (;;) {
    std::array<char, 4096> block{};
    const size_t size = block.size() - at % block.size();
    iovec here{block.data(), size}, there{reinterpret_cast<void*>(at), size};
    const ssize_t read = process_vm_readv(process, &here, 1, &there, 1, 0);
    if (read <= 0) return text;
    text.append(block.data(), strnlen(block.data(), static_cast<size_t>(read)));
    if (memchr(block.data(), 0, static_cast<size_t>(read)) != nullptr) return text;
    at += static_cast<unsigned long>(read);
  }
}

std::string path_of(pid_t process, const Call& call, const Arguments& arguments) {
  const auto of_descriptor = [&](unsigned long fd) {
    return static_cast<int>(fd) < 0 ? std::string() : link_of(process, "fd/" + std::to_string(fd));
  };
  const auto argument = static_cast<size_t>(call.argument);
  if (call.names == Names::descriptor)  // but of standard input, output and error
    return arguments[argument] > STDERR_FILENO ? of_descriptor(arguments[argument]) : "";
  const std::string path = text_at(process, arguments[argument]);
  if (path.starts_with('/')) return path;
  const bool is_in_folder = argument > 0 && static_cast<int>(arguments[argument - 1]) >= 0;
  const std::string folder =
      is_in_folder ? of_descriptor(arguments[argument - 1]) : link_of(process, "cwd");
  return path.empty() ? folder : folder + "/" + path;
}

bool is_meant(const std::string& path) {
  static const char* const words = variable("FAULT_IN");
  if (words != nullptr) return path.find(words) != std::string::npos;
  if (!path.starts_with('/')) return false;  // a pipe
  for (const char* of_system :
       {"/usr/", "/lib", "/etc/", "/proc", "/sys", "/dev/", "/run/", "/var/", "/memfd:", "/root/"})
    if (path.starts_with(of_system)) return false;
  return true;
}

/// Reading leaves nothing behind that a failed close could lose.
bool is_open_for_writing(pid_t process, unsigned long fd) {
  const std::string info = "/proc/" + std::to_string(process) + "/fdinfo/" + std::to_string(fd);
  FILE* file = fopen(info.c_str(), "r");
  unsigned flags = 0;
  if (file == nullptr) return false;
  const bool is_read = fscanf(file, "pos: %*s flags: %o", &flags) == 1;
  fclose(file);
  return is_read && (flags & O_ACCMODE) != O_RDONLY;
}

bool starts_thread(pid_t process, const Call& call, const Arguments& arguments) {
  unsigned long flags = arguments[0];
  if (call.number == SYS_clone3) {
    iovec here{&flags, sizeof flags}, there{reinterpret_cast<void*>(arguments[0]), sizeof flags};
    if (process_vm_readv(process, &here, 1, &there, 1, 0) < 0) return true;
  }
  return call.number != SYS_vfork && (flags & CLONE_THREAD) != 0;
}

std::map<std::string, long> counts;

/// The error of the call at which the process stands; -1: none.
int error_of(pid_t process, const Call& call, const Arguments& arguments) {
  static const char* const named = variable("FAULT_CALLS");
  static const long from = number("FAULT_FROM"), only = number("FAULT_AT");
  static long count = 0;
  if (named != nullptr && !is_in(named, call.function)) return -1;
  if (call.names == Names::no_file
          ? variable("FAULT_IN") != nullptr ||
                (call.function == std::string("start") && starts_thread(process, call, arguments))
          : !is_meant(path_of(process, call, arguments)))
    return -1;
  if (call.number == SYS_close && !is_open_for_writing(process, arguments[0])) return -1;
  ++counts[call.function];
  ++count;
  const bool fails = (from > 0 && count >= from) || count == only;
  return fails ? static_cast<int>(number("FAULT_ERRNO")) : -1;
}

const Call* call_of(unsigned long number) {
  const auto* found = std::find_if(std::begin(calls), std::end(calls), [&](const Call& call) {
    return static_cast<unsigned long>(call.number) == number;
  });
  return found == std::end(calls) ? nullptr : found;
}

[[noreturn]] void become(char** words) {
  std::vector<sock_filter> filter{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const Call& call : calls) {
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<__u32>(call.number), 0, 1));
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRACE));
  }
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  setenv("LSAN_OPTIONS", "detect_leaks=0", 1);  // it traces too
  ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
  raise(SIGSTOP);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) _exit(126);
  execvp(words[0], words);
  _exit(127);
}

class Tracer {
 public:
  explicit Tracer(pid_t child) : child_(child) {}

  int run() {
    int status = 0;
    waitpid(child_, &status, 0);
    ptrace(PTRACE_SETOPTIONS, child_, nullptr,
           PTRACE_O_TRACESECCOMP | PTRACE_O_TRACECLONE | PTRACE_O_TRACEFORK | PTRACE_O_TRACEVFORK |
               PTRACE_O_TRACEEXEC | PTRACE_O_EXITKILL | PTRACE_O_TRACESYSGOOD);
    go_on(child_);
    for (;;) {
      const pid_t process = waitpid(-1, &status, __WALL);
      if (process < 0) return 126;
      if (process == child_ && WIFEXITED(status)) return WEXITSTATUS(status);
      if (process == child_ && WIFSIGNALED(status)) return 128 + WTERMSIG(status);
      if (WIFSTOPPED(status)) stopped(process, status);
    }
  }

 private:
  static void go_on(pid_t process, int signal = 0) {
    ptrace(PTRACE_CONT, process, nullptr, signal);
  }
  void stopped(pid_t process, int status) {
    const int event = status >> 16, signal = WSTOPSIG(status);
    if (event == PTRACE_EVENT_SECCOMP) return called(process);
    if (signal == (SIGTRAP | 0x80)) return returned(process);
    if (event == PTRACE_EVENT_EXEC) {
      if (has_begun_) others_.insert(process);
      has_begun_ = true;
    }
    go_on(process, event != 0 || signal == SIGSTOP || signal == SIGTRAP ? 0 : signal);
  }
  void called(pid_t process) {
    user_regs_struct registers{};
    ptrace(PTRACE_GETREGS, process, nullptr, &registers);
    const Call* call = call_of(registers.orig_rax);
    static const bool with_children = number("FAULT_CHILDREN") != 0;
    if (call == nullptr || !has_begun_ || (others_.contains(process) && !with_children))
      return go_on(process);
    const int error = error_of(process, *call, arguments_of(registers));
    if (error < 0) return go_on(process);
    if (call->number == SYS_close) {  // the file is closed all the same
      errors_[process] = error;
      ptrace(PTRACE_SYSCALL, process, nullptr, nullptr);
      return;
    }
    const unsigned long size = registers.rdx;
    registers.orig_rax = static_cast<unsigned long>(-1);  // it is not made
    registers.rax = error == 0 ? size : static_cast<unsigned long>(-error);
    ptrace(PTRACE_SETREGS, process, nullptr, &registers);
    go_on(process);
  }
  /// From a call that was made and fails.
  void returned(pid_t process) {
    user_regs_struct registers{};
    ptrace(PTRACE_GETREGS, process, nullptr, &registers);
    if (registers.rax == static_cast<unsigned long>(-ENOSYS))  // its beginning
      return static_cast<void>(ptrace(PTRACE_SYSCALL, process, nullptr, nullptr));
    registers.rax = static_cast<unsigned long>(-errors_[process]);
    ptrace(PTRACE_SETREGS, process, nullptr, &registers);
    go_on(process);
  }

  pid_t child_;
  bool has_begun_ = false;
  std::set<pid_t> others_;  ///< programs that it started
  std::map<pid_t, int> errors_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 126;
  signal(SIGINT, SIG_IGN);  // of the terminal: the program's own
  const pid_t child = fork();
  if (child < 0) return 126;
  if (child == 0) {
    signal(SIGINT, SIG_DFL);
    become(argv + 1);
  }
  const int status = Tracer(child).run();
  if (const char* file = variable("FAULT_COUNT"); file != nullptr) {
    FILE* out = fopen(file, "w");
    if (out == nullptr) return 126;
    for (const auto& [function, count] : counts) fprintf(out, "%s %ld\n", function.c_str(), count);
    fclose(out);
  }
  return status;
}
#else
int main() { return 126; }
#endif
