#include <harmos/scene/detail/ExpectedStages.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::scene {
namespace {

// Linear stages at an accuracy of 1e-3, by which share of them they grow with every decade, since what slowly converges
// to 1e-3 slowly goes on, and how those of the march fall where there are more load steps than usual, which are shorter
// then.
constexpr double usualSteps = 11.0, growthWithSteps = -0.25, growthPerDecade = 0.2, usualAccuracy = 1e-3;
// Where all laws are affine, for the root of the points along an interface, over which stiffnesses of long and of short
// waves differ; of these, what the certificate takes; how they fall with the load steps, which go straight on.
constexpr double affineMarch = 4.0, affineCertificate = 0.5, affineGrowth = -0.5;
// Where bodies press on each other, for every joint of JointGraph::height, and for its square in the plane and in
// space: what slides at one joint passes forces on to the next, and every joint has directions of its own that the
// certificate must know.
constexpr double marchOfJoint = 5.0, certificateOfJoints[] = {2.0, 3.0}, leastStages = 9.0;
// Of the stages: for every doubling of the pieces of a part.
constexpr double growthWithPieces = 0.18;
// Other solutions are looked for to a residual two decades below; of the stages of the march, in the plane, where
// bodies meet at points, and in space, where they do along lines.
constexpr double marchesOfWay[] = {0.1, 2.0};

// Where velocities are iterated on, a load step moves when those before it have come to rest: linear stages of a load
// step, of those of the march.
constexpr double stagesOfVelocities = 0.75;
// Directions that the first parameter of a derivative adds at a load step, over the linear stages of a certificate at
// 1e-3, where contacts have tangents of their own at every load step and where all laws are affine; and of how many
// stages of a certificate there are directions at least.
constexpr double directionsOfContact = 6.0, directionsOfAffine = 1.5, leastOfDirections = 6.0;

}  // namespace

ExpectedStages expectedStages(const CostScope& scope, const latin::LatinOptions& solver) {
  ExpectedStages stages;
  const double height = scope.joints.height,
               further = std::max(0.5, 1.0 + growthPerDecade * std::log10(usualAccuracy / solver.accuracy));
  if (scope.isAffine) {
    const double first = std::max(1.0, further * affineMarch * std::sqrt(scope.joints.points));
    stages.march = std::max(1.0, first * std::pow(scope.steps, affineGrowth));
    stages.certificate = affineCertificate * first;
    stages.directions = directionsOfAffine * stages.certificate / further;
    return stages;
  }
  const double pieces = 1.0 + growthWithPieces * std::log2(scope.pieces);
  const double march = std::max(1.0, further * pieces * std::max(leastStages, marchOfJoint * height));
  stages.march =
      solver.stages.formulation == latin::Formulation::velocity
          ? std::min<double>(solver.maximumIterations, march * std::max(1.0, stagesOfVelocities * scope.steps))
          : march * std::min(1.0, std::pow(scope.steps / usualSteps, growthWithSteps));
  const double certificate = certificateOfJoints[scope.dimension - 2] * height * height;
  stages.certificate = std::max(1.0, further * pieces * std::max(leastStages, certificate));
  stages.directions = directionsOfContact * pieces * std::max(leastOfDirections, certificate);
  if (scope.joints.sharedNodes > 0.0)
    stages.others = ExpectedStages::ways * marchesOfWay[scope.dimension - 2] * stages.march;
  return stages;
}

}  // namespace harmos::scene
