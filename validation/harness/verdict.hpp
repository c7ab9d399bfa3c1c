#pragma once
// Stands elsewhere now.
#include "validation/statistics/verdict.hpp"
