#pragma once

#include <string>

#include <Teuchos_Comm.hpp>

namespace harmos::latin {

/// Collective. Of the texts that ranks have, that of the lowest rank whose is not empty; empty: all are.
std::string firstText(const std::string& mine, const Teuchos::Comm<int>& comm);

}  // namespace harmos::latin
