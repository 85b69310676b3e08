// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace glissade {

/// A group of processes: one, or the ranks of an mpirun. A value type; copies share the group.
class Communicator {
 public:
  /// One process, no MPI.
  static Communicator serial();
  int rank() const;
  int size() const;
  bool is_root() const { return rank() == 0; }

  /// Sends the bytes of one rank to all. Collective.
  void broadcast(std::vector<char>& bytes, int from = 0) const;
  /// The lowest rank on which `holds`; size() where it holds on none. The ranks wait for the last
  /// of them without work for their processors. Collective.
  int first_where(bool holds) const;
  /// The values of rank 0 on all ranks, stored once on each machine (MPI-3 shared memory; on each
  /// rank where the machine has too little of it), until the session ends. Collective.
  template <class T>
  requires std::is_trivially_copyable_v<T> std::span<const T> on_each_machine(std::vector<T> values)
  const {
    if (size() == 1) {
      const auto kept = std::make_shared<std::vector<T>>(std::move(values));
      keep(kept);
      return *kept;
    }
    const std::span<const std::byte> bytes =
        bytes_on_each_machine(std::as_bytes(std::span<const T>(values)));
    return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
  }
  /// Collects the bytes of all ranks on rank 0, by rank; empty on the others.
  std::vector<std::vector<char>> gather(const std::vector<char>& bytes) const;
  /// Rank 0 receives the messages of all other ranks, by rank, one at a time. A sender makes each,
  /// `count` in all, when it is due; those of rank 0 are not made. Where `next` or `receive`
  /// throws, every rank throws the same, as `together` does. Collective.
  void collect(std::uint64_t count, const std::function<std::vector<char>()>& next,
               const std::function<void(std::vector<char>)>& receive) const;
  /// Ends every rank at once: for an error of one of several ranks that is not of a step of them
  /// all.
  [[noreturn]] void abort(int exit_status) const;

  /// Self-scheduling: gives 0, 1, 2, ... once each over all ranks. Construction and destruction are
  /// collective.
  class Ticket {
   public:
    struct State;
    explicit Ticket(std::unique_ptr<State> state);
    ~Ticket();
    Ticket(Ticket&&) noexcept;
    std::uint64_t next();
    /// No rank gets a number below `count` any more, but for one that it has fetched ahead. Not
    /// collective.
    void close(std::uint64_t count);

   private:
    std::unique_ptr<State> state_;
  };
  Ticket make_ticket() const;

  struct State;

 private:
  explicit Communicator(std::shared_ptr<State> state);
  /// Until the session ends.
  void keep(std::shared_ptr<const void> values) const;
  std::span<const std::byte> bytes_on_each_machine(std::span<const std::byte> bytes) const;
  std::shared_ptr<State> state_;
  friend class MpiSession;
  friend class LentProcessors;
};

/// Calls work(item) for every item below `count`, each on one rank, the next free one. Every rank
/// calls `stop` before it takes an item: where it is true it takes none, and the others none but
/// one that they have fetched ahead. The same where `work` throws: then every rank throws, as
/// `together` does, once all have ended what they had begun. Collective.
void self_schedule(
    const Communicator& world, std::uint64_t count, const std::function<void(std::uint64_t)>& work,
    const std::function<bool()>& stop = [] { return false; });

/// Parts from messages of their numbers and values, each `put(number).put(values)`.
std::vector<std::vector<double>> numbered_parts(std::size_t count,
                                                const std::vector<std::vector<char>>& messages);

/// What `part` gives for every number below `count`, on every rank; each computed by one.
/// Collective.
std::vector<std::vector<double>> share_parts(
    const Communicator& world, std::size_t count,
    const std::function<std::vector<double>(std::size_t)>& part);

/// While it lives, threads that rank 0 starts run on the processors of all ranks of its machine,
/// which are to wait for it. Construction is collective.
class LentProcessors {
 public:
  explicit LentProcessors(const Communicator& world);
  ~LentProcessors();
  LentProcessors(const LentProcessors&) = delete;
  LentProcessors& operator=(const LentProcessors&) = delete;
  /// On root: one for each rank of its machine, but no more than it has processors.
  int threads() const { return threads_; }

 private:
  struct Processors;
  int threads_ = 1;
  std::unique_ptr<Processors> own_;  ///< of rank 0, where it has borrowed others
};

/// Starts MPI for the lifetime of the object if the program runs under mpirun (or srun); otherwise
/// does nothing.
class MpiSession {
 public:
  MpiSession(int& argc, char**& argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
  Communicator world() const;

 private:
  std::shared_ptr<Communicator::State> world_;
};

}  // namespace glissade
