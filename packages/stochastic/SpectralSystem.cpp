#include <harmos/stochastic/SpectralSystem.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <harmos/base/Error.hpp>
#include <harmos/latin/InterfaceMass.hpp>
#include <harmos/latin/PrescribedForces.hpp>
#include <harmos/probability/GalerkinMatrix.hpp>
#include <harmos/stochastic/AffineComponents.hpp>
#include <harmos/stochastic/detail/ProjectedLaw.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::stochastic {
namespace {

// Entries of a Galerkin matrix below this share of its norm are zero but for round-off.
constexpr double negligible = 1e-12;
constexpr double straight = 1e-9;

[[noreturn]] void refuse(const assembly::Interface& interface, const std::string& why) {
  throw base::Error("interface \"" + interface.name + "\": the direct spectral method " + why, base::ExitCode::input);
}

/// Direction of a component of the law at a pair, global components.
base::Vector3 axisOf(const assembly::Interface& interface, std::size_t component, std::size_t pair) {
  if (interface.law->frame() == laws::Frame::interface) return interface.frame[pair][component];
  base::Vector3 axis{};
  axis[component] = 1.0;
  return axis;
}

std::vector<mesh::MassEntry> massOf(const assembly::Interface& interface) {
  if (!interface.mass.empty()) return interface.mass;
  std::vector<mesh::MassEntry> lumped;
  for (int p = 0; p < interface.pairs(); ++p) lumped.push_back({p, p, interface.area[p]});
  return lumped;
}

}  // namespace

SpectralSystem::SpectralSystem(const assembly::Assembly& assembly, const std::shared_ptr<const Projection>& projection,
                               const Realisations& laws)
    : dimension_(assembly.dimension), terms_(projection->terms()), steps_(assembly.steps()) {
  for (const substructure::Substructure& body : assembly.bodies) {
    firstDof_.push_back(dofs_);
    dofs_ += dimension_ * static_cast<int>(body.nodes.size());
  }
  isHeld_.assign(dofs_, 0);
  held_.shape(dofs_ * terms_, steps_);
  right_.shape(dofs_ * terms_, steps_);
  std::vector<Entry> entries;
  addBodies(assembly, entries);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    std::vector<std::shared_ptr<const laws::InterfaceLaw>> realisations;
    for (const auto& point : laws) realisations.push_back(point[i]);
    if (interface.law->prescribesTraction()) {
      assembly::Interface boundary = interface;
      boundary.law = std::make_shared<ProjectedLaw>(std::move(realisations), projection);
      addLoads(boundary, assembly.times);
    } else {
      addInterface(interface, realisations, *projection, entries);
    }
  }
  constant_ = compressed(std::move(entries));

  std::vector<double> product(right_.numRows());
  for (int t = 0; t < steps_; ++t) {
    applyFree(held_[t], product.data());
    for (int i = 0; i < right_.numRows(); ++i) {
      const bool isHeld = isHeld_[i / terms_] != 0;
      right_[t][i] = isHeld ? held_[t][i] : right_[t][i] - product[i];
    }
  }
}

double& SpectralSystem::at(base::Matrix& vectors, int dof, int column) const {
  return vectors[column / terms_][dof * terms_ + column % terms_];
}

SpectralSystem::Rows SpectralSystem::compressed(std::vector<Entry> entries) {
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return std::tie(a.row, a.column) < std::tie(b.row, b.column); });
  Rows rows;
  const Entry* last = nullptr;
  for (const Entry& entry : entries) {
    const bool isNewRow = last == nullptr || last->row != entry.row;
    if (isNewRow) {
      rows.number.push_back(entry.row);
      rows.begin.push_back(rows.column.size());
    }
    if (isNewRow || last->column != entry.column) {
      rows.column.push_back(entry.column);
      rows.value.push_back(entry.value);
    } else {
      rows.value.back() += entry.value;
    }
    last = &entry;
  }
  rows.begin.push_back(rows.column.size());
  return rows;
}

Teuchos::RCP<base::CrsMatrix> SpectralSystem::crsMatrix(std::vector<Entry> entries) {
  const Rows rows = compressed(std::move(entries));
  return substructure::makeCrsMatrix(rows.begin, rows.column, rows.value);
}

void SpectralSystem::addBodies(const assembly::Assembly& assembly, std::vector<Entry>& entries) {
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const substructure::Substructure& body = assembly.bodies[b];
    if (body.stiffness.is_null()) {
      throw base::Error("part \"" + body.partName() +
                            "\": the direct spectral method runs on one process and does not " +
                            "share operators between congruent parts",
                        base::ExitCode::input);
    }
    const substructure::CrsView view = substructure::viewOf(*body.stiffness, body.partName());
    const int first = firstDof_[b];
    for (int row = 0; row < view.rows; ++row) {
      for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k) {
        entries.push_back({first + row, first + view.columns[k], view.values[k]});
      }
    }
    for (int t = 0; t < body.loads.numCols(); ++t) {
      for (int row = 0; row < body.loads.numRows(); ++row) at(right_, first + row, t * terms_) += body.loads(row, t);
    }
  }
}

