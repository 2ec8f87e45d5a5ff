#include <harmos/latin/InterfaceLines.hpp>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Tensor3.hpp>

namespace harmos::latin {
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

void InterfaceLines::put(const Joint& joint, int pair, const base::Vector3& t, double* traction) const {
  const int dimension = layout_.dimension();
  for (int c = 0; c < dimension; ++c) {
    if (joint.begin1 >= 0) traction[joint.begin1 + pair * dimension + c] = t[c];
    if (joint.begin2 >= 0) traction[joint.begin2 + pair * dimension + c] = -t[c];
  }
}

void InterfaceLines::fill(int interfaceIndex, int column, const base::Matrix& beta,
                          std::vector<laws::LocalLine>& lines) const {
  const assembly::Interface& interface = of(interfaceIndex);
  const std::vector<double>& k = searchDirection_.of(interfaceIndex);
  const int dimension = layout_.dimension();
  const int pairs = interface.pairs();
  const bool local = interface.law->frame() == laws::Frame::interface;
  const auto [beta1, beta2] = betas(interfaceIndex, column, beta);
  const double sides = interface.sides();
  lines.resize(pairs);
  for (int p = 0; p < pairs; ++p) {
    const double compliance = 1.0 / k[p];
    base::Vector3 free{};
    for (int c = 0; c < dimension; ++c) {
      const double b2 = beta2 != nullptr ? beta2[p * dimension + c] : 0.0;
      free[c] = compliance * (beta1[p * dimension + c] - b2);
    }
    laws::LocalLine& line = lines[p];
    line.compliance = sides * compliance;
    line.freeJump = local ? base::toFrame(interface.frame[p], free) : free;
  }
}

double InterfaceLines::write(int interfaceIndex, const laws::LocalState* states, double* traction) const {
  const assembly::Interface& interface = of(interfaceIndex);
  const bool local = interface.law->frame() == laws::Frame::interface;
  double check = 0.0;
  for (int p = 0; p < interface.pairs(); ++p) {
    const base::Vector3& f = states[p].traction;
    check += f[0] + f[1] + f[2];
    put(joints_[interfaceIndex], p, local ? base::toGlobal(interface.frame[p], f) : f, traction);
  }
  return check;
}

void InterfaceLines::map(int interfaceIndex, const std::vector<base::Frame>& matrices, int column,
                         const base::Matrix& beta, double* traction) const {
  const int dimension = layout_.dimension();
  const auto [beta1, beta2] = betas(interfaceIndex, column, beta);
  for (std::size_t p = 0; p < matrices.size(); ++p) {
    const auto first = static_cast<std::ptrdiff_t>(p) * dimension;
    base::Vector3 difference{};
    for (int c = 0; c < dimension; ++c) {
      difference[c] = beta1[first + c] - (beta2 != nullptr ? beta2[first + c] : 0.0);
    }
    put(joints_[interfaceIndex], static_cast<int>(p), base::product(matrices[p], difference), traction);
  }
}

}  // namespace harmos::latin
