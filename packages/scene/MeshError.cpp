#include <harmos/scene/MeshError.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/Snapshot.hpp>
#include <harmos/recovery/Resummation.hpp>
#include <harmos/scene/detail/AdjointFields.hpp>
#include <harmos/scene/detail/NearSliding.hpp>
#include <harmos/scene/detail/PartFields.hpp>
#include <harmos/scene/detail/VolumetricLocking.hpp>

namespace harmos::scene {
namespace {

// Value over the size of a response, below which theta means nothing.
constexpr double smallValue = 0.1;
// |dJ| over the sum of |dJ_E|: less is what is left of cancellation. dJ without known tractions over dJ with them.
constexpr double cancelled = 0.35, leastRatio = 0.35, largestRatio = 1.4;
// Of the sum of |dJ_E|, printed where they cancel.
constexpr double doubtful = 0.5;
constexpr double coarse = 0.5;
// Of the sum of |dJ_E|: a part that brings more is named.
constexpr double named = 0.2;
constexpr std::size_t namesAtMost = 3;
// Relative error from which on parts that lock are told of.
constexpr double visible = 0.05;
using results::negligibleMeshError;

base::Matrix columnsOf(const base::Matrix& all, const std::vector<int>& columns) {
  base::Matrix result(all.numRows(), all.numRows() > 0 ? static_cast<int>(columns.size()) : 0);
  for (int j = 0; j < result.numCols(); ++j) std::copy_n(all[columns[j]], all.numRows(), result[j]);
  return result;
}

/// Of the parts that bring most of an error, those that lock because they are nearly incompressible, and what helps.
std::string lockingOf(const Problem& problem, const std::vector<WholePart>& parts, const ResponseMeshError& error) {
  std::string text;
  for (const std::string& name : error.parts) {
    const auto part =
        std::find_if(parts.begin(), parts.end(), [&](const WholePart& candidate) { return candidate.name == name; });
    const std::string remedy = lockingRemedy(problem, part->bodies.front());
    if (!remedy.empty()) text += (text.empty() ? "" : "; ") + name + " " + remedy;
  }
  return text;
}

/// What the parts say of one response, a number each.
struct Shares {
  std::vector<recovery::PartShare> part;
  std::vector<double> absolute, uncorrected;  // as in recovery::PartResidual
};

ResponseMeshError judge(const std::string& response, double value, double size, bool isHidden,
                        const std::vector<WholePart>& parts, const Shares& shares) {
  double sum = 0.0;
  for (const recovery::PartShare& part : shares.part) sum += part.change;
  const std::vector<double>& absolute = shares.absolute;
  const double all = std::accumulate(absolute.begin(), absolute.end(), 0.0);
  const double raw = std::accumulate(shares.uncorrected.begin(), shares.uncorrected.end(), 0.0);
  ResponseMeshError error;
  error.response = response;
  const bool cancels = std::abs(sum) < cancelled * all;
  const double ratio = sum != 0.0 ? raw / sum : 1.0;
  const bool isSmall = std::abs(value) < smallValue * size;
  const recovery::ResummedChange resummed = recovery::resummed(value, shares.part);
  error.change = isSmall ? sum : resummed.change;
  if (cancels) error.change = std::copysign(std::max(std::abs(error.change), doubtful * all), sum);
  const bool isBeyond = !isSmall && resummed.isBeyond;
  const double converged = value + error.change;
  error.relative = isBeyond ? 1.0 : std::abs(error.change) / std::max({std::abs(converged), smallValue * size});
  if (size == 0.0) error.relative = 0.0;
  if (isBeyond) {
    error.word = MeshErrorWord::locks;
  } else if (error.relative > coarse) {
    error.word = MeshErrorWord::tooCoarse;
  } else if ((cancels || ratio < leastRatio || ratio > largestRatio || isHidden) &&
             error.relative >= negligibleMeshError) {
    error.word = MeshErrorWord::uncertain;
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return absolute[a] > absolute[b]; });
  for (const std::size_t p : order) {
    if (absolute[p] < named * all || error.parts.size() == namesAtMost || all == 0.0) break;
    error.parts.push_back(parts[p].name);
  }
  return error;
}

}  // namespace

const char* textOf(MeshErrorWord word) {
  switch (word) {
    case MeshErrorWord::estimated:
      return "estimated";
    case MeshErrorWord::uncertain:
      return "uncertain";
    case MeshErrorWord::nearSliding:
      return "near sliding";
    case MeshErrorWord::tooCoarse:
      return "too coarse";
    case MeshErrorWord::locks:
      return "locks";
  }
  return "";
}

