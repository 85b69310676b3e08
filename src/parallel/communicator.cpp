// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/parallel/communicator.hpp"

#define OMPI_SKIP_MPICXX
#include <mpi.h>
#include <sched.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "glissade/core/bytes.hpp"
#include "glissade/core/error.hpp"

namespace glissade {

/// The group: MPI_COMM_NULL if the program runs alone and MPI was not started.
struct Communicator::State {
  MPI_Comm group = MPI_COMM_NULL;
  int rank = 0, size = 1;
  std::function<void()> before_abort;
  std::vector<MPI_Win> shared_memory;             ///< of `on_each_machine`
  std::vector<std::shared_ptr<const void>> kept;  ///< where that is not possible
};

Communicator::Communicator(std::shared_ptr<State> state) : state_(std::move(state)) {}

Communicator Communicator::serial() { return Communicator(std::make_shared<State>()); }
int Communicator::rank() const { return state_->rank; }
int Communicator::size() const { return state_->size; }

namespace {

// MPI counts are ints: messages are sent in pieces well below 2^31 bytes.
constexpr std::size_t piece_bytes = std::size_t{1} << 30;

/// A rank that waits for rank 0 may wait for minutes: it leaves its core to others.
void wait_quietly(MPI_Request request) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  for (int done = 0;;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done != 0) return;
    if (Clock::now() - begin > std::chrono::milliseconds(20))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

template <class Transfer>
void in_pieces(std::span<char> bytes, Transfer transfer) {
  for (std::size_t at = 0; at < bytes.size(); at += piece_bytes) {
    transfer(bytes.data() + at, static_cast<int>(std::min(piece_bytes, bytes.size() - at)));
  }
}

}  // namespace

void Communicator::broadcast(std::vector<char>& bytes) const {
  if (size() == 1) return;
  std::uint64_t count = bytes.size();
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(&count, 1, MPI_UINT64_T, 0, state_->group, &request);
  wait_quietly(request);
  bytes.resize(count);
  in_pieces(bytes, [&](char* data, int n) { MPI_Bcast(data, n, MPI_CHAR, 0, state_->group); });
}

namespace {

/// The ranks of one machine, and the first ranks of all machines (none on other ranks).
struct Machines {
  MPI_Comm mine = MPI_COMM_NULL, first_ranks = MPI_COMM_NULL;
  explicit Machines(MPI_Comm group) {
    int rank = 0;
    MPI_Comm_split_type(group, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &mine);
    MPI_Comm_rank(mine, &rank);
    MPI_Comm_split(group, rank == 0 ? 0 : MPI_UNDEFINED, 0, &first_ranks);
  }
  ~Machines() {
    MPI_Comm_free(&mine);
    if (is_first()) MPI_Comm_free(&first_ranks);
  }
  Machines(const Machines&) = delete;
  Machines& operator=(const Machines&) = delete;
  bool is_first() const { return first_ranks != MPI_COMM_NULL; }
};

/// On every machine. Open MPI makes shared memory in /dev/shm, and a rank that cannot is waited for
/// by the others for ever; containers have 64 MB.
bool shared_memory_has_room_for(double bytes, MPI_Comm group) {
  struct statvfs space {};
  int has_room =
      statvfs("/dev/shm", &space) != 0 ||
      static_cast<double>(space.f_bavail) * static_cast<double>(space.f_frsize) > bytes + 16e6;
  MPI_Allreduce(MPI_IN_PLACE, &has_room, 1, MPI_INT, MPI_LAND, group);
  return has_room != 0;
}

/// A window of the machine's first rank, which all its ranks can read.
std::span<std::byte> allocate_on_machine(std::size_t count, const Machines& machines,
                                         MPI_Win* window) {
  std::byte* data = nullptr;
  MPI_Aint bytes = machines.is_first() ? static_cast<MPI_Aint>(count) : 0;
  int unit = 1;
  MPI_Win_allocate_shared(bytes, unit, MPI_INFO_NULL, machines.mine, &data, window);
  MPI_Win_shared_query(*window, 0, &bytes, &unit, &data);
  return {data, count};
}

}  // namespace

void Communicator::keep(std::shared_ptr<const void> values) const {
  state_->kept.push_back(std::move(values));
}

std::span<const std::byte> Communicator::bytes_on_each_machine(
    std::span<const std::byte> bytes) const {
  std::uint64_t count = bytes.size();
  MPI_Bcast(&count, 1, MPI_UINT64_T, 0, state_->group);
  if (count == 0) return {};
  const auto broadcast_into = [&](std::span<std::byte> copy, MPI_Comm group) {
    if (is_root()) std::ranges::copy(bytes, copy.begin());
    in_pieces({reinterpret_cast<char*>(copy.data()), copy.size()},
              [&](char* data, int n) { MPI_Bcast(data, n, MPI_CHAR, 0, group); });
  };
  if (!shared_memory_has_room_for(static_cast<double>(count), state_->group)) {
    const auto own = std::make_shared<std::vector<std::byte>>(count);
    keep(own);
    broadcast_into(*own, state_->group);
    return *own;
  }
  const Machines machines(state_->group);
  MPI_Win& window = state_->shared_memory.emplace_back(MPI_WIN_NULL);
  const std::span<std::byte> copy = allocate_on_machine(count, machines, &window);
  MPI_Win_fence(0, window);
  if (machines.is_first()) broadcast_into(copy, machines.first_ranks);
  MPI_Win_fence(0, window);
  return copy;
}

namespace {

void send_to_root(MPI_Comm group, std::vector<char> bytes) {
  const std::uint64_t count = bytes.size();
  MPI_Send(&count, 1, MPI_UINT64_T, 0, 0, group);
  in_pieces(bytes, [&](char* data, int n) { MPI_Send(data, n, MPI_CHAR, 0, 1, group); });
}

std::vector<char> receive_from(MPI_Comm group, int rank) {
  std::uint64_t count = 0;
  MPI_Recv(&count, 1, MPI_UINT64_T, rank, 0, group, MPI_STATUS_IGNORE);
  std::vector<char> bytes(count);
  in_pieces(bytes, [&](char* data, int n) {
    MPI_Recv(data, n, MPI_CHAR, rank, 1, group, MPI_STATUS_IGNORE);
  });
  return bytes;
}

}  // namespace

std::vector<std::vector<char>> Communicator::gather(const std::vector<char>& bytes) const {
  std::vector<std::vector<char>> all;
  if (is_root()) all.push_back(bytes);
  collect(
      1, [&] { return bytes; },
      [&](std::vector<char> message) { all.push_back(std::move(message)); });
  return all;
}

void Communicator::collect(std::uint64_t count, const std::function<std::vector<char>()>& next,
                           const std::function<void(std::vector<char>)>& receive) const {
  if (!is_root()) {
    MPI_Send(&count, 1, MPI_UINT64_T, 0, 0, state_->group);
    for (; count > 0; --count) send_to_root(state_->group, next());
    return;
  }
  for (int rank = 1; rank < size(); ++rank) {
    MPI_Recv(&count, 1, MPI_UINT64_T, rank, 0, state_->group, MPI_STATUS_IGNORE);
    for (; count > 0; --count) receive(receive_from(state_->group, rank));
  }
}

void Communicator::before_abort(std::function<void()> clean_up) const {
  state_->before_abort = std::move(clean_up);
}

void Communicator::abort(int exit_status) const {
  if (state_->before_abort) state_->before_abort();
  if (size() > 1) MPI_Abort(state_->group, exit_status);
  std::exit(exit_status);
}

/// A counter on rank 0 that all ranks fetch and increment (MPI-3 one-sided), or a plain number. The
/// next number is fetched while the last one's work is done: on a network without remote atomics
/// rank 0 answers only between two units of its own.
struct Communicator::Ticket::State {
  MPI_Comm group = MPI_COMM_NULL;
  MPI_Win window = MPI_WIN_NULL;
  std::uint64_t* counter = nullptr;
  std::uint64_t alone = 0;
  std::uint64_t fetched = 0;  ///< when the window is flushed

