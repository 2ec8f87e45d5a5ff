#include <harmos/laws/detail/FormulaGraph.hpp>

#include <algorithm>
#include <limits>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/input/ErrorList.hpp>

namespace harmos::laws {

namespace {

const std::array<const char*, 3> entries = {"Normal Traction", "Tangential Traction 1", "Tangential Traction 2"};
const std::array<const char*, 3> examples = {"500 * jump_n", "200 * jump_1", "200 * jump_2"};

// The first slots of every formula.
enum Slot : std::size_t { jumpN, jump1, jump2, gap, placeX, placeY, placeZ, time, duration, firstHistory };
const std::array<const char*, firstHistory> places = {"jump_n", "jump_1", "jump_2", "gap", "x", "y", "z", "t", "dt"};

const std::string oldSuffix = "_old";

}  // namespace

void FormulaGraph::describe(input::ParameterSpec& spec) {
  const char* const what =
      " as a formula in jump_n, jump_1, jump_2, gap, x, y, z [length], t, dt (end and duration of the load step "
      "[time]), the Constants, the Fields, and of every entry of History its value at the end of this load step and, "
      "with _old behind its name, of the one before.";
  for (std::size_t i = 0; i < entries.size(); ++i) {
    spec.text(entries[i]).example(examples[i]).defaultValue("0").doc("Traction on side 1 [stress]" + std::string(what));
  }
  spec.namedNumbers("Constants").summary("Numbers that the formulas use by name; a study may vary them.");
  spec.texts("Fields").optional().doc(
      "Entries of the list Fields of the scene, such as {coating}, that the formulas use by name, with their value at "
      "the place and load step.");
  input::ParameterSpec& history = spec.namedLists("History");
  history.summary(
      "Numbers kept at every point from one load step to the next, 0 at the start, and written to the results; later "
      "ones may use earlier ones. Names have small letters, digits and underscores.");
  history.text("Formula").required().doc(
      "Its value at the end of a load step, in jumps and old values, such as \"max(opened_old, jump_n)\".");
  history.text("Unit").defaultValue("-").doc("For the legend of the results.");
}

FormulaGraph::FormulaGraph(const input::Parameters& parameters) {
  input::ErrorList errors;
  names_.assign(places.begin(), places.end());
  const auto add = [&](const std::string& name, const std::string& where) {
    if (!input::isFormulaName(name)) {
      errors.add(where, base::quoted(name) + " cannot stand in a formula.",
                 "Take letters, digits and underscores, and no name of a function.");
    } else if (std::find(names_.begin(), names_.end(), name) != names_.end()) {
      errors.add(where, base::quoted(name) + " means something else already.", "Take another name.");
    }
    names_.push_back(name);
  };
  const std::vector<input::Parameters>& lists = parameters.lists("History");
  for (const input::Parameters& list : lists) {
    add(list.name(), list.where());
    add(list.name() + oldSuffix, list.where());
    if (list.name().size() > 32 ||
        list.name().find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos) {
      errors.add(list.where(), base::quoted(list.name()) + " cannot name a field of the results.",
                 "Take at most 32 small letters, digits and underscores.");
    }
    histories_.push_back(list.name());
    outputs_.push_back({list.name(), list.text("Unit"), "History of the law by formulas."});
  }
  if (parameters.has("Fields")) fields_ = parameters.texts("Fields");
  for (const std::string& field : fields_) add(field, parameters.where("Fields"));
  if (parameters.hasList("Constants")) {
    const input::Parameters& numbers = parameters.list("Constants");
    for (const input::Parameters::Entry& entry : numbers.entries()) {
      add(entry.name, numbers.where(entry.name));
      constants_.push_back(numbers.number(entry.name));
    }
  }
  errors.throwIfAny();
  now_.resize(histories_.size());
  for (std::size_t h = 0; h < lists.size(); ++h) {
    errors.collect(lists[h].where("Formula"), [&] { updates_.push_back(compiled(lists[h], "Formula", h)); });
    errors.throwIfAny();
  }
  for (const char* entry : entries) {
    errors.collect(parameters.where(entry),
                   [&] { tractions_.push_back(compiled(parameters, entry, histories_.size())); });
  }
  errors.throwIfAny();
  isUncoupled_ = true;
  std::vector<double> known(names_.size(), std::numeric_limits<double>::quiet_NaN());
  std::copy(constants_.rbegin(), constants_.rend(), known.rbegin());
  for (std::size_t c = 0; c < 3; ++c) {
    areZero_[c] = tractions_[c].formula.whatever(known) == 0.0;
    for (std::size_t other = 0; other < 3; ++other) {
      if (other != c && tractions_[c].hasJump[other]) isUncoupled_ = false;
    }
  }
}

/// `known`: how many histories have values at the end of the load step when it is asked.
FormulaGraph::Expression FormulaGraph::compiled(const input::Parameters& list, const std::string& entry,
                                                std::size_t known) const {
  const input::Formula::Words words{"quantity of this law", "Known are",
                                    "\"k * jump_n\" or \"jump_n < 0 ? k * jump_n : 0\""};
  std::vector<std::string> allowed = names_;
  Expression result{input::Formula(list.text(entry), names_, words), {}, {}, false};
  const std::vector<std::string> used = result.formula.variables();
  const auto uses = [&](const std::string& name) { return std::find(used.begin(), used.end(), name) != used.end(); };
  std::vector<bool> isNeeded(histories_.size(), false);
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    if (!uses(histories_[h])) continue;
    if (h >= known) {
      throw base::Error("it uses " + base::quoted(histories_[h]) +
                            " before it has a value at the end of the load step.\n  Take " +
                            base::quoted(histories_[h] + oldSuffix) + ", or exchange the two.",
                        base::ExitCode::input);
    }
    isNeeded[h] = true;
    for (const std::size_t earlier : updates_[h].histories) isNeeded[earlier] = true;
  }
  for (std::size_t c = 0; c < 3; ++c) result.hasJump[c] = uses(places[c]);
  for (std::size_t h = 0; h < known; ++h) {
    if (!isNeeded[h]) continue;
    result.histories.push_back(h);
    for (std::size_t c = 0; c < 3; ++c) result.hasJump[c] = result.hasJump[c] || updates_[h].hasJump[c];
  }
  for (std::size_t s = gap; s < firstHistory; ++s) result.hasPlace = result.hasPlace || uses(places[s]);
  std::copy(constants_.begin(), constants_.end(), result.formula.slots() + (names_.size() - constants_.size()));
  return result;
}