MeshErrors estimateMeshErrors(const Problem& problem, latin::FixedPoint& fixedPoint, const latin::Iterate& state,
                              const std::vector<std::shared_ptr<const latin::Response>>& responses,
                              const Teuchos::Comm<int>& comm) {
  const int step = problem.assembly.steps() - 1;
  const latin::Snapshot values(state, responses);
  std::vector<latin::ResponseGradient> gradients;
  std::vector<std::size_t> linear;
  bool hasDisplacements = false;
  for (std::size_t i = 0; i < responses.size(); ++i) {
    if (values.isSmall(i)) continue;  // of what counts as zero no error is told
    auto gradient = responses[i]->gradient(problem.assembly);
    if (!gradient) continue;
    gradients.push_back(std::move(*gradient));
    linear.push_back(i);
    hasDisplacements = hasDisplacements || responses[i]->quantity() == latin::Quantity::displacement;
  }
  const std::size_t asked = linear.size();
  const std::vector<NearSliding> sliding =
      hasDisplacements ? findNearSliding(state, step) : std::vector<NearSliding>();  // they serve displacements only
  for (const NearSliding& interface : sliding) gradients.push_back(interface.gradient);
  std::vector<PartPieces> pieces = partPieces(problem.mesh, problem.bodies.pieces);
  const AdjointFields found = adjointFields(pieces, fixedPoint, state, step, gradients);
  const std::vector<WholePart> parts =
      wholeParts(problem, std::move(pieces), found.fields, found.steps, gradients, comm);
  const std::size_t count = gradients.size(), width = 5 * count + 2;
  std::vector<double> mine(width * parts.size(), 0.0);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (static_cast<int>(p) % comm.getSize() != comm.getRank()) continue;
    const WholePart& part = parts[p];
    const auto body = static_cast<std::size_t>(part.bodies.front());
    const base::Matrix temperature = columnsOf(problem.temperatures->of(part.piece), found.steps);
    const elasticity::ElasticPart elastic{problem.mesh,
                                          part.piece,
                                          *problem.bodies.materials[body],
                                          problem.bodies.parts[body].formulation,
                                          problem.model.kinematics,
                                          problem.model.thickness,
                                          temperature.numRows() > 0 ? &temperature : nullptr};
    const recovery::PartResidual residual = recovery::dualWeightedResidual(elastic, part.displacements, found.adjoints,
                                                                           part.boundary, part.faces, part.skipped);
    double* to = mine.data() + width * p;
    for (const auto* list :
         {&residual.change, &residual.absolute, &residual.uncorrected, &residual.work, &residual.absoluteWork}) {
      to = std::copy(list->begin(), list->end(), to);
    }
    *to++ = residual.errorEnergy;
    *to = residual.energy;
  }
  std::vector<double> all(mine);
  if (comm.getSize() > 1) {
    Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  }

  const auto judged = [&](std::size_t j, const std::string& name, double value, double size) {
    Shares shares;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const double* of = all.data() + width * p;
      shares.part.push_back({of[j], of[3 * count + j], of[4 * count + j]});
      shares.absolute.push_back(of[count + j]);
      shares.uncorrected.push_back(of[2 * count + j]);
    }
    return judge(name, value, size, found.isHidden[j], parts, shares);
  };
  MeshErrors result;
  for (std::size_t j = 0; j < asked; ++j) {
    const std::size_t i = linear[j];
    result.responses.push_back(judged(j, responses[i]->name(), values.responses()[i][step], values.size(i)));
    ResponseMeshError& error = result.responses.back();
    if (error.relative >= visible) error.locking = lockingOf(problem, parts, error);
    if (responses[i]->quantity() != latin::Quantity::displacement || error.relative < negligibleMeshError) continue;
    for (std::size_t k = 0; k < sliding.size() && error.reason.empty(); ++k) {
      const NearSliding& interface = sliding[k];
      const double uncertainty = judged(asked + k, interface.name, interface.clamping, interface.clamping).relative;
      if (interface.reserve >= uncertainty) continue;
      error.word = MeshErrorWord::nearSliding;
      error.reason = describe(interface, uncertainty);
    }
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const double* energies = all.data() + width * p + 5 * count;
    result.parts.push_back({parts[p].name, energies[1] > 0.0 ? energies[0] / energies[1] : 0.0});
  }
  return result;
}

results::MeshErrorRecord recordOf(const ResponseMeshError& error) {
  return {error.response,     error.change, error.relative,
          textOf(error.word), error.parts,  error.reason.empty() ? error.locking : error.reason};
}

std::string describe(const ResponseMeshError& error, double value) {
  std::ostringstream text;
  if (error.relative < negligibleMeshError) return "mesh " + results::meshErrorInWords(error.relative);
  if (error.word == MeshErrorWord::locks) {
    text << "the mesh locks";
  } else if (error.word == MeshErrorWord::nearSliding) {
    if (error.relative > coarse) {
      text << "the mesh is too coarse: " << error.reason;
    } else {
      text << "mesh at least " << results::percentage(error.relative) << ": " << error.reason;
    }
  } else if (error.word == MeshErrorWord::tooCoarse) {
    text << "the mesh is too coarse (more than " << 100.0 * coarse << " %)";
  } else {
    text << "mesh " << results::meshErrorInWords(error.relative);
    if (error.word == MeshErrorWord::uncertain) text << ", uncertain";
    text << " (towards " << std::setprecision(2) << value + error.change << ")";
  }
  const char* separator = "; refine ";
  for (const std::string& part : error.parts) {
    text << separator << part;
    separator = ", ";
  }
  if (!error.locking.empty()) text << "; " << error.locking;
  return text.str();
}

}  // namespace harmos::scene
