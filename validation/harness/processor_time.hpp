#pragma once
// Stands elsewhere now.
#include "validation/timing.hpp"
