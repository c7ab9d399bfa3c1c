#pragma once
// From an instant to a picture: which colour each ball has and what is marked.

#include "view/frame.hpp"
#include "view/picture.hpp"

namespace clack::view {

enum class Visible { no, yes };

struct Look {
    Colouring colouring = Colouring::speed;
    Background background = Background::light;
    Visible flashes = Visible::no;
    double flash_wait = 0.1; // in which a flash fades  [time]
    Visible next_pair = Visible::no;
    Visible cube = Visible::yes;
    Cut cut;

    bool operator==(Look const&) const = default;
};

Picture picture_of(Frame const& frame, Look const& look);
/// With these balls only.
Picture picture_of(Frame const& frame, Look const& look, std::vector<Eigen::Index> const& balls);

/// Of the sides of the start, Okabe and Ito's; of rings, around the next pair and the next partner.
constexpr Colour left_colour{0, 114, 178}, right_colour{230, 159, 0}, pair_colour{230, 80, 160},
    partner_colour{86, 180, 233};

/// Colours of a scale from 0 to 1: blue to yellow, lightness rising evenly.
Colour scale_colour(double share);
/// The value that has the scale's last colour, for the legend.
double scale_top(Frame const& frame, Colouring colouring);

} // namespace clack::view
