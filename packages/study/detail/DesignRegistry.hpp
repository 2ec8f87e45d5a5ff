#pragma once

#include <memory>
#include <utility>

#include <harmos/design/Configuration.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/input/Registry.hpp>
#include <harmos/study/StudyDesign.hpp>

namespace harmos::study {

/// The designs that a study may name.
using DesignRegistry = input::Registry<StudyDesign>;

/// Adds the design written as struct D under D::name: D::describe(spec) declares its entries, D::read(parameters) gives
/// options and points.
template <class D>
void addDesign(DesignRegistry& designs) {
  input::ParameterSpec spec(D::name);
  D::describe(spec);
  designs.add(std::move(spec), [](const input::Parameters& p) {
    auto design = std::make_unique<StudyDesign>(D::read(p));
    design->type = p.type();
    design->where = p.where();
    return design;
  });
}

/// All designs: the list in packages/study/CMakeLists.txt.
const DesignRegistry& builtInDesigns();

/// Of the input of a study; a grid, when it has no list Design.
StudyDesign readDesign(const input::Parameters& study);

/// Entries that several designs have.
void addCount(input::ParameterSpec& spec);
/// Order, points and hold-outs of what all methods for polynomial chaos have in common.
void addOrder(input::ParameterSpec& spec);
/// `ofWhat` is judged by the hold-outs.
void addHoldOuts(input::ParameterSpec& spec, const std::string& ofWhat);
HoldOutOptions readHoldOuts(const input::Parameters& parameters);

}  // namespace harmos::study

/// Ends the file of a design: defines the function that the generated list calls.
#define HARMOS_DESIGN(Design)                 \
  void add##Design(DesignRegistry& designs) { \
    addDesign<Design>(designs);               \
  }
