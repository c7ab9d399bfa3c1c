#pragma once
// Which of very many balls a draft has: a picture that stands for a blink, while a hand moves.

#include "view/appearance.hpp"

namespace clack::view {

/// The balls that are nearest to the eye, and every so many-th of those farther away; all where
/// they are no more than `most`. Of those that the cut leaves standing.
///   eye  [sides of the cube]
std::vector<Eigen::Index> balls_of_draft(Frame const& frame, Cut const& cut,
                                         Eigen::Vector3f const& eye, std::size_t most);

} // namespace clack::view
