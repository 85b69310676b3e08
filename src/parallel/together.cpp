// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/parallel/together.hpp"

#include <filesystem>
#include <new>
#include <optional>
#include <system_error>
#include <vector>

#include "glissade/core/bytes.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/not_converged.hpp"

namespace glissade {

ExitStatus exit_status_of_exception() {
  constexpr int refused = 2, fault = 1;
  const std::string refusal = "the system refuses it: ",
                    limits = "; check the limits of processes, memory and open files (ulimit -a)";
  try {
    throw;
  } catch (const ExitStatus& ending) {
    return ending;
  } catch (const InputError& error) {
    return {refused, error.what()};
  } catch (const NotConverged& error) {  // `run` counts these
    return {refused, "the history did not converge: " + std::string(error.what())};
  } catch (const std::bad_alloc&) {
    return {refused,
            "there is not enough memory for this; take fewer samples, levels or ranks, or raise "
            "its limit (ulimit -v)"};
  } catch (const std::filesystem::filesystem_error& error) {
    std::error_code ignored;
    const bool is_gone = std::filesystem::current_path(ignored).empty();
    const InputError reported({is_gone ? "the working directory" : error.path1().string(),
                               "cannot be used: " + error.code().message(),
                               "check that it is there and that you may read and write it", ""});
    return {refused, reported.what()};
  } catch (const std::system_error& error) {
    return {refused, refusal + error.code().message() + limits};
  } catch (const std::exception& error) {
    const std::string what = error.what();
    if (what.starts_with("pthread_create")) return {refused, refusal + what + limits};  // oneTBB
    return {fault, "internal error: " + what};
  }
}

void together(const Communicator& world, const std::function<void()>& step) {
  std::optional<ExitStatus> mine;
  try {
    step();
  } catch (...) {
    mine = exit_status_of_exception();
  }
  const int first = world.first_where(mine.has_value());
  if (first == world.size()) return;
  std::vector<char> message;
  if (world.rank() == first) {
    const std::string of_rank = first > 0 && !mine->message.empty()
                                    ? "rank " + std::to_string(first) + ": " + mine->message
                                    : mine->message;
    message = ByteWriter().put(mine->status).put(of_rank).take();
  }
  world.broadcast(message, first);
  ExitStatus common;
  ByteReader(message).get(common.status).get(common.message);
  throw common;
}

void on_root(const Communicator& world, const std::function<void()>& step) {
  together(world, [&] {
    if (world.is_root()) step();
  });
}

bool root_says(const Communicator& world, const std::function<bool()>& question) {
  std::vector<char> answer(1);
  on_root(world, [&] { answer[0] = question() ? 1 : 0; });
  world.broadcast(answer);
  return answer[0] != 0;
}

}  // namespace glissade
