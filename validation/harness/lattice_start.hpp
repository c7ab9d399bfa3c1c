#pragma once
// Stands elsewhere now.
#include "validation/lattice_start.hpp"
