#include <harmos/study/detail/DesignRegistry.hpp>

#include <harmos/design/GridDesign.hpp>

namespace harmos::study {

StudyDesign readDesign(const input::Parameters& study) {
  if (study.hasList("Design")) return *builtInDesigns().create(study.list("Design"));
  StudyDesign grid;
  grid.where = study.where();
  grid.points = std::make_shared<const design::GridDesign>();
  return grid;
}

void addCount(input::ParameterSpec& spec) {
  spec.integer("Count")
      .required()
      .atLeast(1)
      .atMost(design::mostConfigurations)
      .doc("Number of points, those that conditions leave out included.");
}

void addOrder(input::ParameterSpec& spec) {
  spec.integer("Order").defaultValue(3).atLeast(0).atMost(20).doc("Highest total degree of the polynomials.");
  spec.integer("Points").defaultValue(0).atLeast(0).atMost(64).doc(
      "Gauss points per random parameter; 0: as many as the order and the distributions need.");
  addHoldOuts(spec, "expansion");
}

void addHoldOuts(input::ParameterSpec& spec, const std::string& ofWhat) {
  spec.integer("Hold-Out Count")
      .defaultValue(5)
      .atLeast(0)
      .atMost(design::mostConfigurations)
      .doc("Random configurations that are solved besides, only to see how far the " + ofWhat + " is off there.");
  spec.integer("Seed").defaultValue(1).doc("Of the hold-out configurations.");
}

HoldOutOptions readHoldOuts(const input::Parameters& parameters) {
  return {parameters.integer("Hold-Out Count"), parameters.integer("Seed")};
}

}  // namespace harmos::study
