#pragma once
// Stands elsewhere now.
#include "validation/child_process.hpp"
