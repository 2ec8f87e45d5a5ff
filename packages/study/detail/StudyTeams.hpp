#pragma once

#include <functional>
#include <optional>
#include <string>

#include <mpi.h>
#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/study/detail/WorkRange.hpp>

namespace harmos::study {

/// The ranks of a study in teams of equal size, each of which solves configurations of its own.
///
/// Rank 0 of all leads the first team, owns the files, hands out work to whoever has none left, and receives what the
/// leaders of the other teams report; it does so between its own iterations, by serve().
class StudyTeams {
 public:
  using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;

  /// Collective. Throws base::Error (input) when the ranks cannot be split so.
  StudyTeams(const Comm& all, int ranksPerTeam);
  ~StudyTeams();
  StudyTeams(const StudyTeams&) = delete;
  StudyTeams& operator=(const StudyTeams&) = delete;

  const Comm& all() const { return all_; }
  const Comm& team() const { return team_; }
  int count() const { return all_->getSize() / team_->getSize(); }
  bool ownsFiles() const { return all_->getRank() == 0; }
  bool leads() const { return team_->getRank() == 0; }

  /// For rank 0 of all: what hears reports, and what gives the next work (nothing: none is left). Both must stay valid
  /// until finish().
  void setOffice(std::function<void(const std::string&)> receive, std::function<std::optional<WorkRange>()> nextWork);
  /// Leaders other than rank 0 of all: sends a report to it.
  void report(const std::string& text);
  /// Collective over the team.
  std::optional<WorkRange> nextWork();
  /// Rank 0 of all: hears all that has been sent. Others: nothing.
  void serve();
  /// Collective over all: waits until every team has come here; all reports have been heard then.
  void finish();

 private:
  void send(char kind, const std::string& text);
  /// Hears one message; false when there is none and `waits` is false.
  bool hear(bool waits);

  Comm all_, team_;
  MPI_Comm mail_ = MPI_COMM_NULL;  // of all ranks, for these messages alone
  std::function<void(const std::string&)> receive_;
  std::function<std::optional<WorkRange>()> giveWork_;
  int atWork_ = 0;  // teams, but the first, that have not finished
};

}  // namespace harmos::study
