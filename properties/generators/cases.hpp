// From a function that fills a case with drawn numbers to a generator that shrinks.
#pragma once

#include <functional>

#include "properties/case.hpp"
#include "properties/format.hpp"
#include "properties/law.hpp"

namespace tps::properties {

/// What a law's `cases` is: `fill` draws (numbers.hpp), shrinking is by simpler().
std::function<rc::Gen<Case>(const Format&)> cases(std::function<void(Case&, const Format&)> fill);

}  // namespace tps::properties
