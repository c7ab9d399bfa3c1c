#pragma once
// Stands elsewhere now.
#include "validation/mutants/engine_maker.hpp"
