#include <harmos/laws/detail/FaceJoint.hpp>

#include <cmath>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Matrix.hpp>

namespace harmos::laws {
namespace {

/// Place of an entry of the symmetric matrix among the sums, i <= j.
int at(int i, int j) {
  return 6 + i * 6 - i * (i - 1) / 2 + (j - i);
}

double entry(const double* sums, int i, int j) {
  return sums[i <= j ? at(i, j) : at(j, i)];
}

}  // namespace

FaceJoint::FaceJoint(Kind kind, const FaceMotions& face, const base::Vector3& point, const base::Frame& axes,
                     double sign)
    : kind_(kind), face_(face), sign_(sign), used_(face.components()), motion_{}, unit_{} {
  for (const int i : used_) {
    const auto axis = static_cast<std::size_t>(i % 3);
    Six unit{};
    for (std::size_t c = 0; c < 3; ++c) unit[c + (i < 3 ? 0 : 3)] = axes[axis][c];
    unit_[static_cast<std::size_t>(i)] = face.divided(face.fromPoint(point, unit));
    if (kind == Kind::distributing) {
      motion_[static_cast<std::size_t>(i)] = unit_[static_cast<std::size_t>(i)];
      continue;
    }
    Six& motion = motion_[static_cast<std::size_t>(i)];
    motion = unit;
    if (i < 3) continue;
    const base::Vector3 shift = base::cross(axes[axis], face.centre() - point);
    for (std::size_t c = 0; c < 3; ++c) motion[c] = shift[c];
  }
}

std::array<base::Vector3, 6> FaceJoint::vectors(const base::Vector3& place) const {
  return fieldsAt(motion_, place);
}

std::array<base::Vector3, 6> FaceJoint::unitTractions(const base::Vector3& place) const {
  return fieldsAt(unit_, place);
}

std::array<base::Vector3, 6> FaceJoint::fieldsAt(const std::array<Six, 6>& fields, const base::Vector3& place) const {
  std::array<base::Vector3, 6> result{};
  for (const int i : used_) {
    result[static_cast<std::size_t>(i)] = sign_ * face_.at(fields[static_cast<std::size_t>(i)], place);
  }
  return result;
}

void FaceJoint::addToSums(const NodeArrays& nodes, double* sums) const {
  for (int p = 0; p < nodes.count; ++p) {
    const auto v = vectors(nodes.position[p]);
    const LocalLine& line = nodes.line[p];
    const bool isRigid = kind_ == Kind::rigid;
    const double ofJump = isRigid ? nodes.area[p] / line.compliance : nodes.area[p];
    const double ofMatrix = isRigid ? ofJump : nodes.area[p] * line.compliance;
    for (const int i : used_) {
      const base::Vector3& vi = v[static_cast<std::size_t>(i)];
      sums[i] += ofJump * base::dot(vi, line.freeJump);
      for (const int j : used_) {
        if (j >= i) sums[at(i, j)] += ofMatrix * base::dot(vi, v[static_cast<std::size_t>(j)]);
      }
    }
  }
}

FaceJoint::Six FaceJoint::solve(const Components& components, const double* sums) const {
  Six c{};
  std::vector<int> unknown;
  const bool isRigid = kind_ == Kind::rigid;
  for (const int i : used_) {
    const JointComponent& component = components[static_cast<std::size_t>(i)];
    const bool isKnown = isRigid ? std::isinf(component.stiffness) : component.stiffness == 0.0;
    if (isKnown) {
      c[static_cast<std::size_t>(i)] = isRigid ? component.value : component.force;
    } else {
      unknown.push_back(i);
    }
  }
  const int size = static_cast<int>(unknown.size());
  if (size == 0) return c;
  base::Matrix matrix(size, size), right(size, 1);
  for (int a = 0; a < size; ++a) {
    const int i = unknown[static_cast<std::size_t>(a)];
    const JointComponent& component = components[static_cast<std::size_t>(i)];
    for (int b = 0; b < size; ++b) matrix(a, b) = entry(sums, i, unknown[static_cast<std::size_t>(b)]);
    double known = 0.0;
    for (const int j : used_) known += entry(sums, i, j) * c[static_cast<std::size_t>(j)];
    if (isRigid) {
      matrix(a, a) += component.stiffness;
      right(a, 0) = component.force + component.stiffness * component.value - sums[i] - known;
    } else {
      matrix(a, a) += 1.0 / component.stiffness;
      right(a, 0) = component.value + component.force / component.stiffness + sums[i] - known;
    }
  }
  int info = 0;
  Teuchos::LAPACK<int, double>().POSV('U', size, 1, matrix.values(), matrix.stride(), right.values(), right.stride(),
                                      &info);
  // A line that is not finite is reported by whoever asks: the tractions are not finite then.
  if (info != 0 && std::isfinite(right.normInf())) throw base::Error("the motion of a face is not determined");
  for (int a = 0; a < size; ++a) c[static_cast<std::size_t>(unknown[static_cast<std::size_t>(a)])] = right(a, 0);
  return c;
}

FaceJoint::Six FaceJoint::motions(const double* sums, const Six& c) const {
  if (kind_ == Kind::rigid) return c;
  Six result{};
  for (const int i : used_) {
    double sum = -sums[i];
    for (const int j : used_) sum += entry(sums, i, j) * c[static_cast<std::size_t>(j)];
    result[static_cast<std::size_t>(i)] = sum;
  }
  return result;
}

void FaceJoint::meet(const NodeArrays& nodes, const Six& c) const {
  for (int p = 0; p < nodes.count; ++p) {
    const auto v = vectors(nodes.position[p]);
    base::Vector3 sum{};
    for (const int i : used_) sum = sum + c[static_cast<std::size_t>(i)] * v[static_cast<std::size_t>(i)];
    const LocalLine& line = nodes.line[p];
    const base::Vector3 traction = kind_ == Kind::rigid ? (1.0 / line.compliance) * (line.freeJump + sum) : sum;
    nodes.state[p] = {traction, Status::bonded};
  }
}

}  // namespace harmos::laws
