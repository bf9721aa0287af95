#pragma once
#include <memory>

#include "core/materials/catalog.hpp"

namespace brunt {

/// As make_strength, eight points at a time; null where the law has no such version.
std::unique_ptr<Strength> make_wide_strength(const StrengthLaw& law, const StrengthInputs& inputs);

}  // namespace brunt
// Tested by tests/unit/core/wide_return_test.cpp.
