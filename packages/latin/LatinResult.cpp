#include <harmos/latin/LatinResult.hpp>

#include <algorithm>

namespace harmos::latin {

bool LatinResult::isUnique() const {
  return freePressures.empty() && std::all_of(responses.begin(), responses.end(), [](const ResponseResult& response) {
           return response.range.widest() < 0;
         });
}

}  // namespace harmos::latin
