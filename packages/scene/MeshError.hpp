#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/results/MeshErrorRecord.hpp>
#include <harmos/scene/Problem.hpp>

namespace harmos::scene {

/// How far an estimate of the error of the mesh can be trusted, from best to worst.
enum class MeshErrorWord {
  estimated,    ///< 86 to 96 of 100 such estimates lie within 0.5 and 3 times the truth
  uncertain,    ///< the shares of the elements cancel, or known tractions change it much
  nearSliding,  ///< an interface has less left to sliding than its pressures are uncertain: nothing linear follows
  tooCoarse,    ///< more than half of the response: only its order says something
  locks         ///< the converged value is out of sight
};

/// As it is written: estimated, uncertain, near sliding, too coarse, locks.
const char* textOf(MeshErrorWord word);

/// The error that the mesh makes in a response at the last load step, over and above the error estimate of the solver.
struct ResponseMeshError {
  std::string response;   ///< its name
  double change = 0.0;    ///< converged value less that on this mesh, in the unit of the response
  double relative = 0.0;  ///< |change| over the converged value, or over its size if that is larger
  MeshErrorWord word = MeshErrorWord::estimated;  ///< what it is worth
  std::vector<std::string> parts = {};            ///< whose elements bring most of it, the worst first
  std::string reason = {};                        ///< of the word nearSliding, for the user
  std::string locking = {};                       ///< of these parts, which lock, and what helps, for the user
};

/// What the stress of a part that its mesh does not show.
struct PartMeshError {
  std::string part;          ///< its name
  double energyShare = 0.0;  ///< energy of the recovered stress less that of the elements, over that of the latter [-]
};

/// The estimates for a run.
struct MeshErrors {
  std::vector<ResponseMeshError> responses;  ///< of those that are linear in displacements and tractions
  std::vector<PartMeshError> parts;          ///< in the order of the list Parts
};

/// Estimates the error of the mesh at the last load step by dual-weighted residuals: one adjoint for each response
/// (latin::AdjointProblem) and stresses recovered part by part (recovery::dualWeightedResidual()).
///
/// With dJ the sum over all parts and J_h the value on this mesh, theta = dJ / J_h is the error over the converged
/// value J = J_h / (1 - theta), which is exact where one stiff mode rules; where J_h is small beside the response's
/// size, J = J_h + dJ. Where the reserve of friction of an interface against sliding (findNearSliding()) is less than
/// what the mesh does to its clamping force, displacements are no more than marked: they grow without bound. It sees
/// the mesh as the geometry: facets of curved faces are not in it, nor are the size of the load steps and the law. No
/// bound: 5 to 15 of 100 estimates lie outside of what the words say.
///
/// `state`: the fields of a solution of `problem`, laws included, of all load steps and in the displacement form;
/// `responses`: of it, which to look at. Collective; ends the validity of the state. Throws as
/// recovery::dualWeightedResidual().
MeshErrors estimateMeshErrors(const Problem& problem, latin::FixedPoint& fixedPoint, const latin::Iterate& state,
                              const std::vector<std::shared_ptr<const latin::Response>>& responses,
                              const Teuchos::Comm<int>& comm);

/// As files hold it.
results::MeshErrorRecord recordOf(const ResponseMeshError& error);

/// One estimate for the user: mesh about 9 % (towards 1500); refine bolt_1, head_1.
std::string describe(const ResponseMeshError& error, double value);

}  // namespace harmos::scene
