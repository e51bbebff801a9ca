// From a function that fills a case with generated numbers to a generator that shrinks.
#pragma once

#include <rapidcheck.h>

#include <functional>
#include <utility>

#include "properties/case.hpp"
#include "properties/format.hpp"
#include "properties/generators/simpler.hpp"

namespace tps::properties {

/// What a law's `cases` is: `fill` draws with RapidCheck's combinators (`*gen`), shrinking is by simpler().
inline std::function<rc::Gen<Case>(const Format&)> cases(std::function<void(Case&, const Format&)> fill) {
  return [fill = std::move(fill)](const Format& format) {
    const rc::Gen<Case> drawn = rc::gen::exec([fill, format] {
      Case c;
      fill(c, format);
      return c;
    });
    return rc::Gen<Case>([drawn, format](const rc::Random& random, int size) {
      return rc::shrinkable::shrinkRecur(drawn(random, size).value(), [format](const Case& c) {
        return rc::seq::fromContainer(simpler(c, format));
      });
    });
  };
}

}  // namespace tps::properties
