// Seven laws, written as a user of an installed Harmos writes them, in one plugin.
#include "Cohesive.hpp"
#include "Iwan.hpp"
#include "Maxwell.hpp"
#include "MeanBolt.hpp"
#include "Orthotropic.hpp"
#include "RippledGlue.hpp"
#include "Tresca.hpp"

HARMOS_LAW_PLUGIN(Cohesive, Iwan, Maxwell, MeanBolt, Orthotropic, RippledGlue, Tresca)
