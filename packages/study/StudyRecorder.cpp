#include <harmos/study/detail/StudyRecorder.hpp>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/AllRanks.hpp>
#include <harmos/study/FailurePolicy.hpp>

namespace harmos::study {

namespace {

constexpr char ofResult = 'R', ofNote = 'N', ofShortfall = 'S';

void broadcast(std::string& text, const Teuchos::Comm<int>& comm) {
  int length = static_cast<int>(text.size());
  Teuchos::broadcast(comm, 0, Teuchos::outArg(length));
  text.resize(length);
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

StudyRecorder::StudyRecorder(const files::StudyFiles& files, bool restart, results::StudyResults& results,
                             StudyTeams& teams)
    : results_(results), teams_(teams) {
  std::string added, lines;
  base::onFirstRank(*teams.all(), [&] {
    const results::StudyDescription& description = results.description();
    writer_ = std::make_unique<files::StudyWriter>(files, results, restart);
    const auto& all = results.configurations();
    for (std::size_t i = description.configurations.size(); i < all.size(); ++i) {
      added += files::configurationToJson(all[i]) + "\n";
    }
    for (const auto& result : results.all()) lines += files::resultToJson(result) + "\n";
  });
  broadcast(added, *teams.all());
  broadcast(lines, *teams.all());
  if (teams.ownsFiles()) return;
  forEachLine(added, [&](const std::string& line) { results_.add(files::configurationFromJson(line)); });
  forEachLine(lines, [&](const std::string& line) { results_.set(files::resultFromJson(line)); });
}

void StudyRecorder::record(const results::ConfigurationResult& result) {
  hasFailed_ = hasFailed_ || mayBeHelped(result);
  if (!writer_) results_.set(result);
  write([&](files::StudyWriter& writer) { writer.record(result); });
  if (isMessenger()) teams_.report(ofResult + files::resultToJson(result));
  if (observer_) observer_(results_);
}

void StudyRecorder::note(const std::string& name, const results::Note& note) {
  // Every team has something to say about itself.
  const int team = teams_.all()->getRank() / teams_.team()->getSize();
  const std::string full = teams_.count() == 1 ? name : name + " (team " + std::to_string(team + 1) + ")";
  if (!writer_) results_.note(full, note);
  write([&](files::StudyWriter& writer) { writer.note(full, note); });
  if (isMessenger()) teams_.report((note.isUnmet ? ofShortfall : ofNote) + full + "\n" + note.text);
}

void StudyRecorder::add(const design::Configuration& configuration) {
  if (!writer_) results_.add(configuration);
  write([&](files::StudyWriter& writer) { writer.add(configuration); });
}

void StudyRecorder::setStatistics(std::shared_ptr<const results::StochasticSummary> statistics) {
  if (!writer_) results_.setStatistics(statistics);
  write([&](files::StudyWriter& writer) { writer.setStatistics(statistics); });
}

void StudyRecorder::receive(const std::string& report) {
  const std::string text = report.substr(1);
  if (report.front() == ofResult) {
    record(files::resultFromJson(text));
  } else {
    const std::size_t end = text.find('\n');
    const results::Note note{text.substr(end + 1), report.front() == ofShortfall};
    write([&](files::StudyWriter& writer) { writer.note(text.substr(0, end), note); });
  }
}

void StudyRecorder::finish(const std::string& state) {
  write([&](files::StudyWriter& writer) { writer.finish(state); });
}

void StudyRecorder::write(const std::function<void(files::StudyWriter&)>& action) {
  if (!writer_) return;
  cannotWrite_ = true;  // until it has
  action(*writer_);
  cannotWrite_ = false;
}

}  // namespace harmos::study