void SpectralSystem::addLoads(const assembly::Interface& boundary, const std::vector<double>& times) {
  std::vector<double> modal;
  for (const double time : times) modal.insert(modal.end(), terms_, time);
  for (int column = 0; column < steps_ * terms_; ++column) {
    const std::vector<double> force = latin::prescribedForces(boundary, modal, dimension_, column);
    for (int p = 0; p < boundary.pairs(); ++p) {
      for (const auto& [node, weight] : boundary.trace1.row(p)) {
        for (int c = 0; c < dimension_; ++c) {
          at(right_, dofOf(boundary.body1, node) + c, column) += weight * force[p * dimension_ + c];
        }
      }
    }
  }
}

std::vector<SpectralSystem::Entry> SpectralSystem::springs(const assembly::Interface& interface,
                                                           std::size_t component) const {
  std::vector<Entry> entries;
  for (const mesh::MassEntry& mass : massOf(interface)) {
    const auto r = static_cast<std::size_t>(mass.row), s = static_cast<std::size_t>(mass.column);
    const base::Vector3 rowAxis = axisOf(interface, component, r), columnAxis = axisOf(interface, component, s);
    for (std::size_t c = 0; c < 3; ++c) {
      if (std::abs(rowAxis[c] - columnAxis[c]) > straight) refuse(interface, "takes a consistent mass on planes only");
    }
    for (int side = 0; side < interface.sides(); ++side) {
      for (int other = 0; other < interface.sides(); ++other) {
        const double sign = side == other ? 1.0 : -1.0;
        for (const auto& [rowNode, rowWeight] : interface.trace(side).row(mass.row)) {
          for (const auto& [columnNode, columnWeight] : interface.trace(other).row(mass.column)) {
            const int row = dofOf(interface.body(side), rowNode);
            const int column = dofOf(interface.body(other), columnNode);
            for (int a = 0; a < dimension_; ++a) {
              for (int b = 0; b < dimension_; ++b) {
                const double value = sign * rowWeight * columnWeight * mass.value * rowAxis[a] * columnAxis[b];
                if (value != 0.0) entries.push_back({row + a, column + b, value});
              }
            }
          }
        }
      }
    }
  }
  return entries;
}

void SpectralSystem::addOffset(const assembly::Interface& interface, std::size_t component, int column,
                               double traction) {
  for (const mesh::MassEntry& mass : massOf(interface)) {
    const base::Vector3 axis = axisOf(interface, component, static_cast<std::size_t>(mass.column));
    for (int side = 0; side < interface.sides(); ++side) {
      for (const auto& [node, weight] : interface.trace(side).row(mass.row)) {
        const int dof = dofOf(interface.body(side), node);
        for (int c = 0; c < dimension_; ++c) {
          const double force = weight * mass.value * traction * axis[c];
          at(right_, dof + c, column) += side == 0 ? force : -force;
        }
      }
    }
  }
}

void SpectralSystem::hold(const assembly::Interface& interface, std::size_t component, int column, double jump) {
  if (interface.sides() != 1) refuse(interface, "does not treat rigid joints of two bodies");
  if (!interface.trace1.isSelection()) refuse(interface, "holds nodes, no means of several nodes");
  for (int p = 0; p < interface.pairs(); ++p) {
    const base::Vector3 axis = axisOf(interface, component, static_cast<std::size_t>(p));
    for (int c = 0; c < dimension_; ++c) {
      const double cosine = axis[c];
      if (std::abs(cosine) <= straight) continue;
      if (std::abs(cosine) < 1.0 - straight) refuse(interface, "holds boundaries along the axes only");
      const int dof = dofOf(interface.body1, interface.trace1.node(p)) + c;
      isHeld_[dof] = 1;
      // The ground is at rest: the jump is -w1.
      at(held_, dof, column) = -jump * cosine;
    }
  }
}

