#include <harmos/setup/StudyDesign.hpp>

#include <harmos/study/AdaptiveDesign.hpp>
#include <harmos/study/GridDesign.hpp>
#include <harmos/study/LatinHypercubeDesign.hpp>
#include <harmos/study/RandomDesign.hpp>
#include <harmos/study/SobolDesign.hpp>

namespace harmos::setup {

std::unique_ptr<study::Design> makeDesign(const base::Parameters& study) {
  if (!study.hasList("Design") || study.list("Design").type() == "Grid") return std::make_unique<study::GridDesign>();
  const base::Parameters& design = study.list("Design");
  if (design.type() == "Adaptive") return std::make_unique<study::AdaptiveDesign>(refinementOptions(design));
  const int count = design.integer("Count");
  const int seed = design.integer("Seed");
  if (design.type() == "Random") return std::make_unique<study::RandomDesign>(count, seed);
  if (design.type() == "Sobol") return std::make_unique<study::SobolDesign>(count, seed);
  return std::make_unique<study::LatinHypercubeDesign>(count, seed);
}

study::Refinement::Options refinementOptions(const base::Parameters& design) {
  study::Refinement::Options options;
  options.tolerance = design.number("Tolerance");
  options.initialCount = design.integer("Initial Count");
  options.maximumCount = design.integer("Maximum Count");
  options.seed = design.integer("Seed");
  return options;
}

}  // namespace harmos::setup
