#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include <harmos/results/ConfigurationResult.hpp>
#include <harmos/results/Note.hpp>
#include <harmos/results/StudyDescription.hpp>

namespace harmos::files {

/// The results of a study as they come, in a file that survives any sudden end: lines of JSON, each with its checksum,
/// are only ever appended, each in one write.
///
/// HDF5 is not safe against being killed while it writes; so this journal is what a study resumes from, and the HDF5
/// file is made of it. While the object lives no other process can open the same journal.
class StudyJournal {
 public:
  /// Opens or creates the journal and reads what is in it; an incomplete last line is cut off. `restart` empties it.
  ///
  /// Throws base::Error (input) when another process has it open, naming that process; when it belongs to a study with
  /// another `identity`, naming the entries that differ; and when the file is no journal, or one of another format of
  /// Harmos. base::Error when it cannot be written.
  StudyJournal(const std::string& path, const results::Identity& identity, bool restart);
  ~StudyJournal();
  StudyJournal(const StudyJournal&) = delete;
  StudyJournal& operator=(const StudyJournal&) = delete;

  /// What was in the file when it was opened, the last result of every configuration.
  const std::vector<results::ConfigurationResult>& results() const { return results_; }
  /// What had been added to the study's configurations when it was opened, in the order of adding.
  const std::vector<design::Configuration>& added() const { return added_; }
  /// The texts about the study that were in the file when it was opened, by name; the last one of each.
  const std::map<std::string, results::Note>& notes() const { return notes_; }
  /// How many lines were unreadable; their configurations are open again.
  int damaged() const { return damaged_; }
  /// From here on a sudden end of the process does not lose the result. A power failure may, until the file is
  /// synchronised: with this result or the first one more than a second after the last time, and with the end of the
  /// object. Throws base::Error when it cannot be written; the file then ends where it did before.
  void append(const results::ConfigurationResult& result);
  /// The same of a configuration that an adaptive design has added; it is synchronised with a result only.
  void append(const design::Configuration& added);
  /// The same of a text about the study; a later one of this name replaces it.
  void appendNote(const std::string& name, const results::Note& note);

 private:
  void lock();
  void read(const results::Identity& identity);
  void create(const results::Identity& identity);
  void writeLine(const std::string& json);

  std::string path_;
  int descriptor_ = -1;
  std::vector<results::ConfigurationResult> results_;
  std::vector<design::Configuration> added_;
  std::map<std::string, results::Note> notes_;
  int damaged_ = 0;
  std::chrono::steady_clock::time_point lastSync_;
};

/// A result as the journal writes it, without line break; exact, except that what is not finite becomes not a number
/// and what is not UTF-8 is replaced.
std::string resultToJson(const results::ConfigurationResult& result);
/// The reverse; throws base::Error when the text is not such a result.
results::ConfigurationResult resultFromJson(const std::string& json);
/// A configuration as the journal writes it, without line break.
std::string configurationToJson(const design::Configuration& configuration);
/// The reverse; throws base::Error when the text is not such a configuration.
design::Configuration configurationFromJson(const std::string& json);

}  // namespace harmos::files
