#pragma once

#include <string>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>

namespace harmos::latin {

/// What a second look at the laws of a state has found; the same on all ranks.
struct LawFindings {
  std::string falseGraph;    ///< why a law has no graph, with interface, load step and point; empty: all have
  std::string lackOfDigits;  ///< why double precision does not give the accuracy with these laws; empty: it does
  std::vector<std::string> remarks;  ///< on laws that fall and do not say so, and whose energies do not go together
};

/// Asks the laws of a state again. Collective; `iterate` is the present one of `fixedPoint`, all load steps selected,
/// with the local stage PointwiseLocalStage, and stays valid. The state need not be a fixed point.
///
/// A law is a graph t = R(delta): where it meets one line, it meets every other line through that point. Along the load
/// steps, with the histories that they have led to, each point is asked on lines of a quarter of the compliance and,
/// where the law says that it never falls, of four times it; the traction must stay what it is, to `accuracy` [-], or
/// 1e-7, times the largest of the interface. What comes out otherwise solves other equations than the law's, and
/// depends on the search direction; the certificate, which sees one search direction only, cannot tell. Laws
/// over whole faces (CoupledLaw) are asked for all points of a face together; those that fall at a jump are not asked.
///
/// A law that is asked point by point and says that it never falls is asked a little farther along the normal and along
/// the surface, too, with the same history: a traction that is less there gives a remark, since there may be other
/// solutions then. What changes with the pressure is left aside.
///
/// Where the terms of a law cancel, so that round-off in it is more than half of the accuracy, the accuracy is refused.
///
/// Where a law that is asked point by point dissipates, no load step may gain energy, t.(delta - delta_old) >=
/// keptWork(), nor, from the second one on and where it never falls, store more than it keeps, storedEnergy() -
/// storedEnergy_old <= keptWork(). The latter is not asked where the law itself has changed from the load step before
/// (moved tools, gaps with histories): what changes it does work, too. Digits that jumps and energies lose are left
/// out.
LawFindings checkLaws(FixedPoint& fixedPoint, const Iterate& iterate, double accuracy);

/// Why a law has no graph at a state, or else why double precision does not give the accuracy; empty: neither. What
/// checkLaws() finds but for the remarks, with fewer questions to the laws. Collective, as checkLaws().
std::string lackOfGraph(FixedPoint& fixedPoint, const Iterate& iterate, double accuracy);

}  // namespace harmos::latin
