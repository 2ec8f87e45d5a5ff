#pragma once

#include <memory>
#include <vector>

#include <harmos/latin/Response.hpp>
#include <harmos/stochastic/Projection.hpp>

namespace harmos::stochastic {

/// Responses as functions of the germs, from the coefficients of the fields: no solve.
///
/// Responses that are linear in the fields have the coefficients of the fields. Those on interface fields are evaluated
/// point by point from the expansions of tractions and jumps of the local stage, complete on every rank.
class ResponseSampler {
 public:
  /// Collective. `state`: on all modal columns, of which nothing is kept; `assembly` is the one of the load steps and
  /// must outlive this object.
  ResponseSampler(const assembly::Assembly& assembly, const latin::Iterate& state,
                  std::shared_ptr<const Projection> projection,
                  std::vector<std::shared_ptr<const latin::Response>> responses);

  /// Of a response, counted from 0, terms x load steps in its unit; of responses on interface fields by the quadrature.
  base::Matrix coefficients(int response) const;
  /// Of a response at points of germs, load steps x points in its unit. Not collective.
  base::Matrix sample(int response, const std::vector<std::vector<double>>& germs) const;

 private:
  struct PairExpansion {
    int interface = -1;
    base::Matrix traction, jump;  // (load steps x pairs x 3) x terms
  };

  /// Of one response where the polynomials have the given values, terms x points.
  base::Matrix evaluate(int response, const base::Matrix& polynomials) const;
  const PairExpansion& expansionOf(int interfaceIndex) const;

  const assembly::Assembly& assembly_;
  std::shared_ptr<const Projection> projection_;
  std::vector<std::shared_ptr<const latin::Response>> responses_;
  std::vector<base::Matrix> linear_;  // coefficients, terms x load steps; empty when the response is not linear
  std::vector<PairExpansion> pairs_;
};

}  // namespace harmos::stochastic
