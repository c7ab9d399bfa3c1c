#pragma once
// Stands elsewhere now.
#include "validation/harness/experiment.hpp"
