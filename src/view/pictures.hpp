#pragma once
// Stills and movies, drawn without a window.

#include "view/source.hpp"
#include "view/view.hpp"

namespace clack::view {

void make_screenshot(Source& source, Options const& options);
void make_movie(Source& source, Options const& options);

} // namespace clack::view
