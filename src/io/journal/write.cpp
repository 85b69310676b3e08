// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/core/output_file.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/study/run/exchange.hpp"
#include "journal/frame.hpp"
#include "journal/names.hpp"

namespace glissade {

namespace fs = std::filesystem;

namespace {

/// By a name that no writer had before, which is returned.
fs::path open_new(const JournalNames& names, int rank, std::optional<OutputFile>& file) {
  int session = 1, fd = -1;
  fs::path path;
  do {
    path = names.units(rank, session++);
    fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  } while (fd < 0 && errno == EEXIST);
  file.emplace(fd, path);
  return path;
}

}  // namespace

/// The file, and a thread that flushes it to the disk: a unit that takes long must not keep the
/// one before it waiting. Where the system starts no thread, the next unit flushes it.
struct JournalWriter::State {
  JournalNames names;
  int rank;
  std::string head;
  std::optional<OutputFile> file;
  fs::path path;                      ///< of the file
  std::optional<FrameReader> reader;  ///< of what was appended when it was opened
  std::uint64_t read_bytes = 0;
  std::mutex mutex;  // of the three below
  std::condition_variable_any wake;
  bool dirty = false;
  std::exception_ptr failure;  ///< of the thread
  std::chrono::steady_clock::time_point flushed = std::chrono::steady_clock::now();
  std::jthread thread;  // last: it ends before what it uses

  void open() {
    path = open_new(names, rank, file);
    file->write(head);
    sync_folder(names.folder);
    try {
      thread = std::jthread([this](const std::stop_token& stop) { flush_now_and_then(stop); });
    } catch (const std::system_error&) {  // a limit on processes or memory
    }
  }

  void flush_without_thread() {
    const auto now = std::chrono::steady_clock::now();
    if (thread.joinable() || now - flushed < std::chrono::seconds(seconds_to_disk)) return;
    file->sync();
    flushed = now;
  }

  void flush_now_and_then(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      wake.wait_for(lock, stop, std::chrono::seconds(seconds_to_disk), [] { return false; });
      if (!dirty) continue;
      dirty = false;
      lock.unlock();
      std::exception_ptr error;
      try {
        file->sync();
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      if (error) failure = error;
    }
  }

  void throw_failure() {
    const std::lock_guard lock(mutex);
    if (failure) std::rethrow_exception(failure);
  }
};

JournalWriter::JournalWriter(const fs::path& run_folder, int rank, const RunIdentity& run)
    : state_(new State{.names = JournalNames(run_folder), .rank = rank, .head = units_head(run)}) {}

JournalWriter::JournalWriter(JournalWriter&&) noexcept = default;
JournalWriter::~JournalWriter() = default;

void JournalWriter::append(const UnitResult& unit) {
  state_->throw_failure();
  if (!state_->file) state_->open();
  state_->file->write(framed(pack(unit)));
  state_->flush_without_thread();
  const std::lock_guard lock(state_->mutex);
  state_->dirty = true;
}

std::vector<char> JournalWriter::read_next() {
  State& s = *state_;
  if (!s.reader || s.reader->bytes_left() == 0) {
    s.read_bytes = std::max(s.read_bytes, std::uint64_t{s.head.size()});
    s.reader.emplace(s.path, std::numeric_limits<std::uint64_t>::max(), s.read_bytes);
  }
  std::optional<std::vector<char>> unit = s.reader->next();
  if (!unit) {
    throw InputError({s.path.string(), "does not hold any more what was written to it",
                      "check the disk, and go on with --resume", ""});
  }
  s.read_bytes += frame_head_bytes + unit->size();
  return std::move(*unit);
}

void JournalWriter::sync() {
  if (!state_->file) return;
  state_->thread = {};  // ends: Linux reports a failed write once, which may be to its flush
  state_->throw_failure();
  state_->file->sync();
}

void copy_journals(const fs::path& from, const fs::path& to) {
  for (const fs::path& units : JournalNames(from).all_units()) {
    const InputFile in(units);
    std::optional<OutputFile> out;
    open_new(JournalNames(to), 0, out);
    std::string block(1u << 20, '\0');
    while (const std::size_t count = in.read(block))
      out->write(std::string_view(block).substr(0, count));
    out->sync();
    out->close();
  }
}

}  // namespace glissade
