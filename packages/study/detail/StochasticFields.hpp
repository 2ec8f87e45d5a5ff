#pragma once

#include <harmos/files/StochasticTables.hpp>
#include <harmos/study/detail/ChaosStudy.hpp>

namespace harmos::study {

/// Writes what the expanded fields of a study come to, one file for parts and one for interfaces; collective, rank 0
/// writes.
///
/// Of every field X, per load step: X_mean, X_std, and per random parameter X_sobol_<parameter> (X_sobol_xi_1, .. of
/// the germs when these are correlated), the main Sobol' index (0 where nothing varies). Parts: disp [length];
/// interfaces: contact_pressure and traction on side 1 [stress].
void writeStochasticFields(const Study& study, const ChaosStudy& chaos, const files::StochasticFiles& files,
                           const Teuchos::Comm<int>& comm);

}  // namespace harmos::study