  void fetch() {
    static constexpr std::uint64_t one = 1;
    MPI_Fetch_and_op(&one, &fetched, MPI_UINT64_T, 0, 0, MPI_SUM, window);
  }
};

Communicator::Ticket::Ticket(std::unique_ptr<State> state) : state_(std::move(state)) {}
Communicator::Ticket::Ticket(Ticket&&) noexcept = default;

Communicator::Ticket Communicator::make_ticket() const {
  auto state = std::make_unique<Ticket::State>();
  if (size() > 1) {
    state->group = state_->group;
    const MPI_Aint bytes = is_root() ? sizeof(std::uint64_t) : 0;
    MPI_Win_allocate(bytes, sizeof(std::uint64_t), MPI_INFO_NULL, state->group, &state->counter,
                     &state->window);
    MPI_Win_lock_all(0, state->window);
    if (is_root()) *state->counter = 0;
    MPI_Win_sync(state->window);
    MPI_Barrier(state->group);
    state->fetch();
  }
  return Ticket(std::move(state));
}

std::uint64_t Communicator::Ticket::next() {
  if (state_->window == MPI_WIN_NULL) return state_->alone++;
  MPI_Win_flush(0, state_->window);
  const std::uint64_t item = state_->fetched;
  state_->fetch();
  return item;
}

void Communicator::Ticket::close(std::uint64_t count) {
  if (state_->window == MPI_WIN_NULL) {
    state_->alone += count;
  } else {
    MPI_Accumulate(&count, 1, MPI_UINT64_T, 0, 0, 1, MPI_UINT64_T, MPI_SUM, state_->window);
    MPI_Win_flush(0, state_->window);
  }
}

Communicator::Ticket::~Ticket() {
  if (!state_ || state_->window == MPI_WIN_NULL) return;
  MPI_Win_unlock_all(state_->window);
  MPI_Win_free(&state_->window);
}

namespace {

/// Stack unwinding would wait until the other ranks have finished all their work.
[[noreturn]] void end_all(const Communicator& world, const char* what, int exit_status) {
  std::fprintf(stderr, "glissade: rank %d: %s\n", world.rank(), what);
  world.abort(exit_status);
}

}  // namespace

void self_schedule(const Communicator& world, std::uint64_t count,
                   const std::function<void(std::uint64_t)>& work,
                   const std::function<bool()>& stop) {
  Communicator::Ticket ticket = world.make_ticket();
  while (true) {
    try {
      if (stop()) return ticket.close(count);
      const std::uint64_t item = ticket.next();
      if (item >= count) return;
      work(item);
    } catch (const InputError& error) {
      if (world.size() > 1) end_all(world, error.what(), 2);
      throw;
    } catch (const std::exception& error) {
      if (world.size() > 1) end_all(world, error.what(), 1);
      throw;
    }
  }
}

std::vector<std::vector<double>> numbered_parts(std::size_t count,
                                                const std::vector<std::vector<char>>& messages) {
  std::vector<std::vector<double>> parts(count);
  for (const std::vector<char>& message : messages) {
    ByteReader in(message);
    for (std::uint64_t i = 0; !in.at_end();) {
      in.get(i);
      in.get(parts.at(i));
    }
  }
  return parts;
}

std::vector<std::vector<double>> share_parts(
    const Communicator& world, std::size_t count,
    const std::function<std::vector<double>(std::size_t)>& part) {
  ByteWriter mine;
  self_schedule(world, count, [&](std::uint64_t i) { mine.put(i).put(part(i)); });
  std::vector<char> all;
  for (const std::vector<char>& message : world.gather(mine.take()))
    all.insert(all.end(), message.begin(), message.end());
  world.broadcast(all);
  return numbered_parts(count, {all});
}

/// Launchers bind a rank to processors of its own, and its threads with it.
struct LentProcessors::Processors {
  cpu_set_t set;
};

LentProcessors::LentProcessors(const Communicator& world) {
  if (world.size() == 1) return;
  const Machines machines(world.state_->group);
  MPI_Comm_size(machines.mine, &ranks_);
  cpu_set_t mine, all;
  CPU_ZERO(&mine);
  CPU_ZERO(&all);
  sched_getaffinity(0, sizeof mine, &mine);
  MPI_Reduce(&mine, &all, sizeof mine, MPI_BYTE, MPI_BOR, 0, machines.mine);
  if (!world.is_root()) return;
  own_ = std::make_unique<Processors>(mine);
  sched_setaffinity(0, sizeof all, &all);
}

LentProcessors::~LentProcessors() {
  if (own_) sched_setaffinity(0, sizeof own_->set, &own_->set);
}

namespace {

/// Open MPI 4.1 with UCX takes it for windows between machines that are linked by TCP only, and
/// then cannot make them (its issues 9871, 11466). What the user states to Open MPI is left.
void leave_out_ucx_without_its_devices() {
  std::error_code ignored;
  const std::filesystem::path devices = "/sys/class/infiniband";
  if (!std::filesystem::exists(devices, ignored) || std::filesystem::is_empty(devices, ignored))
    setenv("OMPI_MCA_osc", "^ucx", /*overwrite=*/0);
}

/// Ranks of one machine send through its memory. Open MPI would first look for networks (0.2 s).
void leave_out_networks_on_one_machine() {
  const char* const all = std::getenv("OMPI_COMM_WORLD_SIZE");
  const char* const here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  if (all != nullptr && here != nullptr && std::string_view(all) == here)
    setenv("OMPI_MCA_pml", "ob1", /*overwrite=*/0);
}

}  // namespace

MpiSession::MpiSession(int& argc, char**& argv) : world_(std::make_shared<Communicator::State>()) {
  // Open MPI's and PMIx's launchers say so in the environment; without one MPI_Init would start a
  // daemon of its own.
  const auto set = [](const char* name) { return std::getenv(name) != nullptr; };
  if (!set("OMPI_COMM_WORLD_SIZE") && !set("PMIX_RANK") && !set("PMI_RANK")) return;
  leave_out_ucx_without_its_devices();
  leave_out_networks_on_one_machine();
  int provided = 0;  // threads of this program make no calls of MPI
  if (MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS)
    throw std::runtime_error("MPI_Init failed");
  world_->group = MPI_COMM_WORLD;
  MPI_Comm_rank(MPI_COMM_WORLD, &world_->rank);
  MPI_Comm_size(MPI_COMM_WORLD, &world_->size);
}

MpiSession::~MpiSession() {
  if (world_->group == MPI_COMM_NULL) return;
  for (MPI_Win& window : world_->shared_memory) MPI_Win_free(&window);
  MPI_Finalize();
}

Communicator MpiSession::world() const { return Communicator(world_); }

}  // namespace glissade
