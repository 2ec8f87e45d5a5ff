#include <harmos/latin/InterfaceLines.hpp>

#include <type_traits>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Tensor3.hpp>

namespace harmos::latin {
namespace {

/// Calls with the dimension as a constant, so that loops over components are no loops.
template <class Call>
void withDimension(int dimension, const Call& call) {
  if (dimension == 3) {
    call(std::integral_constant<int, 3>());
  } else {
    call(std::integral_constant<int, 2>());
  }
}

}  // namespace

template <int dimension>
base::Vector3 InterfaceLines::Sides::difference(int pair) const {
  base::Vector3 result{};
  for (int c = 0; c < dimension; ++c) {
    result[c] = first[pair * dimension + c] - (second != nullptr ? second[pair * dimension + c] : 0.0);
  }
  return result;
}

InterfaceLines::InterfaceLines(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                               const TraceLayout& layout)
    : assembly_(assembly), searchDirection_(searchDirection), layout_(layout) {
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    Joint joint;
    joint.begin1 = layout.begin(static_cast<int>(i), 0);
    joint.begin2 = layout.begin(static_cast<int>(i), 1);
    joint.active = joint.begin1 >= 0 || joint.begin2 >= 0;
    if (joint.active && interface.sides() == 2 && (joint.begin1 < 0 || joint.begin2 < 0)) {
      joint.neighbour = assembly.ownerOf(joint.begin1 < 0 ? interface.body1 : interface.body2);
    }
    joints_.push_back(std::move(joint));
  }
}

void InterfaceLines::reserve(int columns) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].neighbour < 0) continue;
    joints_[i].remote.resize(static_cast<std::size_t>(of(static_cast<int>(i)).pairs() * layout_.dimension()) *
                             static_cast<std::size_t>(columns));
  }
}

void InterfaceLines::exchange(const base::Matrix& beta, int first, int count) {
  if (layout_.comm().getSize() == 1) return;
  // Every rank visits the interfaces in the same order, so the messages between two ranks match without tags.
  std::vector<std::vector<double>> sent;
  Teuchos::Array<Teuchos::RCP<Teuchos::CommRequest<int>>> requests;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    Joint& joint = joints_[i];
    if (joint.neighbour < 0) continue;
    const int begin = joint.begin1 >= 0 ? joint.begin1 : joint.begin2;
    const int rows = of(static_cast<int>(i)).pairs() * layout_.dimension();
    std::vector<double> buffer(static_cast<std::size_t>(rows) * static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t) std::copy_n(beta[first + t] + begin, rows, buffer.begin() + t * rows);
    sent.push_back(std::move(buffer));
    const auto received = Teuchos::arrayViewFromVector(joint.remote).view(first * rows, count * rows);
    requests.push_back(
        Teuchos::ireceive<int, double>(layout_.comm(), Teuchos::arcpFromArrayView(received), joint.neighbour));
    requests.push_back(Teuchos::isend<int, double>(
        layout_.comm(), Teuchos::arcpFromArrayView(Teuchos::arrayViewFromVector(sent.back())), joint.neighbour));
  }
  Teuchos::waitAll(layout_.comm(), requests());
}

InterfaceLines::Sides InterfaceLines::betas(int interfaceIndex, int column, const base::Matrix& beta) const {
  const assembly::Interface& interface = of(interfaceIndex);
  const Joint& joint = joints_[interfaceIndex];
  const double* remote =
      joint.remote.data() + static_cast<std::size_t>(column) * interface.pairs() * layout_.dimension();
  Sides result{joint.begin1 >= 0 ? beta[column] + joint.begin1 : remote, nullptr};
  if (interface.sides() == 2) result.second = joint.begin2 >= 0 ? beta[column] + joint.begin2 : remote;
  return result;
}

template <class OfPair>
void InterfaceLines::put(int interfaceIndex, const OfPair& t, double* traction) const {
  const Joint& joint = joints_[interfaceIndex];
  double* const first = joint.begin1 >= 0 ? traction + joint.begin1 : nullptr;
  double* const second = joint.begin2 >= 0 ? traction + joint.begin2 : nullptr;
  const int pairs = of(interfaceIndex).pairs();
  withDimension(layout_.dimension(), [&](auto dimension) {
    for (int p = 0; p < pairs; ++p) {
      const base::Vector3 here = t(p);
      for (int c = 0; c < dimension; ++c) {
        if (first != nullptr) first[p * dimension + c] = here[c];
        if (second != nullptr) second[p * dimension + c] = -here[c];
      }
    }
  });
}

void InterfaceLines::fill(int interfaceIndex, int column, const base::Matrix& beta,
                          std::vector<laws::LocalLine>& lines) const {
  const assembly::Interface& interface = of(interfaceIndex);
  const std::vector<double>& k = searchDirection_.of(interfaceIndex);
  const int pairs = interface.pairs();
  const bool local = interface.law->frame() == laws::Frame::interface;
  const Sides sides = betas(interfaceIndex, column, beta);
  const double count = interface.sides();
  lines.resize(pairs);
  withDimension(layout_.dimension(), [&](auto dimension) {
    for (int p = 0; p < pairs; ++p) {
      const double compliance = 1.0 / k[p];
      const base::Vector3 free = compliance * sides.difference<dimension>(p);
      laws::LocalLine& line = lines[p];
      line.compliance = count * compliance;
      line.freeJump = local ? base::toFrame(interface.frame[p], free) : free;
    }
  });
}

double InterfaceLines::write(int interfaceIndex, const laws::LocalState* states, double* traction) const {
  const assembly::Interface& interface = of(interfaceIndex);
  const bool local = interface.law->frame() == laws::Frame::interface;
  double check = 0.0;
  put(
      interfaceIndex,
      [&](int p) {
        const base::Vector3& f = states[p].traction;
        check += f[0] + f[1] + f[2];
        return local ? base::toGlobal(interface.frame[p], f) : f;
      },
      traction);
  return check;
}

void InterfaceLines::map(int interfaceIndex, const std::vector<base::Frame>& matrices, int column,
                         const base::Matrix& beta, double* traction) const {
  const Sides sides = betas(interfaceIndex, column, beta);
  withDimension(layout_.dimension(), [&](auto dimension) {
    put(
        interfaceIndex, [&](int p) { return base::product(matrices[p], sides.difference<dimension>(p)); }, traction);
  });
}

}  // namespace harmos::latin
