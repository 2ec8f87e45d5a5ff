#include <harmos/study/detail/StudyDesign.hpp>

#include <harmos/design/AdaptiveDesign.hpp>
#include <harmos/design/GridDesign.hpp>
#include <harmos/design/LatinHypercubeDesign.hpp>
#include <harmos/design/RandomDesign.hpp>
#include <harmos/design/SobolDesign.hpp>

namespace harmos::study {

std::unique_ptr<design::Design> makeDesign(const input::Parameters& study) {
  if (!study.hasList("Design") || study.list("Design").type() == "Grid") return std::make_unique<design::GridDesign>();
  const input::Parameters& design = study.list("Design");
  if (design.type() == "Adaptive") return std::make_unique<design::AdaptiveDesign>(refinementOptions(design));
  const int count = design.integer("Count");
  const int seed = design.integer("Seed");
  if (design.type() == "Random") return std::make_unique<design::RandomDesign>(count, seed);
  if (design.type() == "Sobol") return std::make_unique<design::SobolDesign>(count, seed);
  return std::make_unique<design::LatinHypercubeDesign>(count, seed);
}

design::Refinement::Options refinementOptions(const input::Parameters& design) {
  design::Refinement::Options options;
  options.tolerance = design.number("Tolerance");
  options.initialCount = design.integer("Initial Count");
  options.maximumCount = design.integer("Maximum Count");
  options.seed = design.integer("Seed");
  return options;
}

}  // namespace harmos::study
