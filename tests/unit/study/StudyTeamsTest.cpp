#include <gtest/gtest.h>

#include <set>
#include <vector>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/study/detail/StudyTeams.hpp>

namespace harmos::study {
namespace {

TEST(StudyTeams, EveryPieceIsDoneOnceAndReported) {
  const auto all = Tpetra::getDefaultComm();
  StudyTeams teams(all, 1);
  EXPECT_EQ(teams.count(), all->getSize());
  constexpr int pieces = 50;
  int next = 0;
  std::multiset<std::string> heard;
  teams.setOffice([&](const std::string& report) { heard.insert(report); },
                  [&] { return next < pieces ? "piece " + std::to_string(next++) : ""; });
  int mine = 0;
  for (std::string piece = teams.nextWork(); !piece.empty(); piece = teams.nextWork()) {
    ++mine;
    if (teams.ownsFiles()) {
      heard.insert(piece);
    } else {
      teams.report(piece);
    }
  }
  teams.finish();
  int sum = 0;
  Teuchos::reduceAll(*all, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(sum));
  EXPECT_EQ(sum, pieces);
  if (!teams.ownsFiles()) return;
  EXPECT_EQ(heard.size(), static_cast<std::size_t>(pieces));
  EXPECT_EQ(std::set<std::string>(heard.begin(), heard.end()).size(), heard.size());
}

TEST(StudyTeams, AllRanksMayBeOneTeam) {
  const auto all = Tpetra::getDefaultComm();
  StudyTeams teams(all, all->getSize());
  EXPECT_EQ(teams.count(), 1);
  int left = 3, done = 0;
  teams.setOffice({}, [&] { return left-- > 0 ? "work" : ""; });
  while (!teams.nextWork().empty()) ++done;
  teams.finish();
  EXPECT_EQ(done, 3);
}

TEST(StudyTeams, RanksMustDivide) {
  const auto all = Tpetra::getDefaultComm();
  EXPECT_THROW(StudyTeams(all, all->getSize() + 1), base::Error);
  EXPECT_THROW(StudyTeams(all, 0), base::Error);
}

}  // namespace
}  // namespace harmos::study
