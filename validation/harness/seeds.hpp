#pragma once
// Stands elsewhere now.
#include "validation/harness/campaign.hpp"
