#pragma once

#include <string>

#include <harmos/latin/FixedPoint.hpp>

namespace harmos::latin {

/// Why double precision does not give an accuracy [-] with these laws, for the user, with interface, law, load step and
/// the accuracy that is attainable; empty: it does. Collective; the local stage is PointwiseLocalStage and has met a
/// state, the last load step of which is looked at. Changes nothing.
///
/// Of every law that is asked point by point and is not affine, the point with the largest traction is asked on lines
/// around the one that it has met: what its tractions scatter by over all lengths around it (laws::Scatter) is what
/// cancelling terms leave of their digits; less than 1e-4 or so of the tractions, more cannot be told from kinks.
/// Neither the iteration nor its error estimate sees it, since it is the same whenever a line is met again.
std::string lackOfDigits(FixedPoint& fixedPoint, double accuracy);

/// Of a run that has come to no end: the law with so much less round-off that it may be why, for the user, with the
/// accuracy at which it is not; empty: there is none. Collective, as lackOfDigits().
std::string scatterOfLaws(FixedPoint& fixedPoint, double accuracy);

}  // namespace harmos::latin