void FormulaGraph::place(Expression& expression, const NodeContext& at, const double* old,
                         const std::vector<double>& fields) const {
  double* const slots = expression.formula.slots();
  for (std::size_t h = 0; h < histories_.size(); ++h) slots[firstHistory + 2 * h + 1] = old[h];
  std::copy(fields.begin(), fields.end(), slots + firstHistory + 2 * histories_.size());
  if (!expression.hasPlace) return;
  const base::Vector3 where = at.position();
  slots[gap] = at.gap;
  for (std::size_t c = 0; c < 3; ++c) slots[placeX + c] = where[c];
  slots[time] = at.time();
  slots[duration] = at.duration();
}

void FormulaGraph::goTo(const NodeContext& at, const double* old, const std::vector<double>& fields) {
  for (Expression& update : updates_) place(update, at, old, fields);
  for (Expression& traction : tractions_) place(traction, at, old, fields);
}

/// The histories that it uses have their values.
double FormulaGraph::alone(Expression& expression, const base::Vector3& jump) {
  double* const slots = expression.formula.slots();
  for (std::size_t c = 0; c < 3; ++c) slots[c] = jump[c];
  for (const std::size_t h : expression.histories) slots[firstHistory + 2 * h] = now_[h];
  return expression.formula.atSlots();
}

double FormulaGraph::valueOf(Expression& expression, const base::Vector3& jump) {
  for (const std::size_t h : expression.histories) now_[h] = alone(updates_[h], jump);
  return alone(expression, jump);
}

base::Vector3 FormulaGraph::traction(const base::Vector3& jump) {
  base::Vector3 result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = valueOf(tractions_[c], jump);
  return result;
}

double FormulaGraph::component(std::size_t c, double jump) {
  Expression& expression = tractions_[c];
  if (expression.histories.empty()) {
    expression.formula.slots()[c] = jump;
    return expression.formula.atSlots();
  }
  base::Vector3 all{};
  all[c] = jump;
  return valueOf(expression, all);
}

void FormulaGraph::update(const base::Vector3& jump, double* now) {
  for (std::size_t h = 0; h < histories_.size(); ++h) now[h] = now_[h] = alone(updates_[h], jump);
}

}  // namespace harmos::laws
