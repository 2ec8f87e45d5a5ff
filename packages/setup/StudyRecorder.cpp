#include <harmos/setup/StudyRecorder.hpp>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/setup/FailurePolicy.hpp>

namespace harmos::setup {

namespace {

constexpr char ofResult = 'R', ofNote = 'N';

void broadcast(std::string& text, const Teuchos::Comm<int>& comm) {
  int length = static_cast<int>(text.size());
  Teuchos::broadcast(comm, 0, Teuchos::outArg(length));
  text.resize(static_cast<std::size_t>(length));
  if (length > 0) Teuchos::broadcast(comm, 0, length, text.data());
}

void forEachLine(const std::string& text, const std::function<void(const std::string&)>& action) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    action(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

}  // namespace

StudyRecorder::StudyRecorder(const output::StudyFiles& files, bool restart, output::StudyResults& results,
                             StudyTeams& teams)
    : results_(results), teams_(teams) {
  std::string error, added, lines;
  int code = 0;
  if (teams.ownsFiles()) {
    try {
      const output::StudyDescription& description = results.description();
      writer_ = std::make_unique<output::StudyWriter>(files, description, restart);
      const auto& all = writer_->results().configurations();
      for (std::size_t i = description.configurations.size(); i < all.size(); ++i) {
        added += output::configurationToJson(all[i]) + "\n";
      }
      for (const auto& result : writer_->results().all()) lines += output::resultToJson(result) + "\n";
      for (const auto& [name, text] : writer_->results().notes()) results_.note(name, text);
    } catch (const base::Error& failure) {
      error = failure.what();
      code = static_cast<int>(failure.code());
    }
  }
  broadcast(error, *teams.all());
  Teuchos::broadcast(*teams.all(), 0, Teuchos::outArg(code));
  if (!error.empty()) throw base::Error(error, static_cast<base::ExitCode>(code));
  broadcast(added, *teams.all());
  broadcast(lines, *teams.all());
  forEachLine(added, [&](const std::string& line) { results_.add(output::configurationFromJson(line)); });
  forEachLine(lines, [&](const std::string& line) { results_.set(output::resultFromJson(line)); });
}

void StudyRecorder::record(const study::ConfigurationResult& result) {
  results_.set(result);
  hasFailed_ = hasFailed_ || mayBeHelped(result);
  write([&](output::StudyWriter& writer) { writer.record(result); });
  if (isMessenger()) teams_.report(ofResult + output::resultToJson(result));
  if (observer_) observer_(results_);
}

void StudyRecorder::note(const std::string& name, const std::string& text) {
  // Every team has something to say about itself.
  const int team = teams_.all()->getRank() / teams_.team()->getSize();
  const std::string full = teams_.count() == 1 ? name : name + " (team " + std::to_string(team + 1) + ")";
  results_.note(full, text);
  write([&](output::StudyWriter& writer) { writer.note(full, text); });
  if (isMessenger()) teams_.report(ofNote + full + "\n" + text);
}

void StudyRecorder::add(const study::Configuration& configuration) {
  results_.add(configuration);
  write([&](output::StudyWriter& writer) { writer.add(configuration); });
}

void StudyRecorder::setStatistics(std::shared_ptr<const study::StochasticSummary> statistics) {
  results_.setStatistics(statistics);
  write([&](output::StudyWriter& writer) { writer.setStatistics(statistics); });
}

void StudyRecorder::receive(const std::string& report) {
  const std::string text = report.substr(1);
  if (report.front() == ofResult) {
    record(output::resultFromJson(text));
  } else {
    const std::size_t end = text.find('\n');
    results_.note(text.substr(0, end), text.substr(end + 1));
    write([&](output::StudyWriter& writer) { writer.note(text.substr(0, end), text.substr(end + 1)); });
  }
}

void StudyRecorder::finish(const std::string& state) {
  write([&](output::StudyWriter& writer) { writer.finish(state); });
}

void StudyRecorder::write(const std::function<void(output::StudyWriter&)>& action) {
  if (!writer_) return;
  cannotWrite_ = true;
  action(*writer_);
  cannotWrite_ = false;
}

}  // namespace harmos::setup
