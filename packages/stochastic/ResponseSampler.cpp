#include <harmos/stochastic/ResponseSampler.hpp>

#include <algorithm>
#include <set>

namespace harmos::stochastic {
namespace {

// Points that are evaluated together: few enough for their fields to stay in the cache.
constexpr int chunk = 64;

/// (load steps x pairs x 3) x terms from vectors that stand by modal column and pair.
base::Matrix arranged(const std::vector<base::Vector3>& vectors, int steps, int pairs, int terms) {
  base::Matrix result(3 * steps * pairs, terms);
  const base::Vector3* from = vectors.data();
  for (int t = 0; t < steps; ++t) {
    for (int a = 0; a < terms; ++a) {
      double* to = result[a] + 3 * t * pairs;
      for (int p = 0; p < pairs; ++p, ++from) to = std::copy_n(from->begin(), 3, to);
    }
  }
  return result;
}

void copyVectors(const double* from, std::vector<base::Vector3>& to) {
  for (base::Vector3& vector : to) {
    std::copy_n(from, 3, vector.begin());
    from += 3;
  }
}

base::Matrix product(const base::Matrix& coefficients, const base::Matrix& polynomials, int first, int count) {
  const base::Matrix some(Teuchos::View, polynomials, polynomials.numRows(), count, 0, first);
  base::Matrix result(coefficients.numRows(), count);
  result.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, coefficients, some, 0.0);
  return result;
}

}  // namespace

ResponseSampler::ResponseSampler(const assembly::Assembly& assembly, const latin::Iterate& state,
                                 std::shared_ptr<const Projection> projection,
                                 std::vector<std::shared_ptr<const latin::Response>> responses)
    : assembly_(assembly), projection_(std::move(projection)), responses_(std::move(responses)) {
  const int terms = projection_->terms();
  const int steps = assembly.steps();
  std::set<int> interfaces;
  for (const auto& response : responses_) {
    linear_.emplace_back();
    if (const auto* onPairs = dynamic_cast<const latin::PairResponse*>(response.get())) {
      interfaces.insert(onPairs->interfaces().begin(), onPairs->interfaces().end());
      continue;
    }
    std::vector<double> values = response->evaluate(state);
    linear_.back() = base::Matrix(Teuchos::Copy, values.data(), terms, terms, steps);
  }
  for (const int i : interfaces) {
    const latin::PairFields fields = latin::pairFields(state, i);
    pairs_.push_back(
        {i, arranged(fields.traction, steps, fields.pairs, terms), arranged(fields.jump, steps, fields.pairs, terms)});
  }
}

const ResponseSampler::PairExpansion& ResponseSampler::expansionOf(int interfaceIndex) const {
  return *std::find_if(pairs_.begin(), pairs_.end(),
                       [&](const PairExpansion& one) { return one.interface == interfaceIndex; });
}

base::Matrix ResponseSampler::evaluate(int response, const base::Matrix& polynomials) const {
  const int steps = assembly_.steps();
  const int points = polynomials.numCols();
  base::Matrix result(steps, points);
  const base::Matrix& coefficients = linear_[response];
  if (coefficients.numRows() > 0) {
    result.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, coefficients, polynomials, 0.0);
    return result;
  }
  const auto& onPairs = static_cast<const latin::PairResponse&>(*responses_[response]);
  for (int first = 0; first < points; first += chunk) {
    const int count = std::min(chunk, points - first);
    std::vector<std::vector<double>> values(count, onPairs.begin(steps));
    for (const int i : onPairs.interfaces()) {
      const assembly::Interface& interface = assembly_.interfaces[i];
      const PairExpansion& expansion = expansionOf(i);
      const base::Matrix tractions = product(expansion.traction, polynomials, first, count);
      const base::Matrix jumps = product(expansion.jump, polynomials, first, count);
      latin::PairFields fields;
      fields.pairs = interface.pairs();
      fields.steps = steps;
      fields.times = assembly_.times;
      fields.traction.resize(static_cast<std::size_t>(steps) * static_cast<std::size_t>(interface.pairs()));
      fields.jump.resize(fields.traction.size());
      for (int s = 0; s < count; ++s) {
        copyVectors(tractions[s], fields.traction);
        copyVectors(jumps[s], fields.jump);
        onPairs.include(interface, fields, values[s]);
      }
    }
    for (int s = 0; s < count; ++s) {
      std::copy_n(onPairs.finish(std::move(values[s])).begin(), steps, result[first + s]);
    }
  }
  return result;
}

base::Matrix ResponseSampler::coefficients(int response) const {
  const base::Matrix& linear = linear_[response];
  if (linear.numRows() > 0) return linear;
  const base::Matrix values = evaluate(response, base::Matrix(projection_->values(), Teuchos::TRANS));
  base::Matrix result(projection_->terms(), assembly_.steps());
  result.multiply(Teuchos::NO_TRANS, Teuchos::TRANS, 1.0, projection_->projector(), values, 0.0);
  return result;
}

base::Matrix ResponseSampler::sample(int response, const std::vector<std::vector<double>>& germs) const {
  base::Matrix polynomials(projection_->terms(), static_cast<int>(germs.size()));
  for (std::size_t s = 0; s < germs.size(); ++s) {
    const std::vector<double> values = projection_->basis()->evaluate(germs[s]);
    std::copy(values.begin(), values.end(), polynomials[static_cast<int>(s)]);
  }
  return evaluate(response, polynomials);
}

}  // namespace harmos::stochastic
