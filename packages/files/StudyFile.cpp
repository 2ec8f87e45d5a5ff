#include <harmos/files/detail/StudyFile.hpp>

#include <algorithm>
#include <functional>
#include <limits>

#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/Version.hpp>
#include <harmos/files/detail/Hdf5.hpp>
#include <harmos/files/detail/StochasticGroup.hpp>
#include <harmos/results/StatusName.hpp>
#include <harmos/results/SurfaceData.hpp>

namespace harmos::files {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

class Writer {
 public:
  Writer(const Hdf5Group& group, const results::StudyResults& results, bool hasSurrogates)
      : group_(group), results_(results), description_(results.description()), hasSurrogates_(hasSurrogates) {}

  void write() const {
    writeParameters();
    writeConfigurations();
    writeResponses();
    writeCurves();
    writeMeshErrors();
    const Hdf5Group input = group_.group("input");
    input.attribute("study", description_.studyInput);
    input.attribute("scene", description_.sceneInput);
    if (hasSurrogates_) writeSurrogates();
    if (results_.statistics()) writeStatistics(group_.group("statistics"), *results_.statistics());
    const Hdf5Group notes = group_.group("notes");
    for (const auto& [name, note] : results_.notes()) notes.attribute(name, note.text);
    const Hdf5Group leftOut = group_.group("left_out");
    for (const auto& [condition, count] : description_.leftOut) leftOut.attribute(condition, count);
  }

 private:
  using Result = results::ConfigurationResult;

  /// One number per configuration; `otherwise` of those that are open.
  template <class T>
  std::vector<T> collect(const std::function<T(const Result&)>& value, T otherwise) const {
    std::vector<T> values;
    for (const auto& configuration : results_.configurations()) {
      const Result* result = results_.find(configuration.id);
      values.push_back(result ? value(*result) : otherwise);
    }
    return values;
  }

  void writeParameters() const {
    const Hdf5Group parameters = group_.group("parameters");
    std::vector<std::string> names;
    for (std::size_t p = 0; p < description_.parameters.size(); ++p) {
      const auto& parameter = description_.parameters[p];
      std::vector<double> values;
      for (const auto& configuration : results_.configurations()) values.push_back(configuration.values[p]);
      const Hdf5Group array = parameters.array(parameter.name, values);
      array.attribute("unit", parameter.unit);
      array.attribute("formula", parameter.formula);
      array.attribute("entries", parameter.entries);
      array.attribute("phase", parameter.phase);
      names.push_back(parameter.name);
    }
    parameters.attribute("order", names);
  }

  void writeConfigurations() const {
    const Hdf5Group rows = group_.group("configurations");
    std::vector<int> ids;
    std::size_t mostStarts = 1;
    for (const auto& configuration : results_.configurations()) {
      ids.push_back(configuration.id);
      const Result* result = results_.find(configuration.id);
      if (result) mostStarts = std::max(mostStarts, result->starts.size());
    }
    std::vector<int> starts(ids.size() * mostStarts, 0);
    for (std::size_t row = 0; row < ids.size(); ++row) {
      const Result* result = results_.find(ids[row]);
      if (result) std::copy(result->starts.begin(), result->starts.end(), starts.begin() + row * mostStarts);
    }
    rows.array("id", ids);
    rows.array("status", collect<std::string>([](const Result& r) { return results::statusName(r.status); }, "open"));
    rows.array("reason", collect<std::string>([](const Result& r) { return r.reason; }, ""));
    rows.array("iterations", collect<int>([](const Result& r) { return r.iterations; }, 0));
    rows.array("linear_stages", collect<int>([](const Result& r) { return r.linearStages; }, 0));
    rows.array("error_estimate", collect<double>([](const Result& r) { return r.errorEstimate; }, none));
    rows.array("starts", starts, mostStarts);
    rows.array("cpu_seconds", collect<double>([](const Result& r) { return r.cpuSeconds; }, none));
  }

