#include <harmos/files/StudyWriter.hpp>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <harmos/base/Error.hpp>
#include <harmos/files/detail/StudyFile.hpp>
#include <harmos/files/detail/StudyTables.hpp>

namespace harmos::files {

namespace fs = std::filesystem;

namespace {

void demandJournal(const StudyFiles& files, bool restart) {
  std::error_code ignored;
  if (restart || fs::exists(files.journal, ignored) || !fs::exists(files.file, ignored)) return;
  throw base::Error(files.file + " exists, but its journal " + files.journal +
                        ", from which a study resumes, does not.\n  Write into another folder (--output DIR), or start "
                        "over with --restart. Nothing was run.",
                    base::ExitCode::input);
}

/// What was being written when an earlier process was killed; it holds the journal no more.
void removePartialFiles(const StudyFiles& files) {
  std::error_code error;
  const fs::path directory = fs::path(files.file).parent_path();
  for (const auto& entry : fs::directory_iterator(directory.empty() ? "." : directory, error)) {
    const std::string name = entry.path().filename().string();
    for (const auto& path : files.all()) {
      if (name.rfind(fs::path(path).filename().string() + ".partial.", 0) == 0) fs::remove(entry.path(), error);
    }
  }
}

}  // namespace

StudyFiles::StudyFiles(const std::string& directory, const std::string& study)
    : stochastic((fs::path(directory) / fs::path(study).stem()).string()) {
  const std::string base = (fs::path(directory) / fs::path(study).stem()).string();
  file = base + ".h5";
  journal = base + ".journal";
  table = base + ".csv";
  dakota = base + "_dakota.dat";
}

std::vector<std::string> StudyFiles::tables() const {
  std::vector<std::string> tables = stochastic.all();
  tables.insert(tables.end(), {table, dakota});
  return tables;
}

std::vector<std::string> StudyFiles::all() const {
  std::vector<std::string> paths = tables();
  paths.insert(paths.end(), {file, journal});
  return paths;
}

StudyWriter::StudyWriter(const StudyFiles& files, results::StudyResults& results, bool restart)
    : files_(files),
      results_(results),
      journal_((demandJournal(files, restart), files.journal), results.description().identity, restart) {
  removePartialFiles(files_);
  for (const auto& path : files_.tables()) {
    std::error_code error;
    fs::remove(path, error);
    if (error) throw base::Error("Cannot remove the old result " + path + ": " + error.message() + ".");
  }
  for (const auto& configuration : journal_.added()) results_.add(configuration);
  for (const auto& result : journal_.results()) results_.set(result);
  for (const auto& [name, note] : journal_.notes()) results_.note(name, note);
  writeFile("running");
}

void StudyWriter::record(const results::ConfigurationResult& result) {
  journal_.append(result);
  results_.set(result);
  if (std::chrono::steady_clock::now() >= nextFile_) writeFile("running");
}

void StudyWriter::note(const std::string& name, const results::Note& note) {
  journal_.appendNote(name, note);
  results_.note(name, note);
}

void StudyWriter::add(const design::Configuration& configuration) {
  journal_.append(configuration);
  results_.add(configuration);
}

void StudyWriter::finish(const std::string& state) {
  writeFile(state);
  writeStudyTable(files_.table, results_);
  writeDakotaTable(files_.dakota, results_);
  if (results_.statistics()) writeStochasticTables(files_.stochastic, *results_.statistics());
}

void StudyWriter::writeFile(const std::string& state) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  writeStudyFile(files_.file, results_, state);
  const auto end = Clock::now();
  // Often enough to look at while it grows, and never more than 2 % of the time.
  nextFile_ = end + std::max<Clock::duration>(std::chrono::seconds(5), 50 * (end - begin));
}

}  // namespace harmos::files
