#include <gtest/gtest.h>

#include <set>
#include <vector>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/study/detail/StudyTeams.hpp>

namespace harmos::study {
namespace {

TEST(StudyTeams, EveryRangeIsSolvedOnceAndReported) {
  const auto all = Tpetra::getDefaultComm();
  StudyTeams teams(all, 1);
  EXPECT_EQ(teams.count(), all->getSize());
  constexpr std::size_t ranges = 50;
  std::size_t next = 0;
  std::multiset<std::string> heard;
  teams.setOffice([&](const std::string& report) { heard.insert(report); },
                  [&]() -> std::optional<WorkRange> {
                    if (next == ranges) return std::nullopt;
                    ++next;
                    return WorkRange{3, next, 10 * next};
                  });
  int mine = 0;
  while (const auto range = teams.nextWork()) {
    ++mine;
    EXPECT_EQ(range->operators, 3u);
    EXPECT_EQ(range->end, 10 * range->begin);
    if (teams.ownsFiles()) {
      heard.insert(toMessage(*range));
    } else {
      teams.report(toMessage(*range));
    }
  }
  teams.finish();
  int sum = 0;
  Teuchos::reduceAll(*all, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(sum));
  EXPECT_EQ(sum, static_cast<int>(ranges));
  if (!teams.ownsFiles()) return;
  EXPECT_EQ(heard.size(), ranges);
  EXPECT_EQ(std::set<std::string>(heard.begin(), heard.end()).size(), heard.size());
}

TEST(StudyTeams, SendRangesExactly) {
  const WorkRange range{7, 0, 123456789012};
  EXPECT_EQ(rangeOf(toMessage(range)), range);
}

TEST(StudyTeams, AllRanksMayBeOneTeam) {
  const auto all = Tpetra::getDefaultComm();
  StudyTeams teams(all, all->getSize());
  EXPECT_EQ(teams.count(), 1);
  int left = 3, done = 0;
  teams.setOffice({}, [&] { return left-- > 0 ? std::make_optional(WorkRange{}) : std::nullopt; });
  while (teams.nextWork()) ++done;
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
