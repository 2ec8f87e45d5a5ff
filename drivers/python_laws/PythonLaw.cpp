#include "PythonLaw.hpp"

#include <algorithm>
#include <array>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/laws/NoIntersection.hpp>

#include "Interpreter.hpp"

namespace harmos::python_laws {

namespace py = pybind11;

namespace {

using Array = py::array_t<double, py::array::c_style>;

constexpr auto number = static_cast<py::ssize_t>(sizeof(double));

/// A copy of `count` rows that lie `stride` bytes apart; zeros where there are none.
Array copied(const double* first, py::ssize_t count, py::ssize_t columns, py::ssize_t stride) {
  Array rows({count, columns});
  double* const to = rows.mutable_data();
  const char* from = reinterpret_cast<const char*>(first);
  for (py::ssize_t i = 0; i < count; ++i, from += stride) {
    if (first == nullptr) {
      std::fill_n(to + i * columns, columns, 0.0);
    } else {
      std::copy_n(reinterpret_cast<const double*>(from), columns, to + i * columns);
    }
  }
  return rows;
}

Array copied(const double* first, py::ssize_t count, py::ssize_t columns) {
  return copied(first, count, columns, columns * number);
}

Array row(const base::Vector3& vector) {
  return copied(vector.data(), 1, 3);
}

py::object column(const Array& rows) {
  return rows.attr("reshape")(-1);
}

/// harmos.laws.Where.
py::object where(int step, double time, double duration, const Array& gap, const Array& position, const Array& frame,
                 const Array& area, const py::object& numbers) {
  return py::module_::import("harmos.laws.law")
      .attr("Where")(step, time, duration, column(gap), position, frame.attr("reshape")(-1, 3, 3), column(area),
                     numbers);
}

py::object where(int step, const laws::NodeArrays& nodes) {
  const py::ssize_t n = nodes.count;
  const auto first = [](const auto* rows) { return rows == nullptr ? nullptr : rows->data(); };
  py::array_t<int> numbers(n);
  for (py::ssize_t i = 0; i < n; ++i) {
    numbers.mutable_at(i) = nodes.number == nullptr ? static_cast<int>(i) : nodes.number[i];
  }
  const double* const frame = nodes.frame == nullptr ? nullptr : (*nodes.frame)[0].data();
  return where(step, nodes.time, nodes.duration, copied(nodes.gap, n, 1), copied(first(nodes.position), n, 3),
               copied(frame, n, 9), copied(nodes.area, n, 1), numbers);
}

py::object where(const laws::NodeContext& at) {
  const double gap = at.gap, area = at.area();
  const base::Vector3 place = at.position();
  py::array_t<int> numbers(1);
  numbers.mutable_at(0) = at.number();
  return where(at.step, at.time(), at.duration(), copied(&gap, 1, 1), copied(place.data(), 1, 3),
               copied(at.frame()[0].data(), 1, 9), copied(&area, 1, 1), numbers);
}

laws::Sides sidesOf(const std::string& text) {
  if (text == "two") return laws::Sides::two;
  return text == "one" ? laws::Sides::one : laws::Sides::any;
}

/// Whether the class has a method of its own.
bool overrides(const py::object& law, const char* method) {
  return !py::type::of(law).attr(method).is(py::module_::import("harmos.laws.law").attr("Law").attr(method));
}

base::Vector3 vectorOf(const py::handle& numbers) {
  const auto three = numbers.cast<std::array<double, 3>>();
  return {three[0], three[1], three[2]};
}

}  // namespace

PythonLaw::PythonLaw(const py::object& object, std::string file)
    : object_(kept(object)),
      file_(std::move(file)),
      name_(object_->attr("name").cast<std::string>()),
      historySize_(object_->attr("history").cast<int>()),
      frame_(object_->attr("frame").cast<std::string>() == "global" ? laws::Frame::global : laws::Frame::interface),
      sides_(sidesOf(object_->attr("sides").cast<std::string>())),
      dissipates_(object_->attr("dissipates").cast<bool>()),
      isAffine_(object_->attr("affine").cast<bool>()),
      isSmooth_(object_->attr("smooth").cast<bool>()),
      keepsWork_(overrides(*object_, "kept_work")),
      storesEnergy_(overrides(*object_, "stored_energy")),
      lowestSlope_(object_->attr("lowest_slope").cast<double>()) {
  for (const py::handle each : object_->attr("outputs")) {
    outputs_.push_back({each.attr("name").cast<std::string>(), each.attr("unit").cast<std::string>(),
                        each.attr("doc").cast<std::string>()});
  }
}

std::vector<double> PythonLaw::stepped(const char* what, const laws::PairStep& step, std::size_t count) const {
  const py::gil_scoped_acquire lock;
  try {
    const py::object given = py::module_::import("harmos.laws.law")
                                 .attr("Step")(row(step.oldJump), row(step.jump), row(step.traction),
                                               copied(step.oldHistory, 1, historySize_),
                                               copied(step.history, 1, historySize_), where(step.at));
    const auto found = bridge("stepped")(*object_, what, given).cast<Array>();
    return {found.data(), found.data() + count};
  } catch (const py::error_already_set& error) {
    throw base::Error("law " + base::quoted(name_) + " raises " + reasonOf(error, file_) + ".");
  }
}

double PythonLaw::keptWork(const laws::PairStep& step) const {
  return keepsWork_ ? stepped("kept_work", step, 1)[0] : 0.0;
}

double PythonLaw::storedEnergy(const laws::PairStep& step) const {
  return storesEnergy_ ? stepped("stored_energy", step, 1)[0] : 0.0;
}

void PythonLaw::output(const laws::PairStep& step, double* values) const {
  if (outputs_.empty()) return;
  const std::vector<double> found = stepped("output", step, outputs_.size());
  std::copy(found.begin(), found.end(), values);
}

std::optional<laws::AdmissibleTractions> PythonLaw::admissibleTractions(int step) const {
  const py::gil_scoped_acquire lock;
  try {
    const py::object given = object_->attr("admissible")(step);
    if (given.is_none()) return std::nullopt;
    const auto parts = given.cast<py::tuple>();
    laws::AdmissibleTractions admissible;
    admissible.lower = vectorOf(parts[0]);
    admissible.upper = vectorOf(parts[1]);
    admissible.friction = parts[2].cast<double>();
    return admissible;
  } catch (const py::error_already_set& error) {
    throw base::Error("law " + base::quoted(name_) + " raises " + reasonOf(error, file_) + ".");
  } catch (const py::cast_error&) {
    throw base::Error("law " + base::quoted(name_) +
                      " must give from admissible() three numbers, three numbers and a number, or None.");
  }
}

void PythonLaw::solve(int step, const laws::NodeArrays& nodes) const {
  if (nodes.count == 0) return;
  const py::gil_scoped_acquire lock;
  constexpr auto line = static_cast<py::ssize_t>(sizeof(laws::LocalLine));
  const py::ssize_t n = nodes.count;
  try {
    const py::tuple found =
        bridge("solved")(*object_, where(step, nodes), copied(nodes.line->freeJump.data(), n, 3, line),
                         copied(&nodes.line->compliance, n, 1, line), copied(nodes.oldHistory, n, historySize_));
    const auto traction = found[0].cast<Array>(), history = found[1].cast<Array>();
    const auto status = found[2].cast<py::array_t<int>>();
    for (py::ssize_t i = 0; i < n; ++i) {
      nodes.state[i] = {{traction.at(i, 0), traction.at(i, 1), traction.at(i, 2)},
                        static_cast<laws::Status>(status.at(i))};
    }
    if (historySize_ > 0) std::copy_n(history.data(), n * historySize_, nodes.newHistory);
  } catch (const py::error_already_set& error) {
    const int missed = bridge("missed_point")(error.value()).cast<int>();
    if (missed >= 0 && missed < nodes.count) {
      const std::string why = py::str(error.value());
      throw laws::NoIntersection(nodes.line[missed], laws::NodeContext(step, nodes, missed), why);
    }
    throw laws::LawFailure("raises " + reasonOf(error, file_) + ".");
  }
}

}  // namespace harmos::python_laws
