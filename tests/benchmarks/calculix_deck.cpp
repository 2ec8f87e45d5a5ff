// Writes a scene as an input deck of CalculiX:
//   calculix_deck SCENE.xml PENALTY STICK > deck.inp
#include <cstdlib>
#include <exception>
#include <iostream>

#include <Tpetra_Core.hpp>

#include "CalculixDeck.hpp"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: calculix_deck SCENE.xml PENALTY STICK > deck.inp\n";
    return 2;
  }
  Tpetra::ScopeGuard scope(&argc, &argv);
  try {
    const harmos::scene::Scene scene = harmos::scene::readScene(argv[1], {}, harmos::laws::builtInLaws());
    harmos::base::Timers timers;
    const harmos::scene::Problem problem = harmos::scene::makeProblem(scene, *Tpetra::getDefaultComm(), timers);
    harmos::benchmarks::writeCalculixDeck(std::cout, scene, problem, {std::atof(argv[2]), std::atof(argv[3])});
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
