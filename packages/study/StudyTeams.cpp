#include <harmos/study/detail/StudyTeams.hpp>

#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::study {

namespace {

constexpr int toOffice = 1, fromOffice = 2;  // tags
constexpr char reports = 'R', wantsWork = 'W', hasFinished = 'F';

std::string receiveText(int source, int tag, MPI_Comm comm, int& from) {
  MPI_Status status;
  MPI_Probe(source, tag, comm, &status);
  int length = 0;
  MPI_Get_count(&status, MPI_CHAR, &length);
  from = status.MPI_SOURCE;
  std::string text(static_cast<std::size_t>(length), '\0');
  MPI_Recv(text.data(), length, MPI_CHAR, from, tag, comm, MPI_STATUS_IGNORE);
  return text;
}

/// Empty: there is no work left.
std::string messageOf(const std::optional<WorkRange>& work) {
  return work ? toMessage(*work) : "";
}

}  // namespace

StudyTeams::StudyTeams(const Comm& all, int ranksPerTeam) : all_(all), team_(all) {
  const int ranks = all->getSize();
  if (ranksPerTeam < 1 || ranks % ranksPerTeam != 0) {
    throw base::Error(std::to_string(ranks) + " ranks cannot be split into teams of " + std::to_string(ranksPerTeam) +
                          ".\n  Take a number that divides " + std::to_string(ranks) + ".",
                      base::ExitCode::input);
  }
  if (ranksPerTeam == ranks) return;
  team_ = all->split(all->getRank() / ranksPerTeam, all->getRank());
  const auto& mpi = dynamic_cast<const Teuchos::MpiComm<int>&>(*all);
  MPI_Comm_dup(*mpi.getRawMpiComm(), &mail_);
  atWork_ = count() - 1;
}

StudyTeams::~StudyTeams() {
  if (mail_ != MPI_COMM_NULL) MPI_Comm_free(&mail_);
}

void StudyTeams::setOffice(std::function<void(const std::string&)> receive,
                           std::function<std::optional<WorkRange>()> nextWork) {
  receive_ = std::move(receive);
  giveWork_ = std::move(nextWork);
}

void StudyTeams::report(const std::string& text) {
  send(reports, text);
}

std::optional<WorkRange> StudyTeams::nextWork() {
  std::string work;
  if (ownsFiles()) {
    serve();
    work = messageOf(giveWork_());
  } else if (leads()) {
    send(wantsWork, "");
    int office = 0;
    work = receiveText(0, fromOffice, mail_, office);
  }
  int length = static_cast<int>(work.size());
  Teuchos::broadcast(*team_, 0, Teuchos::outArg(length));
  work.resize(length);
  if (length > 0) Teuchos::broadcast(*team_, 0, length, work.data());
  return work.empty() ? std::nullopt : std::make_optional(rangeOf(work));
}

void StudyTeams::serve() {
  if (!ownsFiles() || mail_ == MPI_COMM_NULL) return;
  while (hear(false)) {
  }
}

void StudyTeams::finish() {
  if (mail_ == MPI_COMM_NULL) return;
  if (ownsFiles()) {
    while (atWork_ > 0) hear(true);
  } else if (leads()) {
    send(hasFinished, "");
  }
  all_->barrier();
}

void StudyTeams::send(char kind, const std::string& text) {
  const std::string message = kind + text;
  MPI_Send(message.data(), static_cast<int>(message.size()), MPI_CHAR, 0, toOffice, mail_);
}

bool StudyTeams::hear(bool waits) {
  int isThere = 1;
  if (!waits) MPI_Iprobe(MPI_ANY_SOURCE, toOffice, mail_, &isThere, MPI_STATUS_IGNORE);
  if (isThere == 0) return false;
  int from = 0;
  const std::string message = receiveText(MPI_ANY_SOURCE, toOffice, mail_, from);
  if (message.front() == reports) receive_(message.substr(1));
  if (message.front() == hasFinished) --atWork_;
  if (message.front() == wantsWork) {
    const std::string work = messageOf(giveWork_());
    MPI_Send(work.data(), static_cast<int>(work.size()), MPI_CHAR, from, fromOffice, mail_);
  }
  return true;
}

}  // namespace harmos::study
