#pragma once
// Stands elsewhere now.
#include "validation/records/campaign.hpp"
