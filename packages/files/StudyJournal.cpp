#include <harmos/files/StudyJournal.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <limits>
#include <map>
#include <optional>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/Version.hpp>
#include <harmos/files/detail/Checksum.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::files {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format = "harmos study journal";
constexpr int formatVersion = 2;  // 2: with evidence, and results that are reopened
constexpr std::size_t checksumLength = 8;

/// The JSON of a line, or nothing when the line is damaged.
std::optional<Json> parseLine(const std::string& line) {
  if (line.size() < checksumLength + 1) return std::nullopt;
  const std::string text = line.substr(checksumLength + 1);
  if (line.compare(0, checksumLength, checksum(text)) != 0) return std::nullopt;
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  return json;
}

std::string readAll(int descriptor) {
  std::string text;
  char buffer[65536];
  for (::off_t at = 0;;) {
    const ::ssize_t length = ::pread(descriptor, buffer, sizeof buffer, at);
    if (length < 0 && errno == EINTR) continue;
    if (length <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(length));
    at += length;
  }
}

/// Complete lines, without line break.
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) break;
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string dump(const Json& json) {
  // Text from the user may not be UTF-8; replacing what is not is better than losing a result.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string now() {
  char text[32];
  const std::time_t time = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&time, &parts);
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::string hostName() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

/// Who has the journal open, from its last line about a session.
std::string holderIn(const std::string& text) {
  std::string holder = "another process";
  for (const std::string& line : linesOf(text)) {
    const auto json = parseLine(line);
    if (!json || !json->contains("session")) continue;
    const Json& session = (*json)["session"];
    holder = "process " + std::to_string(session.value("pid", 0)) + " on " + session.value("host", "") + " since " +
             session.value("started", "");
  }
  return holder;
}

/// The entries in which two inputs differ, one per line, or the first one that stands elsewhere: load steps follow one
/// another, and a design runs through one parameter after the other.
std::string differences(const results::Identity& before, const results::Identity& now) {
  constexpr int most = 12;
  const std::map<std::string, std::string> old(before.begin(), before.end()), present(now.begin(), now.end());
  std::string text;
  int count = 0;
  const auto add = [&](const std::string& name, const std::string& change) {
    if (++count <= most) text += "  " + name + " " + change + "\n";
  };
  for (const auto& [name, value] : now) {
    const auto found = old.find(name);
    if (found == old.end()) {
      add(name, "= " + value + ", which was not there before");
    } else if (found->second != value) {
      add(name, "= " + value + ", was " + found->second);
    }
  }
  for (const auto& [name, value] : before) {
    if (present.count(name) == 0) add(name, "is not there any more, was " + value);
  }
  if (count > most) text += "  and " + std::to_string(count - most) + " more\n";
  if (count > 0) return text;
  const auto first = std::mismatch(now.begin(), now.end(), before.begin(), before.end());
  if (first.first != now.end() && first.second != before.end())
    add(first.first->first, "stands before " + first.second->first + ", was behind it");
  return text;
}

Json numbers(const std::vector<double>& values) {
  return Json(values);  // what is not finite is written as null
}

