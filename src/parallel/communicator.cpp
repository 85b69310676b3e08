// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/parallel/communicator.hpp"

#define OMPI_SKIP_MPICXX
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "glissade/core/error.hpp"

namespace glissade {

/// The group: MPI_COMM_NULL if the program runs alone and MPI was not started.
struct Communicator::State {
  MPI_Comm group = MPI_COMM_NULL;
  int rank = 0, size = 1;
  std::function<void()> before_abort;
};

Communicator::Communicator(std::shared_ptr<State> state) : state_(std::move(state)) {}

Communicator Communicator::serial() { return Communicator(std::make_shared<State>()); }
int Communicator::rank() const { return state_->rank; }
int Communicator::size() const { return state_->size; }

namespace {

// MPI counts are ints: messages are sent in pieces well below 2^31 bytes.
constexpr std::size_t piece_bytes = std::size_t{1} << 30;

template <class Transfer>
void in_pieces(std::vector<char>& bytes, Transfer transfer) {
  for (std::size_t at = 0; at < bytes.size(); at += piece_bytes) {
    transfer(bytes.data() + at, static_cast<int>(std::min(piece_bytes, bytes.size() - at)));
  }
}

}  // namespace

void Communicator::broadcast(std::vector<char>& bytes) const {
  if (size() == 1) return;
  std::uint64_t count = bytes.size();
  MPI_Bcast(&count, 1, MPI_UINT64_T, 0, state_->group);
  bytes.resize(count);
  in_pieces(bytes, [&](char* data, int n) { MPI_Bcast(data, n, MPI_CHAR, 0, state_->group); });
}

std::vector<std::vector<char>> Communicator::gather(const std::vector<char>& bytes) const {
  if (size() == 1) return {bytes};
  std::vector<char> own = bytes;
  if (!is_root()) {
    const std::uint64_t count = own.size();
    MPI_Send(&count, 1, MPI_UINT64_T, 0, 0, state_->group);
    in_pieces(own, [&](char* data, int n) { MPI_Send(data, n, MPI_CHAR, 0, 1, state_->group); });
    return {};
  }
  std::vector<std::vector<char>> all{std::move(own)};
  for (int rank = 1; rank < size(); ++rank) {
    std::uint64_t count = 0;
    MPI_Recv(&count, 1, MPI_UINT64_T, rank, 0, state_->group, MPI_STATUS_IGNORE);
    std::vector<char> part(count);
    in_pieces(part, [&](char* data, int n) {
      MPI_Recv(data, n, MPI_CHAR, rank, 1, state_->group, MPI_STATUS_IGNORE);
    });
    all.push_back(std::move(part));
  }
  return all;
}

void Communicator::before_abort(std::function<void()> clean_up) const {
  state_->before_abort = std::move(clean_up);
}

void Communicator::abort(int exit_status) const {
  if (state_->before_abort) state_->before_abort();
  if (size() > 1) MPI_Abort(state_->group, exit_status);
  std::exit(exit_status);
}

/// A counter on rank 0 that all ranks fetch and increment (MPI-3 one-sided), or a plain number.
struct Communicator::Ticket::State {
  MPI_Comm group = MPI_COMM_NULL;
  MPI_Win window = MPI_WIN_NULL;
  std::uint64_t* counter = nullptr;
  std::uint64_t alone = 0;
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
  }
  return Ticket(std::move(state));
}

namespace {

/// The counter before `more` is added to it.
std::uint64_t fetch_and_add(MPI_Win window, std::uint64_t more) {
  std::uint64_t before = 0;
  MPI_Fetch_and_op(&more, &before, MPI_UINT64_T, 0, 0, MPI_SUM, window);
  MPI_Win_flush(0, window);
  return before;
}

}  // namespace

std::uint64_t Communicator::Ticket::next() {
  if (state_->window == MPI_WIN_NULL) return state_->alone++;
  return fetch_and_add(state_->window, 1);
}

void Communicator::Ticket::close(std::uint64_t count) {
  if (state_->window == MPI_WIN_NULL) {
    state_->alone += count;
  } else {
    fetch_and_add(state_->window, count);
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

MpiSession::MpiSession(int& argc, char**& argv) {
  // Open MPI's and PMIx's launchers say so in the environment; without one MPI_Init would start a
  // daemon of its own.
  const auto set = [](const char* name) { return std::getenv(name) != nullptr; };
  if (!set("OMPI_COMM_WORLD_SIZE") && !set("PMIX_RANK") && !set("PMI_RANK")) return;
  int provided = 0;  // threads of this program make no calls of MPI
  if (MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS)
    throw std::runtime_error("MPI_Init failed");
  started_ = true;
}

MpiSession::~MpiSession() {
  if (started_) MPI_Finalize();
}

Communicator MpiSession::world() const {
  auto state = std::make_shared<Communicator::State>();
  if (started_) {
    state->group = MPI_COMM_WORLD;
    MPI_Comm_rank(MPI_COMM_WORLD, &state->rank);
    MPI_Comm_size(MPI_COMM_WORLD, &state->size);
  }
  return Communicator(std::move(state));
}

}  // namespace glissade
