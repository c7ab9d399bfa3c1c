#pragma once
// Stands elsewhere now.
#include "validation/records/tables.hpp"