double number(const Json& json) {
  return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> numbers(const Json& json, const char* key) {
  std::vector<double> values;
  for (const Json& value : json.at(key)) values.push_back(number(value));
  return values;
}

Json toJson(const results::ConfigurationResult& result) {
  Json curves = Json::array();
  for (const auto& curve : result.curves) curves.push_back(numbers(curve));
  Json meshErrors = Json::array();
  for (const results::MeshErrorRecord& error : result.meshErrors) {
    meshErrors.push_back({{"response", error.response},
                          {"change", error.change},
                          {"relative", error.relative},
                          {"word", error.word},
                          {"parts", error.parts},
                          {"reason", error.reason}});
  }
  Json json = {{"id", result.id},
               {"status", results::statusName(result.status)},
               {"reason", result.reason},
               {"error_estimate", result.errorEstimate},
               {"iterations", result.iterations},
               {"linear_stages", result.linearStages},
               {"starts", result.starts},
               {"cpu_seconds", result.cpuSeconds},
               {"curve_errors", numbers(result.curveErrors)},
               {"mesh_errors", meshErrors},
               {"curves", curves}};
  const results::Evidence& evidence = result.evidence;
  if (evidence.indicators) {
    json["indicators"] = {{"force", evidence.indicators->force},
                          {"balance", evidence.indicators->balance},
                          {"responses", numbers(evidence.indicators->responses)}};
  }
  if (evidence.ratios)
    json["ratios"] = {{"force", evidence.ratios->force}, {"responses", numbers(evidence.ratios->responses)}};
  if (evidence.audit) json["audit"] = *evidence.audit;
  return json;
}

/// Nothing of it in files of before.
results::Evidence evidenceOf(const Json& json) {
  results::Evidence evidence;
  if (json.contains("indicators")) {
    const Json& indicators = json["indicators"];
    evidence.indicators = results::Indicators{number(indicators.at("force")), number(indicators.at("balance")),
                                              numbers(indicators, "responses")};
  }
  if (json.contains("ratios"))
    evidence.ratios = results::Ratios{number(json["ratios"].at("force")), numbers(json["ratios"], "responses")};
  if (json.contains("audit")) evidence.audit = number(json["audit"]);
  return evidence;
}

results::ConfigurationResult fromJson(const Json& json) {
  results::ConfigurationResult result;
  try {
    result.id = json.at("id").get<int>();
    const auto status = results::statusNamed(json.at("status").get<std::string>());
    if (!status) throw base::Error("unknown status");
    result.status = *status;
    result.reason = json.at("reason").get<std::string>();
    result.errorEstimate = number(json.at("error_estimate"));
    result.iterations = json.at("iterations").get<int>();
    result.linearStages = json.at("linear_stages").get<int>();
    result.starts = json.at("starts").get<std::vector<int>>();
    result.cpuSeconds = number(json.at("cpu_seconds"));
    result.curveErrors = numbers(json, "curve_errors");
    for (const Json& curve : json.at("curves")) {
      result.curves.emplace_back();
      for (const Json& value : curve) result.curves.back().push_back(number(value));
    }
    for (const Json& error : json.value("mesh_errors", Json::array())) {  // files of before have none
      result.meshErrors.push_back({error.at("response").get<std::string>(), number(error.at("change")),
                                   number(error.at("relative")), error.at("word").get<std::string>(),
                                   error.at("parts").get<std::vector<std::string>>(),
                                   error.at("reason").get<std::string>()});
    }
    result.evidence = evidenceOf(json);
  } catch (const Json::exception& error) {
    throw base::Error(std::string("This is no result of a configuration: ") + error.what());
  }
  return result;
}

design::Configuration configurationOf(const Json& json) {
  try {
    return {json.at("configuration").get<int>(), numbers(json, "values")};
  } catch (const Json::exception& error) {
    throw base::Error(std::string("This is no configuration: ") + error.what());
  }
}

}  // namespace

std::string resultToJson(const results::ConfigurationResult& result) {
  return dump(toJson(result));
}

results::ConfigurationResult resultFromJson(const std::string& json) {
  return fromJson(Json::parse(json, nullptr, false));
}

std::string configurationToJson(const design::Configuration& configuration) {
  return dump({{"configuration", configuration.id}, {"values", numbers(configuration.values)}});
}

design::Configuration configurationFromJson(const std::string& json) {
  return configurationOf(Json::parse(json, nullptr, false));
}

