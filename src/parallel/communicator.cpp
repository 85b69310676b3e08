// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/parallel/communicator.hpp"

#define OMPI_SKIP_MPICXX
#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "glissade/core/bytes.hpp"
#include "glissade/core/error.hpp"
#include "glissade/parallel/together.hpp"

namespace glissade {

/// The group: MPI_COMM_NULL if the program runs alone and MPI was not started.
struct Communicator::State {
  MPI_Comm group = MPI_COMM_NULL;
  int rank = 0, size = 1;
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

int Communicator::first_where(bool holds) const {
  int first = holds ? rank() : size();
  if (size() == 1) return first;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, state_->group, &request);
  wait_quietly(request);
  return first;
}

void Communicator::broadcast(std::vector<char>& bytes, int from) const {
  if (size() == 1) return;
  std::uint64_t count = bytes.size();
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(&count, 1, MPI_UINT64_T, from, state_->group, &request);
  wait_quietly(request);
  together(*this, [&] { bytes.resize(count); });
  in_pieces(bytes, [&](char* data, int n) { MPI_Bcast(data, n, MPI_CHAR, from, state_->group); });
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

/// A folder in memory, which every Linux has; containers have 64 MB of it.
constexpr const char* usual_shared_memory = "/dev/shm";
/// Open MPI makes the files of shared memory in these folders.
constexpr const char* folder_of_windows = "OMPI_MCA_osc_sm_backing_directory";
constexpr const char* folders_of_shared_memory[] = {folder_of_windows,
                                                    "OMPI_MCA_osc_rdma_backing_directory",
                                                    "OMPI_MCA_btl_vader_backing_directory"};

std::string shared_memory() {
  const char* const stated = std::getenv(folder_of_windows);
  return stated == nullptr ? usual_shared_memory : stated;
}

/// Beside what Open MPI has in it for itself.
bool has_room_for(double bytes, const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  return error || static_cast<double>(space.available) > bytes + 16e6;
}

/// A rank that cannot make a window is waited for by the others for ever: an exception, which is
/// none of a step of them all, ends them.
void check_window(int code) {
  if (code == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  MPI_Error_string(code, text.data(), &length);
  const std::string folder = shared_memory();
  throw InputError(
      {folder, "MPI cannot make memory there that the ranks share: " + std::string(text.data()),
       "make room in " + folder + ", or in the folder of temporary files (TMPDIR)", ""});
}

/// Errors of MPI end all ranks, with messages of MPI; in this scope they are returned.
class ReturnedErrors {
 public:
  explicit ReturnedErrors(MPI_Comm group) : group_(group) {
    MPI_Comm_set_errhandler(group_, MPI_ERRORS_RETURN);
  }
  ~ReturnedErrors() { MPI_Comm_set_errhandler(group_, MPI_ERRORS_ARE_FATAL); }
  ReturnedErrors(const ReturnedErrors&) = delete;
  ReturnedErrors& operator=(const ReturnedErrors&) = delete;

 private:
  MPI_Comm group_;
};

/// A window of the machine's first rank, which all its ranks can read.
std::span<std::byte> allocate_on_machine(std::size_t count, const Machines& machines,
                                         MPI_Win* window) {
  std::byte* data = nullptr;
  MPI_Aint bytes = machines.is_first() ? static_cast<MPI_Aint>(count) : 0;
  int unit = 1;
  {
    const ReturnedErrors returned(machines.mine);
    check_window(MPI_Win_allocate_shared(bytes, unit, MPI_INFO_NULL, machines.mine, &data, window));
  }
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
  if (first_where(!has_room_for(static_cast<double>(count), shared_memory())) < size()) {
    std::shared_ptr<std::vector<std::byte>> own;
    together(*this, [&] { own = std::make_shared<std::vector<std::byte>>(count); });
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

std::vector<std::vector<char>> Communicator::gather(const std::vector<char>& bytes) const {
  std::vector<std::vector<char>> all;
  if (is_root()) all.push_back(bytes);
  collect(
      1, [&] { return bytes; },
      [&](std::vector<char> message) { all.push_back(std::move(message)); });
  return all;
}

namespace {

/// The messages of one rank to root: the size of each, to which root says whether it takes it, and
/// then the message; `no_more` in place of a size ends them.
class MessagesToRoot {
 public:
  MessagesToRoot(MPI_Comm group, int rank) : group_(group), rank_(rank) {}

  void send(std::uint64_t count, const std::function<std::vector<char>()>& next) const {
    try {
      for (; count > 0; --count)
        if (!send_one(next())) return;
    } catch (...) {
      send_size(no_more);
      throw;
    }
    send_size(no_more);
  }
  /// Until there are no more, or `take` throws.
  void receive(const std::function<void(std::vector<char>)>& take) const {
    for (std::uint64_t size = receive_size(); size != no_more; size = receive_size()) {
      std::vector<char> bytes;
      try {
        bytes.resize(size);
      } catch (...) {
        answer(false);
        throw;
      }
      answer(true);
      in_pieces(bytes, [&](char* data, int n) {
        MPI_Recv(data, n, MPI_CHAR, rank_, 2, group_, MPI_STATUS_IGNORE);
      });
      try {
        take(std::move(bytes));
      } catch (...) {
        refuse();
        throw;
      }
    }
  }
  /// All that are still to come.
  void refuse() const {
    if (receive_size() != no_more) answer(false);
  }

 private:
  static constexpr std::uint64_t no_more = ~std::uint64_t{0};

  bool send_one(std::vector<char> bytes) const {
    send_size(bytes.size());
    char is_taken = 0;
    MPI_Recv(&is_taken, 1, MPI_CHAR, 0, 1, group_, MPI_STATUS_IGNORE);
    if (is_taken == 0) return false;
    in_pieces(bytes, [&](char* data, int n) { MPI_Send(data, n, MPI_CHAR, 0, 2, group_); });
    return true;
  }
  void send_size(std::uint64_t size) const { MPI_Send(&size, 1, MPI_UINT64_T, 0, 0, group_); }
  std::uint64_t receive_size() const {
    std::uint64_t size = 0;
    MPI_Recv(&size, 1, MPI_UINT64_T, rank_, 0, group_, MPI_STATUS_IGNORE);
    return size;
  }
  void answer(bool is_taken) const {
    const char answer = is_taken ? 1 : 0;
    MPI_Send(&answer, 1, MPI_CHAR, rank_, 1, group_);
  }

  MPI_Comm group_;
  int rank_;
};

}  // namespace

void Communicator::collect(std::uint64_t count, const std::function<std::vector<char>()>& next,
                           const std::function<void(std::vector<char>)>& receive) const {
  together(*this, [&] {
    if (!is_root()) return MessagesToRoot(state_->group, rank()).send(count, next);
    int from = 1;
    try {
      for (; from < size(); ++from) MessagesToRoot(state_->group, from).receive(receive);
    } catch (...) {
      for (++from; from < size(); ++from) MessagesToRoot(state_->group, from).refuse();
      throw;
    }
  });
}

void Communicator::abort(int exit_status) const {
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
    const ReturnedErrors returned(state->group);
    check_window(MPI_Win_allocate(bytes, sizeof(std::uint64_t), MPI_INFO_NULL, state->group,
                                  &state->counter, &state->window));
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

void self_schedule(const Communicator& world, std::uint64_t count,
                   const std::function<void(std::uint64_t)>& work,
                   const std::function<bool()>& stop) {
  Communicator::Ticket ticket = world.make_ticket();
  together(world, [&] {
    try {
      while (!stop()) {
        const std::uint64_t item = ticket.next();
        if (item >= count) return;
        work(item);
      }
    } catch (...) {
      ticket.close(count);
      throw;
    }
    ticket.close(count);
  });
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
  int ranks = 1;
  MPI_Comm_size(machines.mine, &ranks);
  cpu_set_t mine, all;
  CPU_ZERO(&mine);
  CPU_ZERO(&all);
  sched_getaffinity(0, sizeof mine, &mine);
  MPI_Reduce(&mine, &all, sizeof mine, MPI_BYTE, MPI_BOR, 0, machines.mine);
  if (!world.is_root()) return;
  threads_ = std::min(ranks, CPU_COUNT(&all));
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

/// Where /dev/shm has no room for its files, Open MPI ends without a message.
void leave_a_full_shared_memory() {
  constexpr double bytes_of_rank = 5e6;
  const char* const here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  const double needed = bytes_of_rank * (here == nullptr ? 1.0 : std::atof(here));
  std::error_code error;
  const std::filesystem::path other = std::filesystem::temp_directory_path(error);
  if (has_room_for(needed, usual_shared_memory) || error || !has_room_for(needed, other)) return;
  for (const char* folder : folders_of_shared_memory)
    setenv(folder, other.c_str(), /*overwrite=*/0);
}

}  // namespace

MpiSession::MpiSession(int& argc, char**& argv) : world_(std::make_shared<Communicator::State>()) {
  // Open MPI's and PMIx's launchers say so in the environment; without one MPI_Init would start a
  // daemon of its own.
  const auto set = [](const char* name) { return std::getenv(name) != nullptr; };
  if (!set("OMPI_COMM_WORLD_SIZE") && !set("PMIX_RANK") && !set("PMI_RANK")) return;
  leave_out_ucx_without_its_devices();
  leave_out_networks_on_one_machine();
  leave_a_full_shared_memory();
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
