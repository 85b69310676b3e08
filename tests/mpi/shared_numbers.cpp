// SPDX-License-Identifier: GPL-3.0-or-later
//
// Under mpirun: exit status 0 if every rank has the numbers of rank 0, and the ranks of one machine
// have them in one place.
#include <cstdio>
#include <span>
#include <vector>

#include "glissade/parallel/communicator.hpp"

int main(int argc, char** argv) {
  const glissade::MpiSession mpi(argc, argv);
  const glissade::Communicator world = mpi.world();
  bool right = true;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1} << 20}) {
    std::vector<double> numbers(world.is_root() ? count : 0, 0.25);
    const std::span<const double> shared = world.on_each_machine(std::move(numbers));
    right = right && shared.size() == count;
    for (const double number : shared) right = right && number == 0.25;
    if (count == 0) continue;
    // What one rank writes all read: there is one copy.
    std::vector<char> none;
    world.gather(none);
    if (world.is_root()) const_cast<double&>(shared.back()) = 0.5;
    world.broadcast(none);
    right = right && shared.back() == 0.5;
  }
  if (!right) std::fprintf(stderr, "rank %d has other numbers\n", world.rank());
  return right ? 0 : 1;
}
