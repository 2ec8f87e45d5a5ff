#include "Declaration.hpp"

#include <pybind11/stl.h>

namespace harmos::python_laws {

namespace py = pybind11;

namespace {

input::ParameterEntry& declared(input::ParameterSpec& spec, const std::string& kind, const std::string& name) {
  if (kind == "number") return spec.number(name);
  if (kind == "integer") return spec.integer(name);
  if (kind == "flag") return spec.flag(name);
  if (kind == "text") return spec.text(name);
  if (kind == "numbers") return spec.numbers(name);
  throw py::value_error("the parameter \"" + name + "\" is of no kind that there is");
}

void setDefault(input::ParameterEntry& entry, const std::string& kind, const py::object& value) {
  if (kind == "number") {
    entry.defaultValue(value.cast<double>());
  } else if (kind == "integer") {
    entry.defaultValue(value.cast<int>());
  } else if (kind == "flag") {
    entry.defaultValue(value.cast<bool>());
  } else {
    entry.defaultValue(value.cast<std::string>().c_str());
  }
}

void add(input::ParameterSpec& spec, const py::handle& entry) {
  const auto kind = entry.attr("kind").cast<std::string>();
  input::ParameterEntry& each = declared(spec, kind, entry.attr("name").cast<std::string>());
  each.unit(entry.attr("unit").cast<std::string>()).doc(entry.attr("doc").cast<std::string>());
  const py::object standard = entry.attr("default");
  if (!standard.is_none()) setDefault(each, kind, standard);
  if (entry.attr("optional").cast<bool>()) each.optional();
  if (entry.attr("varying").cast<bool>()) each.varying();
  const auto limit = [&](const char* name) { return entry.attr(name).cast<std::optional<double>>(); };
  if (const auto bound = limit("at_least")) each.atLeast(*bound);
  if (const auto bound = limit("above")) each.above(*bound);
  if (const auto bound = limit("at_most")) each.atMost(*bound);
  if (const auto bound = limit("below")) each.below(*bound);
  auto choices = entry.attr("choices").cast<std::vector<std::string>>();
  if (!choices.empty()) each.oneOf(std::move(choices));
}

/// The value at every load step for which there is a history, else one for all.
py::list perStep(const input::Parameters& parameters, const std::string& name) {
  const input::Schedule schedule = parameters.schedule(name);
  const std::string history = name + " History";
  const input::Histories histories = parameters.histories();
  const std::vector<double>* known = parameters.has(history) ? histories.find(parameters.text(history)) : nullptr;
  py::list values;
  for (std::size_t step = 0; step < (known == nullptr ? 1 : known->size()); ++step) {
    values.append(schedule[static_cast<int>(step)]);
  }
  return values;
}

}  // namespace

input::ParameterSpec specOf(const py::object& law) {
  input::ParameterSpec spec(law.attr("name").cast<std::string>());
  spec.summary(py::module_::import("inspect").attr("getdoc")(law).cast<std::string>());
  const auto source = law.attr("source").cast<std::string>(), equation = law.attr("equation").cast<std::string>();
  if (!source.empty()) spec.source(source);
  if (!equation.empty()) spec.equation(equation);
  for (const py::handle entry : law.attr("parameters")) add(spec, entry);
  for (const py::handle each : law.attr("outputs")) {
    spec.output(each.attr("name").cast<std::string>(), each.attr("unit").cast<std::string>(),
                each.attr("doc").cast<std::string>());
  }
  return spec;
}

py::dict valuesOf(const py::object& law, const input::Parameters& parameters) {
  py::dict values;
  for (const py::handle entry : law.attr("parameters")) {
    const auto name = entry.attr("name").cast<std::string>(), kind = entry.attr("kind").cast<std::string>();
    if (!parameters.has(name)) continue;
    if (kind == "number" && entry.attr("varying").cast<bool>()) {
      values[name.c_str()] = perStep(parameters, name);
    } else if (kind == "number") {
      values[name.c_str()] = parameters.number(name);
    } else if (kind == "integer") {
      values[name.c_str()] = parameters.integer(name);
    } else if (kind == "flag") {
      values[name.c_str()] = parameters.flag(name);
    } else if (kind == "text") {
      values[name.c_str()] = parameters.text(name);
    } else {
      values[name.c_str()] = parameters.numbers(name);
    }
  }
  return values;
}

}  // namespace harmos::python_laws
