#pragma once
// Stands elsewhere now.
#include "validation/statistics/estimate.hpp"