  void writeResponses() const {
    const Hdf5Group responses = group_.group("responses");
    std::vector<std::string> names;
    std::vector<std::vector<double>> columns(description_.responses.size());
    for (const auto& configuration : results_.configurations()) {
      const auto values = results_.responses(configuration.id);
      for (std::size_t r = 0; r < values.size(); ++r) columns[r].push_back(values[r]);
    }
    for (std::size_t r = 0; r < columns.size(); ++r) {
      const results::ScalarResponse& response = description_.responses[r];
      responses.array(response.name, columns[r]).attribute("curve", description_.curves[response.curve]);
      names.push_back(response.name);
    }
    responses.attribute("order", names);
  }

  void writeSurrogates() const {
    const results::SurfaceData data = results::surfaceDataOf(results_);
    const Hdf5Group surrogates = group_.group("surrogates");
    surrogates.attribute("parameters", data.parameters);
    for (std::size_t r = 0; r < data.values.size(); ++r) {
      const auto surrogate = data.surrogate(r);
      if (!surrogate) continue;
      const Hdf5Group group = surrogates.group(description_.responses[r].name);
      const design::Surrogate::Model& model = surrogate->model();
      group.attribute("degree", model.degree);
      group.attribute("nugget", model.nugget);
      group.attribute("calibration", model.calibration);
      group.attribute("largest_left_out_error", surrogate->largestLeftOutError());
      group.attribute("mean_left_out_error", surrogate->meanLeftOutError());
      group.array("lengths", model.lengths);
      group.array("lower", model.lower);
      group.array("upper", model.upper);
    }
  }

  void writeCurves() const {
    const Hdf5Group curves = group_.group("curves");
    const std::size_t steps = description_.times.size();
    for (std::size_t c = 0; c < description_.curves.size(); ++c) {
      std::vector<double> values;
      for (const auto& configuration : results_.configurations()) {
        const Result* result = results_.find(configuration.id);
        if (result && c < result->curves.size() && result->curves[c].size() == steps) {
          values.insert(values.end(), result->curves[c].begin(), result->curves[c].end());
        } else {
          values.insert(values.end(), steps, none);
        }
      }
      curves.array(description_.curves[c], values, steps);
    }
    const Hdf5Group errors = group_.group("curve_errors");
    for (std::size_t c = 0; c < description_.curves.size(); ++c) {
      errors.array(
          description_.curves[c],
          collect<double>([c](const Result& r) { return c < r.curveErrors.size() ? r.curveErrors[c] : none; }, none));
    }
    curves.attribute("order", description_.curves);
    group_.array("times", description_.times);
  }

  void writeMeshErrors() const {
    const Hdf5Group errors = group_.group("mesh_errors"), changes = group_.group("mesh_changes"),
                    words = group_.group("mesh_words");
    for (const std::string& curve : description_.curves) {
      const auto of = [&curve](const Result& result) {
        const auto& all = result.meshErrors;
        const auto isMeant = [&curve](const results::MeshErrorRecord& each) { return each.response == curve; };
        const auto found = std::find_if(all.begin(), all.end(), isMeant);
        return found == all.end() ? nullptr : &*found;
      };
      errors.array(curve, collect<double>([&](const Result& r) { return of(r) ? of(r)->relative : none; }, none));
      changes.array(curve, collect<double>([&](const Result& r) { return of(r) ? of(r)->change : none; }, none));
      words.array(curve, collect<std::string>([&](const Result& r) { return of(r) ? of(r)->word : ""; }, ""));
    }
  }

  const Hdf5Group& group_;
  const results::StudyResults& results_;
  const results::StudyDescription& description_;
  bool hasSurrogates_;
};

}  // namespace

void writeStudyFile(const std::string& path, const results::StudyResults& results, const std::string& state) {
  const QuietHdf5 quiet;
  const results::StudyDescription& description = results.description();
  const Hdf5Group root = Hdf5Group::create();
  root.attribute("schema", std::string("harmos-study"));
  root.attribute("schema_version", studySchemaVersion);
  root.attribute("program_version", std::string(version()));
  {
    const Hdf5Group group = root.group(description.name);
    group.attribute("title", description.title);
    group.attribute("scene", description.scene);
    group.attribute("accuracy", description.accuracy);
    group.attribute("state", state);
    Writer(group, results, state != "running").write();
  }
  replaceFile(path, root.image());
}

}  // namespace harmos::files