void SpectralSystem::addInterface(const assembly::Interface& interface,
                                  const std::vector<std::shared_ptr<const laws::InterfaceLaw>>& laws,
                                  const Projection& projection, std::vector<Entry>& entries) {
  // Any length: the law's stiffness does not depend on the line.
  const double compliance = 1.0;
  std::vector<double> stiffness[3];
  for (int t = 0; t < steps_; ++t) {
    for (std::size_t q = 0; q < laws.size(); ++q) {
      const auto components = affineComponents(*laws[q], t, compliance, interface.name);
      for (std::size_t c = 0; c < 3; ++c) {
        const double k = components[c].stiffness;
        if (t == 0) {
          stiffness[c].push_back(k);
        } else if (!areSame({stiffness[c][q], k})) {
          refuse(interface, "takes a stiffness that is constant in time");
        }
        for (int a = 0; a < terms_; ++a) {
          const double share = projection.projector()(a, static_cast<int>(q)) * components[c].offset;
          if (!std::isinf(k) && share != 0.0) addOffset(interface, c, t * terms_ + a, share);
        }
      }
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const bool isRandom = !areSame(stiffness[c]);
    if (!isRandom && std::isinf(stiffness[c][0])) {
      for (int t = 0; t < steps_; ++t) {
        std::vector<double> jump(terms_, 0.0);
        for (std::size_t q = 0; q < laws.size(); ++q) {
          const double value = affineComponents(*laws[q], t, compliance, interface.name)[c].offset;
          for (int a = 0; a < terms_; ++a) {
            jump[a] += projection.projector()(a, static_cast<int>(q)) * value;
          }
        }
        for (int a = 0; a < terms_; ++a) hold(interface, c, t * terms_ + a, jump[a]);
      }
      continue;
    }
    std::vector<Entry> unit = springs(interface, c);
    if (isRandom) {
      random_.push_back({compressed(std::move(unit)),
                         probability::galerkinMatrix(*projection.basis(), projection.quadrature(), stiffness[c])});
    } else {
      for (const Entry& entry : unit) entries.push_back({entry.row, entry.column, stiffness[c][0] * entry.value});
    }
  }
}

void SpectralSystem::applyFree(const double* x, double* y) const {
  std::fill_n(y, static_cast<std::size_t>(dofs_) * static_cast<std::size_t>(terms_), 0.0);
  const auto addRow = [&](const Rows& rows, std::size_t i, double* sum) {
    for (std::size_t k = rows.begin[i]; k < rows.begin[i + 1]; ++k) {
      const double* from = x + rows.column[k] * terms_;
      for (int a = 0; a < terms_; ++a) sum[a] += rows.value[k] * from[a];
    }
  };
  for (std::size_t i = 0; i < constant_.number.size(); ++i) addRow(constant_, i, y + constant_.number[i] * terms_);
  std::vector<double> sum(terms_);
  for (const Random& random : random_) {
    for (std::size_t i = 0; i < random.matrix.number.size(); ++i) {
      std::fill(sum.begin(), sum.end(), 0.0);
      addRow(random.matrix, i, sum.data());
      double* to = y + random.matrix.number[i] * terms_;
      for (int b = 0; b < terms_; ++b) {
        for (int a = 0; a < terms_; ++a) to[a] += random.galerkin(a, b) * sum[b];
      }
    }
  }
}

void SpectralSystem::apply(const double* x, double* y) const {
  std::vector<double> free(x, x + static_cast<std::ptrdiff_t>(dofs_) * terms_);
  const auto forHeld = [&](const auto& action) {
    for (int dof = 0; dof < dofs_; ++dof) {
      if (isHeld_[dof] != 0) action(dof * terms_);
    }
  };
  forHeld([&](int first) { std::fill_n(free.begin() + first, terms_, 0.0); });
  applyFree(free.data(), y);
  forHeld([&](int first) { std::copy_n(x + first, terms_, y + first); });
}

Teuchos::RCP<base::CrsMatrix> SpectralSystem::meanMatrix() const {
  std::vector<Entry> entries;
  const auto add = [&](const Rows& rows, double factor) {
    for (std::size_t i = 0; i < rows.number.size(); ++i) {
      if (isHeld_[rows.number[i]] != 0) continue;
      for (std::size_t k = rows.begin[i]; k < rows.begin[i + 1]; ++k) {
        if (isHeld_[rows.column[k]] != 0) continue;
        entries.push_back({rows.number[i], rows.column[k], factor * rows.value[k]});
      }
    }
  };
  add(constant_, 1.0);
  for (const Random& random : random_) add(random.matrix, random.galerkin(0, 0));
  for (int dof = 0; dof < dofs_; ++dof) {
    if (isHeld_[dof] != 0) entries.push_back({dof, dof, 1.0});
  }
  return crsMatrix(std::move(entries));
}

Teuchos::RCP<base::CrsMatrix> SpectralSystem::wholeMatrix() const {
  std::vector<Entry> entries;
  const auto add = [&](const Rows& rows, const base::Matrix* galerkin) {
    for (std::size_t i = 0; i < rows.number.size(); ++i) {
      if (isHeld_[rows.number[i]] != 0) continue;
      for (std::size_t k = rows.begin[i]; k < rows.begin[i + 1]; ++k) {
        if (isHeld_[rows.column[k]] != 0) continue;
        for (int a = 0; a < terms_; ++a) {
          for (int b = 0; b < terms_; ++b) {
            const double factor = galerkin != nullptr ? (*galerkin)(a, b) : a == b ? 1.0 : 0.0;
            if (std::abs(factor) <= negligible * (galerkin != nullptr ? galerkin->normInf() : 0.0)) continue;
            entries.push_back({rows.number[i] * terms_ + a, rows.column[k] * terms_ + b, factor * rows.value[k]});
          }
        }
      }
    }
  };
  add(constant_, nullptr);
  for (const Random& random : random_) add(random.matrix, &random.galerkin);
  for (int dof = 0; dof < dofs_; ++dof) {
    for (int a = 0; a < terms_ && isHeld_[dof] != 0; ++a) {
      entries.push_back({dof * terms_ + a, dof * terms_ + a, 1.0});
    }
  }
  return crsMatrix(std::move(entries));
}

}  // namespace harmos::stochastic
