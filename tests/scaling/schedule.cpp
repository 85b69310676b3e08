// SPDX-License-Identifier: GPL-3.0-or-later
#include "schedule.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace glissade::test {
namespace {

constexpr int root = 0;

class Simulation {
 public:
  Simulation(std::span<const double> costs_s, int ranks, const Network& network, Fetch fetch,
             double slowdown)
      : costs_s_(costs_s),
        network_(network),
        fetch_(fetch),
        slowdown_(slowdown),
        ranks_(static_cast<std::size_t>(ranks)) {}

  double run() {
    for (int rank = 0; rank < static_cast<int>(ranks_.size()); ++rank) ask(rank, 0.0);
    while (!events_.empty()) {
      const Event event = events_.top();
      events_.pop();
      switch (event.kind) {
        case Event::request:
          receive(event.rank, event.time_s);
          break;
        case Event::reply:
          take(event.rank, event.item, event.time_s);
          break;
        case Event::finish:
          finish(event.rank, event.time_s);
          break;
      }
    }
    return end_s_;
  }

 private:
  struct Event {
    enum Kind { request, reply, finish } kind;
    double time_s;
    std::uint64_t number;  ///< of two at one time the one made first is first
    int rank;
    std::size_t item = 0;
    bool operator<(const Event& other) const {  // the least is on top of the queue
      return time_s != other.time_s ? time_s > other.time_s : number > other.number;
    }
  };
  struct Rank {
    bool waits = true;
    std::optional<std::size_t> fetched;
  };

  void add(Event::Kind kind, int rank, double time_s, std::size_t item = 0) {
    events_.push({kind, time_s, made_++, rank, item});
  }
  double latency_s(int rank) const { return rank == root ? 0.0 : network_.latency_s; }
  void ask(int rank, double now_s) { add(Event::request, rank, now_s + latency_s(rank)); }

  void receive(int rank, double now_s) {
    const bool answers = network_.remote_atomics || rank == root || ranks_[root].waits;
    if (!answers) return unanswered_.push_back(rank);
    served_s_ = std::max(served_s_, now_s) + network_.service_s;
    add(Event::reply, rank, served_s_ + latency_s(rank), next_++);
  }
  void take(int rank, std::size_t item, double now_s) {
    Rank& r = ranks_[static_cast<std::size_t>(rank)];
    if (!r.waits) {
      r.fetched = item;
    } else if (item < costs_s_.size()) {
      r.waits = false;
      add(Event::finish, rank, now_s + slowdown_ * costs_s_[item]);
      if (fetch_ == Fetch::ahead) ask(rank, now_s);
    } else {
      end_s_ = std::max(end_s_, now_s);  // it waits for the end, and answers if it is rank 0
    }
  }
  void finish(int rank, double now_s) {
    Rank& r = ranks_[static_cast<std::size_t>(rank)];
    r.waits = true;
    if (rank == root && !unanswered_.empty()) {
      for (const int other : std::exchange(unanswered_, {})) receive(other, now_s);
      now_s = std::max(now_s, served_s_);
    }
    if (r.fetched) {
      take(rank, *std::exchange(r.fetched, std::nullopt), now_s);
    } else if (fetch_ == Fetch::when_free) {
      ask(rank, now_s);
    }
  }

  std::span<const double> costs_s_;
  Network network_;
  Fetch fetch_;
  double slowdown_;
  std::vector<Rank> ranks_;
  std::vector<int> unanswered_;  ///< requests that wait for rank 0
  std::priority_queue<Event> events_;
  std::uint64_t made_ = 0;
  std::size_t next_ = 0;
  double served_s_ = 0.0, end_s_ = 0.0;
};

}  // namespace

double makespan_s(std::span<const double> costs_s, int ranks, const Network& network, Fetch fetch,
                  double slowdown) {
  return Simulation(costs_s, ranks, network, fetch, slowdown).run();
}

}  // namespace glissade::test