StudyJournal::StudyJournal(const std::string& path, const results::Identity& identity, bool restart) : path_(path) {
  createFolderOf(path);
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw base::Error("Cannot write " + path + ": " + std::strerror(errno) + ".");
  try {
    lock();
    if (restart && ::ftruncate(descriptor_, 0) != 0)
      throw base::Error("Cannot empty " + path + ": " + std::strerror(errno) + ".");
    read(identity);
    writeLine(dump(
        {{"session",
          {{"pid", static_cast<int>(::getpid())}, {"host", hostName()}, {"started", now()}, {"version", version()}}}}));
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

StudyJournal::~StudyJournal() {
  ::fdatasync(descriptor_);
  ::close(descriptor_);  // and with it the lock
}

void StudyJournal::lock() {
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno != EWOULDBLOCK) throw base::Error("Cannot lock " + path_ + ": " + std::strerror(errno) + ".");
  throw base::Error(path_ + " is in use by " + holderIn(readAll(descriptor_)) +
                        ".\n  Wait for it, end it, or write into another folder (--output DIR). Nothing was run.",
                    base::ExitCode::input);
}

void StudyJournal::read(const results::Identity& identity) {
  const std::string text = readAll(descriptor_);
  const std::size_t complete = text.rfind('\n') + 1;  // 0 when there is no line
  if (complete < text.size() && ::ftruncate(descriptor_, static_cast<::off_t>(complete)) != 0)
    throw base::Error("Cannot repair " + path_ + ": " + std::strerror(errno) + ".");
  const std::vector<std::string> lines = linesOf(text);
  if (lines.empty()) {
    // Killed before its first line was complete, or new; anything else has a line.
    create(identity);
    return;
  }
  const auto header = parseLine(lines.front());
  if (!header || header->value("format", "") != format)
    throw base::Error(path_ + " is not the journal of a study.\n  Remove it, or write into another folder.",
                      base::ExitCode::input);
  const int version = header->value("version", 0);
  if (version < 1 || version > formatVersion)
    throw base::Error(path_ + " was written by another version of Harmos, " + header->value("program_version", "") +
                          ".\n  Finish the study with that one, or start over with --restart.",
                      base::ExitCode::input);
  const std::string changes = differences(header->value("identity", results::Identity()), identity);
  if (!changes.empty())
    throw base::Error(path_ + " belongs to a study with another input:\n" + changes +
                          "  Undo the change, write into another folder (--output DIR), or start over with --restart.\n"
                          "  Nothing was run.",
                      base::ExitCode::input);

  std::map<int, results::ConfigurationResult> latest;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto json = parseLine(lines[i]);
    if (!json) {
      ++damaged_;
    } else if (json->contains("configuration")) {
      added_.push_back(configurationOf(*json));
    } else if (json->contains("note")) {
      notes_[json->at("note").get<std::string>()] = {json->value("text", ""), json->value("unmet", false)};
    } else if (json->contains("id")) {
      results::ConfigurationResult result = fromJson(*json);
      latest[result.id] = std::move(result);
    }
  }
  for (auto& entry : latest) results_.push_back(std::move(entry.second));
}

void StudyJournal::create(const results::Identity& identity) {
  writeLine(
      dump({{"format", format}, {"version", formatVersion}, {"program_version", version()}, {"identity", identity}}));
}

void StudyJournal::append(const results::ConfigurationResult& result) {
  writeLine(resultToJson(result));
  const auto time = std::chrono::steady_clock::now();
  // A synchronisation may take longer than a solution.
  if (time - lastSync_ < std::chrono::seconds(1)) return;
  lastSync_ = time;
  ::fdatasync(descriptor_);
}

void StudyJournal::append(const design::Configuration& added) {
  writeLine(configurationToJson(added));
}

void StudyJournal::appendNote(const std::string& name, const results::Note& note) {
  writeLine(dump({{"note", name}, {"text", note.text}, {"unmet", note.isUnmet}}));
}

void StudyJournal::writeLine(const std::string& json) {
  struct ::stat file {};
  if (::fstat(descriptor_, &file) == 0 && file.st_nlink == 0)
    throw base::Error("Cannot write " + path_ + ": it was removed while the study went on.");
  const std::string line = checksum(json) + " " + json + "\n";
  const ::off_t before = ::lseek(descriptor_, 0, SEEK_END);
  std::size_t written = 0;
  while (written < line.size()) {
    const ::ssize_t length = ::write(descriptor_, line.data() + written, line.size() - written);
    if (length < 0 && errno == EINTR) continue;
    if (length < 0) {
      const std::string reason = std::strerror(errno);
      if (::ftruncate(descriptor_, before) != 0) {
        // The checksum will show it when the journal is read.
      }
      throw base::Error("Cannot write " + path_ + ": " + reason + ".");
    }
    written += static_cast<std::size_t>(length);
  }
}

}  // namespace harmos::files
