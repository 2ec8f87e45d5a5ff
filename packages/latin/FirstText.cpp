#include <harmos/latin/detail/FirstText.hpp>

#include <Teuchos_CommHelpers.hpp>

namespace harmos::latin {

std::string firstText(const std::string& mine, const Teuchos::Comm<int>& comm) {
  const int none = comm.getSize(), here = mine.empty() ? none : comm.getRank();
  int first = none;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MIN, here, Teuchos::outArg(first));
  if (first == none) return {};
  std::string text = mine;
  int length = static_cast<int>(text.size());
  Teuchos::broadcast(comm, first, Teuchos::outArg(length));
  text.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(comm, first, length, text.data());
  return text;
}

}  // namespace harmos::latin
